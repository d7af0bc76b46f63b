/**
 * Opening and saving design files.
 *
 * @import { Design, Read, ShellContext } from "./types.d.ts"
 * @import { Texts } from "./texts.js"
 */
import { h } from "./dom.js";
import { createMenu } from "./menu.js";
import { isSingleFile } from "./packed.js";

/** A design file has a few thousand characters; a larger one is something else. */
const LARGEST = 1_000_000;

/** @typedef {{ openFile: (text: string, notJson: string) => Read, saveFile: (design: Design) => string, check: (design: unknown) => Read }} FileEngine */

/**
 * Opens a design file that somebody chose or dropped, or tells why not.
 * @param {ShellContext} context
 * @param {Pick<FileEngine, "openFile">} engine
 * @returns {(file: File) => Promise<void>}
 */
export function opener({ store, t, banner, whole }, { openFile }) {
  return async (file) => {
    const text = file.size > LARGEST ? "" : await file.text().catch(() => "");
    const attempt = () => openFile(text, t("banner.file.json"));
    await whole();
    const read = attempt();
    if (read.error) return banner.show("banner.file", () => ({ reason: sentence(attempt()) }));
    banner.hide();
    store.replace(read.design, t("edit.file"));
  };
}

/**
 * @param {ShellContext} context
 * @param {Texts} texts
 * @param {FileEngine} engine
 */
export function createFiles(context, texts, engine) {
  const { store } = context;
  const chooser = h("input", { type: "file", accept: ".json,application/json", class: "unseen", tabindex: "-1", "aria-hidden": "true" });
  const open = texts.text(h("button", { type: "button" }), "header.open");
  const save = texts.text(h("button", { type: "button" }), "header.save");
  const recent = texts.text(h("button", { type: "button", "aria-haspopup": "dialog" }), "header.recent");
  const exports = texts.text(h("button", { type: "button", "aria-haspopup": "dialog" }), "header.export");
  const paper = texts.text(h("button", { type: "button", "aria-haspopup": "dialog", "aria-keyshortcuts": "Control+P" }), "header.print");
  const symbols = texts.text(h("button", { type: "button", "aria-haspopup": "menu" }), "header.notation");
  // A page on disk may load nothing: there only the command line writes other files.
  const menu = createMenu("files-menu", [open, recent, save, ...(isSingleFile() ? [] : [exports]), paper, symbols]);
  const openFile = opener(context, engine);
  /** @type {Promise<() => Promise<void>> | undefined} */
  let recentDialog;
  /** @type {Promise<() => Promise<void>> | undefined} */
  let exportDialog;
  /** @type {Promise<() => Promise<void>> | undefined} */
  let printDialog;
  /** @type {Promise<{ open: (anchor: HTMLElement) => void }> | undefined} */
  let notationMenu;
  const files = texts.text(h("button", { type: "button", class: "quiet drop", "aria-haspopup": "menu" }), "header.files");

  files.addEventListener("click", () => menu.open(files));
  open.addEventListener("click", () => chooser.click());
  chooser.addEventListener("change", () => {
    const [file] = chooser.files ?? [];
    chooser.value = "";
    if (file) void openFile(file);
  });
  recent.addEventListener("click", async () => {
    recentDialog ??= import("./recent-dialog.js").then(({ createRecentDialog }) => createRecentDialog(context, engine.check));
    await (await recentDialog)();
  });
  exports.addEventListener("click", async () => {
    exportDialog ??= import("./exports/dialog.js").then(({ createExportDialog }) => createExportDialog(context));
    await (await exportDialog)();
  });
  paper.addEventListener("click", async () => {
    printDialog ??= import("./exports/print-dialog.js").then(({ createPrintDialog }) => createPrintDialog(context));
    await (await printDialog)();
  });
  symbols.addEventListener("click", async () => {
    notationMenu ??= import("./notation.js").then(({ createNotationMenu }) => createNotationMenu(context));
    (await notationMenu).open(files);
  });
  addEventListener("keydown", (event) => {
    const asked = (event.ctrlKey || event.metaKey) && !event.altKey && !event.shiftKey && event.key.toLowerCase() === "p";
    if (!asked || document.querySelector("dialog[open]")) return;
    event.preventDefault();
    paper.click();
  });

  save.addEventListener("click", () => {
    const design = store.lastGood();
    const url = URL.createObjectURL(new Blob([engine.saveFile(design)], { type: "application/json" }));
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
