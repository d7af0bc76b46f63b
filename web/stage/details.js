/**
 * What is drawn anew in every frame around the parts: roller, spring, scale bar.
 *
 * @import { Format, Report } from "../types.d.ts"
 * @import { Follower } from "./follower-part.js"
 * @import { Pen } from "./pen.js"
 */
import { roundLength } from "./view.js";

/** Coils of the spring. */
const COILS = 7;
/** Longest scale bar, in heights of the type: the shortest then holds its label, on the projector too. */
const SCALE_BAR = 8.5;
const SPOKES = 3;

/**
 * The roller with its spokes, so that its rolling is seen.
 * @param {Pen} pen
 * @param {number} x
 * @param {number} y
 * @param {number} spin  rad
 * @param {number} radius
 */
export function drawRoller(pen, x, y, spin, radius) {
  const { context, palette } = pen;
  pen.world(x, y, spin);
  context.beginPath();
  context.arc(0, 0, radius, 0, 2 * Math.PI);
  context.fillStyle = palette.panel;
  context.fill();
  pen.line(palette.camEdge, 1.5);
  context.stroke();
  context.beginPath();
  for (let i = 0; i < SPOKES; i++) {
    const angle = (2 * Math.PI * i) / SPOKES;
    context.moveTo(0, 0);
    context.lineTo(0.86 * radius * Math.cos(angle), 0.86 * radius * Math.sin(angle));
  }
  pen.line(palette.line, 1.25);
  context.stroke();
  context.beginPath();
  context.arc(0, 0, 0.2 * radius, 0, 2 * Math.PI);
  context.fillStyle = palette.camEdge;
  context.fill();
}

/**
 * @param {Pen} pen
 * @param {NonNullable<Follower["spring"]>} spring
 * @param {number} height  of the follower's own frame
 */
export function drawSpring(pen, spring, height) {
  const { context, palette } = pen;
  pen.screen();
  const left = pen.x(spring.x - spring.half);
  const right = pen.x(spring.x + spring.half);
  const bottom = pen.y(height + spring.foot);
  const rise = pen.y(spring.seat) - bottom;
  context.beginPath();
  context.moveTo(right, bottom);
  for (let i = 1; i <= 2 * COILS; i++) context.lineTo(i % 2 ? left : right, bottom + (rise * i) / (2 * COILS));
  context.lineJoin = "round";
  // Wire that never fills the gap between its coils.
  const wire = Math.min(1.5, (-0.3 * rise) / COILS / pen.weight);
  pen.line(palette.steel, 2.4 * wire);
  context.stroke();
  pen.line(palette.camEdge, wire);
  context.stroke();
}

/**
 * @param {Pen} pen
 * @param {Report} report
 * @param {Format} format
 * @param {number} height
 */
export function drawScale(pen, report, format, height) {
  const { context, palette } = pen;
  const length = roundLength((SCALE_BAR * palette.size) / pen.view.scale);
  const width = length * pen.view.scale;
  const y = height - 8;
  context.beginPath();
  context.moveTo(10, y - 5);
  context.lineTo(10, y);
  context.lineTo(10 + width, y);
  context.lineTo(10 + width, y - 5);
  pen.line(palette.muted, 1);
  context.stroke();
  context.font = `${palette.size * 0.85}px ${palette.font}`;
  context.textAlign = "left";
  context.textBaseline = "alphabetic";
  pen.text(format.number(length, { unit: report.units.length }), 14, y - 6, palette.muted);
}
