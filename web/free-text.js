/**
 * Data of a free law that are typed or pasted as text: a formula, a table of points, a list of ordinates.
 *
 * @import { FreeEditor } from "./free-editor.js"
 * @import { Segment, ShellContext, State } from "./types.d.ts"
 */
import { clean } from "./clean.js";
import { h } from "./dom.js";
import { setBeta } from "./free-data.js";
import { fieldText, parseNumber } from "./numbers.js";
import { pastedPoints } from "./pasted.js";

/** Lines of a table that are seen at once. */
const LINES = 6;

let sessions = 0;

/**
 * What a text means: data for the segment, or the sentence that says what cannot be read.
 * @typedef {{ data: unknown, problem?: undefined } | { problem: string, data?: undefined }} Meaning
 */

/**
 * @typedef {object} Kind
 * @property {string} key            the field of the segment
 * @property {boolean} long          several lines
 * @property {(segment: Readonly<Segment>, language: "en" | "es") => string} write
 * @property {(text: string, t: ShellContext["t"]) => Meaning} read
 */

/** @type {Kind} */
const FORMULA = {
  key: "expression",
  long: false,
  write: ({ expression }) => expression ?? "",
  read: (text) => ({ data: text }),
};

/** @type {Kind} */
const ORDINATES = {
  key: "ordinates",
  long: false,
  write: ({ ordinates }, language) => (ordinates ?? []).map((value) => fieldText(value, language)).join("  "),
  read(text, t) {
    const numbers = text.trim().split(/[\s;]+/).filter(Boolean).map((word) => parseNumber(word));
    if (numbers.some(({ problem }) => problem)) return { problem: t("ordinates.unreadable") };
    return { data: numbers.map(({ value }) => value) };
  },
};

/** @type {Kind} */
const TABLE = {
  key: "points",
  long: true,
  write: ({ points }, language) => (points ?? []).map((point) => point.map((value) => fieldText(value, language)).join("\t")).join("\n"),
  read(text, t) {
    const { points, line } = pastedPoints(text);
    if (!points) return { problem: t("table.unreadable", { line }) };
    const first = points[0]?.[0] ?? 0;
    return { data: points.map(([at, s]) => [clean(at - first), s]) };
  },
};

/**
 * @param {Kind} kind
 * @returns {(context: ShellContext, place: { id: string, index: () => number }) => FreeEditor}
 */
const create = (kind) => (context, { id, index }) => {
  const { store, t, format } = context;
  const fieldId = `${id}-${kind.key}`;
  const attributes = { id: fieldId, spellcheck: "false", autocomplete: "off", "aria-describedby": `${fieldId}-hint` };
  const field = kind.long ? h("textarea", { ...attributes, rows: LINES }) : h("input", { ...attributes, type: "text" });
  const label = h("label", { for: fieldId });
  const hint = h("p", { class: "hint", id: `${fieldId}-hint` });
  const error = h("p", { class: "error", hidden: true, id: `${fieldId}-error` });
  const span = h("button", { type: "button", class: "quiet", hidden: true });
  const root = h("div", { class: "free-text" }, label, field, error, hint, span);
  const path = () => `segments[${index()}].${kind.key}`;
  /** @type {string | null} */
  let problem = null;
  let shown = "";
  let session = "";

  const focused = () => document.activeElement === field;
  /** @param {Readonly<State>} state */
  const segmentOf = (state) => state.design.segments[index()];

  field.addEventListener("focus", () => {
    session = `text:${++sessions}`;
    store.set({ highlight: { segment: index() } });
  });
  field.addEventListener("blur", () => {
    store.endGesture();
    update(store.state);
  });
  field.addEventListener("input", () => {
    const meaning = kind.read(field.value, t);
    problem = meaning.problem ?? null;
    if (meaning.data !== undefined) {
      store.edit(t(`edit.${kind.key}`), (draft) => adopt(draft.segments[index()], meaning.data), { gesture: session });
      const segment = segmentOf(store.state);
      if (segment) shown = kind.write(segment, store.state.language);
    }
    update(store.state);
  });
  span.addEventListener("click", () => {
    store.edit(t("edit.points"), (draft) => {
      const segment = draft.segments[index()];
      const last = segment?.points?.at(-1)?.[0];
      // The points stay where they are, and the segment goes as far as they do.
      if (segment && last) setBeta(Object.assign(segment, { beta: last }), last);
    });
    field.focus();
  });

  /**
   * @param {Segment | undefined} segment
   * @param {unknown} data
   */
  function adopt(segment, data) {
    if (!segment) return;
    Object.assign(segment, { [kind.key]: data });
    if (kind.key !== "expression") return;
    // Only a formula that names L has a rise to be told.
    const { heights } = store.state.report;
    if (!/L/.test(String(data))) delete segment.rise;
    else segment.rise ??= clean((heights[index() + 1] ?? 0) - (heights[index()] ?? 0));
  }

  /** @param {Readonly<State>} state */
  function update(state) {
    const segment = segmentOf(state);
    if (!segment) return;
    const text = kind.write(segment, state.language);
    if (text !== shown || (!focused() && problem === null)) {
      if (text !== shown) problem = null;
      shown = text;
      if (field.value !== text) field.value = text;
    }
    const own = state.error?.path === path() || state.error?.path.startsWith(`${path()}[`) ? state.error.message : null;
    const message = problem ?? own ?? "";
    error.hidden = message === "";
    if (error.textContent !== message) error.textContent = message;
    if (message) field.setAttribute("aria-invalid", "true");
    else field.removeAttribute("aria-invalid");
    field.setAttribute("aria-describedby", message ? `${error.id} ${hint.id}` : hint.id);
    const last = segment.points?.at(-1)?.[0];
    span.hidden = last === undefined || last <= 0 || last === segment.beta || problem !== null;
    if (last !== undefined) span.textContent = t("table.span", { angle: format.number(last, { unit: "°" }) });
  }

  function speak() {
    label.textContent = t(`free.${kind.key}`, { number: index() + 1 });
    hint.textContent = t(`free.${kind.key}.hint`);
    update(store.state);
  }

  speak();
  return {
    root,
    update,
    speak,
    reset() {
      problem = null;
      shown = "";
      update(store.state);
    },
    paths() {
      const { error } = store.state;
      return error?.path.startsWith(path()) ? [error.path] : [];
    },
  };
};

export const createFormulaField = create(FORMULA);
export const createOrdinatesField = create(ORDINATES);
export const createTableField = create(TABLE);
