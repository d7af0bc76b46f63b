/**
 * The panel of what the follower drives, by the diagrams; loaded when it is first asked for.
 *
 * @import { ShellContext } from "../types.d.ts"
 */
import { addStrings } from "../strings/index.js";
import { applicationEn } from "../strings/application.en.js";
import { applicationEs } from "../strings/application.es.js";
import { createPanel } from "./panel.js";
import { wear } from "./sheet.js";

/** @type {ReturnType<typeof createPanel> | null} */
let panel = null;

/**
 * Opens the panel, or closes it.
 * @param {ShellContext} context
 * @param {HTMLButtonElement} button
 */
export function open(context, button) {
  if (!panel) {
    addStrings({ en: applicationEn, es: applicationEs });
    wear();
    panel = createPanel(context, button);
  }
  panel.toggle();
}
