/**
 * The calculation: WebAssembly, loaded twice, and started again from what was loaded should it ever panic.
 *
 * First comes what the first picture runs and nothing else, then the whole takes over. What that first part does not hold stops it; the
 * engine then waits for the whole, and the design is analysed again.
 *
 * @import { ApplicationEntry, ChartStyle, Design, Driven, Lab, Language, Opened, PlotArea, Read, Room, SolutionNode, TieKey } from "./types.d.ts"
 */
import { compileFirst, compileWhole, glue } from "./module.js";

/** Stations of a turn that are drawn. */
const SAMPLES = 720;

/** Restarts within `RESTART_WINDOW` milliseconds before giving up. */
const RESTARTS = 3;
const RESTART_WINDOW = 10_000;

/**
 * What the generated module offers.
 * @typedef {object} Module
 * @property {(options: { module_or_path: WebAssembly.Module }) => Promise<WebAssembly.Exports>} default
 * @property {new () => Lab} Lab
 * @property {(fragment: string, language: Language) => Read} open_link
 * @property {(design: unknown, language: Language) => Read} read_design
 * @property {(design: unknown, key: TieKey) => Room | null} room_for_second
 * @property {(design: Readonly<Design>, unit: string, language: Language) => Read} in_unit
 * @property {(unit: string, language: Language) => ApplicationEntry[]} applications
 * @property {(design: Readonly<Design>, key: TieKey, language: Language) => string | undefined} why_no_second
 * @property {{ of: (design: Design) => Driven | undefined }} Driven
 * @property {(design: unknown) => Float64Array} data_marks
 * @property {(design: unknown, language: Language, theta?: number, segment?: number) => SolutionNode[] | undefined} solution
 * @property {(design: unknown, language: Language, theta: number | undefined, segment: number | undefined, to: "latex" | "markdown") => string} solution_text
 * @property {(wanted: unknown, language: Language) => import("./auto/window.js").Answer} join_requirements
 * @property {(canvas: HTMLCanvasElement, design: Design | null, style: ChartStyle, heights: Float64Array, held: Float64Array) => PlotArea} draw_sheet
 */

/**
 * @param {object} options
 * @param {() => Language} options.language
 * @param {(hopeless: boolean) => void} options.restarted  told after a panic, when the engine works again or never will
 * @param {() => void} options.completed  told when the whole has taken over: what was taken from the first part is to be asked for again
 */
export async function startEngine({ language, restarted, completed }) {
  const first = compileFirst();
  /** Asked for once; again when it did not come. @type {Promise<WebAssembly.Module> | null} */
  let rest = null;
  /** True when the whole is at work: in the page of one file, from the start. */
  let whole = compileFirst === compileWhole;
  /** @type {Promise<void> | null} */
  let completing = null;
  let generation = 0;
  /** @type {number[]} */
  let panics = [];
  /** @type {Design | null} */
  let good = null;
  let restarting = false;
  let recovery = Promise.resolve();
  /** @type {Module} */
  let module;
  /** @type {Lab} */
  let lab;

  /**
   * Goes on with a fresh instance, which a fresh copy of the glue holds: a panicked one cannot be trusted, and one of the first part
   * leaves its work to the whole.
   * @param {WebAssembly.Module} compiled
   */
  async function goOn(compiled) {
    const fresh = await glue(generation++);
    await fresh.default({ module_or_path: compiled });
    const left = /** @type {Lab | undefined} */ (lab);
    module = fresh;
    lab = new fresh.Lab();
    if (good) lab.open(good, SAMPLES, language());
    try {
      left?.free();
    } catch {
      // It panicked, and lies there with its instance.
    }
  }

  function remainder() {
    rest ??= compileWhole().catch((/** @type {unknown} */ error) => {
      rest = null;
      throw error;
    });
    return rest;
  }

  /** Lets the whole take over. */
  function complete() {
    completing ??= (async () => {
      try {
        const compiled = await remainder();
        if (whole) return;
        await goOn(compiled);
        whole = true;
        if (!restarting) completed();
      } finally {
        completing = null;
      }
    })();
    return completing;
  }

  /** @param {boolean} early  that the whole is missed is no panic */
  async function restart(early) {
    restarting = true;
    const now = performance.now();
    if (!early) panics = [...panics.filter((time) => now - time < RESTART_WINDOW), now];
    if (panics.length > RESTARTS) return restarted(true);
    try {
      if (early) await complete();
      else await goOn(await remainder());
    } catch (error) {
      console.error(error);
      return restarted(true);
    }
    restarting = false;
    if (early) completed();
    else restarted(false);
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
    const early = !whole;
    if (!early) console.error(error);
    if (!restarting) recovery = restart(early);
    return true;
  }

  await goOn(await first);
  // Links lead to all kinds of cam.
  if (location.hash !== "") void remainder().catch(() => {});

  return {
    lab: () => lab,
    /** A laboratory besides the page's own. */
    another: () => new module.Lab(),
    failed,
    /** The whole module. @returns {Promise<Module>} */
    async whole() {
      if (!whole) await complete();
      await recovery;
      return module;
    },
    /**
     * What `work` gives, once more by the whole when the first part could not do it.
     * @template Result
     * @param {() => Result} work
     */
    async surely(work) {
      const result = work();
      if (!restarting) return result;
      await recovery;
      return work();
    },

    /**
     * @param {Design} design
     * @param {(arriving: boolean) => string} without  what to say when the calculation fails, or when what it needs is still arriving
     * @returns {Opened}
     */
    analyse(design, without) {
      const opened = guarded(() => lab.open(design, SAMPLES, language()), null) ?? { error: { path: "", message: without(!whole), arriving: !whole } };
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
