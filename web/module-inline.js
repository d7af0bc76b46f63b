/** Where the modules of the calculation come from in the single-file page: text in the page itself, since a page on disk may load nothing. */
import { inlined } from "./inlined.js";
import { freshGlue } from "levalab:glue";

/** @type {Map<string, Promise<WebAssembly.Module>>} */
const known = new Map();

/** @param {string} name */
export function compiled(name) {
  const module = known.get(name) ?? WebAssembly.compile(inlined(name));
  known.set(name, module);
  return module;
}

/** @param {string} name */
export const glue = async (name) => freshGlue(name);
