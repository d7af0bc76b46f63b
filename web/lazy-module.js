/**
 * A module of the calculation that is loaded when its work is first asked for.
 *
 * @import { ModuleName } from "./module.js"
 */
import { compiled, glue } from "./module.js";

/**
 * @template Exports
 * @param {ModuleName} name
 */
export function lazyModule(name) {
  /** @type {Promise<Exports> | null} */
  let instance = null;
  let generation = 0;

  async function start() {
    const [module, fresh] = await Promise.all([compiled(name), glue(name, generation++)]);
    await fresh.default({ module_or_path: module });
    return /** @type {Exports} */ (fresh);
  }

  return {
    /** The module at work; a load that failed is tried again at the next call. */
    ready() {
      instance ??= start().catch((/** @type {unknown} */ error) => {
        instance = null;
        throw error;
      });
      return instance;
    },

    /** Forgets the instance, since one that panicked cannot be trusted. */
    forget() {
      instance = null;
    },
  };
}
