/** A small menu by the button that opens it. */
import { h } from "./dom.js";

/**
 * @param {string} id
 * @param {HTMLButtonElement[]} items
 */
export function createMenu(id, items) {
  for (const item of items) {
    item.setAttribute("role", "menuitem");
    item.tabIndex = -1;
    item.addEventListener("click", () => root.hidePopover());
  }
  const root = h("div", { popover: "auto", role: "menu", class: "menu", id }, ...items);

  root.addEventListener("keydown", (event) => {
    const usable = items.filter((item) => !item.disabled);
    const at = usable.findIndex((item) => item === document.activeElement);
    const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: -1 }[event.key];
    if (to === undefined) {
      if (event.key === "Tab") root.hidePopover();
      return;
    }
    event.preventDefault();
    usable.at(to % usable.length)?.focus();
  });

  return {
    root,

    /** @param {HTMLElement} anchor  the button, below which it opens, or above when there is no room */
    open(anchor) {
      root.setAttribute("aria-label", anchor.getAttribute("aria-label") ?? anchor.textContent);
      root.showPopover();
      const { left, bottom, top } = anchor.getBoundingClientRect();
      const below = bottom + root.offsetHeight < innerHeight;
      root.style.left = `${Math.max(4, Math.min(left, innerWidth - root.offsetWidth - 4))}px`;
      root.style.top = `${below ? bottom : Math.max(4, top - root.offsetHeight)}px`;
      items.find((item) => !item.disabled)?.focus();
    },
  };
}
