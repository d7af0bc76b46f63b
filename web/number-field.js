/**
 * A number of the design: label, field, unit, and what is wrong with it told beneath.
 *
 * @import { Design, Edit, ShellContext, State } from "./types.d.ts"
 */
import { h, hide, write as writeText } from "./dom.js";
import { CUT, fieldText, parseNumber, restingText, sum } from "./numbers.js";
import { notePending } from "./pending.js";
import { factor, scrub } from "./scrub.js";
import { unitAsked } from "./unit-change.js";

let sessions = 0;

/** Characters that a usual field has room for. */
const ROOM = 7;
/**
 * @typedef {object} Options
 * @property {string} id
 * @property {() => string} name        what the undo step and screen readers call it
 * @property {Node} [label]             what is seen before the field; without it `name` is only heard
 * @property {() => string} unit
 * @property {(design: Readonly<Design>) => number | undefined} read
 * @property {(value: number) => Edit[]} write
 * @property {() => Edit[]} [clear]     makes nothing of it: then the field may be left empty
 * @property {(design: Readonly<Design>) => number} step
 * @property {() => string} path        where the engine's errors point
 * @property {() => import("./types.d.ts").Highlight} highlight
 * @property {number} [room]            characters that there is room for
 * @property {() => string} [own]       the unit that a number without one is in, where `unit` is not it
 * @property {boolean} [signed]         may be negative: its keyboard has a minus sign on every phone
 * @property {boolean} [late]           taken when the field is left: rows are sorted by it, and must not move while one types
 */

/**
 * @param {ShellContext} context
 * @param {Options} options
 */
export function createNumberField({ store, t }, { id, name, label, unit, read, write, clear, step, path, highlight, room = ROOM, own = unit, signed = false, late = false }) {
  const errorId = `${id}-error`;
  const input = h("input", { id, type: "text", inputmode: signed ? "text" : "decimal", autocomplete: "off", spellcheck: "false", class: "number" });
  const unitNode = h("span", { class: "unit", id: `${id}-unit` });
  const error = h("p", { class: "error", id: errorId, hidden: true });
  const heard = h("span", { class: "unseen" });
  const labelNode = label ? h("label", { for: id, id: `${id}-label` }, label, heard) : null;

  /** @type {number | undefined} */
  let shown;
  /** What was typed and could not be read. @type {string | null} */
  let pending = null;
  /** Why the number was not taken. @type {import("./types.d.ts").DesignError | null} */
  let refusal = null;
  /** What was typed into a late field and is still to be taken. @type {number | undefined} */
  let waiting;
  /** @type {number | undefined} */
  let before;
  let session = "";
  /** The units that typing has chosen between while this session lasts. @type {{ from: string, to: string } | null} */
  let answer = null;

  const current = () => read(store.state.design);
  const focused = () => document.activeElement === input;
  /** The unit chosen instead of the present one: asked about, or answered by typing before the text became unreadable for a moment. */
  const chosenUnit = () => unitAsked(own()) ?? (answer?.from === own() ? answer.to : undefined);
  /** The unit of a number without one. */
  const readUnit = () => chosenUnit() ?? own();

  function begin() {
    session = `field:${++sessions}`;
    before = current();
    answer = null;
  }

  /** @param {number} value */
  function show(value) {
    shown = value;
    const { language } = store.state;
    const text = focused() ? fieldText(value, language) : restingText(value, room, language);
    if (input.value !== text) input.value = text;
    const whole = text.includes(CUT) ? `${fieldText(value, language)}${unit() === "°" ? "" : " "}${unit()}` : "";
    if (input.title !== whole) input.title = whole;
  }

  /**
   * @param {number} value
   * @param {string} gesture
   */
  function change(value, gesture) {
    // Typing on answers the question about another unit: the same numbers, in that unit.
    const to = chosenUnit();
    if (to !== undefined) answer = { from: own(), to };
    /** @type {Edit[]} */
    const relabelled = to === undefined ? [] : [{ op: "relabel", unit: to }];
    if (value === current() && to === undefined) refusal = null;
    else refusal = store.edit(t("edit.field", { name: name() }), [...relabelled, ...write(value)], { gesture, told: true });
  }

  let told = "";

  /** @param {string | null} message */
  function tell(message) {
    const state = `${message ?? ""}\n${pending !== null}\n${unit()}`;
    if (state === told) return;
    told = state;
    hide(error, message === null);
    if (message !== null) writeText(error, message);
    if (message === null) input.removeAttribute("aria-invalid");
    else input.setAttribute("aria-invalid", "true");
    const described = [unit() && !labelNode?.contains(unitNode) ? unitNode.id : "", message === null ? "" : errorId].filter(Boolean).join(" ");
    if (described) input.setAttribute("aria-describedby", described);
    else input.removeAttribute("aria-describedby");
    notePending(input, pending !== null);
  }

  /** @param {number} value */
  function take(value) {
    shown = value;
    change(value, session);
    // What was refused stays as it was typed, and the design as it was.
    if (refusal) shown = current();
  }

  /** @param {string} gesture */
  function empty(gesture) {
    pending = null;
    shown = undefined;
    refusal = clear && current() !== undefined ? store.edit(t("edit.field", { name: name() }), clear(), { gesture, told: true }) : null;
    update(store.state);
  }

  function typed() {
    if (clear && input.value.trim() === "") return empty(session);
    const { value } = parseNumber(input.value, readUnit());
    waiting = undefined;
    if (value === undefined) {
      // The design keeps the value that it had: a number on its way is none.
      pending = input.value;
      shown = before;
      store.cancel(session);
    } else {
      pending = null;
      if (late) waiting = value;
      else take(value);
    }
    update(store.state);
  }

  /** @param {KeyboardEvent} event */
  function key(event) {
    if (event.key === "ArrowUp" || event.key === "ArrowDown") {
      event.preventDefault();
      const value = waiting ?? current();
      if (value === undefined) return;
      const by = step(store.state.design) * factor(event) * (event.key === "ArrowUp" ? 1 : -1);
      pending = null;
      if (late) waiting = sum(value, by);
      else change(sum(value, by), session);
      if (late) input.value = fieldText(sum(value, by), store.state.language);
      else show(sum(value, by));
      update(store.state);
    } else if (event.key === "Escape" && (pending !== null || waiting !== undefined || refusal || current() !== before)) {
      event.preventDefault();
      event.stopPropagation();
      pending = refusal = null;
      waiting = undefined;
      store.cancel(session);
      rest();
      begin();
    } else if (event.key === "Enter") {
      rest();
      begin();
      input.select();
    }
  }

  /** The field at rest shows its number in the usual form; what could not be read stays as it was typed. */
  function rest() {
    if (waiting !== undefined) take(waiting);
    waiting = undefined;
    const value = current();
    if (pending === null && !refusal && value !== undefined) show(value);
    store.endGesture();
    update(store.state);
  }

  input.addEventListener("focus", () => {
    begin();
    const value = current();
    if (pending === null && value !== undefined) show(value);
    input.select();
    store.set({ highlight: highlight() });
  });
  input.addEventListener("blur", () => {
    rest();
    store.set({ highlight: null });
  });
  input.addEventListener("input", typed);
  input.addEventListener("keydown", key);
  if (labelNode) {
    scrub(labelNode, {
      value: () => current() ?? 0,
      step: () => step(store.state.design),
      change,
      cancel: (gesture) => store.cancel(gesture),
      end: () => store.endGesture(),
    });
    labelNode.addEventListener("pointerenter", () => store.set({ highlight: highlight() }));
    labelNode.addEventListener("pointerleave", () => {
      if (!focused()) store.set({ highlight: null });
    });
  }

  /** @param {Readonly<State>} state */
  function update(state) {
    const value = read(state.design);
    if (value === undefined) {
      if (!clear || pending !== null || refusal) return;
      if (shown !== undefined) input.value = input.title = "";
      shown = undefined;
    } else if (value !== shown) {
      pending = refusal = null;
      show(value);
    }
    const wrong = state.error !== null && state.error.path === path() ? state.error.message : null;
    tell(pending === null ? (refusal?.message ?? wrong) : (parseNumber(pending, readUnit(), state.language).problem ?? null));
  }

  return {
    label: labelNode,
    input,
    unit: unitNode,
    error,
    update,

    /** Words again, after a change of language. */
    speak() {
      writeText(heard, ` ${name()}`);
      if (!labelNode) input.setAttribute("aria-label", name());
      writeText(unitNode, unit());
      const value = current();
      if (value !== undefined && pending === null) show(value);
      update(store.state);
    },

    /** The unit alone, which follows the design. */
    speakUnit() {
      writeText(unitNode, unit());
    },

    /** Forgets what could not be read. */
    reset() {
      pending = refusal = null;
      shown = undefined;
      update(store.state);
    },
  };
}

/** @typedef {ReturnType<typeof createNumberField>} NumberField */

/**
 * A step of lengths that suits the cam's size: 1 for a base radius of 35, 0.01 for 0.2.
 * @param {Readonly<Design>} design
 */
export function lengthStep(design) {
  const { base_radius: radius, length = 0 } = design.cam;
  const size = Math.abs(radius ?? length / 4) / 20;
  return size > 0 && Number.isFinite(size) ? 10 ** Math.floor(Math.log10(size) + 1e-9) : 1;
}

/**
 * The same of heights, which are angles when the follower swings.
 * @param {Readonly<Design>} design
 */
export const heightStep = (design) => (design.follower.motion === "oscillating" ? 1 : lengthStep(design));

/**
 * A step of a tenth of the leading digit: 10 for 390, 0.1 for 1.
 * @param {number} value
 */
export function ownStep(value) {
  return value === 0 || !Number.isFinite(value) ? 0.1 : 10 ** (Math.floor(Math.log10(Math.abs(value)) + 1e-9) - 1);
}
