/**
 * The diagrams of what comes out, against θ or time, with the page's one cursor and the value at it.
 *
 * @import { ApplicationOutput, ShellContext } from "../types.d.ts"
 * @import { Row } from "../stage/overlay.js"
 * @import { Work } from "./work.js"
 */
import { h, symbol, write } from "../dom.js";
import { choice } from "../stage/choice.js";
import { cycleOf, decimalsOf } from "../stage/clock.js";
import { moveCursor } from "../stage/cursor-hand.js";
import { AT, instant } from "../stage/instant.js";
import { FLAG, drawOverlay } from "../stage/overlay.js";
import { onAppearance, readColour, readPalette } from "../stage/palette.js";
import { onPixelRatio, pixelRatio, sizeCanvas } from "../stage/pixel-ratio.js";
import { letterOf, placeText } from "../stage/place.js";
import { PLOTS, styleOf } from "../stage/plots.js";
import { watchVisibility } from "../stage/visibility.js";

/** Heights of a diagram that stands alone, and of one of two, CSS pixels. */
const ALONE = 210;
const AMONG = 130;

/** Colours of the outputs, the main one first. */
export const OUTPUT_COLOURS = ["output", "output-2"];

/**
 * @param {ShellContext} context
 * @param {Work} work
 */
export function createPlots(context, work) {
  const { store, t, format } = context;
  const overlay = h("canvas", { class: "diagram-overlay", tabindex: "0", role: "slider", "aria-valuemin": "0", "aria-orientation": "horizontal" });
  const surface = /** @type {CanvasRenderingContext2D} */ (overlay.getContext("2d"));
  const plots = h("div", { class: "application-plots" });
  const against = choice("application-against", ["theta", "time"], (value) => {
    byTime = value === "time";
    draw();
  });
  const root = h("div", {}, plots, h("div", { class: "application-bar" }, against.element));
  let byTime = false;
  let palette = readPalette();
  /** @type {ReturnType<typeof figure>[]} */
  let figures = [];
  /** @type {Row[]} */
  let rows = [];
  /** Of the room for the diagrams, CSS pixels; 0 while it is out of sight. */
  let width = 0;
  let height = 0;
  let ratio = pixelRatio();

  new ResizeObserver(() => draw()).observe(plots);
  onPixelRatio(() => draw());
  onAppearance(() => draw());
  store.subscribe(["cursor", "highlight", "playing"], watchVisibility(plots).inView(drawCursor));

  /** @param {number} index */
  function figure(index) {
    const canvas = h("canvas", { class: "diagram-canvas", role: "img" });
    const letter = h("i", { class: "symbol" });
    const name = h("span");
    const value = h("output");
    const extremes = h("span", { class: "application-extremes" });
    const element = h("figure", {}, h("figcaption", {}, letter, name, value, extremes), canvas);
    element.style.setProperty("--curve", `var(--${OUTPUT_COLOURS[index] ?? OUTPUT_COLOURS[0]})`);
    return { element, canvas, letter, name, value, extremes };
  }

  /** @param {ApplicationOutput} output */
  function caption(output) {
    const { report } = store.state;
    const { unit, min, min_at: minAt, max, max_at: maxAt, per_cycle: volume, per_second: rate } = output;
    /** @param {number} value @param {string} of */
    const say = (value, of = unit) => format.quantity(value, { trim: true, unit: of });
    const values = { min: say(min), minAt: placeText(format, report, minAt), max: say(max), maxAt: placeText(format, report, maxAt) };
    const range = t("application.extremes", values);
    if (volume === null) return { range, values };
    const delivered = t(report.travels ? "application.per-journey" : "application.per-turn", { volume: say(volume), rate: say(rate ?? NaN, `${unit}/s`) });
    return { range: `${range}; ${delivered}`, values };
  }

  function draw() {
    const { driven, report } = work;
    width = plots.clientWidth;
    if (!driven || !report || width === 0) return;
    const { outputs } = report;
    if (figures.length !== outputs.length) {
      figures = outputs.map((_, index) => figure(index));
      plots.replaceChildren(...figures.map(({ element }) => element), overlay);
    }
    palette = readPalette();
    plots.style.setProperty("--flag", `${Math.round(palette.chartSize * FLAG)}px`);
    ratio = pixelRatio();
    const { span, travels } = store.state.report;
    const tall = outputs.length > 1 ? AMONG : ALONE;
    rows = outputs.map((output, index) => {
      const { element, canvas, letter, name, extremes } = /** @type {ReturnType<typeof figure>} */ (figures[index]);
      const { range, values } = caption(output);
      letter.replaceChildren(output.symbol.length === 2 ? symbol(output.symbol) : output.symbol);
      write(name, `${output.name} (${output.unit})`);
      write(extremes, range);
      const count = index === report.main ? report.targets.length : 0;
      canvas.setAttribute("aria-label", t("application.alternative", { ...values, name: output.name, count }));
      const wide = element.clientWidth;
      sizeCanvas(canvas, wide, tall, ratio);
      const colour = readColour(OUTPUT_COLOURS[index] ?? "output");
      const style = { ...styleOf(PLOTS.s, palette, store.state, { width: wide, height: tall, ratio, labels: true }), curve: colour, dash: index > 0 ? [7, 3] : [], per_second: byTime };
      const area = driven.draw(canvas, index, style);
      // Time and θ go together: for the cursor both diagrams run from 0 to the end of the cycle.
      return { area: { ...area, x_min: 0, x_max: span }, x: canvas.offsetLeft, y: canvas.offsetTop, place: index, colour };
    });
    height = plots.clientHeight;
    sizeCanvas(overlay, width, height, ratio);
    overlay.setAttribute("aria-label", t("application.cursor"));
    overlay.setAttribute("aria-valuemax", String(span));
    against.word(t("application.against"), (value) => t(value === "theta" && travels ? "application.against.theta.travel" : `application.against.${value}`), (value) => t(`application.against.${value}`), byTime ? "time" : "theta");
    drawCursor();
  }

  function drawCursor() {
    const { driven, report } = work;
    if (!driven || !report || rows.length === 0 || width === 0) return;
    const { cursor, highlight, report: cam } = store.state;
    const at = driven.at(cursor);
    report.outputs.forEach(({ symbol: sign, unit }, index) => {
      const figure = figures[index];
      if (figure) write(figure.value, `${sign} = ${format.quantity(at[index], { unit })}`);
    });
    const place = `${letterOf(cam)} ${placeText(format, cam, cursor, decimalsOf({ cursor, playing: true }, cycleOf(cam)))}`;
    const seconds = `t ${format.quantity(instant(context)[AT.t], { unit: "s" })}`;
    const label = byTime ? seconds : place;
    drawOverlay(surface, { rows, width, height, ratio, cursor, hover: NaN, label, highlight, report: cam, at, palette });
    // For a reader of the screen; not sixty times a second.
    if (store.state.playing && overlay.hasAttribute("aria-valuenow")) return;
    overlay.setAttribute("aria-valuenow", cursor.toFixed(cam.travels ? 3 : 1));
    overlay.setAttribute("aria-valuetext", `${place}, ${seconds}`);
  }

  moveCursor(overlay, store, () => rows[0]);

  return { root, update: draw };
}
