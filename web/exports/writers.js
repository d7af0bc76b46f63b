/**
 * The module that writes files, loaded when the first one is wanted.
 *
 * @import { Design, Exported, ExportOrder, Language } from "../types.d.ts"
 */

import { lazyModule } from "../lazy-module.js";
import { isSingleFile } from "../packed.js";

/** @typedef {(design: Design, order: ExportOrder, language: Language) => Exported} Make */

const module = /** @type {ReturnType<typeof lazyModule<{ make: Make }>>} */ (lazyModule("levalab_export_wasm"));

/** @returns {Promise<Make>} */
export async function loadExports() {
  // A page on disk may load nothing.
  if (isSingleFile()) throw new Error("a single file has no module for exports");
  return (await module.ready()).make;
}
