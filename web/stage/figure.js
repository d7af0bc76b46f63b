/**
 * One diagram on the page: a line with its letter, a sample of its curve, its name and unit, and its canvas.
 *
 * @import { Plot } from "./plots.js"
 */
import { h, s } from "../dom.js";

/** @param {Plot} plot */
export function figure(plot) {
  const canvas = h("canvas", { class: "diagram-canvas", role: "img" });
  const letter = h("i", { class: "symbol" });
  const name = h("span", { class: "diagram-name" });
  const unit = h("span", { class: "diagram-unit" });
  const sample = s("svg", { class: "diagram-sample", viewBox: "0 0 34 6", "aria-hidden": "true" }, s("path", { d: "M1 3H33" }));
  const element = h("figure", { class: `diagram diagram-${plot.token}` }, h("figcaption", { class: "diagram-caption" }, letter, sample, name, unit), canvas);
  return { plot, element, canvas, letter, name, unit };
}
