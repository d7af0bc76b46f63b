/** A figure that is told and not kept: four decimals of it. */

/** @param {number} value */
export const rounded = (value) => Math.round(value * 1e4) / 1e4;
