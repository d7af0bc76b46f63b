/**
 * The guided first minute: a few steps that point at real things. The page stays in use all the while, and nothing moves by itself.
 *
 * @import { ShellContext } from "../types.d.ts"
 */
import { h } from "../dom.js";
import { keep } from "../memory.js";
import { createTexts } from "../texts.js";
import { beside } from "../floating.js";
import { dressed } from "./words.js";

/** What each step points at, by its key in the strings. @type {readonly (readonly [string, string])[]} */
export const STEPS = [
  ["mechanism", "#mechanism .stage-frame"],
  ["numbers", "#design .drawing-and-fields"],
  ["program", "#design .program"],
  ["diagrams", "#diagrams"],
  ["verdict", "#verdict"],
  ["share", "#header .share"],
];

/** Between the ring and what it is about, CSS pixels. */
const AROUND = 4;

/** Stops the tour that is running. */
let stop = () => {};

/** @param {ShellContext} context */
export async function startTour(context) {
  const { store, t } = context;
  stop();
  keep("tour", true);
  document.querySelector(".offer")?.remove();
  await dressed;
  const texts = createTexts(t);
  const before = document.activeElement;
  let step = 0;
  const count = h("p", { class: "count" });
  const text = h("p", { class: "telling", id: "tour-text" });
  const back = texts.text(h("button", { type: "button", class: "quiet", onclick: () => go(-1) }), "tour.back");
  const next = h("button", { type: "button", class: "next", onclick: () => go(1) });
  const close = texts.text(h("button", { type: "button", class: "quiet", onclick: end }), "tour.close");
  const ring = h("div", { class: "tour-ring", "aria-hidden": "true" });
  const box = h("div", { class: "card tour", role: "dialog", "aria-describedby": "tour-text" }, count, text, h("div", { class: "tour-buttons" }, close, back, next));
  texts.attribute(box, "aria-label", "help.tour");
  texts.also(tell);
  const unsubscribe = store.subscribe(["language"], () => texts.refresh());
  const listening = new AbortController();
  addEventListener("resize", place, { signal: listening.signal });
  addEventListener("scroll", place, { signal: listening.signal, capture: true });
  addEventListener("keydown", key, { signal: listening.signal });
  document.body.append(ring, box);
  stop = leave;
  point();

  function tell() {
    const [name = ""] = STEPS[step] ?? [];
    count.textContent = t("tour.count", { step: step + 1, steps: STEPS.length });
    text.textContent = t(`tour.step.${name}`);
    next.textContent = t(step === STEPS.length - 1 ? "tour.done" : "tour.next");
    back.hidden = step === 0;
  }

  /** @param {number} by */
  function go(by) {
    step += by;
    if (step >= STEPS.length) end();
    else {
      tell();
      point();
    }
  }

  function point() {
    target()?.scrollIntoView({ block: "nearest" });
    place();
    next.focus({ preventScroll: true });
  }

  /** What the step points at, or the middle of the page when it is not to be seen. */
  function target() {
    const found = document.querySelector(STEPS[step]?.[1] ?? "main");
    return found?.checkVisibility() ? found : document.querySelector("main");
  }

  function place() {
    const rect = target()?.getBoundingClientRect();
    if (!rect) return;
    // Around it, where the window leaves room: over its edge the ring would cross the first letters.
    const [left, top] = [Math.max(rect.left - AROUND, 1), Math.max(rect.top - AROUND, 1)];
    const [right, bottom] = [Math.min(rect.right + AROUND, innerWidth - 1), Math.min(rect.bottom + AROUND, innerHeight - 1)];
    Object.assign(ring.style, { left: `${left}px`, top: `${top}px`, width: `${right - left}px`, height: `${bottom - top}px` });
    beside(box, rect);
  }

  /** @param {KeyboardEvent} event */
  function key(event) {
    if (event.key !== "Escape" || event.defaultPrevented || document.querySelector("dialog[open], :popover-open")) return;
    event.preventDefault();
    end();
  }

  function end() {
    leave();
    if (before instanceof HTMLElement && before.isConnected) before.focus();
  }

  function leave() {
    listening.abort();
    unsubscribe();
    ring.remove();
    box.remove();
    stop = () => {};
  }
}
