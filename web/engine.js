/**
 * The calculation of the main screen: a WebAssembly module, started again from what was loaded should it ever panic.
 *
 * @import { Design, Edit, Lab, Language, Opened, Read, TieKey } from "./types.d.ts"
 */
import { compiled, glue } from "./module.js";
import { forgetWorkshop } from "./workshop.js";

/** Stations of a turn that are drawn. */
const SAMPLES = 720;

/** Restarts within `RESTART_WINDOW` milliseconds before a pause as long as that. */
const RESTARTS = 3;
const RESTART_WINDOW = 10_000;

/** @typedef {Omit<typeof import("./pkg/levalab_wasm.js"), "Lab" | "default"> & { default: (options: { module_or_path: WebAssembly.Module }) => Promise<unknown>, Lab: new () => Lab }} Module */

/**
 * @param {object} options
 * @param {() => Language} options.language
 * @param {(hopeless: boolean) => void} options.restarted  told after a panic: the engine works again, or pauses before it is tried again
 */
export async function startEngine({ language, restarted }) {
  const source = await compiled("levalab_wasm");
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

  /** Goes on with a fresh instance, which a fresh copy of the glue holds: a panicked one cannot be trusted. */
  async function goOn() {
    const fresh = /** @type {Module} */ (await glue("levalab_wasm", generation++));
    await fresh.default({ module_or_path: source });
    module = fresh;
    lab = new fresh.Lab();
    if (good) lab.open(good, SAMPLES, language());
  }

  async function restart() {
    restarting = true;
    const now = performance.now();
    panics = [...panics.filter((time) => now - time < RESTART_WINDOW), now];
    if (panics.length > RESTARTS) return pause();
    try {
      await goOn();
    } catch (error) {
      console.error(error);
      return pause();
    }
    restarting = false;
    restarted(false);
  }

  /** Says that it is hopeless for now, and tries again when the panics are past or there may be memory again. */
  function pause() {
    restarted(true);
    setTimeout(() => {
      panics = [];
      void restart();
    }, RESTART_WINDOW);
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
    // What fails in an instance that is being replaced is a consequence.
    if (restarting) return true;
    console.error(error);
    forgetWorkshop();
    void restart();
    return true;
  }

  await goOn();

  return {
    lab: () => lab,
    /** A laboratory besides the page's own. */
    another: () => new module.Lab(),
    failed,
    /** Asked for before each use, since a panic replaces it. */
    module: () => module,

    /**
     * @param {Design} design
     * @param {() => string} without  what to say when the calculation fails
     * @returns {Opened}
     */
    analyse(design, without) {
      const opened = guarded(() => lab.open(design, SAMPLES, language()), null) ?? { error: { path: "", message: without() }, outline: null };
      if (opened.report) good = design;
      return opened;
    },

    /**
     * @param {Design} design
     * @param {Edit[]} edits
     * @param {string} without  what to say when the calculation fails
     * @returns {Read}
     */
    apply: (design, edits, without) => guarded(() => module.edit(design, edits, language()), unread(without)),

    /**
     * @param {Readonly<Design>} design
     * @param {TieKey} key
     */
    room: (design, key) => guarded(() => module.room_for_second(design, key), null),

    /**
     * @param {string} address  the whole one, or a link
     * @returns {import("./types.d.ts").OpenedLink}
     */
    openLink: (address) => guarded(() => module.open_link(address, language()), unread(address)),

    /**
     * @param {Uint8Array} bytes  of a design file
     * @param {string} without  what to say when the calculation fails
     * @returns {Read}
     */
    openFile: (bytes, without) => guarded(() => module.open_file(bytes, language()), unread(without)),

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
