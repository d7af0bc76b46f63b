/**
 * The motion program: its segments in a table that can be changed anywhere, and what is left of the turn.
 *
 * @import { Edit, ShellContext } from "./types.d.ts"
 * @import { Action } from "./segment-menu.js"
 * @import { SegmentRow } from "./segment-row.js"
 * @import { Texts } from "./texts.js"
 */
import { h, hide, symbol, write } from "./dom.js";
import { mark } from "./help-mark.js";
import { onDemand } from "./on-demand.js";
import { createClosing } from "./segment-closing.js";
import { createSegmentMenu } from "./segment-menu.js";
import { createSegmentRow, riseUnit, strideUnit } from "./segment-row.js";

/** Rows that are made at once: no usual program grows before the eyes. */
const ROWS_AT_ONCE = 12;

/** Rows of a longer one that are made in each frame after that: sixty-four segments hold up none. */
const ROWS_A_FRAME = 4;

/**
 * @param {ShellContext} context
 * @param {Texts} texts
 */
export function createSegments(context, texts) {
  const { store, catalogue, t, announce } = context;
  /** @type {SegmentRow[]} */
  const rows = [];
  /** @type {SegmentRow | null} */
  let chosen = null;
  /** Segments that are deleted together. @type {Set<number>} */
  const selected = new Set();

  const list = h("ol", { class: "segments" });
  const betaHead = h("span", { class: "unit" });
  const riseHead = h("span", { class: "unit" });
  const head = h(
    "div",
    { class: "segments-head" },
    h("span", { class: "law-head" }, texts.text(h("span", { id: "head-law" }), "segments.law"), mark("law", "head-law")),
    ...column("beta", symbol("β"), " ", betaHead),
    ...column("rise", symbol("L"), " ", riseHead),
  );

  /** @param {string} key @param {...(Node | string)} shown */
  function column(key, ...shown) {
    const name = texts.text(h("span", { class: "unseen", id: `head-${key}` }), `parameter.${key}`);
    return [h("span", { class: `number-head ${key}` }, h("span", { "aria-hidden": "true" }, ...shown), name), h("span", { class: `mark-head ${key}` }, mark(key, name.id))];
  }

  const add = texts.text(h("button", { type: "button", class: "quiet" }), "segments.add");
  const auto = texts.text(h("button", { type: "button", class: "quiet", "aria-haspopup": "dialog" }), "segments.auto");
  onDemand(context, auto, loadAuto, ({ openAuto }) => openAuto(context));
  /** The window and its calculation. */
  async function loadAuto() {
    const [window] = await Promise.all([import("./auto/index.js"), context.workshop()]);
    return window;
  }

  const closing = createClosing(context, texts, add, auto);
  const menu = createSegmentMenu(act);
  const root = h(
    "fieldset",
    { class: "program" },
    texts.text(h("legend"), "design.program"),
    head,
    list,
    closing.root,
    menu.root,
  );

  add.addEventListener("click", () => insert(store.state.design.segments.length, store.state.design.segments.length - 1));

  const count = () => store.state.design.segments.length;
  const full = () => count() >= catalogue.limits.segments;

  /** @param {Action} action */
  function possible(action) {
    const index = chosen?.index ?? 0;
    if (action === "select") return count() > 1;
    if (action === "delete") return count() > doomed(index).length;
    if (action === "up") return index > 0;
    if (action === "down") return index < count() - 1;
    return !full();
  }

  /** @param {Action} action */
  function act(action) {
    if (!chosen) return;
    const { index } = chosen;
    if (action === "insert-before") insert(index, index);
    else if (action === "insert-after") insert(index + 1, index);
    else if (action === "duplicate") change(t("edit.duplicate"), { op: "duplicate", segment: index }, index + 1);
    else if (action === "select") select(chosen, false);
    else if (action === "delete") remove(index);
    else move(chosen, action === "up" ? -1 : 1);
  }

  /**
   * Edits the list and takes the focus to where the change happened.
   * @param {string} label
   * @param {Edit} edit
   * @param {number} focus
   * @param {"lawSelect" | "grip"} [part]
   */
  function change(label, edit, focus, part = "lawSelect") {
    store.edit(label, [edit]);
    update();
    fill(Infinity);
    for (const row of rows) row.reset();
    rows[focus]?.[part].focus();
  }

  /**
   * @param {number} index
   * @param {number} neighbour
   */
  function insert(index, neighbour) {
    if (!full()) change(t("edit.insert"), { op: "insert", at: index, from: Math.max(0, neighbour) }, index);
  }

  /** What goes with a segment that is deleted: all that are selected, when it is one of them. @param {number} index */
  const doomed = (index) => (selected.has(index) ? [...selected].sort((one, other) => one - other) : [index]);

  /** @param {number} index */
  function remove(index) {
    const segments = doomed(index);
    if (segments.length >= count()) return;
    change(t("edit.delete"), { op: "delete", segments }, Math.min(segments[0] ?? 0, count() - segments.length - 1), "grip");
    announce(t(segments.length > 1 ? "segments.removed.several" : "segments.removed", { number: segments.length, count: count() }));
  }

  /**
   * Selects a segment, or no longer; with `through`, all from the one that was selected last.
   * @param {SegmentRow} row
   * @param {boolean} through
   */
  function select(row, through) {
    const last = [...selected].at(-1) ?? row.index;
    if (through) for (let k = Math.min(last, row.index); k <= Math.max(last, row.index); k++) selected.add(k);
    else if (!selected.delete(row.index)) selected.add(row.index);
    showSelected();
    announce(t("segments.selected", { count: selected.size }));
  }

  function showSelected() {
    for (const row of rows) row.select(selected.has(row.index));
  }

  /**
   * @param {SegmentRow} row
   * @param {number} by
   */
  function move(row, by) {
    const from = row.index;
    const to = from + by;
    selected.clear();
    if (to < 0 || to >= count()) return;
    const part = document.activeElement === row.lawSelect ? "lawSelect" : "grip";
    change(t("edit.move"), { op: "move", from, to }, to, part);
    announce(t("segments.moved", { number: to + 1, count: count() }));
  }

  /**
   * Dragging a row by its number: it changes place with the rows it is drawn over, as one undo step.
   * @param {SegmentRow} row
   * @param {PointerEvent} down
   */
  function grab(row, down) {
    if (down.button !== 0) return;
    const gesture = `move:${down.timeStamp}`;
    let at = row.index;

    /** @param {PointerEvent} event */
    function drag(event) {
      const to = rows.findIndex(({ root: other }) => {
        const { top, bottom } = other.getBoundingClientRect();
        return event.clientY >= top && event.clientY < bottom;
      });
      if (to < 0 || to === at) return;
      const from = at;
      at = to;
      selected.clear();
      store.edit(t("edit.move"), [{ op: "move", from, to }], { gesture });
      update();
      for (const other of rows) other.root.classList.toggle("dragged", other.index === at);
    }

    function drop() {
      removeEventListener("pointermove", drag);
      for (const other of rows) other.root.classList.remove("dragged");
      store.endGesture();
    }

    addEventListener("pointermove", drag);
    addEventListener("pointerup", drop, { once: true });
    addEventListener("pointercancel", drop, { once: true });
  }

  let shown = "";
  /** True while the next frame will make more rows. */
  let growing = false;

  function update() {
    const { design, error, language } = store.state;
    const next = JSON.stringify([design.segments, design.cam, riseUnit(design), error, language]);
    if (next === shown) return;
    shown = next;
    fill(ROWS_AT_ONCE);
    const ready = design.cam.kind === "constant-breadth" && design.cam.generator !== "mirror";
    hide(root, ready);
    write(riseHead, riseUnit(design));
    write(betaHead, strideUnit(design));
    add.disabled = full();
    hide(auto, !["rotating", "grooved"].includes(design.cam.kind));
    closing.update();
  }

  /**
   * Gives each segment its row; those that are still missing after `most` new ones come in the next frames.
   * @param {number} most
   */
  function fill(most) {
    const { length } = store.state.design.segments;
    // The places of those that were selected are no longer theirs.
    if (rows.length !== length) selected.clear();
    while (rows.length > length) rows.pop()?.root.remove();
    const end = Math.min(length, rows.length + most);
    while (rows.length < end) {
      const row = createSegmentRow(context, { menu: openMenu, move, grab, select, remove: ({ index }) => remove(index) });
      rows.push(row);
      list.append(row.root);
    }
    rows.forEach((row, index) => row.update(index));
    showSelected();
    if (rows.length === length || growing) return;
    growing = true;
    requestAnimationFrame(() => {
      growing = false;
      fill(ROWS_A_FRAME);
    });
  }

  /** @param {SegmentRow} row */
  function openMenu(row) {
    chosen = row;
    menu.open(row.more, possible, (action) => {
      if (action === "select" && selected.has(row.index)) return t("action.unselect");
      const several = action === "delete" ? doomed(row.index).length : 1;
      return several > 1 ? t("action.delete.several", { count: several }) : t(`action.${action}`);
    });
  }

  function light() {
    const lit = store.state.highlight?.segment;
    rows.forEach(({ root: row }, index) => row.classList.toggle("lit", index === lit));
  }

  texts.also(() => {
    for (const row of rows) row.speak();
  });
  return { root, update, light };
}
