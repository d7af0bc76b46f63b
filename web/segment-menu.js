/**
 * What can be done with a segment, in a small menu by its row.
 *
 * @import { Translate } from "./types.d.ts"
 */
import { h } from "./dom.js";

/** @typedef {"insert-before" | "insert-after" | "duplicate" | "up" | "down" | "delete"} Action */

/** @type {Action[]} */
const ACTIONS = ["insert-before", "insert-after", "duplicate", "up", "down", "delete"];

/**
 * @param {Translate} t
 * @param {(action: Action) => void} act
 */
export function createSegmentMenu(t, act) {
  const items = ACTIONS.map((action) => {
    const item = h("button", { type: "button", role: "menuitem", tabindex: "-1" });
    item.addEventListener("click", () => {
      root.hidePopover();
      act(action);
    });
    return { action, item };
  });
  const root = h("div", { popover: "auto", role: "menu", class: "menu", id: "segment-menu" }, ...items.map(({ item }) => item));

  root.addEventListener("keydown", (event) => {
    const usable = items.map(({ item }) => item).filter((item) => !item.disabled);
    const at = usable.findIndex((item) => item === document.activeElement);
    const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: -1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    usable.at(to % usable.length)?.focus();
  });

  return {
    root,

    /**
     * @param {HTMLElement} anchor
     * @param {(action: Action) => boolean} possible
     */
    open(anchor, possible) {
      for (const { action, item } of items) {
        item.textContent = t(`action.${action}`);
        item.disabled = !possible(action);
      }
      root.setAttribute("aria-label", anchor.getAttribute("aria-label") ?? "");
      root.showPopover();
      const { left, bottom, top } = anchor.getBoundingClientRect();
      const below = bottom + root.offsetHeight < innerHeight;
      root.style.left = `${Math.max(4, Math.min(left, innerWidth - root.offsetWidth - 4))}px`;
      root.style.top = `${below ? bottom : Math.max(4, top - root.offsetHeight)}px`;
      items.find(({ item }) => !item.disabled)?.item.focus();
    },
  };
}
