/**
 * The report on paper: design, cam to scale, diagrams, verdict and table, made anew each time the browser prints.
 *
 * @import { ColumnName, Design, Diagram, ShellContext } from "../types.d.ts"
 * @import { Module } from "../engine.js"
 * @import { Make } from "./writers.js"
 */
import { h } from "../dom.js";
import { paperPalette } from "../stage/palette.js";
import { letterOf, placeText, unitOfPlace } from "../stage/place.js";
import { PLOTS, styleOf, unitOf } from "../stage/plots.js";
import { parse } from "../stage/print.js";
import { loadExports } from "./writers.js";
import { dressed } from "./words.js";
import { plain } from "../signs.js";

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
/** Those of the second cam of a pair: its derivatives are those of the first with the other sign. @type {ColumnName[]} */
const SECOND_COLUMNS = ["s", "pressure_angle", "rho", "x", "y"];
/** What marks a letter as one of the second cam. */
const SECOND = "₂";

/** Segments that have room beside the design, and in one column below it. */
const BESIDE = 20;
const LONGEST = 23;
/** Height of a line of a narrow table, mm. */
const NARROW = 3.4;

/** Height of a diagram of an application, mm. */
const DRIVEN = 22;

/** @typedef {{ ready: (rows: number) => Promise<void> }} OnPaper */

/** @type {OnPaper | null} */
let onPaper = null;

/** The report that takes the place of the page on paper; there is one. @param {ShellContext} context */
export const reportOnPaper = (context) => (onPaper ??= createReport(context));

/** @param {ShellContext} context @returns {OnPaper} */
function createReport(context) {
  /** @type {Make | null} */
  let make = null;
  /** @type {Module | null} */
  let module = null;
  /** @type {HTMLElement | null} */
  let placed = null;
  let step = 10;

  // The browser's own print asks for nothing before: what may be wanted is there in time.
  const follow = () => void (context.store.lastGood().application && context.whole().then((whole) => (module = whole)));
  context.store.subscribe(["report"], follow);
  follow();

  let clothed = false;
  void dressed.then(() => (clothed = true));

  addEventListener("beforeprint", () => {
    placed?.remove();
    // A solution that is printed is the whole paper.
    if (!clothed || document.querySelector("body > .on-paper")) return;
    placed = compose(context, make, step, module);
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
      module = await context.whole();
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
 * @param {Module | null} module  that works applications out
 */
function compose(context, make, step, module) {
  const { store, t } = context;
  const design = store.lastGood();
  const first = opening(context, design);
  const left = TALL - HEAD - first.height;
  const apart = left < LEAST;
  const cam = drawn(context, design, make, apart ? TALL - 12 : left);
  const said = verdict(context);
  const driven = module && driving(context, design, module);
  return h(
    "article",
    { class: "report", lang: store.state.language },
    h("header", {}, h("h1", {}, design.title || t("app.untitled")), h("p", {}, `LevaLab · ${t("report.unit", { unit: design.length_unit })} · ${new Intl.DateTimeFormat(store.state.language, { dateStyle: "long" }).format()}`)),
    ...first.nodes,
    h("figure", { class: apart ? "cam page" : "cam" }, cam),
    h("div", { class: "page" }, section(t("report.verdict"), ...said.nodes), section(t("report.diagrams"), ...diagrams(context, said.height + (driven?.height ?? 0))), ...(driven ? [section(driven.title, ...driven.nodes)] : [])),
    step > 0 && h("div", { class: "page" }, section(t("report.table"), motion(context, step))),
  );
}

/**
 * @param {string} title
 * @param {...Node} children
 */
const section = (title, ...children) => h("section", {}, h("h2", {}, title), ...children);

/**
 * Design and program side by side; a long program below, in as many columns as it takes to stay on the page. And about how high they are, mm.
 * @param {ShellContext} context
 * @param {Design} design
 */
function opening(context, design) {
  const { t } = context;
  const numbers = magnitudes(context, design);
  const count = segmentsOf(context, design).length;
  if (count <= BESIDE) {
    const nodes = [h("div", { class: "two" }, section(t("report.design"), table(numbers)), section(t("report.program"), program(context, design, 0, count)))];
    return { nodes, height: Math.max(numbers.length, count + 1) * LINE + 8 };
  }
  const half = Math.ceil(numbers.length / 2);
  const columns = Math.ceil(count / LONGEST);
  const each = Math.ceil(count / columns);
  const parts = Array.from({ length: columns }, (_, k) => program(context, design, k * each, Math.min(count, (k + 1) * each)));
  const nodes = [
    section(t("report.design"), h("div", { class: "columns" }, table(numbers.slice(0, half)), table(numbers.slice(half)))),
    section(t("report.program"), h("div", { class: "columns narrow" }, ...parts)),
  ];
  return { nodes, height: half * LINE + (each + 1) * NARROW + 20 };
}

/** The design's own numbers: name, value with its unit. @param {ShellContext} context @param {Design} design @returns {[string, string][]} */
function magnitudes({ t, format, catalogue, store }, design) {
  const unit = design.length_unit;
  const { mechanism, pressure_angle_limit, omega } = store.state.report;
  const entry = catalogue.followers.find(({ motion, contact }) => motion === design.follower.motion && contact === design.follower.contact);
  const rows = (entry?.parameters ?? []).flatMap(({ key, symbol, quantity, default: usual }) => {
    const value = design.follower[key] ?? usual;
    if (typeof value !== "number") return [];
    return [/** @type {[string, string]} */ ([`${t(`parameter.${key}`)} ${key === "arm" ? symbol : plain(symbol)}`, format.number(key === "eccentricity" ? value * (store.state.report.notation?.eccentricity ?? 1) + 0 : value, { unit: quantity === "length" ? unit : "°" })])];
  });
  const speed = `${format.number(design.speed.value)} ${design.speed.unit}${design.speed.unit === "rad/s" || store.state.report.travels ? "" : ` = ${format.quantity(omega, { trim: true })} rad/s`}`;
  const { cam } = design;
  const lengths = /** @type {const} */ (["base_radius", "breadth", "length"]).filter((key) => cam[key]);
  const pair = Object.entries(design.conjugate ?? {});
  return [
    ...(cam.kind === "rotating" ? [] : [/** @type {[string, string]} */ ([t("report.kind"), t(`kind.${cam.kind}`)])]),
    [t("report.follower"), t(`follower.${design.follower.motion}-${design.follower.contact}`)],
    ...lengths.map((key) => /** @type {[string, string]} */ ([key === "base_radius" ? `${t("parameter.base_radius")} ${plain("R_b")}` : t(`report.${key}`), format.number(cam[key], { unit })])),
    ...(mechanism.prime_radius === null || mechanism.roller_radius === 0 || !lengths.includes("base_radius") ? [] : [/** @type {[string, string]} */ ([`${t("report.prime_radius")} ${plain("R_p")}`, format.number(mechanism.prime_radius, { unit })])]),
    ...rows,
    ...pair.map(([key, value]) => /** @type {[string, string]} */ ([t(`pair.${key}`), format.number(value, { unit: key === "angle" ? "°" : unit })])),
    [t("parameter.speed"), speed],
    ...(cam.rotation ? [/** @type {[string, string]} */ ([t("report.rotation"), t(`report.rotation.${cam.rotation}`)])] : []),
    [`${plain("φ")} ${t("report.limit")}`, format.number(pressure_angle_limit, { unit: "°" })],
  ];
}

/** @param {[string, string][]} rows */
function table(rows) {
  return h("table", {}, h("tbody", {}, ...rows.map(([name, value]) => h("tr", {}, h("th", { scope: "row" }, name), h("td", {}, value)))));
}

/** The segments of the design, or those of a motion that is ready-made. @param {ShellContext} context @param {Design} design */
const segmentsOf = ({ store }, design) => store.state.report.program ?? design.segments ?? [];

/** Segments from one to another. @param {ShellContext} context @param {Design} design @param {number} from @param {number} to */
function program(context, design, from, to) {
  const { t, format, store } = context;
  const { borders, units } = store.state.report;
  const place = "length" in design.cam ? design.length_unit : "°";
  const head = ["", t("report.law"), t("report.from"), "β", `L (${units.s})`];
  const rows = segmentsOf(context, design).slice(from, to).map(({ law, beta, rise }, i) => [
    String(from + i + 1),
    t(`law.${law}`),
    format.number(borders[from + i], { unit: place }),
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
  const pair = store.state.report.conjugate;
  const room = (TALL - 20 - above) / DIAGRAMS.length - NAME - 1;
  const height = Math.min(PLOT, Math.max(LEAST_PLOT, room));
  const { report, perSecond } = store.state;
  const palette = { ...paperPalette(), chartSize: pair ? 9 : 10, stroke: 1.3 };
  /** @param {Diagram} diagram @param {boolean} second */
  function figure(diagram, second) {
    const plot = PLOTS[diagram];
    const size = { width: (pair ? ROOM / 2 - 2 : ROOM) * PIXELS, height: height * PIXELS, ratio: 1, labels: true };
    const drawing = parse(lab().svg(diagram, styleOf(plot, palette, store.state, size), second));
    const name = h("figcaption", {}, h("i", {}, `${perSecond ? plot.perSecond : plot.letter}${second ? SECOND : ""}`), ` ${t(`diagram.name.${diagram}`)}${inBrackets(unitOf(plot, report, perSecond))}`);
    return h("figure", {}, name, drawing);
  }
  if (!pair) return DIAGRAMS.map((diagram) => figure(diagram, false));
  const cells = DIAGRAMS.flatMap((diagram) => [figure(diagram, false), figure(diagram, true)]);
  return [h("div", { class: "both" }, h("p", {}, t("diagram.cam.first")), h("p", {}, t("diagram.cam.second")), ...cells)];
}

/**
 * What the follower drives: its figures, its diagrams and the points to hit with their errors; and about how high they are, mm.
 * @param {ShellContext} context
 * @param {Design} design
 * @param {Module} module
 */
function driving({ store, t, format }, design, module) {
  const { language, perSecond, report: cam } = store.state;
  const driven = design.application && module.Driven.of(design);
  const entry = driven && module.applications(design.length_unit, language).find(({ id }) => id === design.application?.kind);
  if (!entry) return null;
  const report = driven.report(language);
  const given = entry.parameters.map(({ id, ...other }) => ({ ...other, value: /** @type {number} */ (design.application?.[id] ?? other.value) }));
  const figures = [...given, ...report.figures].map(({ name, symbol, value, unit }) => `${name} ${symbol} = ${format.quantity(value, { trim: true, unit })}`);
  const palette = { ...paperPalette(), chartSize: 10, stroke: 1.3 };
  const size = { width: ROOM * PIXELS, height: DRIVEN * PIXELS, ratio: 1, labels: true };
  const plots = report.outputs.map(({ name, symbol, unit, min, max, min_at, max_at, per_cycle }, output) => {
    /** @param {number} value */
    const say = (value) => format.quantity(value, { trim: true, unit });
    const style = { ...styleOf(PLOTS.s, palette, store.state, size), curve: output === 0 ? "#006a73" : "#8a3d00", dash: output === 0 ? [] : [7, 3], per_second: perSecond };
    const range = t("report.range", { min: say(min), minAt: placeText(format, cam, min_at), max: say(max), maxAt: placeText(format, cam, max_at) });
    const delivered = per_cycle === null ? "" : `; ${t(cam.travels ? "report.journey" : "report.turn", { volume: say(per_cycle) })}`;
    return h("figure", {}, h("figcaption", {}, h("i", {}, symbol), ` ${name} (${unit}): ${range}${delivered}`), parse(driven.svg(output, style)));
  });
  const main = report.outputs[report.main];
  const head = [`${letterOf(cam)} (${unitOfPlace(cam)})`, "t (s)", ...["wanted", "found", "error"].map((key) => `${t(`report.${key}`)} (${main?.unit})`)];
  const rows = report.targets.map(({ theta, time, value, found, error }) => [format.number(Number(theta.toPrecision(7))), format.quantity(time), format.number(Number(value.toPrecision(7))), format.number(Number(found.toPrecision(6))), format.quantity(error, { trim: true })]);
  driven.free();
  const columns = Math.min(rows.length, rows.length > 6 ? 2 : 1);
  const each = Math.ceil(rows.length / columns);
  const tables = Array.from({ length: columns }, (_, k) => grid(head, rows.slice(k * each, (k + 1) * each), "targets"));
  const nodes = [h("p", {}, figures.join(" · ")), ...plots, rows.length > 0 && h("div", { class: "columns narrow" }, ...tables)].filter((node) => node !== false);
  return { title: entry.title, nodes, height: 12 + plots.length * (DRIVEN + NAME + 1) + (rows.length > 0 ? (each + 1) * NARROW + 2 : 0) };
}

/**
 * @param {ShellContext} context
 * @param {number} step
 */
function motion({ store, lab, format }, step) {
  const { units, conjugate } = store.state.report;
  const theta = lab().column("theta");
  /** @param {ColumnName[]} names @param {boolean} second */
  const columnsOf = (names, second) => names.map((name) => ({ name, second, values: lab().column(name, second) })).filter(({ values }) => values.length > 0);
  const columns = [...columnsOf(COLUMNS, false), ...(conjugate ? columnsOf(SECOND_COLUMNS, true) : [])];
  const every = Math.max(1, Math.round(((theta.length - 1) * step) / 360));
  const unit = { s: units.s, v: units.v, a: units.a, j: units.j, pressure_angle: "°", rho: units.length, x: units.length, y: units.length };
  const letter = { s: "s", v: "v", a: "a", j: "j", pressure_angle: "φ", rho: "ρ", x: "x", y: "y" };
  const { report } = store.state;
  const head = [report.travels ? `x (${units.length})` : "θ", ...columns.map(({ name, second }) => `${["x", "y"].includes(name) ? name : plain(letter[/** @type {keyof typeof letter} */ (name)])}${second ? SECOND : ""}${inBrackets(unit[/** @type {keyof typeof unit} */ (name)])}`)];
  const rows = [];
  for (let i = 0; i < theta.length; i += every) {
    rows.push([report.travels ? format.quantity(theta[i], { trim: true }) : format.number(theta[i], { unit: "°" }), ...columns.map(({ values }) => format.quantity(tidy(values, i), { trim: true }))]);
  }
  return grid(head, rows, conjugate ? "motion wide" : "motion");
}

/** A length by a length has no unit. @param {string} unit */
const inBrackets = (unit) => (unit ? ` (${unit})` : "");

/** What is nothing beside the rest of its column is zero, and not the rounding that is left. @param {Float64Array} values @param {number} i */
function tidy(values, i) {
  const value = /** @type {number} */ (values[i]);
  const greatest = values.reduce((most, other) => (Number.isFinite(other) ? Math.max(most, Math.abs(other)) : most), 0);
  return Math.abs(value) < 1e-12 * greatest ? 0 : value;
}
