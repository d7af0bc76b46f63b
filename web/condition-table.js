/**
 * The conditions of a polynomial or a spline: a row for each place, a column for each of s, v, a, j; an empty cell is free. A spline has its knots
 * beneath them.
 *
 * @import { FreeEditor } from "./free-parts.js"
 * @import { Design, LawEntry, ShellContext, State } from "./types.d.ts"
 * @import { NumberField } from "./number-field.js"
 */
import { h, symbol, write, writeAttribute } from "./dom.js";
import { assemble } from "./free-parts.js";
import { KNOTS } from "./free-text.js";
import { mark } from "./help-mark.js";
import { marksOf } from "./marks.js";
import { createNumberField, lengthStep, ownStep } from "./number-field.js";
import { fieldText } from "./numbers.js";
import { createTextField } from "./text-field.js";

const ORDERS = ["s", "v", "a", "j"];

/** Characters that a cell has room for. */
const CELL = 6;

/** Limits at a border as the engine gives them: s, v, a, j before it, and after it. */
const BEFORE = 0;
const AFTER = 4;

/** Whether two numbers are the same but for rounding. @param {number} a @param {number} b */
const same = (a, b) => Math.abs(a - b) <= 1e-9 * Math.max(Math.abs(a), Math.abs(b), 1e-9);

/**
 * @typedef {object} Row
 * @property {number} at
 * @property {HTMLElement} root
 * @property {NumberField} place
 * @property {NumberField[]} cells
 * @property {HTMLButtonElement} inherit
 * @property {HTMLButtonElement} remove
 */

/**
 * @param {ShellContext} context
 * @param {{ id: string, index: () => number }} place
 * @param {LawEntry} law
 * @returns {FreeEditor}
 */
export function createConditionTable(context, { id, index }, law) {
  const { store, lab, t, format } = context;
  const knots = law.id === "bspline" ? createTextField(context, { id, index }, KNOTS) : null;
  /** @type {Row[]} */
  let rows = [];
  let made = 0;

  const head = h("div", { class: "row head", "aria-hidden": "true" }, h("span", {}, symbol("θ"), " °"), ...ORDERS.map((order) => h("span", { class: order }, symbol(order))));
  const body = h("div", { class: "body" });
  const add = h("button", { type: "button", class: "quiet" });
  const named = `${id}-conditions`;
  const hint = h("span", { class: "hint", id: named });
  const root = h("div", { class: "conditions", role: "group" }, head, body, h("div", { class: "foot" }, add, hint, mark("conditions", named)), knots?.root);

  /** @param {Readonly<Design>} design */
  const segmentOf = (design) => design.segments[index()];
  /** @param {Readonly<Design>} design */
  const conditionsOf = (design) => segmentOf(design)?.conditions ?? [];

  /**
   * @param {Readonly<Design>} design
   * @param {number} at
   * @param {number} order
   */
  const find = (design, at, order) => conditionsOf(design).findIndex((condition) => condition.at === at && condition.order === order);

  /** @param {number} at */
  function createRow(at) {
    const rowId = `${id}-condition-${++made}`;
    const where = () => ({ at: format.number(row.at, { unit: "°" }), number: index() + 1 });
    const highlight = () => ({ segment: index() });
    const place = createNumberField(context, {
      id: `${rowId}-at`,
      name: () => t("conditions.at", where()),
      unit: () => "°",
      read: () => row.at,
      write: (value) => {
        const from = row.at;
        row.at = value;
        return [{ op: "move-conditions", segment: index(), from, to: value }];
      },
      step: () => 1,
      path: () => `segments[${index()}].conditions[${conditionsOf(store.state.design).findIndex((condition) => condition.at === row.at)}].at`,
      highlight,
      room: CELL,
      late: true,
    });
    const cells = ORDERS.map((sign, order) =>
      createNumberField(context, {
        id: `${rowId}-${sign}`,
        name: () => t("conditions.value", { sign, ...where() }),
        unit: () => "",
        read: (design) => conditionsOf(design)[find(design, row.at, order)]?.value,
        write: (value) => [{ op: "condition", segment: index(), at: row.at, order, value }],
        clear: () => [{ op: "drop-conditions", segment: index(), at: row.at, order }],
        step: (design) => (order > 0 ? ownStep(conditionsOf(design)[find(design, row.at, order)]?.value ?? 0) : design.follower.motion === "oscillating" ? 1 : lengthStep(design)),
        path: () => `segments[${index()}].conditions[${find(store.state.design, row.at, order)}].value`,
        highlight,
        room: CELL,
        signed: true,
      }),
    );
    const inherit = h("button", { type: "button", class: "inherit" });
    const remove = h("button", { type: "button", class: "remove" }, "×");
    /** @type {Row} */
    const row = {
      at,
      place,
      cells,
      inherit,
      remove,
      root: h("div", { class: "row" }, place.input, ...cells.map(({ input }) => input), inherit, remove, place.error, ...cells.map(({ error }) => error)),
    };
    inherit.addEventListener("click", () => take(row));
    remove.addEventListener("click", () => {
      const next = rows.indexOf(row);
      rows = rows.filter((other) => other !== row);
      row.root.remove();
      store.edit(t("edit.condition"), [{ op: "drop-conditions", segment: index(), at: row.at }]);
      (rows[next] ?? rows.at(-1))?.cells[0]?.input.focus();
    });
    for (const field of [place, ...cells]) field.speak();
    return row;
  }

  /** Neighbour's s, v, a, j at the end of the segment that a row lies on; none for a row within. @param {Row} row */
  function neighbour(row) {
    const segment = segmentOf(store.state.design);
    const limits = [...lab().limits(index() + (row.at === 0 ? 0 : 1))];
    if (limits.length === 0) return null;
    if (row.at === 0) return limits.slice(BEFORE, AFTER);
    return row.at === segment?.beta ? limits.slice(AFTER) : null;
  }

  /**
   * Takes s, v and a from the neighbour; when it has those already, j as well.
   * @param {Row} row
   */
  function take(row) {
    const values = neighbour(row);
    if (!values) return;
    const { design } = store.state;
    const met = values.slice(0, 3).every((value, order) => same(conditionsOf(design)[find(design, row.at, order)]?.value ?? NaN, value));
    store.edit(t("edit.condition"), values.slice(0, met ? 4 : 3).map((value, order) => ({ op: "condition", segment: index(), at: row.at, order, value })));
  }

  add.addEventListener("click", () => {
    const known = rows.map(({ at }) => at);
    store.edit(t("edit.condition"), [{ op: "add-condition", segment: index() }]);
    editor.update(store.state);
    rows.find(({ at }) => !known.includes(at))?.cells[0]?.input.focus();
  });

  /** @param {Readonly<State>} state */
  function arrange(state) {
    const segment = segmentOf(state.design);
    if (!segment) return;
    const places = new Set(conditionsOf(state.design).map(({ at }) => at));
    // A row that was just emptied stays while it is being worked on.
    rows = rows.filter((row, k) => rows.findIndex(({ at }) => at === row.at) === k && (places.has(row.at) || row.root.contains(document.activeElement)));
    for (const at of places) if (!rows.some((row) => row.at === at)) rows.push(createRow(at));
    rows.sort((a, b) => a.at - b.at);
    const roots = rows.map((row) => row.root);
    if (roots.length !== body.children.length || roots.some((node, k) => body.children[k] !== node)) {
      const active = document.activeElement;
      body.replaceChildren(...roots);
      // What moves along with its row keeps the focus.
      if (active instanceof HTMLElement && body.contains(active)) active.focus();
    }
    for (const row of rows) {
      const [first, last] = [row.at === 0, row.at === segment.beta];
      row.place.input.disabled = first || last;
      row.inherit.style.visibility = first || last ? "" : "hidden";
      write(row.inherit, first ? "↑" : "↓");
      const label = first ? t("conditions.inherit.before") : t("conditions.inherit.after");
      writeAttribute(row.inherit, "aria-label", label);
      writeAttribute(row.inherit, "title", label);
      row.remove.disabled = rows.length === 1;
      const removal = t("conditions.remove", { at: format.number(row.at, { unit: "°" }) });
      writeAttribute(row.remove, "title", removal);
      writeAttribute(row.remove, "aria-label", removal);
    }
    const count = conditionsOf(state.design).length;
    write(hint, knots ? t("conditions.count", { count }) : t("conditions.degree", { count, degree: count - 1 }));
    if (knots) suggest();
  }

  /** The knots that the engine took, where none are told. */
  function suggest() {
    const taken = marksOf(context).filter(({ kind, segment }) => kind === "knot" && segment === index());
    const text = taken.map(({ at }) => fieldText(Number(at.toPrecision(4)), store.state.language)).join("  ");
    if (knots && knots.input.placeholder !== text) knots.input.placeholder = text;
  }

  function word() {
    root.setAttribute("aria-label", t("conditions.title", { number: index() + 1 }));
    add.textContent = t("conditions.add");
  }

  const editor = assemble(context, {
    root,
    fields: () => [...rows.flatMap((row) => [row.place, ...row.cells]), ...(knots ? [knots] : [])],
    word,
    arrange,
    paths: () => [
      ...conditionsOf(store.state.design).flatMap((_, k) => ["at", "value"].map((key) => `segments[${index()}].conditions[${k}].${key}`)),
      ...(knots?.paths() ?? []),
    ],
  });
  return editor;
}
