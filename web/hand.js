/**
 * A hand on a diagram: the value that lies under it, and the round steps that it goes by.
 *
 * @import { Row } from "./stage/overlay.js"
 */
import { exact } from "./numbers.js";

/** Pixels that a hand tells apart: a step is not finer than that, so that round numbers are easily hit. */
const APART = 4;

/** Steps of an angle, degrees. */
const ANGLES = [0.1, 0.5, 1, 5, 10, 15, 30];

/**
 * The inverse of `atValue`.
 * @param {Row} row
 * @param {number} py
 */
export const valueAt = ({ area, y }, py) => area.y_max - ((py - y - area.top) / area.height) * (area.y_max - area.y_min);

/**
 * @param {number} value
 * @param {number} step
 */
export const stepped = (value, step) => exact(Math.round(value / step) * step);

/**
 * Steps of θ and of heights that are easy to hit on a diagram.
 * @param {Row} row
 */
export function steps({ area }) {
  const theta = (APART * (area.x_max - area.x_min)) / area.width;
  return { theta: ANGLES.find((step) => step >= theta) ?? 45, s: round((APART * (area.y_max - area.y_min)) / area.height) };
}

/**
 * The least of 1, 2, 5, 10, … that is not below.
 * @param {number} least
 */
export function round(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return exact(power * ([1, 2, 5].find((digit) => digit * power >= least * (1 - 1e-9)) ?? 10));
}
