/**
 * Designs that the page brings along: what is only looked at is not work to be kept.
 *
 * @import { Design } from "./types.d.ts"
 */

/** @type {Set<string>} */
const shelf = new Set();

/** @param {Design} design */
export function shelve(design) {
  shelf.add(JSON.stringify(design));
}

/** @param {string} text  a design as JSON */
export const isShelved = (text) => shelf.has(text);
