/**
 * Numbers as people write them, read and shown: decimal comma or point, thin spaces, a true minus sign.
 *
 * @import { Format, Language } from "./types.d.ts"
 */

const MINUS = "\u2212";
/** Groups of three digits are parted by a narrow no-break space, from five whole digits on (ISO 80000-1). */
const GROUP = "\u202f";
const SUPERSCRIPT = "⁰¹²³⁴⁵⁶⁷⁸⁹";
const NOTHING = "–";

/** Digits that a number keeps when shown in its shortest form: beyond them lies the noise of a sum. */
const EXACT = 12;
/** Digits of a measured quantity. */
const SIGNIFICANT = 4;
/** Below and above these a number is written with a power of ten. */
const SMALL = 1e-4;
const LARGE = 1e7;
/** A number at rest has three figures at least, whatever the room; in use it shows all it has. */
const FIGURES = /^\D?[0.,]*(?:\d[.,]?){1,3}/;
/** What stands for the figures that are cut off, and how many of them its width takes. */
export const CUT = "…";
const CUT_WIDTH = 2;

/**
 * What can be wrong with a number: each has its sentence under `number.` in the strings.
 * @typedef {"empty" | "two-signs" | "exponent" | "huge" | "unreadable"} NumberProblem
 */

/** @typedef {{ value: number, problem?: undefined } | { problem: NumberProblem, value?: undefined }} Reading */

/**
 * Reads a number with decimal comma or point, spaces between digits, −, and the unit of its field behind it.
 * @param {string} text
 * @param {string} [unit]
 * @returns {Reading}
 */
export function parseNumber(text, unit = "") {
  let rest = text.normalize("NFKC").trim().replaceAll(/[\u2212\u2013\u2012]/g, "-");
  for (const ending of [unit, "°"]) {
    if (ending && rest.endsWith(ending)) rest = rest.slice(0, -ending.length).trim();
  }
  rest = rest.replaceAll(/(?<=\d)[\s'’](?=\d{3}(?!\d))/g, "");
  if (rest === "") return { problem: "empty" };
  if (/^[+-]?[\d.,]*[.,][\d]*[.,][\d.,]*(e.*)?$/i.test(rest)) return { problem: "two-signs" };
  if (/^[+-]?(\d+[.,]?\d*|[.,]\d+)e[+-]?$/i.test(rest)) return { problem: "exponent" };
  if (!/^[+-]?(\d+[.,]?\d*|[.,]\d+)(e[+-]?\d+)?$/i.test(rest)) return { problem: "unreadable" };
  const value = Number(rest.replace(",", "."));
  return Number.isFinite(value) ? { value } : { problem: "huge" };
}

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
 * @param {string} digits  plain decimal form with a point, no sign
 * @param {string} sign
 */
function group(digits, sign) {
  const [whole = "", fraction] = digits.split(".");
  const grouped = whole.length > 4 ? whole.replaceAll(/\B(?=(\d{3})+$)/g, GROUP) : whole;
  return fraction === undefined ? grouped : grouped + sign + fraction;
}

/**
 * @param {number} value
 * @param {number} digits  significant ones
 * @param {string} sign
 */
function powerOfTen(value, digits, sign) {
  const [mantissa = "", exponent = "0"] = value.toExponential(digits - 1).split("e");
  const power = [...String(Math.abs(Number(exponent)))].map((digit) => SUPERSCRIPT[Number(digit)]).join("");
  const factor = mantissa.includes(".") ? mantissa.replace(/\.?0+$/, "") : mantissa;
  return `${factor.replace(".", sign)}·10${Number(exponent) < 0 ? "⁻" : ""}${power}`;
}

/**
 * @param {number} value  not negative
 * @param {string} sign
 */
function shortest(value, sign) {
  const rounded = Number(value.toPrecision(EXACT));
  const text = String(rounded);
  return text.includes("e") ? powerOfTen(rounded, EXACT, sign) : group(text, sign);
}

/**
 * The same number for a field: no groups, nothing lost.
 * @param {number} value
 * @param {Language} language
 */
export function fieldText(value, language) {
  const text = String(value).replace("-", MINUS).replace("e" + MINUS, "e-");
  return language === "es" ? text.replace(".", ",") : text;
}

/**
 * A number as it stands in a field that nobody is in. One with more figures than there is room for is cut, and shows it: rounded, the
 * angles of a program would seem to add up to more than a turn.
 * @param {number} value
 * @param {number} room
 * @param {Language} language
 */
export function restingText(value, room, language) {
  const whole = fieldText(Number(value.toPrecision(EXACT)), language);
  const [mantissa = "", power = ""] = whole.split(/(?=e)/);
  const point = mantissa.search(/[.,]/);
  if (whole.length <= room || point < 0) return whole;
  const figures = FIGURES.exec(mantissa)?.[0].length ?? 0;
  const kept = Math.max(figures, point + 1, room - CUT_WIDTH - power.length);
  return kept + 1 >= mantissa.length ? whole : mantissa.slice(0, kept) + CUT + power;
}

/**
 * @param {() => Language} language
 * @returns {Format}
 */
export function createFormat(language) {
  const decimal = () => (language() === "es" ? "," : ".");

  /**
   * @param {number | null | undefined} value
   * @param {string | undefined} unit
   * @param {(size: number, sign: string) => string} write
   */
  function compose(value, unit, write) {
    if (value === null || value === undefined || Number.isNaN(value)) return NOTHING;
    const size = Math.abs(value);
    const text = size === Infinity ? "∞" : write(size, decimal());
    const minus = value < 0 && /[1-9∞]/.test(text) ? MINUS : "";
    if (!unit) return minus + text;
    return minus + text + (unit === "°" ? "" : "\u00a0") + unit;
  }

  return {
    number: (value, { digits, unit } = {}) =>
      compose(value, unit, (size, sign) => (digits === undefined ? shortest(size, sign) : group(size.toFixed(digits), sign))),

    angle: (value, digits = 1) => compose(value, "°", (size, sign) => group(size.toFixed(digits), sign)),

    quantity: (value, { trim = false, unit } = {}) =>
      compose(value, unit, (size, sign) => {
        if (size === 0) return "0";
        if (size < SMALL || size >= LARGE) return powerOfTen(size, SIGNIFICANT, sign);
        const whole = Math.floor(Math.log10(Number(size.toPrecision(SIGNIFICANT)))) + 1;
        const text = size.toFixed(Math.max(0, SIGNIFICANT - Math.max(whole, size < 1 ? whole : 1)));
        return group(trim && text.includes(".") ? text.replace(/\.?0+$/, "") : text, sign);
      }),
  };
}
