/**
 * The window behind "?": manual, theory, terms, the guided minute, and the keys.
 *
 * @import { ShellContext } from "../types.d.ts"
 */
import { h } from "../dom.js";
import { createTexts } from "../texts.js";
import { addressOf } from "./pages.js";
import { startTour } from "./tour.js";
import { dressed } from "./words.js";

/** @type {HTMLDialogElement | undefined} */
let dialog;

/** @param {ShellContext} context */
export async function open(context) {
  dialog ??= create(context);
  await dressed;
  if (!dialog.open) dialog.showModal();
}

/** @param {ShellContext} context */
function create(context) {
  const { store, t } = context;
  const texts = createTexts(t);
  const heading = texts.text(h("h2", { id: "help-heading" }), "help.title");
  const close = texts.text(h("button", { type: "button" }), "help.close");
  const tour = texts.text(h("button", { type: "button", class: "start-tour" }), "help.tour");
  const reading = h("ul", { class: "reading" }, link("manual-", "help.manual", "help.manual.hint"), link("", "help.theory", "help.theory.hint"), link("terms-", "help.terms", "help.terms.hint"));
  const words = {
    or: () => texts.text(h("span"), "key.or"),
    space: () => texts.text(h("kbd"), "key.space"),
    drag: () => texts.text(h("kbd"), "key.drag"),
  };
  const key = (/** @type {string} */ name) => h("kbd", {}, name);
  const keys = h(
    "dl",
    { class: "keys" },
    ...row(texts.text(h("dd"), "help.play"), words.space()),
    ...row(texts.text(h("dd"), "help.step"), key("←"), key("→")),
    ...row(texts.text(h("dd"), "help.undo"), key("Ctrl Z"), key("Ctrl Y")),
    ...row(texts.text(h("dd"), "help.step-field"), key("↑"), key("↓")),
    ...row(texts.text(h("dd"), "help.marks"), key("←"), key("→")),
    ...row(texts.text(h("dd"), "help.escape"), key("Esc")),
    ...row(texts.text(h("dd"), "help.scrub"), words.drag()),
    ...row(texts.text(h("dd"), "help.move"), key("Alt ↑"), key("Alt ↓"), words.or(), words.drag()),
    ...row(texts.text(h("dd"), "help.pin"), key("C")),
    ...row(texts.text(h("dd"), "help.projector"), key("P"), key("Esc")),
    ...row(texts.text(h("dd"), "help.projector.shown"), key("S"), key("V")),
    ...row(texts.text(h("dd"), "help.help"), key("?")),
  );
  const about = texts.text(h("p"), "help.about");
  const licences = h("p", { class: "licences" }, anchor("licences-", "help.licences"));
  const box = h("dialog", { id: "help", "aria-labelledby": heading.id }, heading, reading, tour, texts.text(h("h3"), "help.keys"), keys, about, licences, close);

  /** @param {"" | "terms-" | "manual-"} page @param {string} label @param {string} hint */
  function link(page, label, hint) {
    return h("li", {}, anchor(page, label), " ", texts.text(h("span"), hint));
  }

  /** @param {"" | "terms-" | "manual-" | "licences-"} page @param {string} label */
  function anchor(page, label) {
    const anchor = texts.text(h("a", { target: "_blank", rel: "noopener" }), label);
    texts.also(() => (anchor.href = addressOf(`${page}${store.state.language}.html`)));
    return anchor;
  }

  close.addEventListener("click", () => box.close());
  tour.addEventListener("click", () => {
    box.close();
    void startTour(context);
  });
  box.addEventListener("click", (event) => {
    if (event.target === box) box.close();
  });
  store.subscribe(["language"], () => texts.refresh());
  document.body.append(box);
  return box;
}

/**
 * @param {HTMLElement} what
 * @param {...HTMLElement} keys
 */
function row(what, ...keys) {
  return [h("dt", {}, ...keys.flatMap((key) => [key, " "])), what];
}
