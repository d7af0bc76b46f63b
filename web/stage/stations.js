/**
 * The graphical construction: the cam held still, the follower laid around it at even stations (kinematic inversion).
 *
 * @import { Lab, Report } from "../types.d.ts"
 * @import { Pen } from "./pen.js"
 */
import { AT, newInstant, value } from "./instant.js";

/** Stations of a turn: every 15°. */
const COUNT = 24;
/** Stations of a travel, both ends among them. */
const TRAVEL_COUNT = 13;
/** Every how many stations one is numbered. */
const NUMBERED = 2;

/**
 * @typedef {object} Stations
 * @property {Path2D} lines     the follower's axis, arm or face at each station, in the cam's frame
 * @property {Path2D} contacts  rollers, or points of contact
 * @property {number} count
 * @property {Float64Array} labels  x, y of each number, in the cam's frame
 */

/**
 * @param {Report} report
 * @param {Lab} lab
 * @returns {Stations}
 */
export function buildStations(report, lab) {
  const { sense, contact, motion, pivot, eccentricity, reach, roller_radius: radius, face } = report.mechanism;
  const at = newInstant();
  const lines = new Path2D();
  const contacts = new Path2D();
  const labels = new Float64Array(2 * COUNT);
  const dot = 0.018 * reach;

  const count = report.travels ? TRAVEL_COUNT : COUNT;
  for (let k = 0; k < count; k++) {
    const theta = report.travels ? (report.span * k) / (count - 1) : (360 * k) / count;
    lab.at(theta, at);
    const c = Math.cos((-sense * theta * Math.PI) / 180);
    const s = Math.sin((-sense * theta * Math.PI) / 180);
    /** @type {(x: number, y: number) => [number, number]} */
    const back = report.travels ? (x, y) => [x + theta, y] : (x, y) => [x * c - y * s, x * s + y * c];
    const [cx, cy] = [value(at, AT.contactX), value(at, AT.contactY)];
    const [nx, ny] = [value(at, AT.normalX), value(at, AT.normalY)];
    const flat = contact === "flat";
    const [tx, ty] = flat ? [cx, cy] : [value(at, AT.traceX), value(at, AT.traceY)];

    if (flat) {
      const width = face ? 0.6 * Math.max(Math.abs(face[1] - face[0]), 0.3 * reach) : 0.5 * reach;
      lines.moveTo(...back(cx - ny * width, cy + nx * width));
      lines.lineTo(...back(cx + ny * width, cy - nx * width));
    }
    if (pivot) {
      lines.moveTo(...back(pivot[0], pivot[1]));
      lines.lineTo(...(flat ? back(pivot[0] + nx * 0.1 * reach, pivot[1] + ny * 0.1 * reach) : back(tx, ty)));
      circle(contacts, back(pivot[0], pivot[1]), 1.4 * dot);
    } else if (!flat) {
      lines.moveTo(...back(eccentricity, 0));
      lines.lineTo(...back(tx, ty + 0.12 * reach));
    }
    if (contact === "roller") circle(contacts, back(tx, ty), radius);
    circle(contacts, back(flat ? cx : tx, flat ? cy : ty), dot);
    const beyond = (contact === "roller" ? radius : 0) + 0.1 * reach + (motion === "translating" && !flat ? 0.08 * reach : 0);
    [labels[2 * k], labels[2 * k + 1]] = back(tx + nx * beyond, ty + ny * beyond);
  }
  return { lines, contacts, count, labels };
}

/**
 * How far from the cam's centre the construction reaches, numbers and all.
 * @param {Report} report
 */
export function stationsReach({ mechanism: { reach, roller_radius: radius, contact, pivot } }) {
  const around = reach * 1.3 + (contact === "roller" ? 2 * radius : 0);
  return pivot ? Math.max(around, Math.hypot(...pivot) + 0.06 * reach) : around;
}

/**
 * @param {Path2D} path
 * @param {[number, number]} centre
 * @param {number} radius
 */
function circle(path, [x, y], radius) {
  path.moveTo(x + radius, y);
  path.arc(x, y, radius, 0, 2 * Math.PI);
}

/**
 * @param {Pen} pen
 * @param {Stations} stations
 * @param {number} angle  of the cam, rad
 * @param {number} shift  by which it has travelled
 */
export function drawStations(pen, stations, angle, shift) {
  const { context, palette } = pen;
  pen.world(-shift, 0, angle);
  pen.line(palette.line, 0.75);
  context.stroke(stations.lines);
  pen.line(palette.s, 1);
  context.stroke(stations.contacts);
  pen.screen();
  context.font = `${palette.size * 0.85}px ${palette.font}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  for (let k = 0; k < stations.count; k += NUMBERED) {
    const x = /** @type {number} */ (stations.labels[2 * k]);
    const y = /** @type {number} */ (stations.labels[2 * k + 1]);
    pen.text(String(k), pen.x(x * c - y * s - shift), pen.y(x * s + y * c), palette.muted);
  }
}
