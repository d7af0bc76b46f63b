// The diagrams as drawings that fill whatever room they are given, as the page's own do: what the engine draws at some size, taken
// apart into what stretches with the plot (the curve, places on it, ticks) and what does not (type, dots, the width of lines).
import { spans } from "./bounds.js";
import { branch } from "./markup.js";
import { COLOURS, digits, readSketch } from "./sketch.js";

/** @import { Diagram, ShellContext } from "../../../web/types.d.ts" */
/** @import { Branch } from "./markup.js" */
/** @import { Point, Sketch } from "./sketch.js" */
/** @import { Bounds, Span } from "./bounds.js" */

/** Heights and widths of a diagram, in CSS pixels, between which its ticks and labels change. */
const HEIGHTS = { from: 40, to: 300 };
const WIDTHS = { from: 220, to: 900 };
/** Diagrams, without the labels below them, for which the values of the extremes are laid out: on a tablet, a laptop, a phone and a large screen. */
const LOW = { width: 636, height: 64 };
const SHORT = { width: 455, height: 97 };
const NARROW = { width: 367, height: 110 };
const TALL = { width: 720, height: 240 };
/** From this height a diagram is no longer low, and below this width it is narrow. */
const LOWEST = 80;
const NARROWEST = 410;
/** Units of a stretched curve. */
const UNITS = { x: 2000, y: 1000 };
/** @param {number} part @param {number} whole */
const percent = (part, whole) => `${Number(((100 * part) / whole).toFixed(2))}%`;
const pixels = (/** @type {number} */ length) => Number(length.toFixed(1));
/** @param {string} name */
const colour = (name) => (name === "" ? "none" : `var(--${name})`);

/**
 * The diagrams of the usual tab, at the start of the turn.
 * @param {ShellContext} context
 * @param {Bounds} bounds
 * @returns {Promise<{ charts: Map<Diagram, Branch>, rules: string }>}
 */
export async function charts(context, bounds) {
  const stage = (/** @type {string} */ name) => import(new URL(`../../../web/stage/${name}.js`, import.meta.url).href);
  const [{ PLOTS, TABS, styleOf }, { readPalette }, { FLAG, LABELS }, { letterOf, placeText }, { cycleOf, decimalsOf }] = await Promise.all(["plots", "palette", "overlay", "place", "clock"].map(stage));
  const { store, lab, format } = context;
  const palette = readPalette();
  for (const name of COLOURS) palette[name] = digits(name);
  const { report } = store.state;
  const flag = `${letterOf(report)} ${placeText(format, report, 0, decimalsOf(store.state, cycleOf(report)))}`;
  /** @type {Map<Diagram, Branch>} */
  const made = new Map();
  const [foot, below] = [LABELS, FLAG].map((heights) => Math.round(heights * palette.chartSize));
  const each = `(round(100cqb,1px) - ${foot + below}px)/${TABS.svaj.length}`;
  // As `measure` shares the room out.
  const rules = [`[data-poster] .diagram{block-size:round(down,${each},1px)}[data-poster] .diagram-${TABS.svaj.at(-1)}{block-size:calc(round(down,${each},1px) + ${foot}px)}`];
  for (const diagram of TABS.svaj) {
    const last = diagram === TABS.svaj.at(-1);
    const plot = PLOTS[diagram];
    /** @param {number} width @param {number} height @param {boolean} labels */
    const sketch = (width, height, labels = last) => readSketch(lab().svg(diagram, styleOf(plot, palette, store.state, { width, height, ratio: 1, labels })), plot.token);
    const chart = new Chart(diagram, sketch, bounds, palette.stroke, last ? foot : 0);
    rules.push(chart.rules());
    const parts = [chart.field(report.borders), chart.curve()];
    if (last) {
      parts.push(chart.flag(flag, palette.chartSize));
      rules.push(chart.flagRule(foot));
    }
    made.set(diagram, branch("div", { class: "poster-plot" }, ...parts));
  }
  return { charts: made, rules: rules.join("") };
}

/** A diagram that is taken apart. */
class Chart {
  /**
   * @param {string} name
   * @param {(width: number, height: number) => Sketch} sketch
   * @param {Bounds} bounds
   * @param {number} stroke  width of a curve
   * @param {number | undefined} foot  height of the labels below it
   */
  constructor(name, sketch, bounds, stroke, foot = 0) {
    this.name = name;
    this.sketch = sketch;
    this.bounds = bounds;
    this.stroke = stroke;
    this.foot = foot;
    this.short = this.#at(SHORT);
    this.tall = this.#at(TALL);
  }

  /** @param {{ width: number, height: number }} size */
  #at({ width, height }) {
    return this.sketch(width, height + this.foot);
  }

  /** Room above the highest place of the curve and below the lowest. @param {Sketch} of @param {number} height */
  #room({ high, low }, height) {
    return [Math.round(high), Math.round(height - low)];
  }

  /** From which height on there is room for values above their dots. */
  get #bound() {
    const room = (/** @type {number} */ height) => this.#room(this.sketch(SHORT.width, height), height).join();
    const usual = this.#room(this.short, SHORT.height + this.foot).join();
    for (let height = SHORT.height + this.foot; height < HEIGHTS.to; height++) if (room(height) !== usual) return height;
    return HEIGHTS.to;
  }

  /** Where the field and the curve lie in the diagram. */
  rules() {
    const { plot } = this.tall;
    const [left, aside] = [plot.left, TALL.width - plot.right];
    /** @param {string} part @param {number[]} edges */
    const place = (part, [top = 0, bottom = 0]) =>
      `.diagram-${this.name} .poster-${part}{inset:${top}px auto auto ${left}px;inline-size:calc(100% - ${left + aside}px);block-size:calc(100% - ${top + bottom}px)}`;
    const curve = (/** @type {Sketch} */ of, /** @type {number} */ height) => place("curve", this.#room(of, height + this.foot));
    const tall = `@container(min-height:${this.#bound}px){${curve(this.tall, TALL.height)}}`;
    return place("field", [plot.top, TALL.height + this.foot - plot.bottom]) + curve(this.short, SHORT.height) + tall;
  }

  /**
   * Borders of the segments, and what stands below the plot.
   * @param {readonly number[]} borders
   */
  field(borders) {
    const below = spans(WIDTHS, (size) => {
      const { plot, labels } = this.sketch(size, SHORT.height);
      const foot = labels.filter(({ at, colour }) => colour === "muted" && at.y > plot.bottom);
      return new Map(foot.map(({ at, text }) => [text, { text, x: percent(at.x - plot.left, plot.right - plot.left), drop: pixels(at.y - plot.bottom) }]));
    });
    return branch(
      "svg", { class: "poster-field", "aria-hidden": "true" },
      ...borders.map((border) => percent(border, borders.at(-1) ?? 1)).map((x) => branch("line", { x1: x, x2: x, y2: "100%" })),
      ...below.map(({ item, ...span }) => branch(
        "svg", { x: item.x, y: "100%", class: this.bounds.classes("w", span, WIDTHS) },
        branch("line", { y2: 4, class: "poster-tick" }),
        branch("text", { y: item.drop, "text-anchor": "middle" }, item.text),
      )),
    );
  }

  /** Ticks, steps, curve, dots and values: all that is placed by values. */
  curve() {
    const { tall } = this;
    const x = (/** @type {number} */ value) => percent(value - tall.plot.left, tall.plot.right - tall.plot.left);
    const y = (/** @type {number} */ value) => percent(value - tall.high, tall.low - tall.high);
    const steps = tall.lines.filter(({ dash }) => dash !== "").map(({ colour: name, opacity, dash, points: [a, b] }) => branch("line", {
      x1: x(a?.x ?? 0), y1: y(a?.y ?? 0), x2: x(b?.x ?? 0), y2: y(b?.y ?? 0), stroke: colour(name), "stroke-dasharray": dash, opacity,
    }));
    const dots = tall.dots.map(({ at, radius, fill, stroke, width }) => branch("circle", {
      cx: x(at.x), cy: y(at.y), r: pixels(radius), fill: colour(fill), ...(stroke ? { stroke: colour(stroke), "stroke-width": pixels(width) } : {}),
    }));
    const start = tall.curve[0]?.points[0];
    return branch(
      "svg", { class: "poster-curve", "aria-hidden": "true" },
      ...this.#ticks(), ...steps, this.#line(), ...dots, ...this.#values(),
      branch("line", { class: "poster-cursor", y1: percent(tall.plot.top - tall.high, tall.low - tall.high), y2: percent(tall.plot.bottom - tall.high, tall.low - tall.high) }),
      branch("circle", { cy: y(start?.y ?? 0), r: pixels(2.4 * this.stroke), fill: colour(this.name), stroke: colour("paper"), "stroke-width": 1.5 }),
    );
  }

  /** Lines of values with their labels, at the heights at which they are drawn; that of zero always. */
  #ticks() {
    const at = (/** @type {number} */ height) => {
      const { labels, plot, high, low } = this.sketch(SHORT.width, height);
      const values = labels.filter(({ colour, anchor, at }) => colour === "muted" && anchor === "end" && at.x < plot.left);
      return new Map(values.map(({ text, at }) => [text, { text, y: percent(at.y - 1 - high, low - high), aside: pixels(at.x - plot.left) }]));
    };
    return spans(HEIGHTS, (height) => at(height)).map(({ item, ...span }) => {
      // Taller, the place is known better.
      const { y, aside } = at(Math.min(span.to - 1, HEIGHTS.to)).get(item.text) ?? item;
      return branch(
        "svg", { y, class: this.bounds.classes("h", span, HEIGHTS) },
        branch("line", { x2: "100%", ...(item.text === "0" ? { class: "poster-zero" } : {}) }),
        branch("text", { x: aside, y: 1, "text-anchor": "end" }, item.text),
      );
    });
  }

  /** The curve itself, stretched. */
  #line() {
    const { plot, high, low, curve } = this.tall;
    const place = (/** @type {Point} */ { x, y }) => [Math.round((UNITS.x * (x - plot.left)) / (plot.right - plot.left)), Math.round((UNITS.y * (y - high)) / (low - high))];
    const d = curve.map(({ points }) => {
      const places = points.map(place);
      const steps = places.slice(1).map(([x = 0, y = 0], index) => `${x - (places[index]?.[0] ?? 0)} ${y - (places[index]?.[1] ?? 0)}`);
      return `M${places[0]?.join(" ")}l${steps.join(" ").replaceAll(" -", "-")}`;
    });
    return branch("svg", { viewBox: `0 0 ${UNITS.x} ${UNITS.y}`, preserveAspectRatio: "none" }, branch("path", { d: d.join("") }));
  }

  /** The values of the extremes, where there is room for them. */
  #values() {
    const [low, bound] = [LOWEST + this.foot, this.#bound];
    const all = { from: 0, to: Infinity };
    const places = /** @type {[Sketch, heights: Span, widths: Span][]} */ ([
      [this.#at(LOW), { from: 0, to: low }, all],
      [this.#at(NARROW), { from: low, to: bound }, { from: 0, to: NARROWEST }],
      [this.short, { from: low, to: bound }, { from: NARROWEST, to: Infinity }],
      [this.tall, { from: bound, to: Infinity }, all],
    ]);
    return places.map(([sketch, heights, widths]) => branch(
      "g", { class: this.bounds.classes("h", heights, all) }, branch("g", { class: this.bounds.classes("w", widths, all) }, ...this.#valuesOf(sketch)),
    ));
  }

  /** @param {Sketch} sketch */
  #valuesOf({ labels, plot, high, low, curve }) {
    return labels.filter(({ colour }) => colour === "ink").map(({ at, text, anchor }) => {
      const edge = Math.abs(at.y - high) < Math.abs(at.y - low) ? high : low;
      const reached = curve.flatMap(({ points }) => points).filter(({ y }) => y === edge);
      const of = reached.reduce((near, point) => (Math.abs(point.x - at.x) < Math.abs(near.x - at.x) ? point : near));
      return branch(
        "svg", { x: percent(of.x - plot.left, plot.right - plot.left), y: edge === high ? "0" : "100%" },
        branch("text", { x: pixels(at.x - of.x), y: pixels(at.y - edge), "text-anchor": anchor, class: "poster-value" }, text),
      );
    });
  }

  /**
   * The place of the cursor below the labels, as `drawOverlay` writes it.
   * @param {string} text
   * @param {number} size
   */
  flag(text, size) {
    const half = text.length * size * 0.3 + 5;
    return branch(
      "svg", { class: "poster-flag", "aria-hidden": "true" },
      branch("rect", { width: 2 * half, height: size + 4, rx: 3 }),
      branch("text", { x: half, y: size / 2 + 2.5, "text-anchor": "middle" }, text),
    );
  }

  /** Where that lies. @param {number} drop  below the plot */
  flagRule(drop) {
    const { plot } = this.tall;
    return `.poster-flag{inset:calc(100% - ${TALL.height + this.foot - plot.bottom - drop}px) auto auto ${plot.left - 4}px}`;
  }
}
