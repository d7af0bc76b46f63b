/** Where the modules of the calculation come from: files beside the page. The single-file page has `module-inline.js` in this one's place. */

import { MissingModule, forbidden } from "./missing-module.js";

/** @typedef {"levalab_wasm" | "levalab_workshop_wasm" | "levalab_export_wasm"} ModuleName */

/**
 * @param {ModuleName} name
 * @returns {Promise<WebAssembly.Module>}
 */
export async function compiled(name) {
  const response = await answer(new URL(`./pkg/${name}_bg.wasm`, import.meta.url));
  const streams = response.headers.get("content-type")?.startsWith("application/wasm") && WebAssembly.compileStreaming;
  try {
    return await (streams ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer()));
  } catch (error) {
    if (forbidden(error)) throw error;
    throw new MissingModule(reasonOf(error), error instanceof WebAssembly.CompileError ? "damaged" : "network", error);
  }
}

/** @param {URL} url */
async function answer(url) {
  const response = await fetch(url).catch((/** @type {unknown} */ error) => {
    throw new MissingModule(reasonOf(error), "network", error);
  });
  if (!response.ok) throw new MissingModule(`${response.status} ${response.statusText}`.trim(), "network");
  return response;
}

/** @param {unknown} error */
const reasonOf = (error) => (error instanceof Error ? error.message : String(error));

/**
 * The generated JavaScript of a module, which holds one instance: a fresh copy for each generation.
 * @param {ModuleName} name
 * @param {number} generation
 */
export function glue(name, generation) {
  const url = new URL(`./pkg/${name}.js`, import.meta.url);
  if (generation > 0) url.search = `?restart=${generation}`;
  return import(url.href);
}
