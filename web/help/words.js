/** The words of the help, which come with whatever part of it is asked for first. */
import { h } from "../dom.js";
import { isSingleFile } from "../packed.js";
import { addStrings } from "../strings/index.js";
import { helpEn } from "../strings/help.en.js";
import { helpEs } from "../strings/help.es.js";

addStrings({ en: helpEn, es: helpEs });

/** Resolves when the styles that they share are there, or cannot be had. A single file has them in it. @type {Promise<void>} */
export const dressed = isSingleFile()
  ? Promise.resolve()
  : new Promise((resolve) => {
      const href = new URL("../styles/help.css", import.meta.url).href;
      document.head.append(h("link", { rel: "stylesheet", href, onload: resolve, onerror: resolve }));
    });
