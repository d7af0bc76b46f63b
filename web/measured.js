/**
 * Measured data that are more than a table: which columns, how many points, and how far the table's curve then is from what was measured.
 *
 * @import { Measured, MeasuredOrder, ShellContext } from "./types.d.ts"
 * @import { Workshop } from "./workshop.js"
 */
import { h, hide, write } from "./dom.js";
import { fieldText, parseNumber } from "./numbers.js";
import { demand } from "./on-demand.js";

/** Kinds of file that cam editors and test stands write. */
const FILES = ".csv,.txt,.tsv,.dat,.asc,.prn,text/plain,text/csv";

/** Bytes of a file that are looked at: one more than are read, so that a larger one is seen to be. */
const LARGEST = 2 ** 20 + 1;

/**
 * @param {ShellContext} context
 * @param {{ id: string, index: () => number }} place
 * @param {() => void} left  after the data were taken or not
 */
export function createMeasured(context, { id, index }, left) {
  const { store, module, workshop, t, format, announce } = context;
  /** The module that reduces, once it has arrived. @type {Workshop | null} */
  let reducer = null;
  /** @type {Uint8Array | null} */
  let bytes = null;
  /** The table that was there when the text came. */
  let before = "";
  /** @type {MeasuredOrder} */
  let order = {};
  /** @type {Measured | null} */
  let found = null;

  const named = `${id}-measured`;
  const title = h("p", { class: "measured-title", id: named });
  const angle = h("select", { id: `${named}-angle` });
  const lift = h("select", { id: `${named}-lift` });
  const count = h("input", { id: `${named}-count`, type: "text", inputmode: "numeric", autocomplete: "off" });
  const within = h("input", { id: `${named}-within`, type: "text", inputmode: "decimal", autocomplete: "off" });
  const unit = h("span", { class: "unit" });
  const status = h("p", { role: "status" });
  const note = h("p", { class: "hint" });
  const error = h("p", { class: "error", role: "alert", hidden: true });
  const take = h("button", { type: "button", class: "primary" });
  const cancel = h("button", { type: "button" });
  /** @type {[HTMLLabelElement, string][]} */
  const labels = [];
  const row = (/** @type {HTMLElement} */ input, /** @type {string} */ key, /** @type {HTMLElement[]} */ ...more) => {
    const label = h("label", { for: input.id });
    labels.push([label, key]);
    return [label, h("span", {}, input, ...more)];
  };
  const panel = h(
    "div",
    { class: "measured", role: "group", "aria-labelledby": named, hidden: true },
    title,
    h("div", { class: "measured-fields" }, ...row(angle, "measured.angle"), ...row(lift, "measured.lift"), ...row(count, "measured.count"), ...row(within, "measured.within", unit)),
    status,
    note,
    error,
    h("p", { class: "measured-do" }, take, cancel),
  );
  const chooser = h("input", { type: "file", accept: FILES, class: "unseen", tabindex: "-1", "aria-hidden": "true" });
  const open = h("button", { type: "button", class: "quiet" });

  /** Asks again and shows what comes of it; the field that somebody is in keeps its text. */
  function refresh() {
    if (!bytes || !reducer) return;
    const answer = /** @type {Measured} */ (reducer.measured(bytes, order, store.lastGood(), index(), store.state.language));
    found = answer;
    const { columns, error: refused, points, all, residual, at } = answer;
    for (const [select, chosen] of /** @type {const} */ ([[angle, answer.angle], [lift, answer.lift]])) {
      select.replaceChildren(...columns.map(({ index: column }) => h("option", { value: column }, nameOf(column))));
      select.value = String(chosen);
    }
    const { language, report } = store.state;
    if (document.activeElement !== count) count.value = refused ? "" : String(points.length);
    if (document.activeElement !== within) within.value = refused ? "" : fieldText(rounded(Math.abs(residual)), language);
    write(unit, report.units.s);
    write(title, t("measured.title", { number: index() + 1 }));
    const size = format.quantity(Math.abs(residual), { unit: report.units.s });
    write(status, refused ? "" : t("measured.residual", { count: points.length, all, value: size, at: format.number(at, { unit: "°" }) }));
    write(note, refused ? "" : answer.note);
    write(error, refused?.message ?? "");
    hide(error, !refused);
    take.disabled = refused !== undefined;
  }

  /** @param {number} column */
  function nameOf(column) {
    const { heading, unit: measure, sample } = found?.columns.find(({ index: other }) => other === column) ?? { heading: "", unit: "", sample: [] };
    const name = [heading, measure && `[${measure}]`].filter(Boolean).join(" ");
    const numbers = sample.map((value) => format.number(value)).join("; ");
    return t(name ? "measured.column.named" : "measured.column", { number: column + 1, name, numbers });
  }

  function close() {
    bytes = null;
    found = null;
    panel.hidden = true;
  }

  function done() {
    close();
    left();
  }

  for (const [select, key] of /** @type {const} */ ([[angle, "angle"], [lift, "lift"]])) {
    select.addEventListener("change", () => {
      order = { ...order, angle: found?.angle ?? 0, lift: found?.lift ?? 0, [key]: Number(select.value) };
      refresh();
    });
  }
  count.addEventListener("input", () => {
    const { value } = parseNumber(count.value);
    if (value === undefined || !Number.isInteger(value) || value < 2) return;
    order = { ...order, count: value, within: undefined };
    refresh();
  });
  within.addEventListener("input", () => {
    const { value } = parseNumber(within.value, store.state.report.units.s);
    if (value === undefined || value <= 0) return;
    order = { ...order, count: undefined, within: value };
    refresh();
  });
  for (const input of [count, within]) input.addEventListener("blur", refresh);
  take.addEventListener("click", () => {
    if (!found || found.error) return;
    const { points } = found;
    /** @param {string} field @param {unknown} value */
    const set = (field, value) => ({ path: ["segments", index(), field], value });
    store.edit(t("edit.measured"), [set("points", points), set("beta", points.at(-1)?.[0]), set("smoothing", 0)]);
    announce(status.textContent ?? "");
    done();
  });
  cancel.addEventListener("click", done);
  panel.addEventListener("keydown", (event) => {
    if (event.key === "Escape") done();
    else if (event.key === "Enter" && event.target instanceof HTMLInputElement) take.click();
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  open.addEventListener("click", () => chooser.click());
  chooser.addEventListener("change", async () => {
    const [file] = chooser.files ?? [];
    chooser.value = "";
    const buffer = await file?.slice(0, LARGEST).arrayBuffer().catch(() => null);
    if (!buffer) return;
    await show(new Uint8Array(buffer), open);
    count.focus();
  });

  const table = () => JSON.stringify(store.state.design.segments[index()]?.points);

  /**
   * Asks about a text; what reduces it is loaded first.
   * @param {Uint8Array} text
   * @param {HTMLElement} from
   */
  function show(text, from) {
    bytes = text;
    before = table();
    order = {};
    return demand(context, from, workshop, (module) => {
      // Another text may have come meanwhile.
      if (bytes !== text) return;
      reducer = module;
      panel.hidden = false;
      refresh();
    });
  }

  return {
    panel,
    /** The button that opens a file, and what it needs. */
    opener: [chooser, open],

    /**
     * What a text is taken for at once; the panel asks about the rest.
     * @param {string} text
     * @param {boolean} pasted
     * @param {HTMLElement} from
     */
    read(text, pasted, from) {
      close();
      const answer = module().read_table(text, pasted, store.state.language);
      if (answer.measured !== undefined) void show(new TextEncoder().encode(text), from);
      return answer;
    },

    /** Another table, as after undo: the question is no more. */
    follow() {
      if (bytes && table() !== before) close();
    },

    speak() {
      for (const [label, key] of labels) write(label, t(key));
      write(take, t("measured.take"));
      write(cancel, t("measured.cancel"));
      write(open, t("measured.open"));
      refresh();
    },
  };
}

/**
 * Two digits of a residual, rounded up: a bound that the curve keeps.
 * @param {number} residual
 */
function rounded(residual) {
  const near = Number(residual.toPrecision(2));
  return near >= residual ? near : Number((near + 10 ** (Math.floor(Math.log10(residual)) - 1)).toPrecision(2));
}
