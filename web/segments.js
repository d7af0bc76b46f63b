/**
 * The motion program: its segments in a table that can be changed anywhere, and what is left of the turn.
 *
 * @import { Design, ShellContext } from "./types.d.ts"
 * @import { Action } from "./segment-menu.js"
 * @import { SegmentRow } from "./segment-row.js"
 * @import { Texts } from "./texts.js"
 */
import { h, hide, symbol, write } from "./dom.js";
import { mark } from "./help-mark.js";
import { onDemand } from "./on-demand.js";
import * as program from "./program.js";
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
  const menu = createSegmentMenu(t, act);
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
    if (action === "delete") return count() > 1;
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
    else if (action === "duplicate") change(t("edit.duplicate"), (draft) => program.duplicate(draft, index), index + 1);
    else if (action === "delete") remove(index);
    else move(chosen, action === "up" ? -1 : 1);
  }

  /**
   * Edits the list and takes the focus to where the change happened.
   * @param {string} label
   * @param {(draft: Design) => void} fn
   * @param {number} focus
   * @param {"lawSelect" | "grip"} [part]
   */
  function change(label, fn, focus, part = "lawSelect") {
    store.edit(label, fn);
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
    if (!full()) change(t("edit.insert"), (draft) => program.insert(draft, index, neighbour), index);
  }

  /** @param {number} index */
  function remove(index) {
    change(t("edit.delete"), (draft) => program.remove(draft, index), Math.min(index, count() - 2), "grip");
    announce(t("segments.removed", { count: count() }));
  }

  /**
   * @param {SegmentRow} row
   * @param {number} by
   */
  function move(row, by) {
    const from = row.index;
    const to = from + by;
    if (to < 0 || to >= count()) return;
    const part = document.activeElement === row.lawSelect ? "lawSelect" : "grip";
    change(t("edit.move"), (draft) => program.move(draft, from, to), to, part);
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
      store.edit(t("edit.move"), (draft) => program.move(draft, from, to), { gesture });
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
    while (rows.length > length) rows.pop()?.root.remove();
    const end = Math.min(length, rows.length + most);
    while (rows.length < end) {
      const row = createSegmentRow(context, { menu: openMenu, move, grab });
      rows.push(row);
      list.append(row.root);
    }
    rows.forEach((row, index) => row.update(index));
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
    menu.open(row.more, possible);
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
