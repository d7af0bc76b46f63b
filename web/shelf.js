/**
 * Designs that the page brings along: what is only looked at is not work to be kept, and goes by a name in the language on screen.
 *
 * @import { Design, Translate } from "./types.d.ts"
 */

/** What each was brought along as, and its name where that is a word: by what it is on screen. @type {Map<string, { design: Design, name: string }>} */
const shelf = new Map();

/** The same as objects: a design that came by a link or a file may look the same, and is somebody's own. @type {WeakSet<Readonly<Design>>} */
const brought = new WeakSet();

/**
 * The design as it is put on screen.
 * @param {Design} design
 * @param {Translate} t
 * @param {string} [name]  key of its title; without one, its own says that it is an example
 */
export function shelve(design, t, name = "") {
  const shown = { ...design, title: name ? t(name) : design.title?.replace(/^Example\b/, t("app.example")) };
  shelf.set(JSON.stringify(shown), { design, name });
  brought.add(shown);
  return shown;
}

/**
 * A design by its title in the language on screen, as long as it is just what was brought along.
 * @param {Design} design
 * @param {Translate} t
 */
export function retitled(design, t) {
  const known = shelf.get(JSON.stringify(design));
  return known ? shelve(known.design, t, known.name) : design;
}

/** @param {string} text  a design as JSON */
export const isShelved = (text) => shelf.has(text);

/** Whether a design is on screen because the page brought it along. @param {Readonly<Design>} design */
export const isBrought = (design) => brought.has(design);
