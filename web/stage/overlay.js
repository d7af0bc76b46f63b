/**
 * What moves over the diagrams: the cursor line with a dot on each curve, the pointer's hairline, the stretch that is lit.
 *
 * @import { Highlight, PlotArea, Report } from "../types.d.ts"
 * @import { Palette } from "./palette.js"
 */
import { placeIn } from "./place.js";

/** Room under the last plot for the labels of θ, and below them for the place of the cursor, in heights of the type. */
export const LABELS = 1.9;
export const FLAG = 1.5;

/**
 * @typedef {object} Row  one diagram as it lies under the overlay
 * @property {import("../types.d.ts").Diagram} [diagram]  which it is, when it is one of the cam
 * @property {PlotArea} area
 * @property {number} x       of its canvas, CSS pixels
 * @property {number} y
 * @property {number} place   of its value in the instant
 * @property {string} colour
 */

/**
 * @param {Row} row
 * @param {number} theta
 */
export const atTheta = ({ area, x }, theta) => x + area.left + (area.width * (theta - area.x_min)) / (area.x_max - area.x_min);

/**
 * @param {Row} row
 * @param {number} px
 */
export const thetaAt = ({ area, x }, px) => area.x_min + ((px - x - area.left) / area.width) * (area.x_max - area.x_min);

/**
 * @param {Row} row
 * @param {number} value
 */
export const atValue = ({ area, y }, value) => y + area.top + (area.height * (area.y_max - value)) / (area.y_max - area.y_min);

/**
 * @param {CanvasRenderingContext2D} context
 * @param {object} shown
 * @param {readonly Row[]} shown.rows
 * @param {number} shown.width
 * @param {number} shown.height
 * @param {number} shown.ratio
 * @param {number} shown.cursor
 * @param {number} shown.hover  NaN without
 * @param {string} shown.label
 * @param {Highlight | null} shown.highlight
 * @param {Report} shown.report
 * @param {Float64Array} shown.at
 * @param {Palette} shown.palette
 */
export function drawOverlay(context, { rows, width, height, ratio, cursor, hover, label, highlight, report, at, palette }) {
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  const first = rows[0];
  const last = rows.at(-1);
  if (!first || !last) return;

  for (const row of rows) lightUp(context, row, highlight, report, palette);

  if (!Number.isNaN(hover)) {
    context.strokeStyle = palette.line;
    context.lineWidth = 1;
    through(context, rows, Math.round(atTheta(first, hover)) + 0.5);
  }
  const x = atTheta(first, cursor);
  context.strokeStyle = palette.ink;
  context.lineWidth = Math.max(1.25, palette.stroke * 0.8);
  through(context, rows, x);

  for (const row of rows) {
    const { area } = row;
    const value = /** @type {number} */ (at[row.place]);
    if (!(value >= area.y_min && value <= area.y_max)) continue;
    context.beginPath();
    context.arc(x, atValue(row, value), 2.4 * palette.stroke, 0, 2 * Math.PI);
    context.fillStyle = row.colour;
    context.fill();
    context.strokeStyle = palette.paper;
    context.lineWidth = 1.5;
    context.stroke();
  }
  flag(context, label, x, last, palette);
}

/**
 * A line through every diagram, leaving the captions between them alone.
 * @param {CanvasRenderingContext2D} context
 * @param {readonly Row[]} rows
 * @param {number} x
 */
function through(context, rows, x) {
  for (const { y, area } of rows) stroke(context, x, y + area.top, y + area.top + area.height);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {number} x
 * @param {number} top
 * @param {number} bottom
 */
function stroke(context, x, top, bottom) {
  context.beginPath();
  context.moveTo(x, top);
  context.lineTo(x, bottom);
  context.stroke();
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Row} row
 * @param {Highlight | null} highlight
 * @param {Report} report
 * @param {Palette} palette
 */
function lightUp(context, row, highlight, report, palette) {
  if (!highlight) return;
  const { area } = row;
  const y = row.y + area.top;
  const segment = highlight.segment ?? NaN;
  const [from, to] = highlight.interval ?? [report.borders[segment], report.borders[segment + 1]];
  if (from !== undefined && to !== undefined) {
    context.fillStyle = palette.accent;
    context.globalAlpha = palette.lit;
    const end = to < from ? report.span : Math.min(to, report.span);
    context.fillRect(atTheta(row, from), y, atTheta(row, end) - atTheta(row, from), area.height);
    if (to < from) context.fillRect(atTheta(row, 0), y, atTheta(row, to) - atTheta(row, 0), area.height);
    context.globalAlpha = 1;
  }
  if (highlight.theta === undefined) return;
  const x = atTheta(row, placeIn(report, highlight.theta));
  context.strokeStyle = palette.accent;
  context.lineWidth = 3;
  stroke(context, x, y, y + area.height);
}

/**
 * The place of the cursor, below the labels of the axis so that it covers none of them, kept inside the plot.
 * @param {CanvasRenderingContext2D} context
 * @param {string} label
 * @param {number} x
 * @param {Row} last
 * @param {Palette} palette
 */
function flag(context, label, x, last, palette) {
  const { area } = last;
  context.font = `600 ${palette.chartSize}px ${palette.font}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  const size = palette.chartSize;
  const half = label.length * size * 0.3 + 5;
  const left = last.x + area.left;
  const middle = Math.min(Math.max(x, left + half - 4), left + area.width - half + 4);
  const y = last.y + area.top + area.height + Math.round(size * LABELS);
  context.fillStyle = palette.ink;
  context.beginPath();
  context.roundRect(middle - half, y, 2 * half, size + 4, 3);
  context.fill();
  context.fillStyle = palette.paper;
  context.fillText(label, middle, y + size / 2 + 2.5);
}
