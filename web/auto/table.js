/**
 * The requirements as rows of numbers, each typed as the user likes.
 *
 * @import { ShellContext } from "../types.d.ts"
 * @import { Demand, Field, Kind } from "./demands.js"
 * @import { List } from "./list.js"
 */
import { h, symbol } from "../dom.js";
import { riseUnit } from "../segment-row.js";
import { KINDS, placed, turnedInto } from "./demands.js";

/** The four columns: the last is the height at the end of a line, or the velocity at a point. @type {readonly (readonly Field[])[]} */
const COLUMNS = [["from"], ["to"], ["s"], ["end", "v"]];

let sessions = 0;

/**
 * @param {ShellContext} context
 * @param {List} list
 * @param {() => void} rest  where the focus goes when a row is gone
 */
export function createTable({ store, t }, list, rest) {
  const root = h("div", { class: "auto-table", role: "group" });
  /** @type {ReturnType<typeof createRow>[]} */
  let rows = [];

  list.watch((what) => {
    if (what === "light") light();
    else update();
  });

  function light() {
    rows.forEach(({ element }, k) => element.classList.toggle("lit", k === list.lit));
  }

  /** Rows are made anew only when other fields are needed: what is being typed into stays. */
  function update() {
    const same = rows.length === list.all.length && rows.every(({ kind }, k) => kind === list.all[k]?.kind);
    if (!same) make();
    rows.forEach(({ inputs }, k) => {
      for (const [field, input] of inputs) {
        const text = list.all[k]?.[field] ?? "";
        if (input.value !== text) input.value = text;
      }
    });
    light();
  }

  function make() {
    const unit = riseUnit(store.state.design);
    const heads = [["θ", "°"], ["θ", "°"], ["s", unit]].map(([sign = "", of]) => h("span", {}, symbol(sign), ` ${of}`));
    const head = h("div", { class: "auto-row auto-head", "aria-hidden": "true" }, h("span"), h("span"), ...heads, h("span", {}, symbol("s"), " · ", symbol("v")), h("span"));
    rows = list.all.map(createRow);
    root.replaceChildren(head, ...rows.map(({ element }) => element));
  }

  /** @param {Demand} demand @param {number} k */
  function createRow({ kind }, k) {
    const number = k + 1;
    const choice = h("select", { "aria-label": t("auto.kind.of", { number }) }, ...Object.keys(KINDS).map((id) => h("option", { value: id, selected: id === kind }, t(`auto.kind.${id}`))));
    choice.addEventListener("change", () => {
      const chosen = /** @type {Kind} */ (choice.value);
      list.edit((draft) => {
        const place = placed(/** @type {Demand} */ (draft[k]));
        draft[k] = { ...draft[k], kind: chosen, ...(place ? list.texts(turnedInto(place, chosen)) : {}) };
      });
      focus(k);
    });
    /** @type {Map<Field, HTMLInputElement>} */
    const inputs = new Map();
    const cells = COLUMNS.map((fields) => {
      const field = fields.find((name) => /** @type {readonly string[]} */ (KINDS[kind]).includes(name));
      if (!field) return h("span");
      const input = h("input", { type: "text", class: "number", inputmode: "decimal", autocomplete: "off", "aria-label": t(`auto.${field}.of`, { number }), placeholder: field === "v" ? t("auto.free") : "" });
      let session = "";
      input.addEventListener("focus", () => {
        session = `type:${++sessions}`;
      });
      input.addEventListener("input", () => {
        list.edit((draft) => {
          const demand = draft[k];
          if (demand) demand[field] = input.value;
        }, session);
      });
      inputs.set(field, input);
      return input;
    });
    const remove = h("button", { type: "button", "aria-label": t("auto.remove", { number }), title: t("auto.remove", { number }) }, "×");
    remove.addEventListener("click", () => {
      list.edit((draft) => void draft.splice(k, 1));
      rest();
    });
    const element = h("div", { class: "auto-row" }, h("span", {}, String(number)), choice, ...cells, remove);
    element.addEventListener("focusin", () => list.light(k));
    element.addEventListener("pointerenter", () => list.light(k));
    return { element, kind, inputs };
  }

  /** @param {number} k */
  function focus(k) {
    rows[k]?.element.querySelector("select")?.focus();
  }

  return {
    root,
    focus,
    /** @param {string | undefined} place  of the requirement that cannot be met */
    blame(place) {
      rows.forEach(({ element }, k) => element.classList.toggle("wrong", place === String(k)));
    },
    word() {
      rows = [];
      update();
    },
  };
}
