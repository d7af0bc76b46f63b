/**
 * Opening and saving design files.
 *
 * @import { Design, Edit, Read, ShellContext } from "./types.d.ts"
 * @import { Texts } from "./texts.js"
 */
import { h } from "./dom.js";
import { createMenu } from "./menu.js";
import { onDemand } from "./on-demand.js";
import { isSingleFile } from "./packed.js";
import { sayWhatLeaves } from "./unfinished.js";

/** Bytes of a file that are looked at: one more than a design file may have, so that a larger one is seen to be. */
const LARGEST = 2 ** 20 + 1;

/** @typedef {{ openFile: (bytes: Uint8Array, without: string) => Read, saveFile: (design: Design) => string, apply: (design: Design, edits: Edit[], without: string) => Read, check: (design: unknown) => Read }} FileEngine */

/**
 * Opens a design file that somebody chose or dropped, or tells why not.
 * @param {ShellContext} context
 * @param {Pick<FileEngine, "openFile">} engine
 * @returns {(file: File) => Promise<void>}
 */
export function opener({ store, t, banner }, { openFile }) {
  return async (file) => {
    const buffer = await file.slice(0, LARGEST).arrayBuffer().catch(() => null);
    if (!buffer) return banner.show("banner.file", () => ({ reason: t("banner.file.unread") }));
    const attempt = () => openFile(new Uint8Array(buffer), t("banner.panic"));
    let { language } = store.state;
    let read = attempt();
    if (read.error) {
      // Read again in another language only: what makes the calculation fail fails each time.
      const reason = () => {
        if (language !== store.state.language) read = attempt();
        ({ language } = store.state);
        return sentence(read);
      };
      return banner.show("banner.file", () => ({ reason: reason() }));
    }
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
  const { store, t, banner } = context;
  const chooser = h("input", { type: "file", accept: ".json,application/json", class: "unseen", tabindex: "-1", "aria-hidden": "true" });
  const fresh = texts.text(h("button", { type: "button" }), "header.new");
  const open = texts.text(h("button", { type: "button" }), "header.open");
  const save = texts.text(h("button", { type: "button" }), "header.save");
  const recent = texts.text(h("button", { type: "button", "aria-haspopup": "dialog" }), "header.recent");
  const exports = texts.text(h("button", { type: "button", "aria-haspopup": "dialog" }), "header.export");
  const paper = texts.text(h("button", { type: "button", "aria-haspopup": "dialog", "aria-keyshortcuts": "Control+P" }), "header.print");
  const symbols = texts.text(h("button", { type: "button", "aria-haspopup": "menu" }), "header.notation");
  // A page on disk may load nothing: there only the command line writes other files.
  const menu = createMenu("files-menu", [fresh, open, recent, save, ...(isSingleFile() ? [] : [exports]), paper, symbols]);
  const openFile = opener(context, engine);
  /** @type {(() => unknown) | undefined} */
  let recentDialog;
  /** @type {(() => unknown) | undefined} */
  let exportDialog;
  /** @type {(() => unknown) | undefined} */
  let printDialog;
  /** @type {{ open: (anchor: HTMLElement) => void } | undefined} */
  let notationMenu;
  const files = texts.text(h("button", { type: "button", class: "quiet drop", "aria-haspopup": "menu" }), "header.files");

  files.addEventListener("click", () => menu.open(files));
  fresh.addEventListener("click", () => {
    const { design } = engine.apply(store.lastGood(), [{ op: "new" }], t("banner.panic"));
    if (!design) return;
    banner.hide();
    store.replace(design, t("edit.new"));
  });
  open.addEventListener("click", () => chooser.click());
  chooser.addEventListener("change", () => {
    const [file] = chooser.files ?? [];
    chooser.value = "";
    if (file) void openFile(file);
  });
  onDemand(context, recent, () => import("./recent-dialog.js"), ({ createRecentDialog }) => (recentDialog ??= createRecentDialog(context, engine.check))());
  onDemand(context, exports, () => import("./exports/dialog.js"), ({ createExportDialog }) => (exportDialog ??= createExportDialog(context))());
  onDemand(context, paper, () => import("./exports/print-dialog.js"), ({ createPrintDialog }) => (printDialog ??= createPrintDialog(context))());
  onDemand(context, symbols, () => import("./notation.js"), ({ createNotationMenu }) => (notationMenu ??= createNotationMenu(context)).open(files));
  addEventListener("keydown", (event) => {
    const asked = (event.ctrlKey || event.metaKey) && !event.altKey && !event.shiftKey && event.key.toLowerCase() === "p";
    if (!asked || document.querySelector("dialog[open]")) return;
    event.preventDefault();
    paper.click();
  });

  save.addEventListener("click", () => {
    sayWhatLeaves(context);
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
