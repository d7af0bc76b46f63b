/**
 * The window that lists the keys.
 *
 * @import { Texts } from "./texts.js"
 */
import { h } from "./dom.js";

/** @param {Texts} texts */
export function createHelp(texts) {
  const heading = texts.text(h("h2", { id: "help-heading" }), "help.title");
  const close = texts.text(h("button", { type: "button", autofocus: true }), "help.close");
  const words = {
    or: () => texts.text(h("span"), "key.or"),
    space: () => texts.text(h("kbd"), "key.space"),
    drag: () => texts.text(h("kbd"), "key.drag"),
  };
  const key = (/** @type {string} */ name) => h("kbd", {}, name);
  const rows = h(
    "dl",
    { class: "keys" },
    ...row(texts.text(h("dd"), "help.play"), words.space()),
    ...row(texts.text(h("dd"), "help.step"), key("←"), key("→")),
    ...row(texts.text(h("dd"), "help.undo"), key("Ctrl Z"), key("Ctrl Y")),
    ...row(texts.text(h("dd"), "help.step-field"), key("↑"), key("↓")),
    ...row(texts.text(h("dd"), "help.escape"), key("Esc")),
    ...row(texts.text(h("dd"), "help.scrub"), words.drag()),
    ...row(texts.text(h("dd"), "help.move"), key("Alt ↑"), key("Alt ↓"), words.or(), words.drag()),
    ...row(texts.text(h("dd"), "help.projector"), key("P")),
    ...row(texts.text(h("dd"), "help.help"), key("?")),
  );
  const dialog = h("dialog", { id: "help", "aria-labelledby": heading.id }, heading, rows, texts.text(h("p"), "help.about"), close);
  const button = h("button", { type: "button", class: "quiet", "aria-haspopup": "dialog" }, "?");
  texts.attribute(button, "aria-label", "header.help");
  texts.attribute(button, "title", "header.help");
  button.addEventListener("click", () => dialog.showModal());
  close.addEventListener("click", () => dialog.close());
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close();
  });
  return { button, dialog };
}

/**
 * @param {HTMLElement} what
 * @param {...HTMLElement} keys
 */
function row(what, ...keys) {
  return [h("dt", {}, ...keys.flatMap((key) => [key, " "])), what];
}
