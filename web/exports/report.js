/**
 * The report on paper: design, cam to scale, diagrams, verdict and table, made anew each time the browser prints.
 *
 * @import { ColumnName, Design, Diagram, ShellContext } from "../types.d.ts"
 * @import { Make } from "./writers.js"
 */
import { h } from "../dom.js";
import { paperPalette } from "../stage/palette.js";
import { PLOTS, styleOf, unitOf } from "../stage/plots.js";
import { parse } from "../stage/print.js";
import { loadExports } from "./writers.js";
import { dressed } from "./words.js";

/** What the cam may take of an A4 page, mm: the width between its margins, and the height that design and program leave. */
const ROOM = 186;
const TALL = 270;
/** Heights on the first page, mm: head and figures, and each line of the tables. */
const HEAD = 22;
const LINE = 5.2;
/** A cam that would have less than this goes on a page of its own, mm. */
const LEAST = 110;

/** CSS pixels to a millimetre. */
const PIXELS = 96 / 25.4;

/** Heights of a diagram, mm: the most that it gets, the least that it can be read with, and its name. */
const PLOT = 32;
const LEAST_PLOT = 16;
const NAME = 5;

/** Letters to a line of the verdict, and the height of one, mm. */
const LETTERS = 115;
const TEXT = 4.4;

/** @type {Diagram[]} */
const DIAGRAMS = ["s", "v", "a", "j", "pressure_angle", "rho"];

/** @type {ColumnName[]} */
const COLUMNS = ["s", "v", "a", "j", "pressure_angle", "rho", "x", "y"];

/** @param {ShellContext} context */
export function createReport(context) {
  /** @type {Make | null} */
  let make = null;
  /** @type {HTMLElement | null} */
  let placed = null;
  let step = 10;

  addEventListener("beforeprint", () => {
    placed?.remove();
    // A solution that is printed is the whole paper.
    if (document.querySelector("body > .on-paper")) return;
    placed = compose(context, make, step);
    document.body.append(placed);
  });
  addEventListener("afterprint", () => {
    placed?.remove();
    placed = null;
  });

  return {
    /**
     * Loads what the report needs. Without the module that draws the cam to scale there is a report all the same.
     * @param {number} rows  degrees between rows of the table, 0 for none
     */
    async ready(rows) {
      step = rows;
      await dressed;
      make = await loadExports().catch((error) => {
        console.warn(error);
        return null;
      });
    },
  };
}

/**
 * @param {ShellContext} context
 * @param {Make | null} make
 * @param {number} step
 */
function compose(context, make, step) {
  const { store, t } = context;
  const design = store.lastGood();
  const lines = Math.max(magnitudes(context, design).length, (design.segments?.length ?? 0) + 1);
  const left = TALL - HEAD - lines * LINE - 8;
  const apart = left < LEAST;
  const cam = drawn(context, design, make, apart ? TALL - 12 : left);
  const said = verdict(context);
  return h(
    "article",
    { class: "report", lang: store.state.language },
    h("header", {}, h("h1", {}, design.title || t("app.untitled")), h("p", {}, `LevaLab · ${t("report.unit", { unit: design.length_unit })} · ${new Intl.DateTimeFormat(store.state.language, { dateStyle: "long" }).format()}`)),
    h("div", { class: "two" }, section(t("report.design"), table(magnitudes(context, design))), section(t("report.program"), program(context, design))),
    h("figure", { class: apart ? "cam page" : "cam" }, cam),
    h("div", { class: "page" }, section(t("report.verdict"), ...said.nodes), section(t("report.diagrams"), ...diagrams(context, said.height))),
    step > 0 && h("div", { class: "page" }, section(t("report.table"), motion(context, step))),
  );
}

/**
 * @param {string} title
 * @param {...Node} children
 */
const section = (title, ...children) => h("section", {}, h("h2", {}, title), ...children);

/** The design's own numbers: name, value with its unit. @param {ShellContext} context @param {Design} design @returns {[string, string][]} */
function magnitudes({ t, format, catalogue, store }, design) {
  const unit = design.length_unit;
  const { mechanism, pressure_angle_limit, omega } = store.state.report;
  const entry = catalogue.followers.find(({ motion, contact }) => motion === design.follower.motion && contact === design.follower.contact);
  const rows = (entry?.parameters ?? []).flatMap(({ key, symbol, quantity, default: usual }) => {
    const value = design.follower[key] ?? usual;
    if (typeof value !== "number") return [];
    return [/** @type {[string, string]} */ ([`${t(`parameter.${key}`)} ${symbol}`, format.number(value, { unit: quantity === "length" ? unit : "°" })])];
  });
  const speed = `${format.number(design.speed.value)} ${design.speed.unit}${design.speed.unit === "rad/s" ? "" : ` = ${format.quantity(omega, { trim: true })} rad/s`}`;
  const { cam } = design;
  const lengths = /** @type {const} */ (["base_radius", "breadth", "length"]).filter((key) => cam[key]);
  const pair = Object.entries(design.conjugate ?? {});
  return [
    [t("report.follower"), t(`follower.${design.follower.motion}-${design.follower.contact}`)],
    ...lengths.map((key) => /** @type {[string, string]} */ ([key === "base_radius" ? `${t("parameter.base_radius")} Rb` : t(`report.${key}`), format.number(cam[key], { unit })])),
    ...(mechanism.prime_radius === null || mechanism.roller_radius === 0 || !lengths.includes("base_radius") ? [] : [/** @type {[string, string]} */ ([`${t("report.prime_radius")} Rp`, format.number(mechanism.prime_radius, { unit })])]),
    ...rows,
    ...pair.map(([key, value]) => /** @type {[string, string]} */ ([t(`pair.${key}`), format.number(value, { unit: key === "angle" ? "°" : unit })])),
    [t("parameter.speed"), speed],
    ...(cam.rotation ? [/** @type {[string, string]} */ ([t("report.rotation"), t(`report.rotation.${cam.rotation}`)])] : []),
    [`φ ${t("report.limit")}`, format.number(pressure_angle_limit, { unit: "°" })],
  ];
}

/** @param {[string, string][]} rows */
function table(rows) {
  return h("table", {}, h("tbody", {}, ...rows.map(([name, value]) => h("tr", {}, h("th", { scope: "row" }, name), h("td", {}, value)))));
}

/** @param {ShellContext} context @param {Design} design */
function program({ t, format, store }, design) {
  const { borders, units } = store.state.report;
  const place = "length" in design.cam ? design.length_unit : "°";
  const head = ["", t("report.law"), t("report.from"), "β", `L (${units.s})`];
  const rows = (design.segments ?? []).map(({ law, beta, rise }, i) => [
    String(i + 1),
    t(`law.${law}`),
    format.number(borders[i], { unit: place }),
    format.number(beta, { unit: place }),
    rise === undefined ? "" : format.number(rise),
  ]);
  return grid(head, rows, "program");
}

/**
 * @param {string[]} head
 * @param {string[][]} rows
 * @param {string} name
 */
function grid(head, rows, name) {
  return h(
    "table",
    { class: name },
    h("thead", {}, h("tr", {}, ...head.map((text) => h("th", { scope: "col" }, text)))),
    h("tbody", {}, ...rows.map((row) => h("tr", {}, ...row.map((text) => h("td", {}, text))))),
  );
}

/**
 * The cam to scale; without the module that draws it, as it stands on the screen.
 * @param {ShellContext} context
 * @param {Design} design
 * @param {Make | null} make
 * @param {number} height  mm
 */
function drawn({ store }, design, make, height) {
  const { bytes } = make?.(design, { to: "svg", room: [ROOM, height] }, store.state.language) ?? {};
  const drawing = bytes && parse(new TextDecoder().decode(bytes));
  if (drawing) return drawing;
  const canvas = document.querySelector("#mechanism canvas");
  return h("img", { src: canvas instanceof HTMLCanvasElement ? canvas.toDataURL() : "", alt: "" });
}

/** Headline, findings and cures, and about how high they are, mm. @param {ShellContext} context */
function verdict({ store, lab, t }) {
  const { verdict: first, conjugate } = store.state.report;
  const second = conjugate?.verdict;
  const headline = second ? `${first.headline} ${t("report.second")}: ${second.headline}` : first.headline;
  const findings = [...first.findings, ...(second?.findings ?? []).map((finding) => ({ ...finding, message: `${t("report.second")}: ${finding.message}` }))];
  const cures = lab().cures(store.state.language);
  const items = findings.map(({ message }, i) => h("li", {}, message, ...(cures[i] ?? []).map((cure) => h("p", { class: "cure" }, `→ ${cure.message}`))));
  const texts = [headline, ...findings.map(({ message }) => message), ...cures.flat().map(({ message }) => message)];
  const lines = texts.reduce((sum, { length }) => sum + Math.ceil(length / LETTERS), 0);
  return { nodes: [h("p", { class: "headline" }, headline), h("ul", {}, ...items)], height: lines * TEXT };
}

/**
 * As high as the verdict leaves room for on the same page.
 * @param {ShellContext} context
 * @param {number} above  mm
 */
function diagrams({ store, lab, t }, above) {
  const room = (TALL - 20 - above) / DIAGRAMS.length - NAME - 1;
  const height = Math.min(PLOT, Math.max(LEAST_PLOT, room));
  const { report, perSecond } = store.state;
  const palette = { ...paperPalette(), chartSize: 10, stroke: 1.3 };
  return DIAGRAMS.map((diagram) => {
    const plot = PLOTS[diagram];
    const size = { width: ROOM * PIXELS, height: height * PIXELS, ratio: 1, labels: true };
    const drawing = parse(lab().svg(diagram, styleOf(plot, palette, store.state, size)));
    const name = h("figcaption", {}, h("i", {}, perSecond ? plot.perSecond : plot.letter), ` ${t(`diagram.name.${diagram}`)} (${unitOf(plot, report, perSecond)})`);
    return h("figure", {}, name, drawing);
  });
}

/**
 * @param {ShellContext} context
 * @param {number} step
 */
function motion({ store, lab, format }, step) {
  const { units } = store.state.report;
  const theta = lab().column("theta");
  const columns = COLUMNS.map((name) => ({ name, values: lab().column(name) })).filter(({ values }) => values.length > 0);
  const every = Math.max(1, Math.round(((theta.length - 1) * step) / 360));
  const unit = { s: units.s, v: units.v, a: units.a, j: units.j, pressure_angle: "°", rho: units.length, x: units.length, y: units.length };
  const letter = { s: "s", v: "v", a: "a", j: "j", pressure_angle: "φ", rho: "ρ", x: "x", y: "y" };
  const head = ["θ", ...columns.map(({ name }) => `${letter[/** @type {keyof typeof letter} */ (name)]} (${unit[/** @type {keyof typeof unit} */ (name)]})`)];
  const rows = [];
  for (let i = 0; i < theta.length; i += every) {
    rows.push([format.number(theta[i], "length" in store.lastGood().cam ? {} : { unit: "°" }), ...columns.map(({ values }) => format.quantity(tidy(values, i), { trim: true }))]);
  }
  return grid(head, rows, "motion");
}

/** What is nothing beside the rest of its column is zero, and not the rounding that is left. @param {Float64Array} values @param {number} i */
function tidy(values, i) {
  const value = /** @type {number} */ (values[i]);
  const greatest = values.reduce((most, other) => (Number.isFinite(other) ? Math.max(most, Math.abs(other)) : most), 0);
  return Math.abs(value) < 1e-12 * greatest ? 0 : value;
}
