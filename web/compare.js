/**
 * The buttons that pin and compare designs. What they do is loaded when it is first asked for, or when something was pinned before.
 *
 * @import { Design, Lab, Read, ShellContext } from "./types.d.ts"
 * @import { Texts } from "./texts.js"
 */
import { h } from "./dom.js";
import { recall } from "./memory.js";

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
    const [{ startComparison }] = await Promise.all([import("./compare/index.js"), context.whole()]);
    return startComparison(context, engine, open);
  }
  const open = texts.text(h("button", { type: "button", class: "quiet", "aria-haspopup": "dialog" }), "header.compare");
  const pin = h("button", { type: "button", class: "quiet", id: "pin", "aria-keyshortcuts": "C" }, "+");
  texts.attribute(pin, "aria-label", "header.pin");
  texts.attribute(pin, "title", "header.pin");
  open.addEventListener("click", async () => (await load()).open());
  pin.addEventListener("click", async () => {
    // That of the click: the next edit may come before what pins it.
    const design = context.store.lastGood();
    (await load()).pin(design);
  });
  if (recall("slate")) requestIdleCallback?.(() => void load());
  return h("div", { class: "group" }, open, pin);
}
