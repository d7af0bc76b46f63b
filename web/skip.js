/**
 * The first stops of Tab: buttons, seen while they have the focus, that lead past all in between. Links would write over the design in the
 * address.
 *
 * @import { Texts } from "./texts.js"
 */
import { h } from "./dom.js";

/** The parts of the page that they lead to. */
const PARTS = /** @type {const} */ (["design", "diagrams"]);

/** @param {Texts} texts */
export function createSkips(texts) {
  return PARTS.map((part) => {
    const button = texts.text(h("button", { type: "button", class: `unseen skip to-${part}` }), `skip.${part}`);
    button.addEventListener("click", () => goTo(part));
    return button;
  });
}

/** Gives a part of the page the focus, which it can only have this way. @param {string} id */
function goTo(id) {
  const part = document.getElementById(id);
  if (!part) return;
  part.tabIndex = -1;
  part.addEventListener("blur", () => part.removeAttribute("tabindex"), { once: true });
  part.focus();
}
