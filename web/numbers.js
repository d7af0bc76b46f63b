/**
 * Numbers of fields and readouts. The calculation reads and writes them, as it does in sentences and diagrams; here they get their units.
 *
 * @import { Format, Language, NumberReading } from "./types.d.ts"
 */

/** @typedef {Pick<import("./engine.js").Module, "NumberForm" | "read_number" | "write_number">} Numbers */

const NOTHING = "–";

/** Digits that a number keeps: beyond them lies the noise of a sum. */
const EXACT = 12;

/** What stands for the figures of a field at rest that are cut off. */
export const CUT = "…";

/** @type {() => Numbers} */
let calculation = () => {
  throw new Error("no number is read or written before the calculation has started");
};

/**
 * Names the module that reads and writes.
 * @param {() => Numbers} module  asked for before each use, since a panic replaces it
 */
export function connectNumbers(module) {
  calculation = module;
}

/**
 * Reads a number: digits or a calculation, with or without a unit; the value is in the unit of the field.
 * @param {string} text
 * @param {string} [unit]  that of the field
 * @param {Language} [language]  of the sentence about a text that is no number
 * @returns {NumberReading}
 */
export const parseNumber = (text, unit = "", language = "en") => calculation().read_number(text, unit, language);

/**
 * A number without the noise that sums of typed decimals carry.
 * @param {number} value
 */
export const exact = (value) => Number(value.toPrecision(EXACT)) + 0;

/**
 * A sum of decimals as it is on paper.
 * @param {number} one
 * @param {number} other
 */
export function sum(one, other) {
  const total = one + other;
  return Math.abs(total) < Math.max(Math.abs(one), Math.abs(other)) * 10 ** -EXACT ? 0 : exact(total);
}

/**
 * A number for a field that is being edited: no groups, nothing lost.
 * @param {number} value
 * @param {Language} language
 */
export const fieldText = (value, language) => written(value, "Editable", 0, language);

/**
 * A number as it stands in a field that nobody is in. One with more figures than there is room for is cut, and shows it.
 * @param {number} value
 * @param {number} room
 * @param {Language} language
 */
export const restingText = (value, room, language) => written(value, "AtRest", room, language);

/**
 * @param {number} value
 * @param {keyof Numbers["NumberForm"]} form
 * @param {number} digits
 * @param {Language} language
 */
function written(value, form, digits, language) {
  const { NumberForm, write_number } = calculation();
  return write_number(value, NumberForm[form], digits, language);
}

/**
 * @param {() => Language} language
 * @returns {Format}
 */
export function createFormat(language) {
  /**
   * @param {number | null | undefined} value
   * @param {string | undefined} unit
   * @param {keyof Numbers["NumberForm"]} form
   */
  function compose(value, unit, form, digits = 0) {
    if (value === null || value === undefined || Number.isNaN(value)) return NOTHING;
    const text = written(value, form, digits, language());
    return unit ? text + (unit === "°" ? "" : "\u00a0") + unit : text;
  }

  return {
    number: (value, { digits, unit } = {}) => compose(value, unit, digits === undefined ? "Exact" : "Fixed", digits),
    angle: (value, digits = 1) => compose(value, "°", "Fixed", digits),
    quantity: (value, { trim = false, unit } = {}) => compose(value, unit, trim ? "Measured" : "MeasuredWhole"),
  };
}
