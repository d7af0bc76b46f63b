/**
 * The module that writes files, loaded when the first one is wanted.
 *
 * @import { Design, Exported, ExportOrder, Language } from "../types.d.ts"
 */

import { isSingleFile } from "../packed.js";

/** @typedef {(design: Design, order: ExportOrder, language: Language) => Exported} Make */

/** @type {Promise<Make> | undefined} */
let loading;

/** @returns {Promise<Make>} */
export function loadExports() {
  loading ??= load();
  // What failed for want of a connection may work the next time.
  loading.catch(() => (loading = undefined));
  return loading;
}

async function load() {
  // A page on disk may load nothing.
  if (isSingleFile()) throw new Error("a single file has no module for exports");
  const glue = await import(new URL("../pkg/levalab_export_wasm.js", import.meta.url).href);
  await glue.default({ module_or_path: new URL("../pkg/levalab_export_wasm_bg.wasm", import.meta.url) });
  return glue.make;
}
