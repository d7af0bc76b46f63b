/**
 * Editors of free laws that are one text: a formula, the ordinates of a Bézier curve, the points of a table with what the curve leaves of them.
 *
 * @import { FreeEditor } from "./free-parts.js"
 * @import { ShellContext, State } from "./types.d.ts"
 * @import { Kind } from "./text-field.js"
 */
import { h, symbol, write } from "./dom.js";
import { assemble } from "./free-parts.js";
import { marksOf } from "./marks.js";
import { createMeasured } from "./measured.js";
import { fieldText, parseNumber } from "./numbers.js";
import { createTextField } from "./text-field.js";

/** @typedef {{ id: string, index: () => number }} Place */

/** @type {Kind} */
const FORMULA = {
  key: "expression",
  radians: true,
  write: ({ expression }) => expression ?? "",
  read: (text) => ({ data: text }),
  // Its rise may come or go with it.
  edits: (data, segment) => [{ op: "formula", segment, text: String(data) }],
};

/** @type {Kind} */
const ORDINATES = {
  key: "ordinates",
  write: ({ ordinates }, language) => listed(ordinates, language),
  read(text, t) {
    const meaning = numbersIn(text, t);
    return meaning.problem === undefined ? { data: meaning.data ?? [] } : meaning;
  },
};

/** Left empty, the engine takes its own. @type {Kind} */
export const KNOTS = {
  key: "knots",
  write: ({ knots }, language) => listed(knots, language),
  read: numbersIn,
};

/**
 * @param {number[] | undefined} numbers
 * @param {"en" | "es"} language
 */
function listed(numbers, language) {
  return (numbers ?? []).map((value) => fieldText(value, language)).join("  ");
}

/**
 * Numbers with spaces between them; none for an empty text.
 * @param {string} text
 * @param {ShellContext["t"]} t
 * @returns {import("./text-field.js").Meaning}
 */
function numbersIn(text, t) {
  const numbers = text.trim().split(/[\s;]+/).filter(Boolean).map((word) => parseNumber(word));
  if (numbers.some(({ problem }) => problem)) return { problem: t("numbers.unreadable") };
  return { data: numbers.length > 0 ? numbers.map(({ value }) => value) : undefined };
}

/** @param {Kind} kind @returns {(context: ShellContext, place: Place) => FreeEditor} */
const ofOneField = (kind) => (context, place) => {
  const field = createTextField(context, place, kind);
  return assemble(context, { root: field.root, fields: () => [field], word: () => undefined, paths: field.paths });
};

export const createFormulaField = ofOneField(FORMULA);
export const createOrdinatesField = ofOneField(ORDINATES);

/**
 * @param {ShellContext} context
 * @param {Place} place
 * @returns {FreeEditor}
 */
export function createTableField(context, place) {
  const { store, t, format } = context;
  const { index } = place;
  const measured = createMeasured(context, place, () => {
    field.reset();
    field.input.focus();
  });
  /** @type {Kind} */
  const table = {
    key: "points",
    long: true,
    write: ({ points }, language) => (points ?? []).map((point) => point.map((value) => fieldText(value, language)).join("\t")).join("\n"),
    read(text, t, event) {
      const { points, error } = measured.read(text, /Paste|Drop/.test(event.inputType), field.input);
      return points ? { data: points } : { problem: error?.message ?? t("measured.choose") };
    },
  };
  const field = createTextField(context, place, table);
  const span = h("button", { type: "button", class: "quiet", hidden: true });
  const summary = h("summary");
  const head = h("thead", {}, h("tr", {}, h("th", { scope: "col" }, symbol("θ")), h("th", { scope: "col" }, symbol("s")), h("th", { scope: "col" })));
  const body = h("tbody");
  const scroll = h("div", { class: "residuals", tabindex: "0", role: "region" }, h("table", {}, head, body));
  const residuals = h("details", { hidden: true }, summary, scroll);
  field.root.append(measured.panel, span, ...measured.opener, residuals);

  span.addEventListener("click", () => {
    const last = store.state.design.segments[index()]?.points?.at(-1)?.[0];
    // The points stay where they are, and the segment goes as far as they do.
    if (last) store.edit(t("edit.points"), [{ path: ["segments", index(), "beta"], value: last }]);
    field.input.focus();
  });

  /** @param {Readonly<State>} state */
  function follow({ design }) {
    const segment = design.segments[index()];
    measured.follow();
    const last = segment?.points?.at(-1)?.[0];
    span.hidden = last === undefined || last <= 0 || last === segment?.beta || !field.readable();
    if (last !== undefined) write(span, t("table.span", { angle: format.number(last, { unit: "°" }) }));
    residuals.hidden = !(Number(segment?.["smoothing"]) > 0);
    if (!residuals.hidden) tell();
  }

  /** What the curve leaves of each point. */
  function tell() {
    const marks = marksOf(context).filter(({ kind, segment }) => kind === "point" && segment === index());
    const [first] = marks;
    if (!first) return;
    const { units } = store.state.report;
    const worst = marks.reduce((worst, mark) => (Math.abs(mark.residual) > Math.abs(worst.residual) ? mark : worst), first);
    write(summary, t("residuals.summary", { value: format.quantity(worst.residual, { unit: units.s }), at: format.number(worst.at, { unit: "°" }) }));
    scroll.setAttribute("aria-label", t("residuals.title", { number: index() + 1 }));
    const [, , title] = head.querySelectorAll("th");
    if (title) write(title, t("residuals.head"));
    while (body.rows.length > marks.length) body.deleteRow(-1);
    marks.forEach(({ at, height, residual }, k) => {
      const row = body.rows[k] ?? body.insertRow();
      [format.number(at), format.number(height), format.quantity(residual)].forEach((text, column) => write(row.cells[column] ?? row.insertCell(), text));
    });
  }

  return assemble(context, { root: field.root, fields: () => [field], word: measured.speak, follow, paths: field.paths });
}
