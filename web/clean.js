/** Sums of decimals as they are on paper. */

/** Sums of typed decimals carry a noise of some 1e-14; twelve digits tell a real difference from it. */
const DIGITS = 12;

/** Differences below this are that noise, not something left to do. */
const NOISE = 1e-9;

/** @param {number} value */
export function clean(value) {
  const rounded = Number(value.toPrecision(DIGITS));
  return Math.abs(rounded) < NOISE ? 0 : rounded;
}
