/**
 * What lies over the diagram of s for curves made from data: measured points, and the ordinates of a Bézier curve, which are moved by
 * pointer or keys.
 *
 * @import { Mark } from "./marks.js"
 * @import { Row } from "./stage/overlay.js"
 * @import { ShellContext } from "./types.d.ts"
 */
import { h, s } from "./dom.js";
import { marksOf } from "./marks.js";
import { heightStep } from "./number-field.js";
import { sum } from "./numbers.js";
import { stepped, valueAt } from "./hand.js";
import { factor } from "./scrub.js";
import { atTheta, atValue } from "./stage/overlay.js";

/** Steps of a drag over the height of the diagram. */
const DRAG_STEPS = 200;
/** Room beyond the plot for ordinates that the curve does not reach, CSS pixels. */
const BEYOND = 6;

let gestures = 0;

/**
 * @param {HTMLElement} plots  where the diagrams lie
 * @param {ShellContext} context
 */
export function createMarks(plots, context) {
  const { store, t, format } = context;
  const dots = s("path", { class: "mark-points" });
  const sides = s("path", { class: "mark-sides" });
  const drawing = s("svg", { "aria-hidden": "true" }, sides, dots);
  const handles = h("div", { class: "mark-handles", role: "group" });
  const layer = h("div", { class: "diagram-marks" }, drawing, handles);
  plots.append(layer);
  /** @type {Handle[]} */
  const made = [];
  /** @type {Row | undefined} */
  let row;
  /** @type {{ row: Row, gesture: string } | null} */
  let dragged = null;

  /**
   * @typedef {object} Handle
   * @property {HTMLButtonElement} button
   * @property {Mark} mark
   */

  /**
   * Height of a value on the page; what lies beyond the plot waits at its edge.
   * @param {Row} row
   * @param {number} value
   */
  function yOf(row, value) {
    const top = row.y + row.area.top;
    return Math.min(Math.max(atValue(row, value), top - BEYOND), top + row.area.height + BEYOND);
  }

  /**
   * @param {Handle} handle
   * @param {number} value
   * @param {string} gesture
   */
  function put({ mark }, value, gesture) {
    const { segment, item } = mark;
    if (store.state.design.segments[segment]?.ordinates?.[item] === value) return;
    store.edit(t("edit.ordinates"), [{ path: ["segments", segment, "ordinates", item], value }], { gesture });
  }

  /** @returns {Handle} */
  function create() {
    const button = h("button", { type: "button", class: "mark-handle", role: "slider", "aria-orientation": "vertical" });
    /** @type {Handle} */
    const handle = { button, mark: { kind: "ordinate", segment: 0, item: 0, at: 0, theta: 0, height: 0, residual: 0 } };
    button.addEventListener("pointerdown", (event) => {
      if (event.button !== 0 || !row) return;
      button.setPointerCapture(event.pointerId);
      // The diagram may change its scale under the hand: the drag goes by the one that it began with.
      dragged = { row, gesture: `ordinate:${++gestures}` };
    });
    button.addEventListener("pointermove", (event) => {
      if (!dragged) return;
      const { area } = dragged.row;
      const step = 10 ** Math.floor(Math.log10((area.y_max - area.y_min) / DRAG_STEPS));
      const value = valueAt(dragged.row, event.clientY - plots.getBoundingClientRect().top);
      put(handle, stepped(value, step), dragged.gesture);
    });
    for (const name of ["pointerup", "pointercancel"]) {
      button.addEventListener(name, () => {
        dragged = null;
        store.endGesture();
      });
    }
    button.addEventListener("keydown", (event) => {
      const way = { ArrowUp: 1, ArrowDown: -1, ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (!way || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      event.stopPropagation();
      put(handle, sum(handle.mark.height, way * heightStep(store.state.design) * factor(event)), `ordinate:${handle.mark.segment}.${handle.mark.item}`);
    });
    button.addEventListener("blur", () => store.endGesture());
    button.addEventListener("focus", () => store.set({ highlight: { segment: handle.mark.segment } }));
    return handle;
  }

  /** @param {readonly Mark[]} marks */
  function draw(marks) {
    if (!row) return;
    const of = row;
    const place = (/** @type {Mark} */ mark) => [atTheta(of, mark.theta), yOf(of, mark.height)];
    const circle = (/** @type {Mark} */ mark) => {
      const [x = 0, y = 0] = place(mark);
      return `M${(x - 2.5).toFixed(1)} ${y.toFixed(1)}a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0 -5 0`;
    };
    dots.setAttribute("d", marks.filter(({ kind }) => kind === "point").map(circle).join(""));
    const ordinates = marks.filter(({ kind }) => kind === "ordinate");
    sides.setAttribute("d", ordinates.map((mark) => `${mark.item === 0 ? "M" : "L"}${place(mark).map((value) => value.toFixed(1)).join(" ")}`).join(""));
    // The ends are the heights of the neighbours: they stay.
    const free = ordinates.filter(({ segment, item }) => item > 0 && item + 1 < (store.lastGood().segments[segment]?.ordinates?.length ?? 0));
    while (made.length > free.length) made.pop()?.button.remove();
    while (made.length < free.length) made.push(create());
    made.forEach((handle, k) => {
      const mark = free[k];
      if (!mark) return;
      handle.mark = mark;
      const [x = 0, y = 0] = place(mark);
      const { button } = handle;
      if (button.parentElement !== handles) handles.append(button);
      button.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
      const unit = store.state.report.units.s;
      button.setAttribute("aria-label", t("ordinate.of", { item: mark.item + 1, number: mark.segment + 1 }));
      button.setAttribute("aria-valuenow", String(mark.height));
      button.setAttribute("aria-valuetext", format.quantity(mark.height, { trim: true, unit }));
      button.title = `${t("ordinate.of", { item: mark.item + 1, number: mark.segment + 1 })}: ${format.quantity(mark.height, { trim: true, unit })}`;
    });
    handles.setAttribute("aria-label", t("ordinates.title"));
  }

  /**
   * @param {Row | undefined} next  the diagram of s, when it is shown
   */
  return function update(next) {
    row = next;
    layer.hidden = next === undefined;
    if (next) draw(marksOf(context));
  };
}
