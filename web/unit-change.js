/**
 * Another unit, asked plainly: the same cam in other numbers, or the same numbers of another cam.
 *
 * @import { Design, ShellContext } from "./types.d.ts"
 */
import { h } from "./dom.js";

/** Closes the question that is open. */
let close = () => {};

/** The unit that the open question is about, and the one that was chosen. @type {{ from: string, to: string } | null} */
let asked = null;

/**
 * The unit chosen instead of this one, while the question about it is open.
 * @param {string} unit
 */
export const unitAsked = (unit) => (asked?.from === unit ? asked.to : undefined);

/**
 * The unit that a menu shows, and the value that tells what a change does to it.
 * @param {Readonly<Design>} design
 * @param {boolean} speed
 */
function told({ speed: { value: rate, unit }, length_unit, cam }, speed) {
  return speed ? { value: rate, unit } : { value: cam.base_radius ?? cam.length ?? 1, unit: length_unit };
}

/**
 * Asks below the fields what the unit just chosen in `select` is to do.
 * @param {ShellContext} context
 * @param {HTMLSelectElement} select
 * @param {HTMLElement} place  the line that the question follows
 */
export function askUnit(context, select, place) {
  const { store, t, format, announce, module } = context;
  close();
  select.dataset["asking"] = "";
  const speed = select.id === "field-speed-unit";
  const { design } = store.state;
  const before = told(design, speed);
  const to = select.value;

  const root = h("div", { class: "fixes unit-question", role: "group" });
  const unsubscribe = store.subscribe(["design", "language"], (state, changed) => {
    const same = told(state.design, speed).unit === before.unit && state.design.cam.kind === design.cam.kind;
    if (changed.has("language") || !same) done();
  });
  const listening = new AbortController();

  function done() {
    unsubscribe();
    listening.abort();
    root.remove();
    delete select.dataset["asking"];
    select.value = told(store.state.design, speed).unit;
    close = () => {};
    asked = null;
  }

  /** @param {() => void} act */
  const answer = (act) => () => {
    act();
    done();
    select.focus();
  };
  const keep = answer(() => {});

  /** @param {Event} event */
  function escape(event) {
    if (!(event instanceof KeyboardEvent) || event.key !== "Escape") return;
    event.stopPropagation();
    keep();
  }

  close = done;
  if (before.unit === to) return done();
  asked = { from: before.unit, to };

  const read = module().edit(design, [{ op: "convert", unit: to }], store.state.language);
  /** @param {{ value: number, unit: string }} quantity */
  const write = ({ value, unit }) => format.quantity(value, { trim: true, unit });
  const question = t("unit.question", { from: before.unit, to });
  const id = `${select.id}-question`;

  /**
   * @param {string} text
   * @param {() => void} act
   */
  const button = (text, act) => h("button", { type: "button", onclick: answer(act) }, text);
  const { design: converted, error } = read;
  const convert = converted
    ? button(t(speed ? "unit.convert.speed" : "unit.convert.cam", { before: write(before), after: write(told(converted, speed)) }), () =>
        store.edit(t("edit.convert", { unit: to }), [{ op: "convert", unit: to }]),
      )
    : h("p", { class: "error" }, t("unit.refused", { reason: error?.message ?? "" }));
  const label = h("span", { id }, question);
  label.style.flexBasis = "100%";
  root.style.paddingBlock = "var(--space-1) var(--space-2)";
  root.append(
    label,
    convert,
    button(t("unit.relabel", { before: write(before), after: write({ ...before, unit: to }) }), () =>
      store.edit(t("edit.relabel", { unit: to }), [{ op: "relabel", unit: to }]),
    ),
    h("button", { type: "button", class: "quiet", onclick: keep }, t("unit.cancel", { unit: before.unit })),
  );
  root.setAttribute("aria-labelledby", id);
  for (const part of [root, select]) part.addEventListener("keydown", escape, { signal: listening.signal });
  place.after(root);
  root.scrollIntoView({ block: "nearest" });
  announce([question, ...[...root.querySelectorAll("button, p")].map((part) => part.textContent)].join(" "));
}
