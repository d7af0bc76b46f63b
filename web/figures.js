/**
 * The key figures of the cam in one line: pressure angle with its limit, smallest radius of curvature, lift, opening of the arm, face length.
 *
 * Of a pair they are those of the cam that the headline is about.
 *
 * @import { Range, Report, ShellContext } from "./types.d.ts"
 */
import { h, hide, write } from "./dom.js";
import { mark } from "./help-mark.js";
import { headlined, placeIn } from "./stage/place.js";

/** What the question mark beside a figure explains. @type {Record<string, string>} */
const TERMS = { phi: "pressure_angle" };

/** How far a breadth may vary, as a part of it, and be called constant. */
const CONSTANT = 1e-12;

/** @param {ShellContext} context */
export function createFigures(context) {
  const { store, t } = context;
  const whose = h("span", { class: "figures-cam" });
  const root = h("div", { class: "figures", role: "group" }, whose);
  /** @type {HTMLButtonElement[]} */
  const buttons = [];

  const entries = () => figuresOf(context, headlined(store.state).report);

  return {
    root,

    update() {
      const list = entries();
      const { cam } = headlined(store.state);
      hide(whose, cam === undefined);
      write(whose, cam === undefined ? "" : t("verdict.figure.cam", { number: cam }));
      while (buttons.length > list.length) buttons.pop()?.parentElement?.remove();
      while (buttons.length < list.length) buttons.push(figure(buttons.length));
      list.forEach(([kind, text], index) => {
        const button = buttons[index];
        if (!button) return;
        write(button, text);
        if (button.classList.contains(kind)) return;
        button.className = `figure ${kind}`;
        const asks = button.nextElementSibling;
        if (asks instanceof HTMLElement) asks.dataset["term"] = TERMS[kind] ?? kind;
      });
    },

    speak: () => root.setAttribute("aria-label", t("verdict.figures")),
  };

  /** A figure, which leads to where it is reached. @param {number} index */
  function figure(index) {
    const button = h("button", { type: "button", id: `figure-${index}` });
    button.addEventListener("click", () => {
      const theta = entries()[index]?.[2];
      const { cam } = headlined(store.state);
      if (theta !== undefined) store.set({ cursor: placeIn(store.state.report, theta), playing: false, ...(cam ? { second: cam === 2 } : {}) });
    });
    root.append(h("span", { class: "figure-place" }, button, mark("", button.id)));
    return button;
  }
}

/** @param {Range} range */
function steepest({ min, min_at, max, max_at }) {
  return Math.abs(min ?? 0) > Math.abs(max ?? 0) ? min_at : max_at;
}

/**
 * The figures of a cam: kind, text, and the place that it leads to.
 * @param {ShellContext} context
 * @param {Report} report
 */
function figuresOf({ t, format }, { summary, least_convex, pressure_angle_limit, mechanism, units }) {
  /** @param {number | null | undefined} value */
  const angle = (value) => format.angle(value);
  const { pressure_angle: phi, s: lift, contact, breadth } = summary;
  /** @type {[string, string, number | undefined][]} */
  const list = [];
  if (phi && mechanism.contact !== "flat") {
    list.push(["phi", t("verdict.figure.phi", { min: angle(phi.min), max: angle(phi.max), limit: format.number(pressure_angle_limit, { unit: "°" }) }), steepest(phi)]);
  }
  if (least_convex) {
    const value = format.quantity(least_convex.value, { trim: true, unit: units.length });
    list.push(["rho", t("verdict.figure.rho", { value }), least_convex.at]);
  }
  if (lift) list.push(["s", t("verdict.figure.lift", { value: format.quantity(lift.max, { trim: true, unit: units.s }) }), lift.max_at]);
  if (breadth) list.push(["breadth", t("verdict.figure.breadth", { value: constant(breadth, units.length, format) }), undefined]);
  if (mechanism.opening !== null) list.push(["opening", t("verdict.figure.opening", { value: format.number(mechanism.opening, { digits: 2, unit: "°" }) }), 0]);
  if (contact && mechanism.face && mechanism.face_length !== null) {
    const [value, near, far] = [mechanism.face_length, ...mechanism.face].map((part) => format.quantity(part, { trim: true, unit: units.length }));
    list.push(["face", t(mechanism.pivot ? "verdict.figure.face.swing" : "verdict.figure.face", { value, near, far }), contact.max_at]);
  }
  return list;
}

/**
 * A breadth measured over the turn: one value when its least and greatest are the same but for rounding, as they must be.
 * @param {Range} breadth
 * @param {string} unit
 * @param {ShellContext["format"]} format
 */
function constant({ min, max }, unit, format) {
  const [least, most] = [min ?? NaN, max ?? NaN];
  const same = Math.abs(most - least) <= CONSTANT * Math.abs(most);
  return same ? format.number(Number(most.toPrecision(9)), { unit }) : `${format.number(least)} … ${format.number(most, { unit })}`;
}
