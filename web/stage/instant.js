/**
 * What the engine tells of one instant, asked once a frame for all who draw it.
 *
 * @import { Context, Lab, Report, Store } from "../types.d.ts"
 */

/** Places in the engine's array. Fixed frame: origin at the cam's centre, y up, follower on top. */
export const AT = Object.freeze({
  s: 0, v: 1, a: 2, j: 3,
  pressureAngle: 4, rho: 5, rhoPitch: 6, contact: 7, sliding: 8,
  contactX: 9, contactY: 10, traceX: 11, traceY: 12, normalX: 13, normalY: 14, centreX: 15, centreY: 16,
  segment: 17, V: 18, A: 19, J: 20, t: 21, slidingTimed: 22,
});

const LENGTH = 23;

/** @returns {Float64Array} */
export const newInstant = () => new Float64Array(LENGTH);

/**
 * A number of an array at a place that it is known to have.
 * @param {Float64Array} at
 * @param {number} place
 */
export const value = (at, place) => /** @type {number} */ (at[place]);

/** @typedef {{ values: Float64Array, cursor: number, report: Report | null, lab: Lab | null }} Kept  of each cam of a pair */

/** @type {WeakMap<Store, [Kept, Kept]>} */
const shared = new WeakMap();

/**
 * The values at the cursor. The array is shared: read it, do not keep it.
 * @param {Context} context
 * @param {boolean} [second]  of the second cam of a pair
 */
export function instant({ store, lab }, second = false) {
  let both = shared.get(store);
  if (!both) shared.set(store, (both = [unknown(), unknown()]));
  const kept = both[second ? 1 : 0];
  const { cursor, report } = store.state;
  const engine = lab();
  if (kept.cursor !== cursor || kept.report !== report || kept.lab !== engine) {
    engine.at(cursor, kept.values, second);
    kept.cursor = cursor;
    kept.report = report;
    kept.lab = engine;
  }
  return kept.values;
}

/** @returns {Kept} */
function unknown() {
  return { values: newInstant(), cursor: NaN, report: null, lab: null };
}
