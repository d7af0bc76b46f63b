/**
 * The title, edited in place.
 *
 * @import { ShellContext } from "./types.d.ts"
 * @import { Texts } from "./texts.js"
 */
import { h } from "./dom.js";

let sessions = 0;

/** Control and bidirectional characters can disguise a text; they have no place in a title. */
const UNWANTED = /[\p{Cc}\u2028\u2029\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069]/gu;

/** Blanks and characters that leave no mark: a title of these alone is none. */
const INVISIBLE = /^[\p{White_Space}\p{Default_Ignorable_Code_Point}\u2800]*$/u;

/**
 * @param {string} text
 * @param {number} longest
 */
export function cleanTitle(text, longest) {
  if (INVISIBLE.test(text)) return "";
  return [...text.replaceAll(UNWANTED, "")].slice(0, longest).join("");
}

/**
 * @param {ShellContext} context
 * @param {Texts} texts
 */
export function createTitleField({ store, catalogue, t }, texts) {
  const longest = catalogue.limits.title;
  const input = h("input", { type: "text", class: "title", maxlength: longest, spellcheck: "false", autocomplete: "off" });
  let gesture = "";
  /** @type {string | null} */
  let shown = null;

  input.addEventListener("focus", () => (gesture = `title:${++sessions}`));
  input.addEventListener("input", () => {
    const title = cleanTitle(input.value, longest);
    if (title !== store.state.design.title) store.edit(t("edit.title"), [{ path: ["title"], value: title }], { gesture });
  });
  input.addEventListener("keydown", (event) => {
    if (event.key === "Escape") {
      event.preventDefault();
      store.cancel(gesture);
    }
    if (event.key === "Enter" || event.key === "Escape") input.blur();
  });
  input.addEventListener("blur", () => {
    shown = null;
    store.endGesture();
    update();
  });
  texts.attribute(input, "aria-label", "header.title");
  texts.attribute(input, "title", "header.title");
  texts.attribute(input, "placeholder", "app.untitled");

  function update() {
    const { title } = store.state.design;
    if (title === shown && document.activeElement !== input) return;
    shown = title;
    if (cleanTitle(input.value, longest) !== title || document.activeElement !== input) input.value = title;
    document.title = title ? `${title} · LevaLab` : "LevaLab";
  }

  return { input, update };
}
