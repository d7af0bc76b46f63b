/**
 * A magnitude drawn on the mechanism while it is being edited: dimension line, arrowheads, symbol and value.
 *
 * @import { Report } from "../types.d.ts"
 * @import { Pen } from "./pen.js"
 */
import { AT } from "./instant.js";
import { parts, sign } from "../signs.js";

/** @typedef {[number, number]} Point */

/**
 * @typedef {object} Dimension
 * @property {Point} from
 * @property {Point} to
 * @property {string} symbol  letter, and index after "_"
 * @property {Point} [about]  an angle about this point instead of a length
 */

/** Direction in which radii are drawn, away from the follower. */
const RADIUS_AT = (205 * Math.PI) / 180;

const ARROW = 9;

/**
 * @param {string} path  "cam.base_radius", "base_radius" …
 * @param {Report} report
 * @param {Float64Array} at
 * @returns {Dimension | null}
 */
export function dimension(path, report, at) {
  const { mechanism } = report;
  const { pivot, eccentricity: e, reach } = mechanism;
  const contact = point(at, AT.contactX);
  const trace = point(at, AT.traceX);
  const normal = point(at, AT.normalX);
  const centre = /** @type {Point} */ ([0, 0]);
  switch (path.slice(path.lastIndexOf(".") + 1)) {
    case "base_radius":
      return { from: centre, to: polar(mechanism.base_radius), symbol: "R_b" };
    case "roller_radius":
      return { from: trace, to: offset(trace, [Math.SQRT1_2, Math.SQRT1_2], mechanism.roller_radius), symbol: "R_f" };
    case "face_radius":
      return { from: trace, to: contact, symbol: "R_f" };
    case "eccentricity":
      return { from: [0, -0.25 * reach], to: [e, -0.25 * reach], symbol: "e" };
    case "arm":
      return pivot && { from: pivot, to: trace, symbol: "A" };
    case "pivot_distance":
      return pivot && { from: centre, to: pivot, symbol: "m" };
    case "pivot_angle":
      return pivot && { from: [Math.hypot(...pivot) * 0.6, 0], to: [pivot[0] * 0.6, pivot[1] * 0.6], about: centre, symbol: "κ" };
    case "face_offset":
      return pivot && { from: pivot, to: offset(pivot, normal, mechanism.face_offset), symbol: "f" };
    case "face_angle": {
      const foot = /** @type {Point} */ ([e, contact[1] + ((contact[0] - e) * normal[0]) / normal[1]]);
      return { from: offset(foot, [1, 0], 0.8 * reach), to: offset(foot, [normal[1], -normal[0]], 0.8 * reach), about: foot, symbol: "γ" };
    }
    default:
      return null;
  }
}

/**
 * @param {Float64Array} at
 * @param {number} place
 * @returns {Point}
 */
const point = (at, place) => [/** @type {number} */ (at[place]), /** @type {number} */ (at[place + 1])];

/**
 * @param {Point} from
 * @param {Point} direction
 * @param {number} by
 * @returns {Point}
 */
const offset = ([x, y], [dx, dy], by) => [x + by * dx, y + by * dy];

/**
 * @param {number} radius
 * @returns {Point}
 */
const polar = (radius) => [radius * Math.cos(RADIUS_AT), radius * Math.sin(RADIUS_AT)];

/**
 * @param {Pen} pen
 * @param {Dimension} shown
 * @param {string} text  the value
 * @param {string} [colour]
 */
export function drawDimension(pen, shown, text, colour = pen.palette.accent) {
  const { context } = pen;
  const [x0, y0] = [pen.x(shown.from[0]), pen.y(shown.from[1])];
  const [x1, y1] = [pen.x(shown.to[0]), pen.y(shown.to[1])];
  pen.line(colour, colour === pen.palette.accent ? 2.25 : 1);
  context.beginPath();
  if (shown.about) {
    const [ox, oy] = [pen.x(shown.about[0]), pen.y(shown.about[1])];
    const [a, b] = [Math.atan2(y0 - oy, x0 - ox), Math.atan2(y1 - oy, x1 - ox)];
    context.moveTo(x0, y0);
    context.lineTo(ox, oy);
    context.lineTo(x1, y1);
    const radius = Math.hypot(x0 - ox, y0 - oy) * 0.9;
    context.moveTo(ox + radius * Math.cos(a), oy + radius * Math.sin(a));
    context.arc(ox, oy, radius, a, b, b < a);
  } else {
    context.moveTo(x0, y0);
    context.lineTo(x1, y1);
    const angle = Math.atan2(y1 - y0, x1 - x0);
    if (Math.hypot(x1 - x0, y1 - y0) > 2.2 * ARROW) {
      arrow(context, x0, y0, angle + Math.PI);
      arrow(context, x1, y1, angle);
    } else {
      tick(context, x0, y0, angle);
      tick(context, x1, y1, angle);
    }
  }
  context.stroke();
  label(pen, shown.symbol, text, (x0 + x1) / 2, (y0 + y1) / 2, Math.abs(x1 - x0) > Math.abs(y1 - y0), colour);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {number} x
 * @param {number} y
 * @param {number} angle
 */
function arrow(context, x, y, angle) {
  for (const side of [-0.35, 0.35]) {
    context.moveTo(x, y);
    context.lineTo(x - ARROW * Math.cos(angle + side), y - ARROW * Math.sin(angle + side));
  }
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {number} x
 * @param {number} y
 * @param {number} angle
 */
function tick(context, x, y, angle) {
  const [dx, dy] = [ARROW * Math.sin(angle), -ARROW * Math.cos(angle)];
  context.moveTo(x - dx, y - dy);
  context.lineTo(x + dx, y + dy);
}

/**
 * Letter in italics, index below, value upright.
 * @param {Pen} pen
 * @param {string} symbol
 * @param {string} text
 * @param {number} x
 * @param {number} y
 * @param {boolean} level  whether the line lies rather than stands
 * @param {string} colour
 */
function label(pen, symbol, text, x, y, level, colour) {
  const { context, palette } = pen;
  // The A of an arm is no acceleration.
  const { letter, index } = parts(symbol === "A" ? symbol : sign(symbol));
  const size = palette.size * 1.2;
  const [italic, small, upright] = [`italic ${size}px ${palette.fontMath}`, `${size * 0.72}px ${palette.fontMath}`, `600 ${palette.size}px ${palette.font}`];
  context.textBaseline = "alphabetic";
  context.textAlign = "left";
  /** @type {[string, string, number][]} */
  const runs = [[italic, letter, 0], [small, index, size * 0.22], [upright, ` = ${text}`, 0]];
  let width = 0;
  for (const [font, run] of runs) {
    context.font = font;
    width += context.measureText(run).width;
  }
  const room = context.canvas.width / pen.ratio;
  let left = Math.max(4, Math.min(level ? x - width / 2 : x + 10, room - width - 4));
  const base = level ? y - 9 : y + size / 3;
  for (const [font, run, drop] of runs) {
    context.font = font;
    pen.text(run, left, base + drop, colour);
    left += context.measureText(run).width;
  }
}
