/**
 * Data of a free law that are typed or pasted as text: a formula, a list of numbers, a table.
 *
 * @import { Edit, Segment, ShellContext, State } from "./types.d.ts"
 */
import { h, hide, write } from "./dom.js";
import { mark } from "./help-mark.js";

/** Lines of a long text that are seen at once. */
const LINES = 6;

let sessions = 0;

/**
 * What a text means: data for the segment (none take the field away), or the sentence that says what cannot be read.
 * @typedef {{ data: unknown, problem?: undefined } | { problem: string, data?: undefined }} Meaning
 */

/**
 * @typedef {object} Kind
 * @property {string} key            the field of the segment, and its entry among the terms
 * @property {boolean} [long]        several lines
 * @property {boolean} [radians]     where the follower swings it is in radians, unlike the numbers on the page, and says so
 * @property {(segment: Readonly<Segment>, language: "en" | "es") => string} write
 * @property {(text: string, t: ShellContext["t"], event: InputEvent) => Meaning} read
 * @property {(data: unknown, index: number) => Edit[]} [edits]  instead of the value of its field
 */

/**
 * @param {ShellContext} context
 * @param {{ id: string, index: () => number }} place
 * @param {Kind} kind
 */
export function createTextField({ store, t }, { id, index }, kind) {
  const { key } = kind;
  const fieldId = `${id}-${key}`;
  const attributes = { id: fieldId, spellcheck: "false", autocomplete: "off" };
  const input = kind.long ? h("textarea", { ...attributes, rows: LINES }) : h("input", { ...attributes, type: "text" });
  const label = h("label", { for: fieldId, id: `${fieldId}-label` });
  const hint = h("p", { class: "hint", id: `${fieldId}-hint` });
  const error = h("p", { class: "error", hidden: true, id: `${fieldId}-error` });
  const root = h("div", { class: "free-text" }, h("div", { class: "ask" }, label, mark(key, label.id)), input, error, hint);
  const path = () => `segments[${index()}].${key}`;
  /** @type {string | null} */
  let problem = null;
  let shown = "";
  let session = "";
  let swings = false;

  /** @param {Readonly<State>} state */
  const segmentOf = (state) => state.design.segments[index()];

  input.addEventListener("focus", () => {
    session = `text:${++sessions}`;
    store.set({ highlight: { segment: index() } });
  });
  input.addEventListener("blur", () => {
    store.endGesture();
    update(store.state);
  });
  input.addEventListener("input", (event) => {
    const { data, problem: unread } = kind.read(input.value, t, event instanceof InputEvent ? event : new InputEvent("input"));
    problem = unread ?? null;
    if (problem === null) {
      problem = store.edit(t(`edit.${key}`), editsFor(data), { gesture: session, told: true })?.message ?? null;
      const segment = segmentOf(store.state);
      if (segment) shown = kind.write(segment, store.state.language);
    }
    update(store.state);
  });

  /** @param {unknown} data @returns {Edit[]} */
  function editsFor(data) {
    const segment = segmentOf(store.state);
    const place = ["segments", index(), key];
    if (kind.edits) return kind.edits(data, index());
    if (data !== undefined) return [{ path: place, value: data }];
    return segment?.[key] === undefined ? [] : [{ op: "clear", path: place }];
  }

  /** @param {Readonly<State>} state */
  function update(state) {
    const segment = segmentOf(state);
    if (!segment) return;
    if (kind.radians && swings !== (state.design.follower.motion === "oscillating")) word();
    const text = kind.write(segment, state.language);
    if (text !== shown || (document.activeElement !== input && problem === null)) {
      if (text !== shown) problem = null;
      shown = text;
      if (input.value !== text) input.value = text;
    }
    const own = state.error?.path === path() || state.error?.path.startsWith(`${path()}[`) ? state.error.message : null;
    const message = problem ?? own ?? "";
    hide(error, message === "");
    write(error, message);
    if (message) input.setAttribute("aria-invalid", "true");
    else input.removeAttribute("aria-invalid");
    input.setAttribute("aria-describedby", message ? `${error.id} ${hint.id}` : hint.id);
  }

  /** What is asked for, and in what. */
  function word() {
    swings = kind.radians === true && store.state.design.follower.motion === "oscillating";
    write(label, t(swings ? `free.${key}.swing` : `free.${key}`, { number: index() + 1 }));
    write(hint, `${swings ? `${t(`free.${key}.swing.hint`)} ` : ""}${t(`free.${key}.hint`)}`);
  }

  return {
    root,
    input,
    error,
    update,
    readable: () => problem === null,

    speak() {
      word();
      update(store.state);
    },

    reset() {
      problem = null;
      shown = "";
      update(store.state);
    },

    /** The place of the engine's complaint, when it is about this field. */
    paths() {
      const found = store.state.error?.path;
      return found === path() || found?.startsWith(`${path()}[`) ? [found] : [];
    },
  };
}

/** @typedef {ReturnType<typeof createTextField>} TextField */
