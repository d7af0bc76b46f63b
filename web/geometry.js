/**
 * Geometry and speed: a dimensioned drawing with its fields, generated from the catalogue.
 *
 * @import { Design, FollowerEntry, KindId, Parameter, Rotation, ShellContext } from "./types.d.ts"
 * @import { NumberField } from "./number-field.js"
 * @import { Texts } from "./texts.js"
 */
import { h, hide, symbol, write } from "./dom.js";
import { followerEntry } from "./follower-choice.js";
import { createHelpDrawing } from "./help-drawing.js";
import { mark } from "./help-mark.js";
import { createNumberField, lengthStep, ownStep } from "./number-field.js";
import { askUnit } from "./unit-change.js";

/** @type {Rotation[]} */
const ROTATIONS = ["counterclockwise", "clockwise"];
const TURNING = { counterclockwise: "↺", clockwise: "↻" };

/** Magnitudes of the cam itself, by its kind. */
/** @type {Record<KindId, Pick<Parameter, "key" | "symbol" | "quantity">[]>} */
const MAGNITUDES = {
  rotating: [{ key: "base_radius", symbol: "R_b", quantity: "length" }],
  grooved: [{ key: "base_radius", symbol: "R_b", quantity: "length" }],
  "constant-breadth": [
    { key: "base_radius", symbol: "R_b", quantity: "length" },
    { key: "breadth", symbol: "d_c", quantity: "length" },
  ],
  translating: [{ key: "length", symbol: "ℓ", quantity: "length" }],
};
const OF_THE_CAM = ["base_radius", "breadth", "length"];

/** What a follower cannot have in a yoke or on a cam that travels. */
const OFF_CENTRE = ["eccentricity", "face_angle"];

/**
 * @param {ShellContext} context
 * @param {Texts} texts
 */
export function createGeometry(context, texts) {
  const { store, catalogue, t } = context;
  const rows = h("div", { class: "fields" });
  const general = h("p", { class: "error", hidden: true });
  /** @type {{ key: string, field: NumberField }[]} */
  let fields = [];
  /** @type {FollowerEntry | undefined} */
  let shown;
  /** @type {KindId} */
  let kind = "rotating";

  const drawing = createHelpDrawing({
    pick: (parameter) => fields.find(({ key }) => key === parameter)?.field.input.focus(),
    point: (parameter) => store.set({ highlight: parameter === null ? null : { parameter } }),
  });

  const speed = createNumberField(context, {
    id: "field-speed",
    label: symbol("ω"),
    name: () => t("parameter.speed"),
    unit: () => "",
    own: () => store.state.design.speed.unit,
    read: (design) => design.speed.value,
    write: (value) => [{ path: ["speed", "value"], value }],
    step: (design) => ownStep(design.speed.value),
    path: () => "speed.value",
    highlight: () => ({ parameter: "speed" }),
  });
  const pace = createNumberField(context, {
    id: "field-pace",
    label: symbol("v", true),
    name: () => t("parameter.pace"),
    unit: () => store.state.design.speed.unit,
    read: (design) => design.speed.value,
    write: (value) => [{ path: ["speed", "value"], value }],
    step: (design) => ownStep(design.speed.value),
    path: () => "speed.value",
    highlight: () => ({ parameter: "speed" }),
  });
  const speedUnit = unitSelect("field-speed-unit", catalogue.speed_units);
  const lengthUnit = unitSelect("field-length-unit", catalogue.length_units);
  const rotation = select("field-rotation", ROTATIONS);
  rotation.addEventListener("change", () => {
    store.edit(t("edit.rotation"), [{ path: ["cam", "rotation"], value: rotation.value }]);
  });

  /**
   * @param {string} id
   * @param {string[]} values
   */
  function select(id, values) {
    return h("select", { id }, ...values.map((value) => h("option", { value }, value)));
  }

  /**
   * Another unit is a question: the same cam, or the same numbers?
   * @param {string} id
   * @param {string[]} units
   */
  function unitSelect(id, units) {
    const element = select(id, units);
    element.addEventListener("change", () => {
      const field = element.closest(".field");
      askUnit(context, element, field instanceof HTMLElement ? field : choices);
    });
    return element;
  }

  /** @param {Pick<Parameter, "key" | "symbol" | "quantity"> & { default?: number | null }} parameter */
  function createField({ key, symbol: sign, quantity, default: usual = null }) {
    /** @param {Readonly<Design>} design */
    const home = (design) => /** @type {Record<string, unknown>} */ (OF_THE_CAM.includes(key) ? design.cam : design.follower);
    // A notation may count an eccentricity the other way: it is shown and typed so, and kept as ever.
    const turned = () => (key === "eccentricity" ? (store.state.report.notation?.eccentricity ?? 1) : 1);
    const field = createNumberField(context, {
      id: `field-${key}`,
      label: symbol(sign, key === "arm"),
      name: () => t(`parameter.${key}`),
      unit: () => (quantity === "length" ? store.state.design.length_unit : quantity === "angle" ? "°" : ""),
      read: (design) => {
        const value = home(design)[key];
        return typeof value === "number" ? value * turned() + 0 : 0;
      },
      write: (value) => [{ path: [OF_THE_CAM.includes(key) ? "cam" : "follower", key], value: value * turned() + 0 }],
      step: (design) => (quantity === "length" ? lengthStep(design) : quantity === "angle" ? 1 : 0.05),
      path: () => `${OF_THE_CAM.includes(key) ? "cam" : "follower"}.${key}`,
      highlight: () => ({ parameter: key }),
      // A size has no usual value; an offset and an angle have one, and may be negative.
      signed: usual !== null,
    });
    return { key, field };
  }

  /**
   * @param {FollowerEntry} entry
   * @param {KindId} of
   */
  function build(entry, of) {
    shown = entry;
    kind = of;
    const own = of === "rotating" || of === "grooved" ? entry.parameters : entry.parameters.filter(({ key }) => !OFF_CENTRE.includes(key));
    fields = [
      ...MAGNITUDES[of].map(createField),
      ...own.map(createField),
      of === "translating" ? { key: "pace", field: pace } : { key: "speed", field: speed },
    ];
    rows.replaceChildren(...fields.map(({ key, field }) => row(key, field)));
    speed.unit.replaceWith(speedUnit);
    for (const part of turning) part.hidden = of === "translating";
    speak();
  }

  /**
   * @param {string} key
   * @param {NumberField} field
   */
  function row(key, field) {
    const unit = key === "speed" ? speedUnit : field.unit;
    return h("div", { class: "field", "data-key": key }, field.label, field.input, unit, mark(key === "pace" ? "speed" : key, `field-${key}-label`), field.error);
  }

  function speak() {
    for (const { key, field } of fields) {
      field.speak();
      if (field.label) field.label.title = `${t(`parameter.${key}`)}. ${t(`parameter.${key}.hint`)}`;
    }
    for (const option of rotation.options) {
      const sense = /** @type {Rotation} */ (option.value);
      option.textContent = `${TURNING[sense]} ${t(`rotation.${sense}`)}`;
    }
    speedUnit.setAttribute("aria-label", t("design.speed-unit"));
    if (shown) void drawing.show(shown, t(`follower.${shown.id}`), kind);
  }

  /** What a cam that travels lacks. */
  const turning = [texts.text(h("label", { for: "field-rotation", id: "name-rotation" }), "design.rotation"), rotation, mark("rotation", "name-rotation")];
  const choices = h(
    "div",
    { class: "choices-row" },
    ...turning,
    h("span", {}, texts.attribute(texts.text(h("label", { for: "field-length-unit" }), "design.length-unit"), "title", "design.length-unit.hint"), " ", lengthUnit),
  );
  const root = h(
    "fieldset",
    { class: "geometry" },
    texts.text(h("legend", { class: "unseen" }), "design.geometry"),
    h("div", { class: "drawing-and-fields" }, drawing.root, rows),
    choices,
    general,
  );
  texts.also(speak);

  function update() {
    const { design, error } = store.state;
    const entry = followerEntry(catalogue.followers, design.follower);
    if (entry && (entry !== shown || design.cam.kind !== kind)) build(entry, design.cam.kind);
    for (const { field } of fields) {
      field.update(store.state);
      field.speakUnit();
    }
    choose(speedUnit, design.speed.unit);
    choose(lengthUnit, design.length_unit);
    choose(rotation, design.cam.rotation ?? "counterclockwise");
    const orphan = error !== null && !/^(segments|conjugate)|generator|sides/.test(error.path) && !owned(error.path);
    hide(general, !orphan);
    write(general, orphan ? error.message : "");
  }

  /**
   * @param {HTMLSelectElement} select
   * @param {string} value
   */
  function choose(select, value) {
    if (select.value !== value && !("asking" in select.dataset)) select.value = value;
  }

  /** @param {string} path */
  function owned(path) {
    return path === "speed.value" || fields.some(({ key }) => path.endsWith(`.${key}`));
  }

  return {
    root,
    update,
    light: () => drawing.light(store.state.highlight?.parameter ?? null),
  };
}
