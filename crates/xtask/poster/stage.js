// The mechanism as an SVG drawing: the page's own scene, drawn on a canvas that keeps paths instead of pixels.
import { Outline } from "./page.js";
import { branch } from "./markup.js";

/** @import { ShellContext } from "../../../web/types.d.ts" */
/** @import { Branch } from "./markup.js" */

/** Units of the drawing along its longer side: a third of a pixel on a large screen. */
const UNITS = 2400;
/** A point this near to the line between its neighbours, in units, is left out. */
const NEAR = 0.4;

/** @typedef {[number, number]} Point */
/** @typedef {[a: number, b: number, c: number, d: number, e: number, f: number]} Matrix  as a canvas takes it */

/** Writes the data of a path: whole units, relative where that is shorter. */
class Data {
  #text = "";
  /** Points from the last that has been written, or of a stretch that begins. @type {Point[]} */
  #run = [];
  /** True when the first of them has been written. */
  #continued = false;

  /** @param {Point} point */
  move(point) {
    this.#flush();
    this.#run = [point];
  }

  /** @param {Point} point */
  line(point) {
    this.#run.push(point);
  }

  /** @param {number} radius @param {boolean} large @param {boolean} sweep @param {Point} end */
  arc(radius, large, sweep, end) {
    this.#flush();
    const [x, y] = end.map(Math.round);
    const size = Number(radius.toFixed(1));
    this.#text += `A${size} ${size} 0 ${Number(large)}${Number(sweep)} ${x} ${y}`;
    this.#run = [end];
    this.#continued = true;
  }

  close() {
    this.#flush();
    this.#text += "Z";
  }

  /** True once there is anything from which a line can go on. */
  get begun() {
    return this.#run.length > 0;
  }

  #flush() {
    const [first, ...rest] = thinned(this.#run).map(([x, y]) => /** @type {Point} */ ([Math.round(x), Math.round(y)]));
    this.#run = [];
    if (!first) return;
    if (!this.#continued) this.#text += `M${first.join(" ")}`;
    this.#continued = false;
    const steps = rest.map(([x, y], index) => {
      const [fromX, fromY] = rest[index - 1] ?? first;
      return `${x - fromX} ${y - fromY}`;
    });
    if (steps.length > 0) this.#text += `l${steps.join(" ").replaceAll(" -", "-")}`;
  }

  /** @returns {string} */
  toString() {
    this.#flush();
    return this.#text;
  }
}

/** The points that matter for how a line looks. @param {Point[]} points @returns {Point[]} */
function thinned(points) {
  const [first, last] = [points[0], points.at(-1)];
  if (!first || !last || points.length < 3) return points;
  const [dx, dy] = [last[0] - first[0], last[1] - first[1]];
  const length = Math.hypot(dx, dy);
  let [far, at] = [0, 0];
  points.forEach(([x, y], index) => {
    const [px, py] = [x - first[0], y - first[1]];
    const away = length > 0 ? Math.abs(px * dy - py * dx) / length : Math.hypot(px, py);
    if (away > far) [far, at] = [away, index];
  });
  if (far <= NEAR) return [first, last];
  return [...thinned(points.slice(0, at + 1)).slice(0, -1), ...thinned(points.slice(at))];
}

/** As much of a canvas context as the scene needs. Its lines keep their width and their dashes, however large the drawing is shown. */
class Surface {
  /** @type {Branch[]} */
  paths = [];
  strokeStyle = "";
  fillStyle = "";
  lineWidth = 1;
  lineJoin = "miter";
  /** @type {number[]} */
  #dashes = [];
  /** @type {Matrix} */
  #matrix = [1, 0, 0, 1, 0, 0];
  #outline = new Outline();

  clearRect() {}

  /** @param {number[]} lengths */
  setLineDash(lengths) {
    this.#dashes = [...lengths];
  }

  /** @param {Matrix} matrix */
  setTransform(...matrix) {
    this.#matrix = matrix;
  }

  beginPath() {
    this.#outline = new Outline();
  }

  /** @param {number[]} numbers */
  moveTo(...numbers) {
    this.#outline.calls.push(["moveTo", ...numbers]);
  }

  /** @param {number[]} numbers */
  lineTo(...numbers) {
    this.#outline.calls.push(["lineTo", ...numbers]);
  }

  /** @param {number[]} numbers */
  arc(...numbers) {
    this.#outline.calls.push(["arc", ...numbers]);
  }

  fill(outline = this.#outline) {
    this.#add(outline, { fill: this.fillStyle });
  }

  stroke(outline = this.#outline) {
    const scale = Math.hypot(this.#matrix[0], this.#matrix[1]);
    const pixels = (/** @type {number} */ length) => String(Number((length * scale).toFixed(2)));
    this.#add(outline, {
      stroke: this.strokeStyle, "stroke-width": pixels(this.lineWidth),
      ...(this.#dashes.length > 0 ? { "stroke-dasharray": this.#dashes.map(pixels).join(" ") } : {}),
      ...(this.lineJoin === "round" ? { "stroke-linejoin": "round" } : {}),
    });
  }

  /**
   * A dot of so many pixels, ringed with paper, however large the drawing is shown: the round ends of lines without length.
   * @param {number} x
   * @param {number} y
   * @param {number} radius
   * @param {number} ring
   * @param {string} colour
   * @param {string} paper
   */
  dot(x, y, radius, ring, colour, paper) {
    const d = `M${Math.round(x)} ${Math.round(y)}h0`;
    for (const [stroke, width] of /** @type {[string, number][]} */ ([[paper, 2 * radius + ring], [colour, 2 * radius - ring]])) {
      this.paths.push(branch("path", { stroke, "stroke-width": width, "stroke-linecap": "round", d }));
    }
  }

  /** @param {Outline} outline @param {Record<string, string>} look */
  #add(outline, look) {
    if (look["fill"] === "none" || look["stroke"] === "none") return;
    this.paths.push(branch("path", { ...look, d: this.#data(outline) }));
  }

  /** @param {Outline} outline */
  #data(outline) {
    const [a, b, c, d, e, f] = this.#matrix;
    const data = new Data();
    const place = (/** @type {number} */ x, /** @type {number} */ y) => /** @type {Point} */ ([a * x + c * y + e, b * x + d * y + f]);
    for (const [name, x = 0, y = 0, third = 0, from = 0, to = 0, back = 0] of outline.calls) {
      if (name === "moveTo") data.move(place(x, y));
      else if (name === "lineTo") data.begun ? data.line(place(x, y)) : data.move(place(x, y));
      else if (name === "closePath") data.close();
      else if (name === "rect") {
        data.move(place(x, y));
        for (const corner of [place(x + third, y), place(x + third, y + from), place(x, y + from)]) data.line(corner);
        data.close();
      } else this.#arc(data, place, x, y, third, from, to, Boolean(back));
    }
    return String(data);
  }

  /**
   * @param {Data} data
   * @param {(x: number, y: number) => Point} place
   * @param {number} x
   * @param {number} y
   * @param {number} radius
   * @param {number} from
   * @param {number} to
   * @param {boolean} back
   */
  #arc(data, place, x, y, radius, from, to, back) {
    const [a, b, c, d] = this.#matrix;
    const at = (/** @type {number} */ angle) => place(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
    const turn = 2 * Math.PI;
    const sweep = Math.abs(to - from) >= turn ? turn * (back ? -1 : 1) : back ? -((((from - to) % turn) + turn) % turn) : (((to - from) % turn) + turn) % turn;
    if (data.begun) data.line(at(from));
    else data.move(at(from));
    // A whole turn ends where it begins, which an arc of SVG cannot: two halves. Their radius, too small for what lies between their
    // ends, grows to just that; one that is a little too large would move their centre.
    const parts = Math.abs(sweep) === turn ? 2 : 1;
    const size = parts === 2 ? 1 : radius * Math.hypot(a, b);
    for (let part = 1; part <= parts; part++) {
      data.arc(size, Math.abs(sweep) / parts > Math.PI, sweep > 0 === a * d - b * c > 0, at(from + (sweep * part) / parts));
    }
  }
}

/**
 * The mechanism at the start of the turn. It fills the box that the page's own view leaves it within its margin, as `fitView` does.
 * @param {ShellContext} context
 * @returns {Promise<Branch>}
 */
export async function mechanism(context) {
  const [{ Scene }, { Pen }, { readPalette }, { instant }] = await Promise.all(
    ["scene", "pen", "palette", "instant"].map((name) => import(new URL(`../../../web/stage/${name}.js`, import.meta.url).href)),
  );
  const { store, lab, format } = context;
  const scene = new Scene(store.state.report, lab(), null, null);
  const surface = new Surface();
  // The scale bar and its label, which are muted, depend on the size of the screen: they come with the living page, as all text does.
  const pen = new Pen(surface, { ...readPalette(), muted: "none" });
  const { left, right, top, bottom } = scene.box(store.state);
  const scale = UNITS / Math.max(right - left, top - bottom);
  pen.view = { scale, x: -left * scale, y: top * scale };
  pen.text = () => {};
  pen.textInside = () => {};
  pen.dot = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ pixels, /** @type {string} */ colour) => {
    surface.dot(pen.x(x), pen.y(y), pixels, 1.25, colour, pen.palette.paper);
  };
  scene.draw(pen, store.state, instant(context), format, 0, 0);
  return branch("svg", { class: "poster-cam", viewBox: `0 0 ${Math.round((right - left) * scale)} ${Math.round((top - bottom) * scale)}`, "aria-hidden": "true" }, ...surface.paths);
}
