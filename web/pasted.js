/** Points that are pasted from a spreadsheet, a cam editor or a text: two numbers a line, with decimal points or commas. */
import { parseNumber } from "./numbers.js";

/**
 * Reads the points of a text. Comments, words behind the two numbers and lines of words are passed over.
 * @param {string} text
 * @returns {{ points: [number, number][], line?: undefined } | { line: number, points?: undefined }} the points, or the line that cannot be read, from 1
 */
export function pastedPoints(text) {
  /** @type {[number, number][]} */
  const points = [];
  /** The first line of words, which is at fault when no point follows. */
  let words = 0;
  for (const [index, whole] of text.split(/\r?\n/).entries()) {
    const line = whole.replace(/(\/\/|#).*$/, "").trim();
    if (line === "") continue;
    const numbers = columns(line).map((word) => parseNumber(word, "°").value);
    const [at, value, ...others] = numbers;
    if (at !== undefined && value !== undefined && others.every((other) => other === undefined)) points.push([at, value]);
    else if (/\d/.test(line) && (points.length > 0 || /^[\s\d.,;+−-]*$/.test(line))) return { line: index + 1 };
    else words ||= index + 1;
  }
  return points.length === 0 && words > 0 ? { line: words } : { points };
}

/** The columns of a line of a spreadsheet or a CSV file. @param {string} line */
function columns(line) {
  const cells = line.trim().split(/\s*[\t;]\s*|\s+/).filter(Boolean);
  // Commas part the columns where nothing else does: "12.5,3.25".
  return cells.length === 1 && cells[0] !== undefined ? cells[0].split(",") : cells.map((cell) => cell.replace(/,$/, ""));
}
