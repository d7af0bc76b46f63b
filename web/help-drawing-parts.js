/**
 * Parts that the dimensioned drawings of followers and kinds of cam share.
 *
 * @import { Point } from "./sketch.js"
 */
import { s } from "./dom.js";
import { arrow, circle, letter, lobe, polar, stroke } from "./sketch.js";

/** @typedef {Record<string, string>} Symbols  symbol by parameter key */

/**
 * @param {Symbols} symbols
 * @param {string} key
 * @param {SVGElement[]} strokes
 * @param {Point} at
 * @param {"start" | "middle" | "end"} [anchor]
 */
export function dimension(symbols, key, strokes, at, anchor) {
  const symbol = symbols[key];
  if (symbol === undefined) return s("g");
  return s("g", { "data-parameter": key, class: "dimension" }, ...strokes, letter(symbol, at, anchor));
}

/**
 * @param {Point} centre
 * @param {number} base
 * @param {number} about  direction of the lobe
 */
export function cam(centre, base, about) {
  return [stroke("cam", lobe(centre, base, 13, about)), circle("base-circle", centre, base), circle("hub", centre, 4)];
}

/**
 * @param {Symbols} symbols
 * @param {Point} centre
 * @param {number} base
 * @param {number} direction
 */
export function baseRadius(symbols, centre, base, direction) {
  const tip = polar(centre, base, direction);
  const label = polar(centre, base * 0.6, direction + 24);
  return dimension(symbols, "base_radius", arrow(centre, tip), { x: label.x, y: label.y + 4 });
}
