/**
 * Geometry and speed: a dimensioned drawing with its fields, generated from the catalogue.
 *
 * @import { Design, FollowerEntry, Parameter, Rotation, ShellContext } from "./types.d.ts"
 * @import { NumberField } from "./number-field.js"
 * @import { Texts } from "./texts.js"
 */
import { h, symbol, write } from "./dom.js";
import { followerEntry } from "./follower-choice.js";
import { createHelpDrawing } from "./help-drawings.js";
import { mark } from "./help-mark.js";
import { createNumberField, lengthStep, ownStep } from "./number-field.js";

/** @type {Rotation[]} */
const ROTATIONS = ["counterclockwise", "clockwise"];
const TURNING = { counterclockwise: "↺", clockwise: "↻" };

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

  const drawing = createHelpDrawing({
    pick: (parameter) => fields.find(({ key }) => key === parameter)?.field.input.focus(),
    point: (parameter) => store.set({ highlight: parameter === null ? null : { parameter } }),
  });

  const speed = createNumberField(context, {
    id: "field-speed",
    label: symbol("ω"),
    name: () => t("parameter.speed"),
    unit: () => "",
    read: (design) => design.speed.value,
    write: (draft, value) => (draft.speed.value = value),
    step: (design) => ownStep(design.speed.value),
    path: () => "speed.value",
    highlight: () => ({ parameter: "speed" }),
  });
  const speedUnit = select("field-speed-unit", catalogue.speed_units, (draft, unit) => (draft.speed.unit = unit), t);
  const lengthUnit = select("field-length-unit", catalogue.length_units, (draft, unit) => (draft.length_unit = unit), t);
  const rotation = select("field-rotation", ROTATIONS, (draft, sense) => (draft.cam.rotation = /** @type {Rotation} */ (sense)), t);

  /**
   * @param {string} id
   * @param {string[]} values
   * @param {(draft: Design, value: string) => void} write
   * @param {typeof t} words
   */
  function select(id, values, write, words) {
    const element = h("select", { id }, ...values.map((value) => h("option", { value }, value)));
    element.addEventListener("change", () => {
      const label = id === "field-rotation" ? words("edit.rotation") : words("edit.unit");
      store.edit(label, (draft) => write(draft, element.value));
    });
    return element;
  }

  /** @param {Pick<Parameter, "key" | "symbol" | "quantity">} parameter */
  function createField({ key, symbol: sign, quantity }) {
    /** @param {Readonly<Design>} design */
    const home = (design) => /** @type {Record<string, unknown>} */ (key === "base_radius" ? design.cam : design.follower);
    const field = createNumberField(context, {
      id: `field-${key}`,
      label: symbol(sign),
      name: () => t(`parameter.${key}`),
      unit: () => (quantity === "length" ? store.state.design.length_unit : quantity === "angle" ? "°" : ""),
      read: (design) => {
        const value = home(design)[key];
        return typeof value === "number" ? value : 0;
      },
      write: (draft, value) => (home(draft)[key] = value),
      step: (design) => (quantity === "length" ? lengthStep(design) : quantity === "angle" ? 1 : 0.05),
      path: () => `${key === "base_radius" ? "cam" : "follower"}.${key}`,
      highlight: () => ({ parameter: key }),
    });
    return { key, field };
  }

  /** @param {FollowerEntry} entry */
  function build(entry) {
    shown = entry;
    fields = [
      createField({ key: "base_radius", symbol: "R_b", quantity: "length" }),
      ...entry.parameters.map(createField),
      { key: "speed", field: speed },
    ];
    rows.replaceChildren(...fields.map(({ key, field }) => row(key, field)));
    speed.unit.replaceWith(speedUnit);
    drawing.show(entry, t(`follower.${entry.id}`));
    speak();
  }

  /**
   * @param {string} key
   * @param {NumberField} field
   */
  function row(key, field) {
    const unit = key === "speed" ? speedUnit : field.unit;
    return h("div", { class: "field", "data-key": key }, field.label, field.input, unit, mark(key, `field-${key}-label`), field.error);
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
    if (shown) drawing.show(shown, t(`follower.${shown.id}`));
  }

  const choices = h(
    "div",
    { class: "choices-row" },
    texts.text(h("label", { for: "field-rotation", id: "name-rotation" }), "design.rotation"),
    rotation,
    mark("rotation", "name-rotation"),
    texts.attribute(texts.text(h("label", { for: "field-length-unit" }), "design.length-unit"), "title", "design.length-unit.hint"),
    lengthUnit,
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
    if (entry && entry !== shown) build(entry);
    for (const { field } of fields) {
      field.update(store.state);
      field.speakUnit();
    }
    choose(speedUnit, design.speed.unit);
    choose(lengthUnit, design.length_unit);
    choose(rotation, design.cam.rotation ?? "counterclockwise");
    const orphan = error !== null && !error.path.startsWith("segments") && !owned(error.path);
    general.hidden = !orphan;
    write(general, orphan ? error.message : "");
  }

  /**
   * @param {HTMLSelectElement} select
   * @param {string} value
   */
  function choose(select, value) {
    if (select.value !== value) select.value = value;
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
