/**
 * The address bar: it holds the design while that fits a link, and opens what is pasted into it.
 *
 * @import { Design, OpenedLink, Read, ShellContext } from "./types.d.ts"
 */
import { keep, recall } from "./memory.js";

/** Browsers refuse more than some 200 writes of the address in half a minute. */
const PAUSE = 350;

/**
 * @param {ShellContext} context
 * @param {Pick<import("./engine.js").Engine, "openLink">} engine
 * @param {First} first  what the page began with; a damaged link stays in the address bar until the first edit
 */
export function keepLink({ store, banner, t }, engine, { damaged, arrived = "" }) {
  let written = fragment();
  /** The link of the report that was seen last, and the newest design that has its own entry among the browser's pages. */
  let seen = store.state.report.link;
  let entered = store.origin();
  const begun = damaged === undefined ? null : store.state.report;
  const cameAsQuery = () => arrived !== "" && location.search === arrived;
  let tooLong = false;
  let lastWrite = -Infinity;
  let timer = 0;

  function write() {
    timer = 0;
    const { link } = store.state.report;
    const design = store.lastGood();
    keep("design", design);
    point(link);
    // Last, so that it names the address that the tab will come back to, whether or not that holds the design.
    keep("design", { design, fragment: fragment() }, "sessionStorage");
  }

  /**
   * @param {string} link  empty for a design that fits no link
   * @param {"replaceState" | "pushState"} [how]
   */
  function point(link, how = "replaceState") {
    written = link;
    if (link === fragment() && !cameAsQuery()) return;
    lastWrite = performance.now();
    const query = cameAsQuery() ? "" : location.search;
    try {
      history[how](null, "", location.pathname + query + (link === "" ? "" : `#${link}`));
    } catch {
      // A sandboxed frame may not touch its address, and a file may not lose its query; the button still copies the link.
    }
  }

  /** A design that was opened has an entry of its own: Back leads to the one before, as it was left. */
  function enter() {
    if (timer && seen !== "") point(seen);
    clearTimeout(timer);
    timer = 0;
    entered = store.origin();
    point(store.state.report.link, "pushState");
    write();
  }

  function schedule() {
    if (store.origin() > entered) enter();
    seen = store.state.report.link;
    if (store.state.report === begun) return;
    const long = seen === "";
    if (long && !tooLong) {
      // Another cam must not stay in the address.
      clearTimeout(timer);
      write();
      banner.show("banner.long");
    } else if (tooLong && !long) banner.hide();
    tooLong = long;
    timer ||= window.setTimeout(write, Math.max(0, PAUSE - (performance.now() - lastWrite)));
  }

  function opened() {
    const pasted = fragment();
    if (pasted === "" || pasted === written) return;
    const read = engine.openLink(location.href);
    if (read.error) return banner.show("banner.link", () => ({ reason: engine.openLink(`#${pasted}`).error?.message ?? "" }), pasted);
    banner.hide();
    // What was still to be written belongs to another entry than the one that is in the address now.
    clearTimeout(timer);
    timer = 0;
    if (read.design) store.replace(read.design, t("edit.link"));
  }

  store.subscribe(["report"], schedule);
  addEventListener("hashchange", opened);
  addEventListener("pagehide", () => {
    if (timer) write();
  });
}

export function fragment() {
  return location.hash.slice(1);
}

/** The whole address with the design in it. @param {string} link */
export function address(link) {
  return location.href.split("#")[0] + "#" + link;
}

/**
 * What the page begins with.
 * @typedef {object} First
 * @property {Design} design
 * @property {string} [damaged]  the link that did not open
 * @property {string} [arrived]  the query of the address, when it is a link
 */

/**
 * What the page opens with: the link, else what this tab had, else what the user had last, else a good example. A damaged link
 * is told. The tab's own design goes before the link that it had then: it may be too long for one.
 * @param {{ openLink: (address: string) => OpenedLink, check: (design: unknown) => Read }} engine
 * @param {Design} example
 * @returns {First}
 */
export function firstDesign(engine, example) {
  const raw = fragment();
  const query = raw === "" && location.search !== "" ? engine.openLink(location.href) : {};
  const arrived = query.design || query.error ? { arrived: location.search } : {};
  const here = /** @type {{ design?: unknown, fragment?: unknown } | null} */ (recall("design", "sessionStorage"));
  const own = engine.check(here?.design).design;
  if (own && !arrived.arrived && (raw === "" || raw === here?.fragment)) return { design: own };
  const read = raw === "" ? query : engine.openLink(location.href);
  if (read.design) return { design: read.design, ...arrived };
  const design = own ?? engine.check(recall("design")).design ?? example;
  return read.error ? { design, damaged: raw || location.search.slice(1), ...arrived } : { design };
}
