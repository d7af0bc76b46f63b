/** On paper a canvas is a grey bitmap: for printing, the same diagrams as vector drawings. */
import { parseOwn } from "../own-markup.js";

/** @typedef {{ canvas: HTMLCanvasElement, svg: string }} Drawing */

/**
 * A drawing of ours as an element.
 * @param {string} text
 * @returns {SVGElement | null}
 */
export function parse(text) {
  const { documentElement } = parseOwn(text, "image/svg+xml");
  if (documentElement.nodeName !== "svg") return null;
  for (const script of documentElement.querySelectorAll("script, foreignObject")) script.remove();
  return document.importNode(/** @type {SVGElement} */ (/** @type {unknown} */ (documentElement)), true);
}

/**
 * Swaps canvases and drawings around each printing.
 * @param {() => Drawing[]} drawings
 */
export function vectorDrawings(drawings) {
  /** @type {SVGElement[]} */
  let placed = [];
  addEventListener("beforeprint", () => {
    for (const { canvas, svg } of drawings()) {
      const drawing = parse(svg);
      if (!drawing) continue;
      drawing.classList.add("diagram-print");
      drawing.setAttribute("aria-hidden", "true");
      canvas.after(drawing);
      placed.push(drawing);
    }
  });
  addEventListener("afterprint", () => {
    for (const drawing of placed) drawing.remove();
    placed = [];
  });
}
