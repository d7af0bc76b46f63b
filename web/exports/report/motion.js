/**
 * The table of the motion and the profile on paper.
 *
 * @import { ColumnName, ShellContext } from "../../types.d.ts"
 */
import { plain } from "../../signs.js";
import { SECOND, grid, inBrackets } from "./paper.js";

/** @type {ColumnName[]} */
const COLUMNS = ["s", "v", "a", "j", "pressure_angle", "rho", "x", "y"];
/** Those of the second cam of a pair: its derivatives are those of the first with the other sign. @type {ColumnName[]} */
const SECOND_COLUMNS = ["s", "pressure_angle", "rho", "x", "y"];
/**
 * @param {ShellContext} context
 * @param {number} step
 */
export function motion({ store, lab, format }, step) {
  const { units, conjugate } = store.state.report;
  const theta = lab().column("theta");
  /** @param {ColumnName[]} names @param {boolean} second */
  const columnsOf = (names, second) => names.map((name) => ({ name, second, values: lab().column(name, second) })).filter(({ values }) => values.length > 0);
  const columns = [...columnsOf(COLUMNS, false), ...(conjugate ? columnsOf(SECOND_COLUMNS, true) : [])];
  const every = Math.max(1, Math.round(((theta.length - 1) * step) / 360));
  const unit = { s: units.s, v: units.v, a: units.a, j: units.j, pressure_angle: "°", rho: units.length, x: units.length, y: units.length };
  const letter = { s: "s", v: "v", a: "a", j: "j", pressure_angle: "φ", rho: "ρ", x: "x", y: "y" };
  const { report } = store.state;
  const head = [report.travels ? `x (${units.length})` : "θ", ...columns.map(({ name, second }) => `${["x", "y"].includes(name) ? name : plain(letter[/** @type {keyof typeof letter} */ (name)])}${second ? SECOND : ""}${inBrackets(unit[/** @type {keyof typeof unit} */ (name)])}`)];
  const rows = [];
  for (let i = 0; i < theta.length; i += every) {
    rows.push([report.travels ? format.quantity(theta[i], { trim: true }) : format.number(theta[i], { unit: "°" }), ...columns.map(({ values }) => format.quantity(tidy(values, i), { trim: true }))]);
  }
  return grid(head, rows, conjugate ? "motion wide" : "motion");
}

/** What is nothing beside the rest of its column is zero, and not the rounding that is left. @param {Float64Array} values @param {number} i */
function tidy(values, i) {
  const value = /** @type {number} */ (values[i]);
  const greatest = values.reduce((most, other) => (Number.isFinite(other) ? Math.max(most, Math.abs(other)) : most), 0);
  return Math.abs(value) < 1e-12 * greatest ? 0 : value;
}
