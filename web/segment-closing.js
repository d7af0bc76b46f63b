/**
 * The line under the segments: whether the program closes, and if not, the ways to close it in one click.
 *
 * @import { Completion, Design, ShellContext } from "./types.d.ts"
 * @import { Texts } from "./texts.js"
 */
import { h, write } from "./dom.js";
import { riseUnit, strideUnit } from "./segment-row.js";

/**
 * @param {ShellContext} context
 * @param {Texts} texts
 * @param {HTMLButtonElement} add
 * @param {HTMLButtonElement} auto
 */
export function createClosing({ store, t, format }, texts, add, auto) {
  const sum = h("span", { class: "sum" });
  const fixes = h("div", { class: "fixes" });
  const problem = h("p", { class: "error", hidden: true, id: "program-problem" });
  const root = h("div", { class: "closing" }, h("div", { class: "closing-line" }, sum, h("span", {}, auto, add)), problem, fixes);

  /**
   * @param {string} key
   * @param {string} label
   * @param {Completion} op
   */
  function fix(key, label, op) {
    const button = texts.text(h("button", { type: "button", hidden: true }), key);
    button.addEventListener("click", () => {
      const next = [...fixes.children].indexOf(button);
      store.edit(t(label), [{ op }]);
      update();
      const other = [...fixes.querySelectorAll("button")].find((candidate) => !candidate.hidden);
      if (next >= 0 && button.hidden) (other ?? add).focus();
    });
    fixes.append(button);
    return button;
  }

  const fillReturn = fix("segments.fill.return", "edit.close", "fill-with-return");
  const fill = fix("segments.fill", "edit.fill", "fill-with-dwell");
  const stretch = fix("segments.stretch", "edit.fill", "stretch-last");
  const shorten = fix("segments.shorten", "edit.fill", "stretch-last");
  const spread = texts.attribute(fix("segments.spread", "edit.spread", "spread"), "title", "segments.spread.hint");
  const close = fix("segments.close", "edit.close", "close");

  let shown = "";

  function update() {
    const { design, error, language, outline } = store.state;
    const { left, open: height, stretches, closes } = outline;
    const whole = format.number(outline.whole, { unit: strideUnit(design) });
    const own = error?.path === "segments" && left === 0 && height === 0 ? error.message : "";
    const state = [left, height, whole, riseUnit(design), language, own, stretches, closes].join();
    if (state === shown) return;
    shown = state;
    fillReturn.hidden = !(left > 0 && height !== 0);
    fill.hidden = !(left > 0 && height === 0);
    stretch.hidden = !(left > 0);
    shorten.hidden = !(left < 0 && stretches);
    spread.hidden = left === 0 || left >= outline.whole;
    close.hidden = !(height !== 0 && left <= 0 && closes);
    fixes.hidden = [...fixes.children].every((button) => button instanceof HTMLElement && button.hidden);

    write(sum, sentence(left, height, design, whole));
    root.classList.toggle("open", left !== 0 || height !== 0);
    problem.hidden = own === "";
    write(problem, own);
  }

  /**
   * @param {number} left
   * @param {number} height
   * @param {Readonly<Design>} design
   * @param {string} whole
   */
  function sentence(left, height, design, whole) {
    const unit = riseUnit(design);
    const parts = [];
    if (left > 0) parts.push(t("segments.left", { angle: format.number(left, { unit: strideUnit(design) }), whole, count: left }));
    if (left < 0) parts.push(t("segments.over", { angle: format.number(-left, { unit: strideUnit(design) }), whole }));
    if (height > 0) parts.push(t("segments.height.above", { height: format.number(height, { unit }) }));
    if (height < 0) parts.push(t("segments.height.below", { height: format.number(-height, { unit }) }));
    return parts.length ? parts.join(" · ") : t(design.cam.kind === "translating" ? "segments.complete" : "segments.closed", { whole });
  }

  return { root, update };
}
