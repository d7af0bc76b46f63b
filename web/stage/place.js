/**
 * Places of the cursor as they are told (θ in degrees, or x in length), and which cam of a pair is in sight.
 *
 * @import { Format, Report, State } from "../types.d.ts"
 */

/** @param {Report} report */
export const letterOf = ({ travels }) => (travels ? "x" : "θ");

/** @param {Report} report */
export const unitOfPlace = ({ travels, units }) => (travels ? units.length : "°");

/**
 * @param {Format} format
 * @param {Report} report
 * @param {number} place
 * @param {number} [digits]
 */
export const placeText = (format, { travels, units }, place, digits) =>
  travels ? (digits === undefined ? format.quantity(place, { trim: true, unit: units.length }) : format.number(place, { digits, unit: units.length })) : format.angle(place, digits);

/**
 * A place told by a finding, within the cycle.
 * @param {Report} report
 * @param {number} place
 */
export const placeIn = ({ travels, span }, place) => (travels ? Math.min(Math.max(place, 0), span) : ((place % 360) + 360) % 360);

/**
 * The cam that diagrams and readings are about.
 * @param {Readonly<State>} state
 */
export const inSight = ({ report, second }) => (second && report.conjugate ? report.conjugate : report);

/**
 * Whether that is the second cam of a pair.
 * @param {Readonly<State>} state
 */
export const seesSecond = ({ report, second }) => second && report.conjugate !== null;

/**
 * The cam that the headline is about, and its number if there are two: the one in sight when the headline is about both.
 * @param {Readonly<State>} state
 * @returns {{ report: Report, cam: number | undefined }}
 */
export function headlined(state) {
  const { verdict, conjugate } = state.report;
  if (!conjugate) return { report: state.report, cam: undefined };
  const cam = verdict.cam ?? (seesSecond(state) ? 2 : 1);
  return { report: cam === 2 ? conjugate : state.report, cam };
}
