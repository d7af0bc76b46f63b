/**
 * Cells that the tables of the comparison share: figures by their place in what the engine tells, verdicts with sign and word.
 *
 * @import { Format, Level, Translate } from "../types.d.ts"
 */
import { h, s } from "../dom.js";
import { SHAPES } from "../verdict.js";
import { plain } from "../signs.js";

/** Places in the engine's figures. */
export const FIGURES = Object.freeze({ level: 0, lift: 1, v: 2, a: 3, j: 4, V: 5, A: 6, J: 7, least: 8, greatest: 9, steepest: 10, rho: 11, face: 12 });

/** @type {readonly Level[]} */
export const LEVELS = ["acceptable", "low-speed", "unacceptable"];

/** @param {Translate} t @param {number} level */
export function verdict(t, level) {
  const name = LEVELS[level] ?? "unacceptable";
  const [shape, mark] = SHAPES[name];
  const sign = s("svg", { viewBox: "0 0 24 24", class: "light", "aria-hidden": "true" }, s("path", { class: "shape", d: shape }), s("path", { class: "mark", d: mark }));
  return h("span", { class: "compare-verdict", "data-level": name }, sign, t(`compare.level.${name}`));
}

/** A quantity's letter, between bars when it is a peak. @param {string} letter @param {string} token @param {boolean} [peak] */
export function letter(letter, token, peak = false) {
  const node = h("i", { class: "symbol" }, plain(letter));
  node.style.color = `var(--${token})`;
  return h("span", { class: "compare-letter" }, peak ? "|" : "", node, peak ? "|" : "");
}

/** @param {Format} format @param {number | undefined} value @param {string} [unit] */
export const quantity = (format, value, unit) => format.quantity(value, { trim: true, ...(unit ? { unit } : {}) });
