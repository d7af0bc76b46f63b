/** What the machine must do, as it is typed and as numbers: dwells, straight lines and points. */
import { round, stepped } from "../hand.js";
import { exact, parseNumber, sum } from "../numbers.js";

/** The fields of each kind of requirement, by the columns of the table. */
export const KINDS = /** @type {const} */ ({ dwell: ["from", "to", "s"], line: ["from", "to", "s", "end"], point: ["from", "s", "v"] });
/** @typedef {keyof typeof KINDS} Kind */
/** @typedef {"from" | "to" | "s" | "end" | "v"} Field */
/** @typedef {{ kind: Kind } & Partial<Record<Field, string>>} Demand  as it is typed */
/** @typedef {Partial<Record<Field, number>>} Values  as numbers */
/** @typedef {{ kind: Kind, from: number, to: number, s: number, end: number, v?: number | undefined }} Placed  with all that its kind asks for; a point ends where it begins */
/** @typedef {"whole" | "from" | "to"} Part  of a requirement that is moved */

export const TURN = 360;
/** A velocity is per radian. */
export const RADIAN = 180 / Math.PI;
/** What a new requirement is wide when nothing else is told, degrees. */
const WIDE = 30;

/** @param {Demand} demand @param {Field} field */
const number = (demand, field) => parseNumber(demand[field] ?? "", "°").value;

/**
 * Where a requirement stands; none while one of its numbers is missing.
 * @param {Demand} demand
 * @returns {Placed | undefined}
 */
export function placed(demand) {
  const { kind } = demand;
  const [from, s] = [number(demand, "from"), number(demand, "s")];
  const to = kind === "point" ? from : number(demand, "to");
  const end = kind === "line" ? number(demand, "end") : s;
  if (from === undefined || to === undefined || s === undefined || end === undefined) return undefined;
  return { kind, from, to, s, end, v: kind === "point" ? number(demand, "v") : undefined };
}

/**
 * The requirements as the engine reads them, or the first that lacks a number.
 * @param {readonly Demand[]} demands
 */
export function asked(demands) {
  const all = demands.map((demand) => {
    const place = placed(demand);
    const free = demand.kind !== "point" || (demand.v ?? "").trim() === "";
    if (!place || (!free && place.v === undefined)) return undefined;
    const { kind, from, to, s, end, v } = place;
    if (kind === "dwell") return { dwell: [from, to], s };
    if (kind === "line") return { line: [from, to], s: [s, end] };
    return free ? { at: from, s } : { at: from, s, v };
  });
  const bad = all.indexOf(undefined);
  return bad < 0 ? { all } : { bad };
}

/**
 * What becomes of a requirement when a part of it is brought to θ and a height, in whole steps: its beginning for the whole of it. It stays
 * within the turn, above the base circle, and a step wide.
 * @param {Placed} place
 * @param {Part} part
 * @param {{ theta: number, s: number }} to
 * @param {{ theta: number, s: number }} steps
 * @returns {Values}
 */
export function moved(place, part, to, steps) {
  const theta = stepped(to.theta, steps.theta);
  const height = stepped(to.s, steps.s);
  const straight = place.kind === "line";
  if (part === "from") {
    const from = within(theta, 0, place.to - steps.theta);
    return straight ? { from, s: Math.max(0, height) } : { from };
  }
  if (part === "to") {
    const end = within(theta, place.from + steps.theta, TURN);
    return straight ? { to: end, end: Math.max(0, height) } : { to: end };
  }
  const [wide, high] = [place.to - place.from, place.end - place.s];
  const from = within(theta, 0, TURN - wide);
  const s = Math.max(height, -high, 0);
  if (place.kind === "point") return { from, s };
  return { from, to: sum(from, wide), s, ...(straight ? { end: sum(s, high) } : {}) };
}

/**
 * The velocity of a point whose tangent is turned to a place: the further away, the finer. Nothing where the tangent would stand upright.
 * @param {Placed} place
 * @param {{ theta: number, s: number }} to
 * @param {{ theta: number, s: number }} steps
 * @returns {Values}
 */
export function turned(place, to, steps) {
  const across = (to.theta - place.from) / RADIAN;
  if (Math.abs(across) < steps.theta / RADIAN) return {};
  return { v: stepped((to.s - place.s) / across, round(steps.s / Math.abs(across))) };
}

/**
 * What is drawn from one place to another.
 * @param {Kind} kind
 * @param {{ theta: number, s: number }} start
 * @param {{ theta: number, s: number }} end
 * @returns {Values}
 */
export function drawn(kind, start, end) {
  if (kind === "point") return { from: end.theta, s: end.s };
  const [left, right] = start.theta <= end.theta ? [start, end] : [end, start];
  return kind === "dwell" ? { from: left.theta, to: right.theta, s: start.s } : { from: left.theta, to: right.theta, s: left.s, end: right.s };
}

/**
 * A new requirement where there is most room, to be moved or typed over.
 * @param {Kind} kind
 * @param {readonly Placed[]} others
 * @param {number} height  when there is no other to go by
 * @returns {Values}
 */
export function suggested(kind, others, height) {
  const { from, to } = widestGap(others);
  const middle = Math.round((from + to) / 2);
  const top = Math.max(...others.flatMap(({ s, end }) => [s, end]), 0) || height;
  if (kind === "point") return { from: middle, s: top };
  const half = Math.min(WIDE / 2, Math.max(1, Math.floor((to - from) / 4)));
  const ends = { from: middle - half, to: middle + half };
  return kind === "dwell" ? { ...ends, s: top } : { ...ends, s: exact(top / 4), end: exact((3 * top) / 4) };
}

/**
 * What another kind makes of the numbers of a requirement, so that it stays where it is.
 * @param {Placed} place
 * @param {Kind} kind
 * @returns {Values}
 */
export function turnedInto({ from, to, s, end, v }, kind) {
  if (kind === "point") return { from, s, ...(v === undefined ? {} : { v }) };
  const until = to > from ? to : Math.min(TURN, from + WIDE);
  return { from, to: until, s, ...(kind === "line" ? { end } : {}) };
}

/** @param {readonly Placed[]} others */
function widestGap(others) {
  let [best, last] = [{ from: 0, to: 0 }, 0];
  for (const { from, to } of [...others].sort((one, other) => one.from - other.from).concat({ kind: "point", from: TURN, to: TURN, s: 0, end: 0 })) {
    if (from - last > best.to - best.from) best = { from: last, to: from };
    last = Math.max(last, to);
  }
  return best;
}

/** @param {number} value @param {number} least @param {number} most */
const within = (value, least, most) => exact(Math.max(least, Math.min(value, most)));
