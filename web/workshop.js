/** The module of the rarer work: worked solution, joining of requirements, tournament of laws. */
import { lazyModule } from "./lazy-module.js";

/** @typedef {typeof import("./pkg/levalab_workshop_wasm.js")} Workshop */

const module = /** @type {ReturnType<typeof lazyModule<Workshop>>} */ (lazyModule("levalab_workshop_wasm"));

/** Asked for before each use, since a panic replaces it. */
export const workshop = () => module.ready();

export const forgetWorkshop = () => module.forget();
