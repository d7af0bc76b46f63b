/**
 * Another kind of cam from the same design: what can be kept is kept, the rest gets magnitudes that work.
 *
 * @import { Catalogue, Design, KindId, Report, Segment } from "./types.d.ts"
 */
import { clean } from "./clean.js";
import { changeFollower } from "./follower-change.js";
import { breadthTravel, heightAt, lift, openHeight, spread, wholeOf } from "./program.js";

/** Length of a cam that travels, for each length that its follower rises in it: φ then stays moderate with the usual laws. */
const GENTLE = 4;

/** Base radius of a cam that turns, as multiples of the follower's travel. */
const STOUT = 4;

const HALF = 180;

/**
 * @param {Design} draft
 * @param {KindId} kind
 * @param {Catalogue} catalogue
 * @param {Report["program"]} ready  the segments of a motion that is ready-made
 */
export function changeKind(draft, kind, catalogue, ready) {
  if (draft.cam.kind === kind) return;
  delete draft.conjugate;
  // Points to hit have their places on the other cam.
  if (kind === "translating" || draft.cam.kind === "translating") delete draft.application?.targets;
  if (draft.cam.kind === "constant-breadth") unfold(draft, catalogue, ready);
  else if (draft.cam.kind === "translating") bend(draft);
  draft.cam.kind = "rotating";
  const suited = catalogue.kinds.find(({ id }) => id === kind)?.followers ?? [];
  const { motion, contact } = draft.follower;
  const entry = [`${motion}-${contact}`, `${motion}-roller`, "translating-roller"].find((id) => suited.includes(id));
  const next = catalogue.followers.find(({ id }) => id === entry);
  if (next && (next.motion !== motion || next.contact !== contact)) changeFollower(draft, next);
  if (kind === "constant-breadth") fold(draft);
  else if (kind === "translating") straighten(draft);
  else draft.cam.kind = kind;
}

/** Half a turn between two faces, its travel that of the program, from the classic motion. @param {Design} draft */
function fold(draft) {
  const base = draft.cam.base_radius ?? 1;
  const travel = Math.min(lift(draft) > 0 ? lift(draft) : 0.5 * base, base);
  centre(draft);
  Object.assign(draft.cam, { kind: "constant-breadth", breadth: clean(2 * base + travel), generator: "harmonic" });
  draft.segments = [];
}

/**
 * The whole turn of a cam of constant breadth, as segments.
 * @param {Design} draft
 * @param {Catalogue} catalogue
 * @param {Report["program"]} ready
 */
function unfold(draft, catalogue, ready) {
  const { cam } = draft;
  if (cam.generator === "mirror") {
    const top = breadthTravel(draft);
    draft.segments.push(...draft.segments.map((segment) => flipped(segment, top)));
  } else {
    const known = new Set(catalogue.laws.map(({ id }) => id));
    draft.segments = (ready ?? []).map(({ law, beta, rise }) => ({ law: known.has(law) ? law : "cycloidal", beta: clean(beta), rise: clean(rise) }));
    spread(Object.assign(draft, { cam: { ...cam, kind: "rotating" } }));
  }
  draft.cam = { kind: "rotating", rotation: cam.rotation ?? "counterclockwise", base_radius: cam.base_radius ?? 1 };
}

/**
 * A segment upside down.
 * @param {Segment} segment
 * @param {number} top
 * @returns {Segment}
 */
function flipped(segment, top) {
  const next = structuredClone(segment);
  if (next.rise) next.rise = -next.rise;
  for (const condition of next.conditions ?? []) condition.value = clean((condition.order === 0 ? top : 0) - condition.value);
  return next;
}

/** A turn laid out straight, long enough for its steepest segment. @param {Design} draft */
function straighten(draft) {
  const steepest = Math.max(...draft.segments.map((segment, index) => (GENTLE * Math.abs(heightAt(draft, index + 1) - heightAt(draft, index)) * wholeOf(draft)) / segment.beta));
  const length = roundUp(steepest > 0 ? steepest : 3 * (draft.cam.base_radius ?? 1));
  const turns = { rpm: 1 / 60, "rad/s": 1 / (2 * Math.PI), "rev/s": 1 }[draft.speed.unit] ?? 1;
  draft.speed = { value: Number((draft.speed.value * turns * length).toPrecision(2)), unit: `${draft.length_unit}/s` };
  centre(draft);
  draft.cam = { kind: "translating", length };
  spread(draft);
}

/** A cam that travels, bent round: there in half a turn and back in the other when it does not come back by itself. @param {Design} draft */
function bend(draft) {
  const { length = 1 } = draft.cam;
  const size = lift(draft);
  draft.speed = { value: Number(((2 * Math.PI * draft.speed.value) / length).toPrecision(2)), unit: "rad/s" };
  draft.cam = { kind: "rotating", rotation: "counterclockwise", base_radius: roundUp(Math.max(length / (2 * Math.PI), STOUT * size)) };
  if (openHeight(draft) !== 0) {
    const back = draft.segments.toReversed().map((segment) => ({ ...structuredClone(segment), rise: -(segment.rise ?? 0) }));
    // Data of a free law cannot be run backwards by a change of sign.
    draft.segments.push(...back.map((segment) => (segment.conditions ? { law: "cycloidal", beta: segment.beta, rise: 0 } : segment)));
    if (openHeight(draft) !== 0) draft.segments = [{ law: "cycloidal", beta: HALF, rise: size || 1 }, { law: "cycloidal", beta: HALF, rise: -(size || 1) }];
  }
  spread(draft);
}

/** Nothing off the axis. @param {Design} draft */
function centre(draft) {
  for (const key of ["eccentricity", "face_angle"]) if (key in draft.follower) draft.follower[key] = 0;
}

/**
 * The motion of a cam of constant breadth made another way.
 * @param {Design} draft
 * @param {NonNullable<Design["cam"]["generator"]>} generator
 * @param {Catalogue["polygons"][number]} polygon  for circular arcs
 */
export function changeGenerator(draft, generator, polygon) {
  const { cam } = draft;
  delete cam.sides;
  cam.generator = generator;
  draft.segments = [];
  const travel = breadthTravel(draft);
  if (generator === "mirror") {
    draft.segments = [{ law: "cycloidal", beta: 120, rise: travel }, { law: "dwell", beta: 60, rise: 0 }];
  } else if (generator === "circular-arc") {
    cam.sides = polygon.sides;
    // A base circle too small for the arcs grows, so that the corners are round.
    const breadth = cam.breadth ?? 1;
    const least = breadth * polygon.least;
    const round = least + ROUND_CORNERS * (0.5 * breadth - least);
    if ((cam.base_radius ?? 0) < round) cam.base_radius = Number(round.toPrecision(4));
  }
}

/** How far a polygon of arcs is from sharp corners to a circle, to begin with. */
const ROUND_CORNERS = 0.25;

/**
 * The next of 1, 1.5, 2, 2.5 … 10 times a power of ten.
 * @param {number} value
 */
function roundUp(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return clean((Math.ceil((value / power) * 2 - 1e-9) / 2) * power);
}
