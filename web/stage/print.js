/** On paper a canvas is a grey bitmap: for printing, the same diagrams as vector drawings. */

/** @typedef {{ canvas: HTMLCanvasElement, svg: string }} Drawing */

/** The engine's own drawing, with its text already escaped, is the only thing that passes. */
const policy = trustedPolicy();

function trustedPolicy() {
  /** @type {{ createPolicy(name: string, rules: { createHTML(text: string): string }): { createHTML(text: string): string } } | undefined} */
  const factory = Reflect.get(globalThis, "trustedTypes");
  return factory?.createPolicy("levalab-drawing", { createHTML: (text) => text });
}

/**
 * A drawing of ours as an element.
 * @param {string} text
 * @returns {SVGElement | null}
 */
export function parse(text) {
  const page = new DOMParser().parseFromString(policy ? policy.createHTML(text) : text, "image/svg+xml");
  const { documentElement } = page;
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
