/**
 * Design files that are dropped anywhere on the page.
 *
 * @import { ShellContext } from "./types.d.ts"
 */
import { h } from "./dom.js";
import { createTexts } from "./texts.js";

/**
 * @param {ShellContext} context
 * @param {(file: File) => Promise<void>} open
 */
export function acceptDrops({ store, t }, open) {
  const texts = createTexts(t);
  const sign = h("div", { class: "dropping", hidden: true, "aria-hidden": "true" }, texts.text(h("p"), "files.drop"));
  document.body.append(sign);
  store.subscribe(["language"], () => texts.refresh());

  /** Files, and no text or link on its way from one field to another. @param {DragEvent} event */
  const carriesFiles = (event) => event.dataTransfer?.types.includes("Files") && !document.querySelector("dialog[open]");

  addEventListener("dragover", (event) => {
    if (!carriesFiles(event) || !event.dataTransfer) return;
    event.preventDefault();
    event.dataTransfer.dropEffect = "copy";
    sign.hidden = false;
  });
  addEventListener("dragleave", (event) => {
    if (!event.relatedTarget) sign.hidden = true;
  });
  addEventListener("drop", (event) => {
    sign.hidden = true;
    if (!carriesFiles(event)) return;
    event.preventDefault();
    const [file] = event.dataTransfer?.files ?? [];
    if (file) void open(file);
  });
}
