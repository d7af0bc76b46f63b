/** Where the calculation comes from in the single-file page: text in the page itself, since a page on disk may load nothing. */
import { inlined } from "./inlined.js";
import { freshGlue } from "levalab:glue";

/** @type {Promise<WebAssembly.Module> | undefined} */
let compiled;

/** The whole is there from the start. */
export const compileWhole = () => (compiled ??= WebAssembly.compile(inlined("levalab-module")));

export const compileFirst = compileWhole;

export const glue = async () => freshGlue();
