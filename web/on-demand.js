/**
 * Buttons whose work is loaded when they are pressed. A part that does not arrive is reported beside its button, with a way to reload.
 *
 * @import { Context } from "./types.d.ts"
 */
import { h } from "./dom.js";
import { beside } from "./floating.js";

/** The report on screen. @type {HTMLElement | null} */
let shown = null;

/**
 * Loads a part at each press of a button and uses it; the browser keeps what has arrived.
 * @template Part
 * @param {Context} context
 * @param {HTMLElement} button
 * @param {() => Promise<Part>} load
 * @param {(part: Part) => unknown} use
 */
export function onDemand(context, button, load, use) {
  button.addEventListener("click", () => demand(context, button, load, use));
}

/**
 * Loads a part and uses it, or reports beside `place` that it did not arrive.
 * @template Part
 * @param {Context} context
 * @param {HTMLElement} place
 * @param {() => Promise<Part>} load
 * @param {(part: Part) => unknown} use
 */
export async function demand(context, place, load, use) {
  let part;
  place.setAttribute("aria-busy", "true");
  try {
    part = await load();
  } catch (error) {
    console.warn(error);
    return report(context, place);
  } finally {
    place.removeAttribute("aria-busy");
  }
  await use(part);
}

/**
 * @param {Context} context
 * @param {HTMLElement} place
 */
function report({ t }, place) {
  shown?.remove();
  const sentence = h("p", { id: "missing-part" }, t("demand.missing"));
  const reload = h("button", { type: "button", onclick: () => location.reload() }, t("demand.reload"));
  const close = h("button", { type: "button", class: "quiet", onclick: () => shown?.hidePopover() }, t("banner.close"));
  shown = h("div", { popover: "auto", class: "missing-part", role: "alertdialog", "aria-labelledby": sentence.id }, sentence, h("p", { class: "missing-do" }, reload, close));
  // Within an open dialog, since the rest of the page cannot be reached then.
  (place.closest("dialog") ?? document.body).append(shown);
  shown.showPopover();
  // A menu that offered the button may have closed with the press.
  const from = place.getClientRects().length > 0 ? place : (document.querySelector('[aria-haspopup="menu"]') ?? place);
  beside(shown, from.getBoundingClientRect());
  reload.focus();
}
