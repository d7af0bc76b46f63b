/**
 * Question marks: each asks for the card of a magnitude. Everything behind them is loaded when it is first asked for. Marks that lie together
 * are one stop of Tab; arrows lead from each to the next.
 *
 * @import { ShellContext } from "./types.d.ts"
 */
import { h } from "./dom.js";
import { demand } from "./on-demand.js";

/** The element that holds the words "What is" in the page's language, which every mark begins its name with. */
const WHAT = "mark-what";
/** The element that says how to reach the other marks of a group. */
const HOW = "mark-how";

/** The parts of the page whose marks are one group. */
const GROUPS = "#design, #readouts, .figures, .stage-layers-list";

/**
 * @param {string} term   its place in the page of terms
 * @param {string} named  id of the element that names it
 */
export function mark(term, named) {
  return h("button", { type: "button", class: "mark", tabindex: "-1", "data-term": term, "aria-haspopup": "dialog", "aria-labelledby": `${WHAT} ${named}` }, "?");
}

/** @param {ShellContext} context */
export function answer(context) {
  const what = h("span", { id: WHAT, hidden: true });
  const how = h("span", { id: HOW, hidden: true });
  const speak = () => {
    what.textContent = context.t("mark.what");
    how.textContent = context.t("mark.how");
  };
  document.body.append(what, how);
  speak();
  context.store.subscribe(["language"], speak);
  document.addEventListener("click", ({ target }) => {
    const asked = target instanceof Element ? target.closest("button[data-term]") : null;
    if (asked instanceof HTMLElement) void demand(context, asked, () => import("./help/card.js"), (card) => card.show(context, asked));
  });
  document.addEventListener("keydown", (event) => {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    // The focus moves after this: only now does it matter which marks are in sight.
    if (event.key === "Tab") for (const group of groups()) chooseStop(group);
    else if (event.target instanceof HTMLElement && event.target.matches("button[data-term]")) moveFrom(event.target, event);
  });
}

/** The marks of each group, in the order of the page. */
function groups() {
  /** @type {Map<Element, HTMLElement[]>} */
  const found = new Map();
  for (const one of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("button[data-term]"))) {
    const group = one.closest(GROUPS) ?? one;
    found.set(group, [...(found.get(group) ?? []), one]);
  }
  return found.values();
}

/**
 * Of the marks in sight one is reached by Tab: the one with the focus, else the one that was reached last, else the first.
 * @param {HTMLElement[]} group
 */
function chooseStop(group) {
  const seen = group.filter((one) => one.checkVisibility());
  const stop = seen.find((one) => one === document.activeElement) ?? seen.find((one) => one.tabIndex === 0) ?? seen[0];
  for (const one of group) makeStop(one, one === stop);
  if (seen.length > 1) stop?.setAttribute("aria-describedby", HOW);
}

/** @param {HTMLElement} one @param {boolean} stop */
function makeStop(one, stop) {
  one.tabIndex = stop ? 0 : -1;
  // How to go on is said where Tab arrives, not at each step.
  one.removeAttribute("aria-describedby");
}

/**
 * Arrows, Home and End within the group of a mark.
 * @param {HTMLElement} from
 * @param {KeyboardEvent} event
 */
function moveFrom(from, event) {
  const all = [...groups()].find((group) => group.includes(from)) ?? [];
  const seen = all.filter((one) => one.checkVisibility());
  const at = seen.indexOf(from);
  const to = { ArrowRight: at + 1, ArrowDown: at + 1, ArrowLeft: at - 1, ArrowUp: at - 1, Home: 0, End: -1 }[event.key];
  const next = to === undefined ? undefined : seen.at(to % seen.length);
  if (!next) return;
  event.preventDefault();
  for (const one of all) makeStop(one, one === next);
  next.focus();
}
