/** Points that are pasted from a spreadsheet, a CSV file or a text: two numbers a line, with decimal points or commas. */
import { parseNumber } from "./numbers.js";

/**
 * Reads the points of a text; what heads the columns is passed over.
 * @param {string} text
 * @returns {{ points: [number, number][], line?: undefined } | { line: number, points?: undefined }} the points, or the line that cannot be read, from 1
 */
export function pastedPoints(text) {
  /** @type {[number, number][]} */
  const points = [];
  for (const [index, line] of text.split(/\r?\n/).entries()) {
    if (line.trim() === "") continue;
    const numbers = columns(line).map((word) => parseNumber(word, "°").value);
    const [at, value] = numbers;
    if (numbers.length === 2 && at !== undefined && value !== undefined) points.push([at, value]);
    // What heads a column is no point.
    else if (points.length > 0 || /^[\s\d.,;+−-]*$/.test(line)) return { line: index + 1 };
  }
  return { points };
}

/** The columns of a line of a spreadsheet or a CSV file. @param {string} line */
function columns(line) {
  const cells = line.trim().split(/\s*[\t;]\s*|\s+/).filter(Boolean);
  // Commas part the columns where nothing else does: "12.5,3.25".
  return cells.length === 1 && cells[0] !== undefined ? cells[0].split(",") : cells.map((cell) => cell.replace(/,$/, ""));
}
