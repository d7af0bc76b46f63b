/**
 * A quiet sentence in a corner, with one thing to do about it.
 *
 * @import { ShellContext } from "./types.d.ts"
 */
import { h } from "./dom.js";
import { createTexts } from "./texts.js";

/** @type {HTMLElement | undefined} */
let root;

/**
 * @param {ShellContext} context
 * @param {string} sentence  key
 * @param {string} action    key
 * @param {() => void} act
 */
export function showNotice({ store, t }, sentence, action, act) {
  root?.remove();
  const texts = createTexts(t);
  const button = texts.text(h("button", { type: "button" }), action);
  const close = h("button", { type: "button", class: "quiet" }, "×");
  const notice = h("aside", { class: "notice", role: "status" });
  texts.attribute(close, "aria-label", "note.close");
  button.addEventListener("click", act);
  close.addEventListener("click", () => notice.remove());
  document.body.append(notice);
  // A screen reader tells what comes into a region that is there already.
  notice.append(texts.text(h("p"), sentence), button, close);
  store.subscribe(["language"], () => texts.refresh());
  root = notice;
}
