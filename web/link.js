/**
 * The address bar: it always holds the design, and opens what is pasted into it.
 *
 * @import { Design, Read, ShellContext } from "./types.d.ts"
 */
import { keep, recall } from "./memory.js";

/** Browsers refuse more than some 200 writes of the address in half a minute. */
const PAUSE = 350;

/**
 * @param {ShellContext} context
 * @param {Pick<import("./engine.js").Engine, "openLink">} engine
 * @param {boolean} damaged  a damaged link stays in the address bar until the first edit
 */
export function keepLink({ store, banner, t }, engine, damaged) {
  let written = fragment();
  /** The link of the report that was seen last, and the newest design that has its own entry among the browser's pages. */
  let seen = store.state.report.link;
  let entered = store.origin();
  const first = damaged ? store.state.report : null;
  let lastWrite = -Infinity;
  let timer = 0;

  function write() {
    timer = 0;
    const { link } = store.state.report;
    const design = store.lastGood();
    keep("design", design);
    if (link !== "") point(link);
    // Last, so that it names the address that the tab will come back to, whether or not that holds the design.
    keep("design", { design, fragment: fragment() }, "sessionStorage");
  }

  /**
   * @param {string} link
   * @param {"replaceState" | "pushState"} [how]
   */
  function point(link, how = "replaceState") {
    written = link;
    if (link === fragment()) return;
    lastWrite = performance.now();
    try {
      history[how](null, "", `#${link}`);
    } catch {
      // A sandboxed frame may not touch its address; the button still copies the link.
    }
  }

  /** A design that was opened has an entry of its own: Back leads to the one before, as it was left. */
  function enter() {
    const { link } = store.state.report;
    if (timer && seen !== "") point(seen);
    clearTimeout(timer);
    timer = 0;
    entered = store.origin();
    if (link !== "") point(link, "pushState");
    write();
  }

  function schedule() {
    if (store.origin() > entered) enter();
    seen = store.state.report.link;
    if (timer || store.state.report === first) return;
    timer = window.setTimeout(write, Math.max(0, PAUSE - (performance.now() - lastWrite)));
  }

  function opened() {
    const pasted = fragment();
    if (pasted === "" || pasted === written) return;
    const read = engine.openLink(pasted);
    if (read.error) return banner.show("banner.link", () => ({ reason: engine.openLink(pasted).error?.message ?? "" }), pasted);
    banner.hide();
    // What was still to be written belongs to another entry than the one that is in the address now.
    clearTimeout(timer);
    timer = 0;
    store.replace(read.design, t("edit.link"));
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
 * What the page opens with: the link, else what this tab had, else what the user had last, else a good example. A damaged link
 * is told. The tab's own design goes before the link that it had then: it may be too long for one.
 * @param {{ openLink: (fragment: string) => Read, check: (design: unknown) => Read }} engine
 * @param {Design} example
 * @returns {{ design: Design, damaged?: string }}  with the link that did not open
 */
export function firstDesign(engine, example) {
  const raw = fragment();
  const here = /** @type {{ design?: unknown, fragment?: unknown } | null} */ (recall("design", "sessionStorage"));
  const own = engine.check(here?.design).design;
  if (own && (raw === "" || raw === here?.fragment)) return { design: own };
  const read = raw === "" ? null : engine.openLink(raw);
  if (read?.design) return { design: read.design };
  const design = own ?? engine.check(recall("design")).design ?? example;
  return read?.error ? { design, damaged: raw } : { design };
}
