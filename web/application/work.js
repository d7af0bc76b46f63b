/**
 * The application of the design on screen as the engine works it out: made again with each good design, let go of with the next.
 *
 * @import { ApplicationEntry, ApplicationReport, Driven, ShellContext } from "../types.d.ts"
 */

/**
 * @typedef {object} Work
 * @property {ApplicationEntry[]} entries  what may be driven
 * @property {Driven | null} driven
 * @property {ApplicationReport | null} report
 */

/** @param {ShellContext} context */
export function createWork({ store, module: current }) {
  /** @type {Work} */
  const work = { entries: [], driven: null, report: null };
  /** @type {unknown} */
  let owner = null;

  return {
    work,
    /** Works it out for the last good design. */
    renew() {
      const module = current();
      // One that belongs to an instance which has panicked cannot be let go of.
      if (owner === module) work.driven?.free();
      owner = module;
      const design = store.lastGood();
      const { language } = store.state;
      work.entries = module.applications(design.length_unit, language);
      work.driven = (design.application && module.Driven.of(design)) || null;
      work.report = work.driven?.report(language) ?? null;
    },
  };
}
