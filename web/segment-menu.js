/** What can be done with a segment, in a small menu by its row. */
import { h } from "./dom.js";
import { createMenu } from "./menu.js";

/** @typedef {"insert-before" | "insert-after" | "duplicate" | "up" | "down" | "select" | "delete"} Action */

/** @type {Action[]} */
const ACTIONS = ["insert-before", "insert-after", "duplicate", "up", "down", "select", "delete"];

/** @param {(action: Action) => void} act */
export function createSegmentMenu(act) {
  const items = ACTIONS.map((action) => ({ action, item: h("button", { type: "button" }) }));
  const menu = createMenu("segment-menu", items.map(({ item }) => item));
  // After the menu has closed and given the focus back.
  for (const { action, item } of items) item.addEventListener("click", () => act(action));

  return {
    root: menu.root,

    /**
     * @param {HTMLElement} anchor
     * @param {(action: Action) => boolean} possible
     * @param {(action: Action) => string} name
     */
    open(anchor, possible, name) {
      for (const { action, item } of items) {
        item.textContent = name(action);
        item.disabled = !possible(action);
      }
      menu.open(anchor);
    },
  };
}
