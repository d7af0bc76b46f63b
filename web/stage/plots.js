/**
 * The diagrams as a list: which belong together, and everything a drawing of one needs.
 *
 * @import { ChartStyle, Diagram, Report, State, Tab } from "../types.d.ts"
 * @import { Palette } from "./palette.js"
 */
import { AT } from "./instant.js";

/**
 * @typedef {object} Plot
 * @property {Diagram} diagram
 * @property {string} letter
 * @property {string} perSecond          letter of the time derivative
 * @property {"s" | "v" | "a" | "j" | "phi" | "rho" | "q"} token  of colour and dash
 * @property {number} place              in the instant, per radian
 * @property {number} timed              in the instant, per second
 */

/** @type {Readonly<Record<Diagram, Plot>>} */
export const PLOTS = Object.freeze({
  s: { diagram: "s", letter: "s", perSecond: "s", token: "s", place: AT.s, timed: AT.s },
  v: { diagram: "v", letter: "v", perSecond: "V", token: "v", place: AT.v, timed: AT.V },
  a: { diagram: "a", letter: "a", perSecond: "A", token: "a", place: AT.a, timed: AT.A },
  j: { diagram: "j", letter: "j", perSecond: "J", token: "j", place: AT.j, timed: AT.J },
  pressure_angle: { diagram: "pressure_angle", letter: "φ", perSecond: "φ", token: "phi", place: AT.pressureAngle, timed: AT.pressureAngle },
  rho: { diagram: "rho", letter: "ρ", perSecond: "ρ", token: "rho", place: AT.rho, timed: AT.rho },
  contact: { diagram: "contact", letter: "q", perSecond: "q", token: "q", place: AT.contact, timed: AT.contact },
});

/** @type {Readonly<Record<Tab, readonly Diagram[]>>} */
export const TABS = Object.freeze({ svaj: ["s", "v", "a", "j"], pressure_angle: ["pressure_angle"], rho: ["rho"], contact: ["contact"] });

/**
 * Unit of a diagram's values.
 * @param {Plot} plot
 * @param {Report} report
 * @param {boolean} perSecond
 */
export function unitOf(plot, { units }, perSecond) {
  if (plot.diagram === "pressure_angle") return "°";
  if (plot.diagram === "rho" || plot.diagram === "contact") return units.length;
  return units[/** @type {keyof typeof units} */ (perSecond ? plot.perSecond : plot.letter)];
}

/**
 * Extremes of a diagram's values.
 * @param {Plot} plot
 * @param {Report} report
 * @param {boolean} perSecond
 */
export const rangeOf = (plot, { summary }, perSecond) =>
  summary[/** @type {keyof typeof summary} */ (perSecond && plot.timed !== plot.place ? plot.perSecond : plot.diagram)];

/**
 * The tab that is shown: a contact that walks along a face is there for flat ones only.
 * @param {Readonly<State>} state
 * @returns {Tab}
 */
export const tabOf = ({ tab, report }) => (tab === "contact" && !report?.summary.contact ? "svaj" : tab);

/**
 * @param {Plot} plot
 * @param {Palette} palette
 * @param {Readonly<State>} state
 * @param {{ width: number, height: number, ratio: number, labels: boolean }} given
 * @returns {ChartStyle}
 */
export function styleOf(plot, palette, { perSecond, language, margins, report }, { width, height, ratio, labels }) {
  return {
    width,
    height,
    pixel_ratio: ratio,
    font: palette.font,
    font_size: palette.chartSize,
    ink: palette.ink,
    muted: palette.muted,
    grid: palette.grid,
    background: palette.paper,
    curve: palette[plot.token],
    limit: palette.bad,
    mark: palette.bad,
    dash: palette.dash[plot.token],
    stroke: palette.stroke,
    ...(plot.diagram === "contact" ? { margin: margins[report.units.length] ?? 0 } : {}),
    per_second: perSecond,
    x_labels: labels,
    decimal_comma: language === "es",
  };
}
