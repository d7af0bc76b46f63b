/** Where the calculation comes from in the single-file page: text in the page itself, since a page on disk may load nothing. */
import { inlined } from "./inlined.js";
import { freshGlue } from "levalab:glue";

/** The whole module. @returns {Promise<WebAssembly.Module>} */
export const compileFirst = () => WebAssembly.compile(inlined("levalab-module"));

/** Nothing is left: a module of eight bytes. */
export const compileRest = () => WebAssembly.compile(Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0));

export const glue = async () => freshGlue();
