/**
 * What is driven, and its parameters with what follows from them.
 *
 * @import { ApplicationDesign, ApplicationEntry, ApplicationMagnitude, ShellContext } from "../types.d.ts"
 * @import { NumberField } from "../number-field.js"
 * @import { Work } from "./work.js"
 */
import { h, symbol } from "../dom.js";
import { createNumberField, lengthStep, ownStep } from "../number-field.js";

/** Parameters that are lengths of the cam's size, and are stepped like it. */
const LENGTHS = ["piston_radius", "seat_diameter"];

/**
 * @param {ShellContext} context
 * @param {Work} work
 */
export function createFields(context, work) {
  const { store, t, format } = context;
  const kind = h("select", { id: "application-kind" });
  const label = h("label", { for: kind.id });
  const figures = h("p", { class: "application-figures" });
  const rows = h("div", { class: "application-fields" }, label, kind);
  const root = h("div", {}, rows, figures);
  /** @type {NumberField[]} */
  let fields = [];
  let made = "";

  kind.addEventListener("change", () => {
    const entry = work.entries.find(({ id }) => id === kind.value);
    store.edit(t("edit.application"), [{ op: "application", ...(entry ? { application: entry.id } : {}) }]);
  });

  /**
   * A field for each parameter of an entry.
   * @param {ApplicationEntry | undefined} entry
   */
  function build(entry) {
    const state = `${entry?.id} ${store.state.language} ${store.state.design.length_unit}`;
    if (state === made) return;
    made = state;
    fields = (entry?.parameters ?? []).map((parameter) => field(parameter));
    rows.replaceChildren(label, kind, ...fields.flatMap((field) => cells(field)));
    for (const field of fields) field.speak();
  }

  /** @param {ApplicationMagnitude} parameter */
  function field({ id: key, symbol: sign, name, unit }) {
    const shown = h("span", {}, h("span", { class: "application-name" }, name, " "), sign.length > 1 ? h("i", { class: "symbol" }, sign) : symbol(sign));
    return createNumberField(context, {
      id: `application-${key}`,
      name: () => name,
      label: shown,
      unit: () => unit,
      read: ({ application }) => number(application?.[key]),
      write: (value) => [{ path: ["application", key], value }],
      step: (design) => (LENGTHS.includes(key) ? lengthStep(design) : unit === "°" ? 1 : ownStep(number(design.application?.[key]) ?? 1)),
      path: () => `application.${key}`,
      highlight: () => ({}),
    });
  }

  /** @param {NumberField} field */
  function cells({ label: name, input, unit, error }) {
    // The name is seen already; that which is only heard would be told twice.
    name?.querySelector(".unseen")?.remove();
    return [name ?? h("span"), h("span"), input, unit, error];
  }

  return {
    root,
    update() {
      const { application } = store.state.design;
      label.textContent = t("application.kind");
      kind.replaceChildren(h("option", { value: "" }, t("application.none")), ...work.entries.map(({ id, title }) => h("option", { value: id }, title)));
      kind.value = application?.kind ?? "";
      build(work.entries.find(({ id }) => id === application?.kind));
      for (const field of fields) field.update(store.state);
      const told = (work.report?.figures ?? []).map(({ symbol: sign, name, unit, value }) => h("span", {}, `${name} `, h("i", { class: "symbol" }, sign), ` = ${format.quantity(value, { unit })}`));
      figures.replaceChildren(...told);
      figures.hidden = told.length === 0;
    },
  };
}

/** @param {ApplicationDesign[string]} value */
const number = (value) => (typeof value === "number" ? value : undefined);
