/**
 * The cam as a part: profile, hub, keyway and reference line, in its own frame, built once a design.
 *
 * @import { Lab, Report } from "../types.d.ts"
 * @import { Pen } from "./pen.js"
 */

/** Hub and bore as shares of the base circle. */
const HUB = 0.36;
const BORE = 0.2;
const KEY = 0.11;

/**
 * @typedef {object} Cam
 * @property {Float64Array} x  profile, even steps of θ
 * @property {Float64Array} y
 * @property {number} span  what its points cover: 360°, or a length
 * @property {Path2D} profile
 * @property {Path2D | null} pitch    the trace point's way around the cam
 * @property {Float64Array | null} rolled  turn of the roller on its pin at even steps of θ, rad
 * @property {Path2D} hub
 * @property {Path2D} bore
 * @property {Path2D} mark  the line that turns with the cam
 */

/**
 * @param {Report} report
 * @param {Lab} lab
 * @param {boolean} [second]  the second cam of a pair
 * @returns {Cam}
 */
export function buildCam(report, lab, second = false) {
  const { mechanism, travels, span } = report;
  const x = lab.column("x", second);
  const y = lab.column("y", second);
  const pitchX = lab.column("pitch_x", second);
  const pitchY = lab.column("pitch_y", second);
  const hasPitch = pitchX.length > 1;
  const profile = along(new Path2D(), x, y, 0, x.length - 1);
  profile.closePath();
  const pitch = hasPitch ? along(new Path2D(), pitchX, pitchY, 0, pitchX.length - 1) : null;
  const rolls = hasPitch && mechanism.contact === "roller" && mechanism.roller_radius > 0;
  return {
    x,
    y,
    span,
    profile,
    pitch,
    rolled: rolls ? rolling(pitchX, pitchY, mechanism.roller_radius, mechanism.sense, travels ? 0 : 2 * Math.PI) : null,
    hub: ring(HUB * mechanism.base_radius),
    bore: bore(mechanism.base_radius),
    mark: mark(x[0] ?? 0, y[0] ?? 0, mechanism.base_radius),
  };
}

/**
 * @param {Path2D} path
 * @param {Float64Array} x
 * @param {Float64Array} y
 * @param {number} first
 * @param {number} last
 */
export function along(path, x, y, first, last) {
  for (let i = first; i <= last; i++) {
    const px = /** @type {number} */ (x[i]);
    const py = /** @type {number} */ (y[i]);
    if (i === first) path.moveTo(px, py);
    else path.lineTo(px, py);
  }
  return path;
}

/** @param {number} radius */
function ring(radius) {
  const path = new Path2D();
  path.arc(0, 0, radius, 0, 2 * Math.PI);
  return path;
}

/**
 * The bore with its keyway, which points where the follower is at θ = 0.
 * @param {number} base
 */
function bore(base) {
  const radius = BORE * base;
  const half = (KEY * base) / 2;
  const side = Math.asin(half / radius);
  const path = new Path2D();
  path.arc(0, 0, radius, Math.PI / 2 + side, Math.PI / 2 - side + 2 * Math.PI);
  path.lineTo(half, radius + half);
  path.lineTo(-half, radius + half);
  path.closePath();
  return path;
}

/**
 * @param {number} x  first point of the profile
 * @param {number} y
 * @param {number} base
 */
function mark(x, y, base) {
  const reach = Math.hypot(x, y) || 1;
  const path = new Path2D();
  const from = (HUB * base) / reach;
  path.moveTo(x * from, y * from);
  path.lineTo(x, y);
  return path;
}

/**
 * The roller's turn as it rolls along the cam: by the cam's own turn, less the way of its centre over its radius.
 * @param {Float64Array} x
 * @param {Float64Array} y
 * @param {number} radius
 * @param {number} sense
 * @param {number} turn  of the cam itself, rad
 */
function rolling(x, y, radius, sense, turn) {
  const turns = new Float64Array(x.length);
  const step = turn / (x.length - 1);
  for (let i = 1; i < x.length; i++) {
    const way = Math.hypot(/** @type {number} */ (x[i]) - /** @type {number} */ (x[i - 1]), /** @type {number} */ (y[i]) - /** @type {number} */ (y[i - 1]));
    turns[i] = /** @type {number} */ (turns[i - 1]) + sense * (step - way / radius);
  }
  return turns;
}

/**
 * Value of a column of even steps at θ, between its two neighbours.
 * @param {Float64Array} column
 * @param {number} theta  0 … span
 * @param {number} [span]
 */
export function between(column, theta, span = 360) {
  const place = (theta / span) * (column.length - 1);
  const i = Math.min(Math.floor(place), column.length - 2);
  const before = /** @type {number} */ (column[i]);
  return before + (/** @type {number} */ (column[i + 1]) - before) * (place - i);
}

/**
 * The stretch of the profile between two angles, which may pass 360°.
 * @param {Cam} cam
 * @param {number} from  degrees
 * @param {number} to
 */
export function stretch(cam, from, to) {
  const path = new Path2D();
  const last = cam.x.length - 1;
  const { span } = cam;
  const degrees = span / last;
  const end = to >= from ? to : to + span;
  path.moveTo(between(cam.x, from % span, span), between(cam.y, from % span, span));
  for (let i = Math.floor(from / degrees) + 1; i * degrees < end; i++) {
    path.lineTo(/** @type {number} */ (cam.x[i % last]), /** @type {number} */ (cam.y[i % last]));
  }
  const stop = end % span || (end > 0 ? span : 0);
  path.lineTo(between(cam.x, stop, span), between(cam.y, stop, span));
  return path;
}

/**
 * The cam in its own frame, where the pen has been put.
 * @param {Pen} pen
 * @param {Cam} cam
 */
export function drawCam(pen, cam) {
  const { context, palette } = pen;
  context.lineJoin = "round";
  context.fillStyle = palette.cam;
  context.fill(cam.profile);
  pen.line(palette.camEdge, 0.75);
  context.stroke(cam.hub);
  context.fillStyle = palette.paper;
  context.fill(cam.bore);
  context.stroke(cam.bore);
  pen.line(palette.camEdge, 1);
  context.stroke(cam.mark);
  pen.line(palette.camEdge, 1.65);
  context.stroke(cam.profile);
}
