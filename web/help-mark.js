/**
 * Question marks: each asks for the card of a magnitude. Everything behind them is loaded when it is first asked for.
 *
 * @import { ShellContext } from "./types.d.ts"
 */
import { h } from "./dom.js";
import { demand } from "./on-demand.js";

/** The element that holds the words "What is" in the page's language, which every mark begins its name with. */
const WHAT = "mark-what";

/**
 * @param {string} term   its place in the page of terms
 * @param {string} named  id of the element that names it
 */
export function mark(term, named) {
  return h("button", { type: "button", class: "mark", "data-term": term, "aria-haspopup": "dialog", "aria-labelledby": `${WHAT} ${named}` }, "?");
}

/** @param {ShellContext} context */
export function answer(context) {
  const what = h("span", { id: WHAT, hidden: true });
  const speak = () => (what.textContent = context.t("mark.what"));
  document.body.append(what);
  speak();
  context.store.subscribe(["language"], speak);
  document.addEventListener("click", ({ target }) => {
    const asked = target instanceof Element ? target.closest("button[data-term]") : null;
    if (asked instanceof HTMLElement) void demand(context, asked, () => import("./help/card.js"), (card) => card.show(context, asked));
  });
}
