/**
 * The buttons that pin and compare designs. What they do is loaded when it is first asked for, or when something was pinned before.
 *
 * @import { Design, Lab, Read, ShellContext } from "./types.d.ts"
 * @import { Texts } from "./texts.js"
 */
import { h } from "./dom.js";
import { recall } from "./memory.js";
import { demand, onDemand } from "./on-demand.js";
import { whenIdle } from "./rest.js";

/** @typedef {{ another: () => Lab, check: (design: unknown) => Read, saveFile: (design: Design) => string }} CompareEngine */

/**
 * @param {ShellContext} context
 * @param {Texts} texts
 * @param {CompareEngine} engine
 */
export function createCompare(context, texts, engine) {
  /** @type {Promise<import("./compare/index.js").Comparison> | null} */
  let loading = null;
  const load = () => (loading ??= begin().catch((/** @type {unknown} */ error) => {
    loading = null;
    throw error;
  }));
  async function begin() {
    const { startComparison } = await import("./compare/index.js");
    return startComparison(context, engine, open);
  }
  const open = texts.text(h("button", { type: "button", class: "quiet", "aria-haspopup": "dialog" }), "header.compare");
  const pin = h("button", { type: "button", class: "quiet", id: "pin", "aria-keyshortcuts": "C" }, "+");
  texts.attribute(pin, "aria-label", "header.pin");
  texts.attribute(pin, "title", "header.pin");
  onDemand(context, open, load, (comparison) => comparison.open());
  pin.addEventListener("click", () => {
    // The design of the click: the next edit may come before the part that pins it.
    const design = context.store.lastGood();
    void demand(context, pin, load, (comparison) => comparison.pin(design));
  });
  if (recall("slate")) whenIdle(() => void load().catch(console.warn));
  return h("div", { class: "group" }, open, pin);
}
