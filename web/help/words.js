/** The words of the help, which come with whatever part of it is asked for first. */
import { addStrings } from "../strings/index.js";
import { helpEn } from "../strings/help.en.js";
import { helpEs } from "../strings/help.es.js";

addStrings({ en: helpEn, es: helpEs });

/** The styles that they share: asked for once. */
const sheet = document.createElement("link");
sheet.rel = "stylesheet";
sheet.href = new URL("../styles/help.css", import.meta.url).href;
document.head.append(sheet);

/** Resolves when the styles are there, or cannot be had. @type {Promise<void>} */
export const dressed = new Promise((resolve) => {
  sheet.addEventListener("load", () => resolve());
  sheet.addEventListener("error", () => resolve());
});

/**
 * The address of a page of theory in that language.
 * @param {"" | "terms-" | "manual-"} page
 * @param {import("../types.d.ts").Language} language
 */
export function pageAddress(page, language) {
  const help = document.querySelector('link[rel="help"]');
  return new URL(`${page}${language}.html`, help instanceof HTMLLinkElement ? help.href : document.baseURI).href;
}
