/**
 * The follower and the frame that carries it, as parts built once a design from what the engine tells of a turn.
 *
 * @import { Lab, Report } from "../types.d.ts"
 * @import { Box } from "./view.js"
 */
import { AT, newInstant, value } from "./instant.js";
import { bar, disc, hatch, mushroom, polygon, rectangle } from "./shapes.js";
import { include } from "./view.js";

/** The measure of all thicknesses, as a share of the cam's reach. */
export const THICKNESS = 0.05;

/**
 * @typedef {object} Pose  where the follower's own frame stands
 * @property {number} x
 * @property {number} y
 * @property {number} angle   rad
 * @property {number} mirror  −1 when the second axis points the other way
 */

/**
 * @typedef {object} Follower
 * @property {Path2D[]} body     in its own frame
 * @property {Path2D[]} joints   pins, in its own frame
 * @property {Path2D[]} ground   fixed
 * @property {Path2D} hatching   fixed
 * @property {number} roller     radius, 0 without one
 * @property {{ x: number, half: number, foot: number, seat: number } | null} spring  foot in the own frame, seat fixed
 * @property {Box} box           what a whole turn needs
 * @property {(at: Float64Array, pose: Pose) => void} place
 */

/**
 * @typedef {object} Surroundings  what another kind of cam changes
 * @property {Box} [box]      instead of the cam with its pitch curve
 * @property {number} [clear] height above which the guide begins
 * @property {boolean} [free] without a spring
 */

/**
 * @param {Report} report
 * @param {Lab} lab
 * @param {Surroundings} [surroundings]
 * @returns {Follower}
 */
export function buildFollower(report, lab, surroundings = {}) {
  return report.mechanism.pivot ? oscillating(report, lab, report.mechanism.pivot) : translating(report, lab, surroundings);
}

/** A pitch curve farther out than this share of the cam's reach, that of a mushroom, is not waited for. */
const FAR_OUT = 0.6;

/**
 * The cam with its pitch curve, however it is turned.
 * @param {Report["mechanism"]} mechanism
 * @returns {Box}
 */
export function around({ reach, base_radius: base, prime_radius: prime }) {
  const far = reach + Math.min((prime ?? base) - base, FAR_OUT * reach);
  return { left: -far, right: far, bottom: -far, top: far };
}

/**
 * The instants at the start, at the lowest and at the highest place of the turn.
 * @param {Report} report
 * @param {Lab} lab
 */
export function extremes(report, lab) {
  const range = report.summary.s;
  return [0, range?.min_at ?? 0, range?.max_at ?? 0].map((theta) => {
    const at = newInstant();
    lab.at(theta, at);
    return at;
  });
}

/**
 * @param {Report} report
 * @param {Lab} lab
 * @param {Surroundings} surroundings
 * @returns {Follower}
 */
function translating(report, lab, { box: given, clear = -Infinity, free = false }) {
  const { mechanism, summary } = report;
  const { reach, roller_radius: radius, contact, eccentricity } = mechanism;
  const t = THICKNESS * reach;
  const half = contact === "roller" ? Math.min(Math.max(0.5 * radius, 0.5 * t), 1.1 * t) : t * 0.9;

  /** @type {Follower["place"]} */
  const place = (at, pose) => {
    pose.x = eccentricity;
    pose.angle = 0;
    pose.mirror = 1;
    pose.y = contact === "flat" ? faceHeight(at, eccentricity) : value(at, AT.traceY);
  };
  const heights = extremes(report, lab).map((at) => {
    const pose = { x: 0, y: 0, angle: 0, mirror: 1 };
    place(at, pose);
    return pose.y;
  });
  const low = Math.min(...heights);
  const high = Math.max(...heights);
  const travel = high - low;

  const { head, top, side } = heads();
  const seat = Math.max(high + top + 1.8 * t + 0.2 * travel, clear);
  const guideTop = seat + 4.2 * t;
  const end = guideTop - low + 1.6 * t;
  const stem = contact === "knife" ? polygon([0, 0], [half, 2.2 * half], [half, end], [-half, end], [-half, 2.2 * half]) : rectangle(-half, stemFoot(), half, end);
  const collar = rectangle(-2.1 * half, top, 2.1 * half, top + 0.7 * t);

  const inner = half + 0.12 * t;
  const outer = inner + 2.2 * t;
  const hatching = new Path2D();
  const ground = [-1, 1].map((hand) => {
    const [a, b] = hand < 0 ? [eccentricity - outer, eccentricity - inner] : [eccentricity + inner, eccentricity + outer];
    hatch(hatching, a, seat, b, guideTop, 0.75 * t);
    return rectangle(a, seat, b, guideTop);
  });

  const box = given ? { ...given } : around(mechanism);
  include(box, eccentricity - Math.max(outer, side), high + end);
  include(box, eccentricity + Math.max(outer, side), guideTop);
  const spring = free ? null : { x: eccentricity, half: half + 0.9 * t, foot: top + 0.7 * t, seat };
  return { body: [...head, stem, collar], joints: [], ground, hatching, roller: contact === "roller" ? radius : 0, spring, box, place };

  function stemFoot() {
    return contact === "roller" ? 0 : contact === "curved" ? top - 0.5 * t : 0.5 * t;
  }

  /** What touches the cam: its pieces, how high it reaches above the follower's own origin and how far to a side. */
  function heads() {
    if (contact === "roller") return { head: [disc(0, 0, half)], top: radius + 0.5 * t, side: radius };
    if (contact === "knife") return { head: [], top: 3.2 * half, side: half };
    if (contact === "curved") {
      const lean = Math.max(Math.abs(summary.pressure_angle?.max ?? 0), Math.abs(summary.pressure_angle?.min ?? 0));
      const arc = Math.min((lean * Math.PI) / 180 + Math.max(0.12, (1.5 * t) / radius), 1.3);
      return { head: [mushroom(radius, arc, 0.8 * t)], top: -radius * Math.cos(arc) + 0.8 * t, side: radius * Math.sin(arc) };
    }
    const [from, to] = mechanism.face ?? [-reach / 2, reach / 2];
    const at = newInstant();
    lab.at(0, at);
    const [nx, ny] = [value(at, AT.normalX), value(at, AT.normalY)];
    // The range is told across, the plate may be inclined.
    const a = Math.min(from / ny, -half) - 1.4 * t;
    const b = Math.max(to / ny, half) + 1.4 * t;
    const plate = polygon([a * ny, -a * nx], [b * ny, -b * nx], [b * ny + t * nx, -b * nx + t * ny], [a * ny + t * nx, -a * nx + t * ny]);
    return { head: [plate], top: t + Math.max(-a * nx, -b * nx, 0) * (nx === 0 ? 0 : 0.35), side: Math.max(-a, b) };
  }
}

/**
 * Height of the flat face where it meets the follower's axis.
 * @param {Float64Array} at
 * @param {number} axis
 */
export function faceHeight(at, axis) {
  return value(at, AT.contactY) + ((value(at, AT.contactX) - axis) * value(at, AT.normalX)) / value(at, AT.normalY);
}

/**
 * @param {Report} report
 * @param {Lab} lab
 * @param {[number, number]} pivot
 * @returns {Follower}
 */
function oscillating(report, lab, [px, py]) {
  const { mechanism } = report;
  const { reach, roller_radius: radius, contact } = mechanism;
  const t = THICKNESS * reach;
  const flat = contact === "flat";
  const offset = mechanism.face_offset;
  const instants = extremes(report, lab);
  // The face runs from the foot of the pivot towards the contact: to which hand of the normal is told by the first instant.
  const [first] = instants;
  const hand = first && flat ? Math.sign(-(value(first, AT.contactX) - px) * value(first, AT.normalY) + (value(first, AT.contactY) - py) * value(first, AT.normalX)) || 1 : 1;

  /** @type {Follower["place"]} */
  const place = (at, pose) => {
    pose.x = px;
    pose.y = py;
    pose.mirror = flat ? -hand : 1;
    pose.angle = flat
      ? Math.atan2(hand * value(at, AT.normalX), -hand * value(at, AT.normalY))
      : Math.atan2(value(at, AT.traceY) - py, value(at, AT.traceX) - px);
  };

  const length = flat ? (mechanism.face?.[1] ?? reach) + 1.6 * t : (mechanism.arm ?? reach);
  const body = flat
    ? [rectangle(-1.3 * t, offset, length, offset + 1.3 * t), rectangle(-0.95 * t, Math.min(0, offset), 0.95 * t, Math.max(0, offset)), disc(0, 0, 1.3 * t)]
    : [bar(length, 1.3 * t, Math.min(0.85 * t, Math.max(0.5 * radius, 0.4 * t)))];

  const box = around(mechanism);
  const pose = { x: 0, y: 0, angle: 0, mirror: 1 };
  for (const at of instants) {
    place(at, pose);
    const [c, s] = [Math.cos(pose.angle), Math.sin(pose.angle)];
    const v = flat ? (offset + 1.3 * t) * pose.mirror : 0;
    include(box, px + length * c - v * s, py + length * s + v * c, Math.max(radius, t));
  }
  const down = py > Math.abs(px) ? 1 : -1;
  const foot = py + down * 3.4 * t;
  const strip = foot + down * 1.1 * t;
  const hatching = new Path2D();
  hatch(hatching, px - 2.8 * t, Math.min(foot, strip), px + 2.8 * t, Math.max(foot, strip), 0.75 * t);
  const ground = [polygon([px - 0.5 * t, py], [px + 0.5 * t, py], [px + 1.9 * t, foot], [px - 1.9 * t, foot]), polygon([px - 2.8 * t, foot], [px + 2.8 * t, foot])];
  include(box, px + 2.8 * t, strip);
  include(box, px - 2.8 * t, py, t);
  return { body, joints: [disc(0, 0, 0.6 * t)], ground, hatching, roller: contact === "roller" ? radius : 0, spring: null, box, place };
}
