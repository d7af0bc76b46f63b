/**
 * The calculation: WebAssembly loaded once, and started again from the kept module should it ever panic.
 *
 * @import { ApplicationEntry, Catalogue, Design, Driven, Lab, Language, Opened, Read, Room, TieKey } from "./types.d.ts"
 */
import { compile, glue } from "./module.js";

/** Stations of a turn that are drawn. */
const SAMPLES = 720;

/** Restarts within `RESTART_WINDOW` milliseconds before giving up. */
const RESTARTS = 3;
const RESTART_WINDOW = 10_000;

/**
 * What the generated module offers.
 * @typedef {object} Module
 * @property {(options: { module_or_path: WebAssembly.Module }) => Promise<unknown>} default
 * @property {new () => Lab} Lab
 * @property {() => Omit<Catalogue, "first"> & { first: string }} catalogue
 * @property {(fragment: string, language: Language) => Read} open_link
 * @property {(design: unknown, language: Language) => Read} read_design
 * @property {(design: unknown, key: TieKey) => Room | null} room_for_second
 * @property {(design: Readonly<Design>, unit: string, language: Language) => Read} in_unit
 * @property {(unit: string, language: Language) => ApplicationEntry[]} applications
 * @property {{ of: (design: Design) => Driven | undefined }} Driven
 * @property {(design: unknown) => Float64Array} data_marks
 */

/**
 * @param {object} options
 * @param {() => Language} options.language
 * @param {(hopeless: boolean) => void} options.restarted  told after a panic, when the engine works again or never will
 */
export async function startEngine({ language, restarted }) {
  const compiled = await compile();
  let generation = 0;
  /** @type {number[]} */
  let panics = [];
  /** @type {Design | null} */
  let good = null;
  let restarting = false;
  /** @type {Module} */
  let module;
  /** @type {Lab} */
  let lab;

  /** A fresh copy of the glue holds a fresh instance: a panicked one cannot be trusted. */
  async function instantiate() {
    /** @type {Module} */
    const fresh = await glue(generation++);
    await fresh.default({ module_or_path: compiled });
    module = fresh;
    lab = new fresh.Lab();
  }

  async function restart() {
    if (restarting) return;
    restarting = true;
    const now = performance.now();
    panics = [...panics.filter((time) => now - time < RESTART_WINDOW), now];
    if (panics.length > RESTARTS) return restarted(true);
    try {
      await instantiate();
      if (good) lab.open(good, SAMPLES, language());
    } catch (error) {
      console.error(error);
      return restarted(true);
    }
    restarting = false;
    restarted(false);
  }

  /**
   * @template Result
   * @param {() => Result} call
   * @param {Result} otherwise
   */
  function guarded(call, otherwise) {
    if (restarting) return otherwise;
    try {
      return call();
    } catch (error) {
      if (!failed(error)) throw error;
      return otherwise;
    }
  }

  /**
   * Takes care of an error when it is a panic.
   * @param {unknown} error
   */
  function failed(error) {
    if (!(error instanceof WebAssembly.RuntimeError)) return restarting;
    console.error(error);
    void restart();
    return true;
  }

  await instantiate();

  return {
    lab: () => lab,
    /** A laboratory besides the page's own. */
    another: () => new module.Lab(),
    failed,
    /** The module with everything that is not asked for at every visit. */
    /** @returns {Promise<Module>} */
    whole: async () => module,
    /** @returns {Catalogue} */
    catalogue() {
      const { first, ...lists } = module.catalogue();
      return { ...lists, first: JSON.parse(first) };
    },

    /**
     * @param {Design} design
     * @param {string} panicked  what to say when the calculation fails
     * @returns {Opened}
     */
    analyse(design, panicked) {
      const opened = guarded(() => lab.open(design, SAMPLES, language()), { error: { path: "", message: panicked } });
      if (opened.report) good = design;
      return opened;
    },

    /**
     * @param {Readonly<Design>} design
     * @param {TieKey} key
     */
    room: (design, key) => guarded(() => module.room_for_second(design, key), null),

    /** @param {string} fragment */
    openLink: (fragment) => guarded(() => module.open_link(fragment, language()), unread(fragment)),

    /**
     * @param {string} text
     * @param {string} notJson  what to say when the text is not JSON at all
     * @returns {Read}
     */
    openFile(text, notJson) {
      /** @type {unknown} */
      let design;
      try {
        design = JSON.parse(text);
      } catch {
        return unread(notJson);
      }
      return guarded(() => module.read_design(design, language()), unread(""));
    },

    /**
     * Whether something kept is a design.
     * @param {unknown} design
     * @returns {Read}
     */
    check(design) {
      const nothing = unread("");
      return typeof design === "object" && design !== null ? guarded(() => module.read_design(design, language()), nothing) : nothing;
    },

    /**
     * The text of a design file.
     * @param {Design} design
     */
    saveFile(design) {
      const read = guarded(() => module.read_design(design, language()), unread(""));
      return `${JSON.stringify(read.design ?? design, null, 2)}\n`;
    },
  };
}

/** @typedef {Awaited<ReturnType<typeof startEngine>>} Engine */

/**
 * @param {string} message
 * @returns {Read}
 */
function unread(message) {
  return { error: { path: "", message } };
}
