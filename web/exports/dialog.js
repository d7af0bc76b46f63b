/**
 * The window for files: which, of what, how fine, how thick.
 *
 * @import { ExportOrder, ShellContext } from "../types.d.ts"
 */
import { h } from "../dom.js";
import { pressOnEnter } from "../enter.js";
import { fieldText, parseNumber } from "../numbers.js";
import { createTexts } from "../texts.js";
import { sayWhatLeaves } from "../unfinished.js";
import { loadExports } from "./writers.js";
import { picture, saveBlob } from "./save.js";
import { dressed } from "./words.js";

const FORMATS = /** @type {const} */ (["xlsx", "csv", "dxf", "stl", "svg", "png"]);
const TABLES = ["everything", "design", "motion", "polar", "cartesian", "pitch-curve", "verdict", "application"];
const DIAGRAMS = /** @type {const} */ (["s", "v", "a", "j", "pressure_angle", "rho", "contact"]);
const STEPS = [0.25, 0.5, 1, 2, 2.5, 5, 10, 15];
const WIDTHS = [800, 1600, 3200];

/** What a format asks for. */
const ASKS = /** @type {const} */ ({
  xlsx: ["step"],
  csv: ["table", "step", "separator"],
  dxf: ["step", "bore", "keyway"],
  stl: ["step", "thickness", "bore", "keyway"],
  svg: ["what", "bore", "keyway"],
  png: ["what", "width", "bore", "keyway"],
});

const TYPES = { xlsx: "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet", csv: "text/csv", dxf: "image/vnd.dxf", stl: "model/stl", svg: "image/svg+xml" };

/** @param {ShellContext} context */
export function createExportDialog(context) {
  const { store, t, format, announce } = context;
  const texts = createTexts(t);
  const heading = texts.text(h("h2", { id: "export-heading" }), "export.title");
  const about = h("p");
  const alarm = h("p", { class: "alarm", role: "alert" });
  const close = texts.text(h("button", { type: "button" }), "export.close");
  const save = texts.text(h("button", { type: "button", class: "primary" }), "export.save");
  const rows = h("div", { class: "fields" });
  const dialog = h("dialog", { class: "export-dialog", "aria-labelledby": heading.id }, heading, rows, about, alarm, h("div", { class: "row" }, close, save));

  const kind = select("format", FORMATS, (value) => t(`export.format.${value}`));
  const what = select("what", ["cam", "svaj", ...DIAGRAMS, "application"], (value) => (["cam", "svaj", "application"].includes(value) ? t(`export.what.${value}`) : sentence(t(`diagram.name.${value}`))));
  const table = select("table", TABLES, (value) => t(`export.table.${value}`));
  const step = select("step", STEPS, (value) => format.number(Number(value), { unit: "°" }));
  const separator = select("separator", ["comma", "semicolon"], (value) => t(`export.separator.${value}`));
  const width = select("width", WIDTHS, (value) => `${value} px`);
  const thickness = measure("thickness", "export.thickness");
  const bore = measure("bore", "export.bore");
  const keyWidth = measure("keyway", "export.keyway.width");
  const keyDepth = measure("keyway", "export.keyway.depth");
  texts.attribute(bore.input, "placeholder", "export.bore.none");

  /**
   * A labelled choice.
   * @param {string} name
   * @param {readonly (string | number)[]} values
   * @param {(value: string) => string} say
   */
  function select(name, values, say) {
    const input = h("select", { id: `export-${name}` }, ...values.map((value) => h("option", { value })));
    texts.also(() => {
      for (const option of input.options) option.textContent = say(option.value);
    });
    const label = texts.text(h("label", { for: input.id }), `export.${name}`);
    rows.append(h("div", { class: "field", "data-asked": name }, label, input));
    input.addEventListener("change", arrange);
    return input;
  }

  /**
   * A labelled length.
   * @param {string} asked
   * @param {string} key
   */
  function measure(asked, key) {
    const input = h("input", { type: "text", inputmode: "decimal", autocomplete: "off", id: key.replaceAll(".", "-") });
    const unit = h("span", { class: "unit" });
    rows.append(h("div", { class: "field", "data-asked": asked }, texts.text(h("label", { for: input.id }), key), h("span", { class: "measure" }, input, unit)));
    return { input, unit };
  }

  /** Shows what the chosen format asks for. */
  function arrange() {
    const chosen = /** @type {keyof typeof ASKS} */ (kind.value);
    /** @type {readonly string[]} */
    const asks = ["format", ...ASKS[chosen]];
    const cam = !asks.includes("what") || what.value === "cam";
    for (const field of rows.children) {
      const asked = /** @type {HTMLElement} */ (field).dataset["asked"] ?? "";
      const fits = asks.includes(asked) && (cam || !["bore", "keyway"].includes(asked));
      const needless = asked === "step" && chosen === "csv" && ["design", "verdict"].includes(table.value);
      /** @type {HTMLElement} */ (field).hidden = !fits || needless;
    }
    about.textContent = chosen === "svg" && !cam ? "" : t(`export.about.${chosen}`);
    alarm.textContent = "";
  }

  /** Units, and what goes with the design and the language. */
  function follow() {
    const { report, language } = store.state;
    for (const { unit } of [thickness, bore, keyWidth, keyDepth]) unit.textContent = report.units.length;
    if (thickness.input.value === "") thickness.input.value = fieldText(Number(usualThickness(store.lastGood()).toPrecision(2)), language);
    for (const option of what.options) if (option.value === "contact") option.hidden = !report.summary.contact;
    for (const option of [...what.options, ...table.options]) if (option.value === "application") option.hidden = !store.lastGood().application;
    if (what.selectedOptions[0]?.hidden) what.value = "cam";
    if (table.selectedOptions[0]?.hidden) table.value = "everything";
    separator.value = language === "es" ? "semicolon" : "comma";
    arrange();
  }

  /** The number in a field: nothing when it is empty or out of sight. @param {{ input: HTMLInputElement }} field */
  function number({ input }) {
    if (input.closest("[hidden]") || input.value.trim() === "") return undefined;
    const { value, problem } = parseNumber(input.value, store.state.report.units.length, store.state.language);
    if (problem) {
      input.focus();
      throw new Refusal(problem);
    }
    return value;
  }

  /** @returns {ExportOrder} */
  function order() {
    const chosen = /** @type {keyof typeof ASKS} */ (kind.value);
    const [across, deep] = [number(keyWidth), number(keyDepth)];
    const thick = number(thickness);
    const hole = number(bore);
    return {
      to: chosen === "png" ? "svg" : chosen,
      table: table.value,
      separator: /** @type {"comma" | "semicolon"} */ (separator.value),
      per_second: store.state.perSecond,
      ...(step.closest("[hidden]") ? {} : { step: Number(step.value) }),
      ...(what.closest("[hidden]") || what.value === "cam" ? {} : { diagram: what.value.replace("_", "-") }),
      ...(thick === undefined ? {} : { thickness: thick }),
      ...(hole === undefined ? {} : { bore: hole }),
      ...(hole === undefined || across === undefined || deep === undefined ? {} : { keyway: [across, deep] }),
    };
  }

  async function write() {
    const design = store.lastGood();
    const wanted = order();
    const made = await loadExports().catch((error) => {
      console.warn(error);
      throw new Refusal(t("export.failed"));
    });
    sayWhatLeaves(context);
    const { bytes, error } = made(design, wanted, store.state.language);
    if (!bytes) throw new Refusal(error);
    const chosen = kind.value;
    const blob = chosen === "png" ? await picture(new TextDecoder().decode(bytes), Number(width.value)) : new Blob([/** @type {Uint8Array<ArrayBuffer>} */ (bytes)], { type: TYPES[/** @type {keyof typeof TYPES} */ (chosen)] });
    const part = wanted.diagram ? `-${wanted.diagram}` : chosen === "csv" && table.value !== "everything" ? `-${table.value}` : "";
    announce(t("export.saved", { name: saveBlob(blob, design.title, `${part}.${chosen}`) }));
  }

  pressOnEnter(rows, save);
  save.addEventListener("click", async () => {
    alarm.textContent = "";
    save.disabled = true;
    try {
      await write();
      dialog.close();
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      alarm.textContent = error.message;
    } finally {
      save.disabled = false;
    }
  });
  close.addEventListener("click", () => dialog.close());
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close();
  });
  store.subscribe(["language"], () => {
    texts.refresh();
    follow();
  });
  step.value = "1";
  width.value = "1600";
  document.body.append(dialog);

  return async function show() {
    await dressed;
    follow();
    dialog.showModal();
    kind.focus();
    // It is wanted soon: meanwhile the choices are made.
    void loadExports().catch(() => {});
  };
}

/** A third of the base radius, or a sixth of what a cam that travels is long. @param {import("../types.d.ts").Design} design */
function usualThickness({ cam }) {
  return cam.base_radius ? cam.base_radius / 3 : (cam.length ?? 1) / 6;
}

/** @param {string} name */
function sentence(name) {
  return name.charAt(0).toLocaleUpperCase() + name.slice(1);
}

/** Why there is no file, told in the window. */
class Refusal extends Error {}
