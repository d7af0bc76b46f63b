/**
 * The symbols in which the page speaks: ours, or those of the notation that the design is told in. The table comes with the report.
 *
 * @import { Report } from "./types.d.ts"
 */

/** @type {Record<string, string>} */
let symbols = {};
let spoken = "";

/** Symbols of ours that stand in sentences; single letters there would be words. */
const IN_SENTENCES = /(?<![\p{L}\d])(?:R[bfp]|[φρ]|s(?= m[aá]x))(?![\p{L}\d])/gu;

const PRIMES = "′″‴";

/** What stands for a symbol of ours, its index after "_". @param {string} ours */
export const sign = (ours) => symbols[ours.replace(/^([Rρ])([a-z])$/u, "$1_$2")] ?? ours;

/** The same on a line of plain text. @param {string} ours */
export const plain = (ours) => sign(ours).replace("_", "");

/** A sentence of ours in these symbols. @param {string} text */
export const say = (text) => (spoken ? text.replaceAll(IN_SENTENCES, plain) : text);

/** Letter and index of a symbol. @param {string} symbol */
export function parts(symbol) {
  const [, letter = symbol, index = ""] = /^(.)_?(\w*)$/u.exec(symbol) ?? [];
  return { letter, index };
}

/**
 * Speaks in the notation of a report from now on; true when that is another.
 * @param {Report["notation"]} notation
 */
export function speakIn(notation) {
  const next = notation ? JSON.stringify(notation.symbols) : "";
  if (next === spoken) return false;
  spoken = next;
  symbols = Object.fromEntries(Object.entries(notation?.symbols ?? {}).map(([ours, theirs]) => [ours, theirs.replace(/'+$/, (primes) => PRIMES[primes.length - 1] ?? primes)]));
  for (const node of document.querySelectorAll("[data-sign]")) /** @type {HTMLElement} */ (node).dispatchEvent(new Event("sign"));
  return true;
}

/** Changes with the notation. */
export const era = () => spoken;
