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

/**
 * A design that the page brings along, by its name in the language on screen.
 * @param {Design} design
 * @param {import("./types.d.ts").Translate} t
 */
export const named = (design, t) => ({ ...design, title: design.title?.replace(/^Example\b/, t("app.example")) });

/** @param {string} text  a design as JSON */
export const isShelved = (text) => shelf.has(text);
