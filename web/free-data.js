/**
 * Book-keeping of the data that free laws are made from: where they end, and how they follow when their segment is stretched.
 *
 * @import { Conditions, Segment } from "./types.d.ts"
 */
import { clean } from "./clean.js";

/** Parameters that are parts of β. */
const PART = /^beta\d$/;

/**
 * The height at which the data of a segment say that it ends.
 * @param {Readonly<Segment>} segment
 */
export function statedEnd({ beta, conditions }) {
  return conditions?.find(({ at, order }) => order === 0 && at === beta)?.value;
}

/**
 * Makes the data of a segment end at a height; false when it has none.
 * @param {Segment} segment
 * @param {number} height
 */
export function setEnd({ beta, conditions }, height) {
  if (!conditions) return false;
  const end = conditions.find(({ at, order }) => order === 0 && at === beta);
  if (end) end.value = height;
  else conditions.push({ at: beta, order: 0, value: height });
  return true;
}

/**
 * Another β for a segment: what lies within it keeps its place in proportion.
 * @param {Segment} segment
 * @param {number} beta
 */
export function setBeta(segment, beta) {
  const { beta: old, conditions } = segment;
  segment.beta = beta;
  for (const [key, value] of Object.entries(segment)) if (PART.test(key) && typeof value === "number") segment[key] = clean((value * beta) / old);
  for (const condition of conditions ?? []) condition.at = condition.at === old ? beta : clean((condition.at * beta) / old);
}

/**
 * Heights of a segment multiplied, derivatives as well.
 * @param {Segment} segment
 * @param {number} factor
 */
export function scaleHeights({ conditions }, factor) {
  for (const condition of conditions ?? []) condition.value = clean(condition.value * factor);
}

/**
 * The data that a law starts with, made for β = 1 from 0 to 1, fitted into a segment.
 * @param {Readonly<Conditions>} first
 * @param {{ beta: number, start: number, rise: number }} span
 * @returns {Conditions}
 */
export function fitted(first, { beta, start, rise }) {
  return first.map(({ at, order, value }) => ({ at: at === 1 ? beta : clean(at * beta), order, value: order === 0 ? clean(start + rise * value) : value }));
}
