/**
 * Book-keeping of the motion program: what is left of the turn, and the one-click ways to complete it.
 *
 * @import { Design, LawEntry, Parameter, Segment } from "./types.d.ts"
 */
import { clean } from "./clean.js";
import { fitted, setBeta, setEnd, statedEnd } from "./free-data.js";

const TURN = 360;

/**
 * What the segments cover: a turn, half a turn that its image completes, or the length of a cam that travels.
 * @param {Readonly<Design>} design
 */
export function wholeOf({ cam }) {
  if (cam.kind === "translating") return cam.length ?? 0;
  return cam.kind === "constant-breadth" ? TURN / 2 : TURN;
}

/**
 * How far the follower of a cam of constant breadth travels: dc − 2Rb.
 * @param {Readonly<Design>} design
 */
export const breadthTravel = ({ cam }) => clean((cam.breadth ?? 0) - 2 * (cam.base_radius ?? 0));

/**
 * How far the program ends above where it should: the starting height, or the far side of a half turn. A cam that travels back
 * the same way may end anywhere.
 * @param {Readonly<Design>} design
 */
export function openHeight(design) {
  if (design.cam.kind === "translating") return 0;
  return clean(heightAt(design) - (design.cam.kind === "constant-breadth" ? breadthTravel(design) : 0));
}

/** @param {Segment} segment */
const riseOf = (segment) => segment.rise ?? 0;

/**
 * Height at which a segment ends that begins at `start`.
 * @param {number} start
 * @param {Segment} segment
 */
const endOf = (start, segment) => statedEnd(segment) ?? start + riseOf(segment);

/**
 * What is left of the whole, degrees or length.
 * @param {Readonly<Design>} design
 */
export function degreesLeft(design) {
  return clean(wholeOf(design) - design.segments.reduce((sum, segment) => sum + segment.beta, 0));
}

/**
 * Height above the base circle where segment `index` begins; without it, where the program ends.
 * @param {Readonly<Design>} design
 */
export function heightAt(design, index = design.segments.length) {
  return clean(design.segments.slice(0, index).reduce(endOf, 0));
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
  draft.segments.push({ ...(model ?? { law: "cycloidal" }), beta: degreesLeft(draft), rise: -openHeight(draft) });
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
  if (last) setBeta(last, clean(last.beta + degreesLeft(draft)));
}

/**
 * Every angle in proportion, in five figures of the whole, the last one taking the rounding.
 * @param {Design} draft
 */
export function spread(draft) {
  const parts = 10 ** (4 - Math.floor(Math.log10(wholeOf(draft))));
  const factor = wholeOf(draft) / (wholeOf(draft) - degreesLeft(draft));
  for (const segment of draft.segments) setBeta(segment, Math.round(segment.beta * factor * parts) / parts);
  stretchLast(draft);
}

/**
 * The last move ends at the starting height.
 * @param {Design} draft
 */
export function closeWithLastMove(draft) {
  const index = lastMove(draft);
  const last = draft.segments[index];
  if (!last) return;
  const end = clean(heightAt(draft, index + 1) - openHeight(draft));
  if (!setEnd(last, end)) last.rise = clean(end - heightAt(draft, index));
}

/** @param {Readonly<Design>} design */
export function lastMove(design) {
  return design.segments.findLastIndex((segment) => riseOf(segment) !== 0 || statedEnd(segment) !== undefined);
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
    draft.segments.splice(index, 0, dwell(left > 0 ? left : wholeOf(draft)));
    return;
  }
  const half = clean(giver.beta / 2);
  setBeta(giver, clean(giver.beta - half));
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
 * @param {Pick<LawEntry, "id" | "moves" | "free"> & { parameters: Pick<Parameter, "key" | "quantity" | "default">[] }} law
 */
export function changeLaw(draft, index, law) {
  const old = draft.segments[index];
  if (!old) return;
  /** @type {Segment} */
  const next = { law: law.id, beta: old.beta };
  const start = heightAt(draft, index);
  const kept = law.moves ? clean(endOf(start, old) - start) : 0;
  const rise = law.moves && kept === 0 ? likelyRise(draft, index) : kept;
  if (law.free) next[law.free.key] = old[law.free.key] ?? fitted(law.free.first, { beta: old.beta, start, rise });
  if (!law.free || law.free.key === "expression") next.rise = rise;
  for (const { key, quantity, default: first } of law.parameters) {
    const usual = first !== null && quantity === "span" ? clean(first * old.beta) : first;
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
  const open = openHeight(draft);
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
