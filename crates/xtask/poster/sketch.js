// A diagram as the engine draws it, taken apart: which lines, dots and labels lie where.

/** The engine takes colours as digits: those that stand for the tokens of the page. */
export const COLOURS = ["paper", "ink", "muted", "grid", "bad", "s", "v", "a", "j"];
export const digits = (/** @type {string} */ name) => `#0000${String(COLOURS.indexOf(name) + 10).padStart(2, "0")}`;
const token = (/** @type {string} */ colour) => COLOURS[Number(colour.slice(1)) - 10] ?? "";

/** @typedef {{ x: number, y: number }} Point */
/** @typedef {{ colour: string, opacity: string, width: number, dash: string, points: Point[] }} Line */
/** @typedef {{ at: Point, radius: number, fill: string, stroke: string, width: number }} Dot */
/** @typedef {{ at: Point, text: string, anchor: string, colour: string }} Label */
/**
 * A diagram as the engine draws it: what lies where, in CSS pixels.
 * @typedef {object} Sketch
 * @property {Line[]} lines
 * @property {Dot[]} dots
 * @property {Label[]} labels
 * @property {Line[]} curve    the runs of it
 * @property {{ left: number, right: number, top: number, bottom: number }} plot
 * @property {number} high     where the curve is highest
 * @property {number} low
 */

/** @param {string} tag @param {string} name */
const attribute = (tag, name) => new RegExp(` ${name}="([^"]*)"`).exec(tag)?.[1] ?? "";

/**
 * Reads an SVG drawing of a diagram.
 * @param {string} svg
 * @param {string} curve  the colour of the curve
 * @returns {Sketch}
 */
export function readSketch(svg, curve) {
  const scale = Number(attribute(svg, "width")) / Number(attribute(svg, "viewBox").split(" ")[2]);
  const number = (/** @type {string} */ tag, /** @type {string} */ name) => scale * Number(attribute(tag, name));
  /** @type {Sketch} */
  const sketch = { lines: [], dots: [], labels: [], curve: [], plot: { left: Infinity, right: 0, top: Infinity, bottom: 0 }, high: Infinity, low: 0 };
  let dash = "";
  for (const [tag, text] of svg.matchAll(/<(?:polyline|circle|g |\/g|text)[^>]*>(?:\s*([^<]+?)\s*<\/text>)?/g)) {
    if (tag.startsWith("<g")) dash = attribute(tag, "stroke-dasharray").split(" ").map((length) => scale * Number(length)).join(" ");
    else if (tag.startsWith("</g")) dash = "";
    else if (tag.startsWith("<polyline")) {
      const points = attribute(tag, "points").trim().split(" ").map((pair) => {
        const [x = 0, y = 0] = pair.split(",").map((value) => scale * Number(value));
        return { x, y };
      });
      const line = { colour: token(attribute(tag, "stroke")), opacity: attribute(tag, "opacity"), width: number(tag, "stroke-width"), dash, points };
      (line.colour === curve && !(dash && points.length === 2 && line.opacity !== "1") ? sketch.curve : sketch.lines).push(line);
    } else if (tag.startsWith("<circle")) {
      sketch.dots.push({ at: { x: number(tag, "cx"), y: number(tag, "cy") }, radius: number(tag, "r"), fill: token(attribute(tag, "fill")), stroke: token(attribute(tag, "stroke")), width: number(tag, "stroke-width") });
    } else {
      sketch.labels.push({ at: { x: number(tag, "x"), y: number(tag, "y") }, text: String(text), anchor: attribute(tag, "text-anchor"), colour: token(attribute(tag, "fill")) });
    }
  }
  for (const { points } of sketch.lines.filter(({ colour }) => colour === "grid")) {
    for (const { x, y } of points) {
      sketch.plot = { left: Math.min(sketch.plot.left, Math.floor(x)), right: Math.max(sketch.plot.right, Math.floor(x)), top: Math.min(sketch.plot.top, y), bottom: Math.max(sketch.plot.bottom, y) };
    }
  }
  for (const { points } of sketch.curve) for (const { y } of points) [sketch.high, sketch.low] = [Math.min(sketch.high, y), Math.max(sketch.low, y)];
  return sketch;
}
