/** How pinned designs look in diagrams, mechanism and tables: every one has a colour and a dash of its own. */
import { s } from "../dom.js";
import { readColour } from "../stage/palette.js";

const DASHES = [[7, 2.5], [2, 2], [12, 3, 2, 3], [5, 2, 1.5, 2, 1.5, 2], [16, 2.5], [3, 4]];

/** So many can be told apart: each colour comes with two dashes. */
export const LOOKS = 2 * DASHES.length;

/** @param {number} look */
const dashOf = (look) => /** @type {number[]} */ (DASHES[(look + (look < DASHES.length ? 0 : 3)) % DASHES.length]);

/** @param {number} look */
const tokenOf = (look) => `look-${(look % DASHES.length) + 1}`;

/**
 * Colour, as canvases need it, and dashes.
 * @param {number} look
 */
export function readLook(look) {
  return { colour: readColour(tokenOf(look)), dash: dashOf(look) };
}

/** A sample of the line. @param {number} look */
export function sample(look) {
  const line = s("path", { d: "M1 4H41", "stroke-dasharray": dashOf(look).join(" ") });
  line.style.stroke = `var(--${tokenOf(look)})`;
  return s("svg", { class: "compare-sample", viewBox: "0 0 42 8", "aria-hidden": "true" }, line);
}
