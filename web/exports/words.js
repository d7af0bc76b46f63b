/** The words and the styles of exports and report, which come with whatever of them is asked for first. */
import { h } from "../dom.js";
import { isSingleFile } from "../packed.js";
import { exportsEn } from "../strings/exports.en.js";
import { exportsEs } from "../strings/exports.es.js";
import { addStrings } from "../strings/index.js";

addStrings({ en: exportsEn, es: exportsEs });

/** Resolves when the styles are there, or cannot be had. A single file has them in it. @type {Promise<void>} */
export const dressed = isSingleFile()
  ? Promise.resolve()
  : new Promise((resolve) => {
      const href = new URL("../styles/exports.css", import.meta.url).href;
      document.head.append(h("link", { rel: "stylesheet", href, onload: resolve, onerror: resolve }));
    });
