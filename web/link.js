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
 * @param {{ openLink: (fragment: string) => Read }} engine
 * @param {boolean} damaged  a damaged link stays in the address bar until the first edit
 */
export function keepLink({ store, banner, t }, engine, damaged) {
  let written = fragment();
  const first = damaged ? store.state.report : null;
  let lastWrite = -Infinity;
  let timer = 0;

  function write() {
    timer = 0;
    const { link } = store.state.report;
    keep("design", store.lastGood());
    if (link === "") return;
    written = link;
    if (link === fragment()) return;
    lastWrite = performance.now();
    try {
      history.replaceState(null, "", `#${link}`);
    } catch {
      // A sandboxed frame may not touch its address; the button still copies the link.
    }
  }

  function schedule() {
    if (timer || store.state.report === first) return;
    timer = window.setTimeout(write, Math.max(0, PAUSE - (performance.now() - lastWrite)));
  }

  function opened() {
    const pasted = fragment();
    if (pasted === "" || pasted === written) return;
    const read = engine.openLink(pasted);
    if (read.error) return banner.show("banner.link", () => ({ reason: engine.openLink(pasted).error?.message ?? "" }), pasted);
    banner.hide();
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
 * What the page opens with: the link, else what the user had, else a good example. A damaged link is told.
 * @param {{ openLink: (fragment: string) => Read, openFile: (text: string, notJson: string) => Read }} engine
 * @param {Design} example
 * @returns {{ design: Design, damaged?: string }}  with the link that did not open
 */
export function firstDesign(engine, example) {
  const raw = fragment();
  const read = raw === "" ? null : engine.openLink(raw);
  if (read?.design) return { design: read.design };
  const kept = recall("design");
  const had = kept === null ? null : engine.openFile(JSON.stringify(kept), "");
  const design = had?.design ?? example;
  return read?.error ? { design, damaged: raw } : { design };
}
