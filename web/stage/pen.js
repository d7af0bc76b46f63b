/**
 * A canvas context that knows the view: paths in world lengths, text and fine lines in CSS pixels.
 *
 * @import { View } from "./view.js"
 * @import { DashName, Palette } from "./palette.js"
 */

/** @type {number[]} */
const FULL = [];
/** The stroke of a curve on a laptop, to which all widths given here are relative. */
const USUAL_STROKE = 1.5;
/** Between a text and the edge of the canvas, CSS pixels. */
const EDGE = 6;

export class Pen {
  /** @type {View} */
  view = { scale: 1, x: 0, y: 0 };
  /** Device pixels for a CSS pixel. */
  ratio = 1;
  /** True while lengths are the world's. */
  #world = false;
  /** @type {Map<number[], { scale: number, lengths: number[] }>} */
  #scaled = new Map();

  /**
   * @param {CanvasRenderingContext2D} context
   * @param {Palette} palette
   */
  constructor(context, palette) {
    this.context = context;
    this.palette = palette;
  }

  /** How much heavier than usual everything is drawn: a projector is seen from afar. */
  get weight() {
    return this.palette.stroke / USUAL_STROKE;
  }

  /** @param {number} x */
  x(x) {
    return this.view.x + this.view.scale * x;
  }

  /** @param {number} y */
  y(y) {
    return this.view.y - this.view.scale * y;
  }

  /** From here on in CSS pixels. */
  screen() {
    this.#world = false;
    this.context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
  }

  /**
   * From here on in world lengths, in a frame that stands at (x, y), is turned by `angle` (rad, counter-clockwise) and whose
   * second axis points the other way when `mirror` is −1.
   * @param {number} x
   * @param {number} y
   * @param {number} angle
   * @param {number} mirror
   */
  world(x = 0, y = 0, angle = 0, mirror = 1) {
    this.#world = true;
    const k = this.ratio * this.view.scale;
    const c = k * Math.cos(angle);
    const s = k * Math.sin(angle);
    this.context.setTransform(c, -s, -s * mirror, -c * mirror, this.ratio * this.x(x), this.ratio * this.y(y));
  }

  /**
   * The look of the next strokes.
   * @param {string} colour
   * @param {number} pixels
   * @param {DashName} [dash]
   */
  line(colour, pixels, dash) {
    const unit = this.#world ? 1 / this.view.scale : 1;
    this.context.strokeStyle = colour;
    this.context.lineWidth = pixels * this.weight * unit;
    this.context.setLineDash(dash ? this.#dash(this.palette.dash[dash]) : FULL);
  }

  /** @param {number[]} pixels */
  #dash(pixels) {
    if (!this.#world) return pixels;
    let kept = this.#scaled.get(pixels);
    if (!kept) this.#scaled.set(pixels, (kept = { scale: NaN, lengths: pixels.slice() }));
    if (kept.scale !== this.view.scale) {
      kept.scale = this.view.scale;
      for (let i = 0; i < pixels.length; i++) kept.lengths[i] = /** @type {number} */ (pixels[i]) / kept.scale;
    }
    return kept.lengths;
  }

  /**
   * A part as one silhouette, though it is made of several pieces: all edges first, then all faces.
   * @param {Path2D[]} pieces
   * @param {string} face
   * @param {string} edge
   * @param {number} pixels
   */
  part(pieces, face, edge, pixels) {
    this.line(edge, 2 * pixels);
    this.context.lineJoin = "round";
    for (const piece of pieces) this.context.stroke(piece);
    this.context.fillStyle = face;
    for (const piece of pieces) this.context.fill(piece);
  }

  /**
   * A circle about a world point, stroked in CSS pixels.
   * @param {number} x
   * @param {number} y
   * @param {number} radius  world length
   */
  circle(x, y, radius) {
    const { context } = this;
    context.beginPath();
    context.arc(this.x(x), this.y(y), Math.max(radius * this.view.scale, 0), 0, 2 * Math.PI);
    context.stroke();
  }

  /**
   * @param {number} x0
   * @param {number} y0
   * @param {number} x1
   * @param {number} y1
   */
  segment(x0, y0, x1, y1) {
    const { context } = this;
    context.beginPath();
    context.moveTo(this.x(x0), this.y(y0));
    context.lineTo(this.x(x1), this.y(y1));
    context.stroke();
  }

  /**
   * A dot of so many CSS pixels, ringed with paper so that it stands out from any line.
   * @param {number} x
   * @param {number} y
   * @param {number} pixels
   * @param {string} colour
   */
  dot(x, y, pixels, colour) {
    const { context } = this;
    context.beginPath();
    context.arc(this.x(x), this.y(y), pixels * this.weight ** 0.5, 0, 2 * Math.PI);
    context.fillStyle = colour;
    context.fill();
    this.line(this.palette.paper, 1.25);
    context.stroke();
  }

  /**
   * Text with a halo of paper.
   * @param {string} text
   * @param {number} px  CSS pixels
   * @param {number} py
   * @param {string} colour
   */
  text(text, px, py, colour) {
    const { context } = this;
    this.line(this.palette.paper, 4 / this.weight);
    context.lineJoin = "round";
    context.strokeText(text, px, py);
    context.fillStyle = colour;
    context.fillText(text, px, py);
  }

  /**
   * The same, moved as far as it takes to stay within the canvas.
   * @param {string} text
   * @param {number} px
   * @param {number} py
   * @param {string} colour
   */
  textInside(text, px, py, colour) {
    const { canvas, textAlign } = this.context;
    const width = this.context.measureText(text).width;
    const before = textAlign === "left" ? 0 : textAlign === "right" ? width : width / 2;
    const left = Math.max(EDGE, Math.min(px - before, canvas.width / this.ratio - width - EDGE));
    const y = Math.max(this.palette.size, Math.min(py, canvas.height / this.ratio - this.palette.size));
    this.text(text, left + before, y, colour);
  }
}
