/**
 * The cam to scale and its diagrams on paper.
 *
 * @import { Design, Diagram, ShellContext } from "../../types.d.ts"
 * @import { Make } from "../writers.js"
 */
import { h } from "../../dom.js";
import { paperPalette } from "../../stage/palette.js";
import { PLOTS, styleOf, unitOf } from "../../stage/plots.js";
import { parse } from "../../stage/print.js";
import { NAME, PIXELS, ROOM, SECOND, TALL, inBrackets } from "./paper.js";

/** Heights of a diagram, mm: the most that it gets, and the least that it can be read with. */
const PLOT = 32;
const LEAST_PLOT = 16;

/** @type {Diagram[]} */
const DIAGRAMS = ["s", "v", "a", "j", "pressure_angle", "rho"];

/**
 * The cam to scale; without the module that draws it, as it stands on the screen.
 * @param {ShellContext} context
 * @param {Design} design
 * @param {Make | null} make
 * @param {number} height  mm
 */
export function drawn({ store }, design, make, height) {
  const { bytes } = make?.(design, { to: "svg", room: [ROOM, height] }, store.state.language) ?? {};
  const drawing = bytes && parse(new TextDecoder().decode(bytes));
  if (drawing) return drawing;
  const canvas = document.querySelector("#mechanism canvas");
  return h("img", { src: canvas instanceof HTMLCanvasElement ? canvas.toDataURL() : "", alt: "" });
}

/**
 * As high as the verdict leaves room for on the same page.
 * @param {ShellContext} context
 * @param {number} above  mm
 */
export function diagrams({ store, lab, t }, above) {
  const pair = store.state.report.conjugate;
  const room = (TALL - 20 - above) / DIAGRAMS.length - NAME - 1;
  const height = Math.min(PLOT, Math.max(LEAST_PLOT, room));
  const { report, perSecond } = store.state;
  const palette = { ...paperPalette(), chartSize: pair ? 9 : 10, stroke: 1.3 };
  /** @param {Diagram} diagram @param {boolean} second */
  function figure(diagram, second) {
    const plot = PLOTS[diagram];
    const size = { width: (pair ? ROOM / 2 - 2 : ROOM) * PIXELS, height: height * PIXELS, ratio: 1, labels: true };
    const drawing = parse(lab().svg(diagram, styleOf(plot, palette, store.state, size), second));
    const name = h("figcaption", {}, h("i", {}, `${perSecond ? plot.perSecond : plot.letter}${second ? SECOND : ""}`), ` ${t(`diagram.name.${diagram}`)}${inBrackets(unitOf(plot, report, perSecond))}`);
    return h("figure", {}, name, drawing);
  }
  if (!pair) return DIAGRAMS.map((diagram) => figure(diagram, false));
  const cells = DIAGRAMS.flatMap((diagram) => [figure(diagram, false), figure(diagram, true)]);
  return [h("div", { class: "both" }, h("p", {}, t("diagram.cam.first")), h("p", {}, t("diagram.cam.second")), ...cells)];
}
