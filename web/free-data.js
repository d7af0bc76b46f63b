/**
 * Book-keeping of the data that free laws are made from: where they end, and how they follow when their segment is stretched.
 *
 * @import { FreeData, Segment } from "./types.d.ts"
 */
import { clean } from "./clean.js";

/** Parameters that are parts of β. */
const PART = /^beta\d$/;

/**
 * The height at which the data of a segment say that it ends; that of a formula only the engine knows.
 * @param {Readonly<Segment>} segment
 */
export function statedEnd({ beta, conditions, points, ordinates }) {
  return conditions?.find(({ at, order }) => order === 0 && at === beta)?.value ?? points?.at(-1)?.[1] ?? ordinates?.at(-1);
}

/**
 * Makes the data of a segment end at a height; false when it has none that can.
 * @param {Segment} segment
 * @param {number} height
 */
export function setEnd({ beta, conditions, points, ordinates }, height) {
  const end = conditions?.find(({ at, order }) => order === 0 && at === beta);
  const last = points?.at(-1);
  if (end) end.value = height;
  else if (last) last[1] = height;
  else if (ordinates?.length) ordinates[ordinates.length - 1] = height;
  else conditions?.push({ at: beta, order: 0, value: height });
  return Boolean(conditions ?? points ?? ordinates);
}

/**
 * Another β for a segment: what lies within it keeps its place in proportion.
 * @param {Segment} segment
 * @param {number} beta
 */
export function setBeta(segment, beta) {
  const { beta: old, conditions, knots, points } = segment;
  /** @param {number} at */
  const along = (at) => (at === old ? beta : clean((at * beta) / old));
  segment.beta = beta;
  for (const [key, value] of Object.entries(segment)) if (PART.test(key) && typeof value === "number") segment[key] = along(value);
  for (const condition of conditions ?? []) condition.at = along(condition.at);
  if (knots) segment.knots = knots.map(along);
  for (const point of points ?? []) point[0] = along(point[0]);
}

/**
 * Heights of a segment multiplied, derivatives as well.
 * @param {Segment} segment
 * @param {number} factor
 */
export function scaleHeights(segment, factor) {
  for (const condition of segment.conditions ?? []) condition.value = clean(condition.value * factor);
  for (const point of segment.points ?? []) point[1] = clean(point[1] * factor);
  if (typeof segment["smoothing"] === "number") segment["smoothing"] = clean(segment["smoothing"] * Math.abs(factor));
  if (segment.ordinates) segment.ordinates = segment.ordinates.map((height) => clean(height * factor));
}

/**
 * The data that a law starts with, made for β = 1 from 0 to 1, fitted into a segment.
 * @param {Readonly<FreeData>} first
 * @param {{ beta: number, start: number, rise: number }} span
 * @returns {FreeData}
 */
export function fitted(first, { beta, start, rise }) {
  if (typeof first === "string") return first;
  /** @param {number} value */
  const height = (value) => clean(start + rise * value);
  /** @param {number} at */
  const place = (at) => (at === 1 ? beta : clean(at * beta));
  return /** @type {FreeData} */ (
    first.map((item) => {
      if (typeof item === "number") return height(item);
      if (Array.isArray(item)) return [place(item[0]), height(item[1])];
      return { at: place(item.at), order: item.order, value: item.order === 0 ? height(item.value) : item.value };
    })
  );
}
