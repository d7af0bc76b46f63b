/** Strokes of a dimensioned technical drawing, in SVG; x to the right, y down. */
import { s } from "./dom.js";
import { parts } from "./signs.js";

/** @typedef {{ x: number, y: number }} Point */

const HEAD = 5;
const HALF_HEAD = 1.7;

/**
 * The point at `distance` from `from` in direction `degrees`, counter-clockwise from the right.
 * @param {Point} from
 * @param {number} distance
 * @param {number} degrees
 * @returns {Point}
 */
export function polar(from, distance, degrees) {
  const angle = (degrees * Math.PI) / 180;
  return { x: from.x + distance * Math.cos(angle), y: from.y - distance * Math.sin(angle) };
}

/** @param {number} value */
const short = (value) => String(Math.round(value * 100) / 100);

/** @param {Point[]} points */
export function path(...points) {
  return points.map(({ x, y }, index) => `${index ? "L" : "M"}${short(x)} ${short(y)}`).join("");
}

/**
 * @param {string} kind  class name
 * @param {string} d
 */
export function stroke(kind, d) {
  return s("path", { class: kind, d });
}

/**
 * @param {string} kind
 * @param {Point} centre
 * @param {number} r
 */
export function circle(kind, centre, r) {
  return s("circle", { class: kind, cx: short(centre.x), cy: short(centre.y), r: short(r) });
}

/**
 * Outline of a plate cam: a circle with a smooth lobe about direction `about`.
 * @param {Point} centre
 * @param {number} r
 * @param {number} lift
 * @param {number} about  degrees
 */
export function lobe(centre, r, lift, about) {
  const points = [];
  for (let angle = 0; angle < 360; angle += 6) {
    const off = Math.abs(((angle - about + 540) % 360) - 180);
    const rise = off < 100 ? (lift * (1 + Math.cos((off * Math.PI) / 100))) / 2 : 0;
    points.push(polar(centre, r + rise, angle));
  }
  return path(...points) + "z";
}

/**
 * @param {Point} tip
 * @param {Point} from
 */
function head(tip, from) {
  const length = Math.hypot(tip.x - from.x, tip.y - from.y) || 1;
  const ux = (tip.x - from.x) / length;
  const uy = (tip.y - from.y) / length;
  const back = { x: tip.x - HEAD * ux, y: tip.y - HEAD * uy };
  return (
    path(tip, { x: back.x - HALF_HEAD * uy, y: back.y + HALF_HEAD * ux }, { x: back.x + HALF_HEAD * uy, y: back.y - HALF_HEAD * ux }) + "z"
  );
}

/**
 * A line with an arrow at its end, or at both.
 * @param {Point} from
 * @param {Point} to
 * @param {boolean} [both]
 */
export function arrow(from, to, both = false) {
  return [stroke("dim-line", path(from, to)), stroke("dim-head", head(to, from) + (both ? head(from, to) : ""))];
}

/**
 * An arc about `centre` from one direction to another, with an arrow at its end.
 * @param {Point} centre
 * @param {number} r
 * @param {number} from  degrees
 * @param {number} to    degrees, less than half a turn away
 */
export function arcArrow(centre, r, from, to) {
  const start = polar(centre, r, from);
  const end = polar(centre, r, to);
  const sweep = to > from ? 0 : 1;
  const before = polar(end, HEAD, to + (to > from ? -90 : 90));
  return [
    stroke("dim-line", `M${short(start.x)} ${short(start.y)}A${r} ${r} 0 0 ${sweep} ${short(end.x)} ${short(end.y)}`),
    stroke("dim-head", head(end, before)),
  ];
}

/**
 * A symbol as in the books, "R_b" or "Rb".
 * @param {string} symbol
 * @param {Point} at
 * @param {"start" | "middle" | "end"} [anchor]
 */
export function letter(symbol, at, anchor = "middle") {
  const { letter: main, index } = parts(symbol);
  const text = s("text", { x: short(at.x), y: short(at.y), "text-anchor": anchor, class: "dim-text" }, s("tspan", { class: "symbol" }, main));
  if (index) text.append(s("tspan", { class: "index", dy: 3 }, index));
  return text;
}
