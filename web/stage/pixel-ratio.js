/**
 * Device pixels for a CSS pixel. They change with the zoom of the browser, and without any change of size when a window is moved to another
 * screen: to a projector, say.
 */

/** No canvas gets sharper than this. */
const SHARPEST = 3;

/** Device pixels for a CSS pixel of a canvas: the screen's own, within reason. */
export const pixelRatio = () => Math.min(Math.max(devicePixelRatio, 1), SHARPEST);

/**
 * Gives a canvas the size of a place on the page. It is shown as large as it is drawn: half a pixel of difference would blur every line.
 * @param {HTMLCanvasElement} canvas
 * @param {number} width   CSS pixels
 * @param {number} height
 * @param {number} ratio
 */
export function sizeCanvas(canvas, width, height, ratio) {
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  canvas.style.inlineSize = `${canvas.width / ratio}px`;
  canvas.style.blockSize = `${canvas.height / ratio}px`;
}

/** @type {Set<() => void>} */
const listeners = new Set();
/** True only as long as the ratio is what it was. @type {MediaQueryList | null} */
let query = null;

/**
 * Calls `fn` whenever the ratio has changed.
 * @param {() => void} fn
 */
export function onPixelRatio(fn) {
  listeners.add(fn);
  if (!query) arm();
}

function arm() {
  query = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
  query.addEventListener("change", changed, { once: true });
}

function changed() {
  arm();
  for (const fn of listeners) fn();
}
