/** The sheet of paper that the report is laid out on: its measures, its tables, its sections. */
import { h } from "../../dom.js";

/** What the cam may take of an A4 page, mm: the width between its margins, and the height that design and program leave. */
export const ROOM = 186;
export const TALL = 270;

/** CSS pixels to a millimetre. */
export const PIXELS = 96 / 25.4;

/** Height of the name of a diagram, mm. */
export const NAME = 5;

/** Height of a line of a narrow table, mm. */
export const NARROW = 3.4;

/** What marks a letter as one of the second cam. */
export const SECOND = "₂";

/**
 * @param {string} title
 * @param {...Node} children
 */
export const section = (title, ...children) => h("section", {}, h("h2", {}, title), ...children);

/**
 * @param {string[]} head
 * @param {string[][]} rows
 * @param {string} name
 */
export function grid(head, rows, name) {
  return h(
    "table",
    { class: name },
    h("thead", {}, h("tr", {}, ...head.map((text) => h("th", { scope: "col" }, text)))),
    h("tbody", {}, ...rows.map((row) => h("tr", {}, ...row.map((text) => h("td", {}, text))))),
  );
}

/** A length by a length has no unit. @param {string} unit */
export const inBrackets = (unit) => (unit ? ` (${unit})` : "");
