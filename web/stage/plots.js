/**
 * The diagrams as a list: which belong together, and everything a drawing of one needs.
 *
 * @import { ChartStyle, Diagram, Language, Report, Tab } from "../types.d.ts"
 * @import { Palette } from "./palette.js"
 */
import { AT } from "./instant.js";

/**
 * @typedef {object} Plot
 * @property {Diagram} diagram
 * @property {string} letter
 * @property {string} perSecond          letter of the time derivative
 * @property {"s" | "v" | "a" | "j" | "phi" | "rho"} token  of colour and dash
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
});

/** @type {Readonly<Record<Tab, readonly Diagram[]>>} */
export const TABS = Object.freeze({ svaj: ["s", "v", "a", "j"], pressure_angle: ["pressure_angle"], rho: ["rho"] });

/**
 * Unit of a diagram's values.
 * @param {Plot} plot
 * @param {Report} report
 * @param {boolean} perSecond
 */
export function unitOf(plot, { units }, perSecond) {
  if (plot.diagram === "pressure_angle") return "°";
  if (plot.diagram === "rho") return units.length;
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
 * @param {Plot} plot
 * @param {Palette} palette
 * @param {{ width: number, height: number, ratio: number, perSecond: boolean, labels: boolean, language: Language }} given
 * @returns {ChartStyle}
 */
export function styleOf(plot, palette, { width, height, ratio, perSecond, labels, language }) {
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
    per_second: perSecond,
    x_labels: labels,
    decimal_comma: language === "es",
  };
}
