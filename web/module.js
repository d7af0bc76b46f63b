/** Where the calculation comes from: files beside the page. The single-file page has `module-inline.js` in this one's place. */

/** What the first picture runs. */
export const compileFirst = () => compile("./pkg/levalab_first.wasm");

/** All there is. */
export const compileWhole = () => compile("./pkg/levalab_wasm_bg.wasm");

/**
 * @param {string} file
 * @returns {Promise<WebAssembly.Module>}
 */
async function compile(file) {
  const response = await fetch(new URL(file, import.meta.url));
  if (!response.ok) throw new Error(`${response.status} ${response.statusText}`);
  if (response.headers.get("content-type")?.startsWith("application/wasm")) return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}

/**
 * The generated JavaScript, which holds one instance: a fresh copy for each generation.
 * @param {number} generation
 */
export function glue(generation) {
  const url = new URL("./pkg/levalab_wasm.js", import.meta.url);
  if (generation > 0) url.search = `?restart=${generation}`;
  return import(url.href);
}
