/**
 * Book-keeping of the motion program: what is left of the turn, and the one-click ways to complete it.
 *
 * @import { Design, Segment } from "./types.d.ts"
 */

const TURN = 360;

/** Sums of typed decimals carry a noise of some 1e-14; twelve digits tell a real difference from it. */
const DIGITS = 12;

/** Differences below this are that noise, not something left to do. */
const NOISE = 1e-9;

/** @param {number} value */
export function clean(value) {
  const rounded = Number(value.toPrecision(DIGITS));
  return Math.abs(rounded) < NOISE ? 0 : rounded;
}

/** @param {Segment} segment */
const riseOf = (segment) => segment.rise ?? 0;

/** @param {Design} design */
export function degreesLeft(design) {
  return clean(TURN - design.segments.reduce((sum, segment) => sum + segment.beta, 0));
}

/**
 * Height above the base circle where segment `index` begins; without it, where the program ends.
 * @param {Design} design
 */
export function heightAt(design, index = design.segments.length) {
  return clean(design.segments.slice(0, index).reduce((sum, segment) => sum + riseOf(segment), 0));
}

/** @param {Design} design */
export function lift(design) {
  return Math.max(...design.segments.map((_, index) => heightAt(design, index)));
}

/**
 * @param {number} beta
 * @returns {Segment}
 */
const dwell = (beta) => ({ law: "dwell", beta, rise: 0 });

/**
 * Completes the turn with a dwell.
 * @param {Design} draft
 */
export function fillWithDwell(draft) {
  draft.segments.push(dwell(degreesLeft(draft)));
}

/**
 * Completes the turn with a move back to the starting height, by the law used last.
 * @param {Design} draft
 */
export function fillWithReturn(draft) {
  const model = draft.segments.findLast((segment) => riseOf(segment) !== 0);
  draft.segments.push({ ...(model ?? { law: "cycloidal" }), beta: degreesLeft(draft), rise: -heightAt(draft) });
}

/** @param {Design} draft */
export function canStretchLast(draft) {
  const last = draft.segments.at(-1);
  return last !== undefined && last.beta + degreesLeft(draft) > 0;
}

/**
 * The last segment takes what is left of the turn, or gives back what is beyond it.
 * @param {Design} draft
 */
export function stretchLast(draft) {
  const last = draft.segments.at(-1);
  if (last) last.beta = clean(last.beta + degreesLeft(draft));
}

/**
 * Every angle in proportion, the last one taking the rounding.
 * @param {Design} draft
 */
export function spread(draft) {
  const factor = TURN / (TURN - degreesLeft(draft));
  for (const segment of draft.segments) segment.beta = Math.round(segment.beta * factor * 100) / 100;
  stretchLast(draft);
}

/**
 * The last move ends at the starting height.
 * @param {Design} draft
 */
export function closeWithLastMove(draft) {
  const last = draft.segments.findLast((segment) => riseOf(segment) !== 0);
  if (last) last.rise = clean(riseOf(last) - heightAt(draft));
}

/**
 * A dwell before segment `index`. It takes what is left of the turn, or else half of its neighbour, so that a good cam stays one.
 * @param {Design} draft
 * @param {number} index
 * @param {number} neighbour
 */
export function insert(draft, index, neighbour) {
  const left = degreesLeft(draft);
  const giver = draft.segments[neighbour];
  if (left > 0 || !giver) {
    draft.segments.splice(index, 0, dwell(left > 0 ? left : TURN));
    return;
  }
  const half = clean(giver.beta / 2);
  giver.beta = clean(giver.beta - half);
  draft.segments.splice(index, 0, dwell(half));
}

/**
 * @param {Design} draft
 * @param {number} index
 */
export function duplicate(draft, index) {
  const segment = draft.segments[index];
  if (segment) draft.segments.splice(index, 0, structuredClone(segment));
}

/**
 * @param {Design} draft
 * @param {number} from
 * @param {number} to
 */
export function move(draft, from, to) {
  const [segment] = draft.segments.splice(from, 1);
  if (segment) draft.segments.splice(to, 0, segment);
}

/**
 * @param {Design} draft
 * @param {number} index
 */
export function remove(draft, index) {
  draft.segments.splice(index, 1);
}

/**
 * Another law for a segment. One that moves and had no rise gets the one that closes the program, or else goes up as
 * high as the program does, or down from there.
 * @param {Design} draft
 * @param {number} index
 * @param {{ id: string, moves: boolean, parameters: { key: string, default: number | null }[] }} law
 */
export function changeLaw(draft, index, law) {
  const old = draft.segments[index];
  if (!old) return;
  /** @type {Segment} */
  const next = { law: law.id, beta: old.beta, rise: law.moves ? riseOf(old) : 0 };
  if (law.moves && next.rise === 0) next.rise = likelyRise(draft, index);
  for (const { key, default: usual } of law.parameters) {
    const value = old[key] ?? usual;
    if (value !== null) next[key] = value;
  }
  draft.segments[index] = next;
}

/**
 * @param {Design} draft
 * @param {number} index
 */
function likelyRise(draft, index) {
  const open = heightAt(draft);
  if (open !== 0) return -open;
  const here = heightAt(draft, index);
  return here > 0 ? -here : lift(draft) || 10;
}

/**
 * Applies the edits of a cure.
 * @param {Design} draft
 * @param {{ path: (string | number)[], value: unknown }[]} edits
 */
export function applyEdits(draft, edits) {
  for (const { path, value } of edits) {
    /** @type {any} */
    let place = draft;
    for (const key of path.slice(0, -1)) place = place[key];
    const key = path.at(-1);
    if (key === undefined) continue;
    if (value === undefined) delete place[key];
    else place[key] = value;
  }
}
