/**
 * Auto: the user draws or types only what the machine must do, and the program that does it is joined by the smoothest laws, seen before it
 * is taken. Loaded when it is first asked for.
 *
 * @import { ShellContext } from "../types.d.ts"
 */
import { autoEn } from "../strings/auto.en.js";
import { autoEs } from "../strings/auto.es.js";
import { addStrings } from "../strings/index.js";
import { wear } from "./sheet.js";
import { createWindow } from "./window.js";

/** @type {ReturnType<typeof createWindow> | null} */
let made = null;

/** @param {ShellContext} context */
export function openAuto(context) {
  if (!made) {
    addStrings({ en: autoEn, es: autoEs });
    wear();
    made = createWindow(context);
  }
  made.open();
}
