/**
 * What can be laid over the mechanism: reference circles, axes, pitch curve, contact normal with φ, osculating circle.
 *
 * @import { Report } from "../types.d.ts"
 * @import { Pen } from "./pen.js"
 */
import { AT, value } from "./instant.js";

/** Names of the layers in the order of their menu, with what they show before anyone chooses. */
export const LAYERS = Object.freeze({ base: true, prime: true, pitch: true, axes: true, normal: true, osculating: false, stations: false });

/** @typedef {keyof typeof LAYERS} Layer */

/** A circle larger than this on screen is drawn as the straight line it looks like. */
const STRAIGHT = 6000;
/** Half of what guide, stem and spring take of the picture at most, as a share of the cam's reach. */
const STEM = 0.17;
/** Between a line and its label, CSS pixels. */
const GAP = 9;
/** A normal that leans less than this stands upright. */
const LEVEL = 1e-9;

/**
 * Whether a layer means anything for this follower.
 * @param {Layer} layer
 * @param {Report} report
 */
export function applies(layer, { mechanism, travels }) {
  if (travels && layer === "prime") return false;
  return (layer !== "prime" && layer !== "pitch") || mechanism.prime_radius !== null;
}

/**
 * @param {Pen} pen
 * @param {Report} report
 */
export function drawAxes(pen, report) {
  const { reach, eccentricity, pivot } = report.mechanism;
  const far = report.travels ? report.span * 1.05 : reach * 1.12;
  pen.line(pen.palette.line, 0.75, "axis");
  if (report.travels) {
    pen.segment(0, -0.2 * report.span, 0, far);
    return;
  }
  pen.segment(-far, 0, far, 0);
  pen.segment(0, -far, 0, far);
  if (pivot) pen.segment(0, 0, pivot[0], pivot[1]);
  else if (eccentricity !== 0) pen.segment(eccentricity, -far * 0.4, eccentricity, far);
}

/**
 * The base circle, or the base line of a cam that travels.
 * @param {Pen} pen
 * @param {Report} report
 * @param {number} cursor
 */
export function drawBase(pen, report, cursor) {
  pen.line(pen.palette.base, 1.25, "base");
  if (report.travels) {
    pen.segment(-cursor, 0, report.span - cursor, 0);
    return;
  }
  pen.circle(0, 0, report.mechanism.base_radius);
}

/**
 * @param {Pen} pen
 * @param {Report} report
 */
export function drawPrime(pen, report) {
  pen.line(pen.palette.prime, 1.25, "prime");
  pen.circle(0, 0, report.mechanism.prime_radius ?? 0);
}

/**
 * The normal at the contact, the way the follower moves, and the angle between them.
 * @param {Pen} pen
 * @param {Report} report
 * @param {Float64Array} at
 * @param {string} label
 */
export function drawNormal(pen, report, at, label) {
  const { context, palette } = pen;
  const { pivot, contact, reach } = report.mechanism;
  const [cx, cy] = [value(at, AT.contactX), value(at, AT.contactY)];
  const [nx, ny] = [value(at, AT.normalX), value(at, AT.normalY)];
  if (Number.isNaN(nx)) return;
  const onFace = contact === "flat" || contact === "curved" || Number.isNaN(value(at, AT.traceX));
  const [ox, oy] = onFace ? [cx, cy] : [value(at, AT.traceX), value(at, AT.traceY)];
  // An oscillating follower's point moves at right angles to its radius from the pivot; outwards is where the normal leads.
  let [dx, dy] = pivot ? [-(oy - pivot[1]), ox - pivot[0]] : [0, 1];
  const size = Math.hypot(dx, dy) * (dx * nx + dy * ny < 0 ? -1 : 1) || 1;
  dx /= size;
  dy /= size;

  const out = Math.max(56 / pen.view.scale, 0.42 * reach);
  pen.line(palette.phi, 1.5);
  pen.segment(cx - nx * 0.3 * reach, cy - ny * 0.3 * reach, ox + nx * out, oy + ny * out);
  pen.line(palette.phi, 1, "phi");
  pen.segment(ox, oy, ox + dx * out, oy + dy * out);

  const radius = 0.8 * out * pen.view.scale;
  const from = Math.atan2(-dy, dx);
  let sweep = Math.atan2(-ny, nx) - from;
  if (sweep > Math.PI) sweep -= 2 * Math.PI;
  if (sweep < -Math.PI) sweep += 2 * Math.PI;
  context.beginPath();
  context.arc(pen.x(ox), pen.y(oy), radius, from, from + sweep, sweep < 0);
  pen.line(palette.phi, 1.5);
  context.stroke();

  // The label stands beside both lines, on the side to which the normal leans, and clear of the stem.
  const ends = [pen.x(ox) + radius * Math.cos(from), pen.x(ox) + radius * Math.cos(from + sweep)];
  const axis = pen.x(pivot ? ox : report.mechanism.eccentricity);
  const clear = pivot ? 0 : STEM * reach * pen.view.scale;
  const aside = pen.x(ox) - axis;
  const right = Math.abs(aside) > 1 ? aside > 0 : nx - dx >= -LEVEL;
  context.font = `italic ${palette.size * 1.15}px ${palette.fontMath}`;
  context.textAlign = right ? "left" : "right";
  context.textBaseline = "middle";
  const x = right ? Math.max(...ends, axis + clear) + GAP : Math.min(...ends, axis - clear) - GAP;
  pen.textInside(label, x, pen.y(oy) + radius * Math.sin(from + sweep / 2), palette.phi);
}

/**
 * @param {Pen} pen
 * @param {Float64Array} at
 */
export function drawOsculating(pen, at) {
  const [cx, cy] = [value(at, AT.contactX), value(at, AT.contactY)];
  const [ox, oy] = [value(at, AT.centreX), value(at, AT.centreY)];
  const [nx, ny] = [value(at, AT.normalX), value(at, AT.normalY)];
  pen.line(pen.palette.rho, 1.5, "rho");
  const radius = Math.hypot(ox - cx, oy - cy);
  if (!(radius * pen.view.scale < STRAIGHT)) {
    const far = STRAIGHT / pen.view.scale;
    pen.segment(cx - ny * far, cy + nx * far, cx + ny * far, cy - nx * far);
    return;
  }
  pen.circle(ox, oy, radius);
  pen.line(pen.palette.rho, 1);
  pen.segment(ox, oy, cx, cy);
  pen.dot(ox, oy, 3, pen.palette.rho);
}
