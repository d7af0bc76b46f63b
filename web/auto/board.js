/**
 * The board under what is drawn: axes of the engine's, and the joined curve when there is one.
 *
 * @import { Design, ShellContext } from "../types.d.ts"
 * @import { Row } from "../stage/overlay.js"
 */
import { h } from "../dom.js";
import { onAppearance, readPalette } from "../stage/palette.js";
import { pixelRatio, onPixelRatio } from "../stage/pixel-ratio.js";
import { PLOTS, styleOf } from "../stage/plots.js";

/**
 * @param {ShellContext} context
 * @param {() => number[]} heights  that the board has room for
 * @param {() => void} ready        it was drawn, perhaps by another scale
 */
export function createBoard({ store, t, module }, heights, ready) {
  const canvas = h("canvas", { role: "img" });
  /** @type {Design | null} */
  let design = null;
  /** @type {Row | null} */
  let row = null;
  /** The scale that a hand goes by. @type {Row | null} */
  let held = null;
  let palette = readPalette();

  new ResizeObserver(draw).observe(canvas);
  onPixelRatio(draw);
  onAppearance(() => {
    palette = readPalette();
    draw();
  });

  function draw() {
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (width === 0 || height === 0) return;
    const ratio = pixelRatio();
    [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    const style = styleOf(PLOTS.s, palette, { ...store.state, perSecond: false }, { width, height, ratio, labels: true });
    const all = heights();
    // A hand that goes on above the board takes it along.
    const scale = held ? [held.area.y_min, Math.max(held.area.y_max, ...all)] : [];
    const area = module().draw_sheet(canvas, design, style, Float64Array.from(all), Float64Array.from(scale));
    row = { area, x: 0, y: 0, place: 0, colour: palette.s };
    ready();
  }

  return {
    canvas,
    draw,
    row: () => row,

    /** Keeps the scale while a hand is at work on it. @param {boolean} on */
    hold(on) {
      held = on ? row : null;
      if (!on) draw();
    },

    /** @param {Design | null} joined */
    show(joined) {
      design = joined;
      draw();
    },
    word() {
      palette = readPalette();
      canvas.setAttribute("aria-label", t("auto.picture"));
    },
  };
}
