/**
 * Opening and saving design files.
 *
 * @import { Design, Read, ShellContext } from "./types.d.ts"
 * @import { Texts } from "./texts.js"
 */
import { h } from "./dom.js";
import { createMenu } from "./menu.js";

/** A design file has a few thousand characters; a larger one is something else. */
const LARGEST = 1_000_000;

/**
 * @param {ShellContext} context
 * @param {Texts} texts
 * @param {{ openFile: (text: string, notJson: string) => Read, saveFile: (design: Design) => string }} engine
 */
export function createFiles({ store, t, banner }, texts, { openFile, saveFile }) {
  const chooser = h("input", { type: "file", accept: ".json,application/json", class: "unseen", tabindex: "-1", "aria-hidden": "true" });
  const open = texts.text(h("button", { type: "button" }), "header.open");
  const save = texts.text(h("button", { type: "button" }), "header.save");
  const menu = createMenu("files-menu", [open, save]);
  const files = texts.text(h("button", { type: "button", class: "quiet drop", "aria-haspopup": "menu" }), "header.files");

  files.addEventListener("click", () => menu.open(files));
  open.addEventListener("click", () => chooser.click());
  chooser.addEventListener("change", async () => {
    const [file] = chooser.files ?? [];
    chooser.value = "";
    if (!file) return;
    const text = file.size > LARGEST ? "" : await file.text();
    const attempt = () => openFile(text, t("banner.file.json"));
    const read = attempt();
    if (read.error) return banner.show("banner.file", () => ({ reason: sentence(attempt()) }));
    banner.hide();
    store.replace(read.design, t("edit.file"));
  });

  save.addEventListener("click", () => {
    const design = store.lastGood();
    const url = URL.createObjectURL(new Blob([saveFile(design)], { type: "application/json" }));
    h("a", { href: url, download: `${fileName(design.title) || "levalab"}.lev.json` }).click();
    setTimeout(() => URL.revokeObjectURL(url), 10_000);
  });

  return [chooser, files, menu.root];
}

/** What is wrong with a file, and where. @param {Read} read */
function sentence({ error }) {
  return error?.path ? `${error.path}: ${error.message}` : (error?.message ?? "");
}

/** @param {string} title */
function fileName(title) {
  return title.replaceAll(/[\\/:*?"<>|.]+/g, " ").trim().replaceAll(/\s+/g, "-");
}
