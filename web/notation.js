/**
 * Whose symbols the page speaks in: a menu, loaded when it is first asked for. The choice is part of the design, and of its link.
 *
 * @import { ShellContext } from "./types.d.ts"
 */
import { h } from "./dom.js";
import { createMenu } from "./menu.js";
import { addStrings } from "./strings/index.js";
import { notationEn } from "./strings/notation.en.js";
import { notationEs } from "./strings/notation.es.js";

addStrings({ en: notationEn, es: notationEs });

/** Words of the design file; ours is the one that is left out. */
const NOTATIONS = ["levalab", "norton", "shigley", "rothbart", "cardona-clos", "capitals"];

/** @param {ShellContext} context */
export function createNotationMenu({ store, t }) {
  const items = NOTATIONS.map((word) => {
    const button = h("button", { type: "button" });
    button.addEventListener("click", () => {
      if (word === (store.state.design.notation ?? "levalab")) return;
      store.edit(t("edit.notation"), [{ path: ["notation"], value: word }]);
    });
    return button;
  });
  const menu = createMenu("notation-menu", items);

  return {
    /** @param {HTMLElement} anchor */
    open(anchor) {
      if (!menu.root.isConnected) anchor.after(menu.root);
      const current = store.state.design.notation ?? "levalab";
      items.forEach((button, index) => {
        const word = NOTATIONS[index] ?? "";
        button.setAttribute("role", "menuitemradio");
        button.setAttribute("aria-checked", String(word === current));
        button.replaceChildren(h("span", { "aria-hidden": "true" }, word === current ? "● " : "○ "), t(`notation.${word}`));
      });
      menu.open(anchor);
      menu.root.setAttribute("aria-label", t("notation.title"));
      items[NOTATIONS.indexOf(current)]?.focus();
    },
  };
}
