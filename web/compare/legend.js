/**
 * The legend under the diagrams: which line is which design, and which of them this diagram cannot show.
 *
 * @import { ShellContext, Tab } from "../types.d.ts"
 * @import { Pin, Slate } from "./slate.js"
 */
import { h } from "../dom.js";
import { tabOf } from "../stage/plots.js";
import { sample } from "./looks.js";
import { turns } from "./slate.js";

/**
 * @param {ShellContext} context
 * @param {Slate} slate
 */
export function createLegend({ store, t }, slate) {
  const root = document.getElementById("legend");
  const list = h("ul", { class: "compare-legend" });
  root?.append(list);
  let drawn = "";

  function update() {
    const { language } = store.state;
    const shown = slate.pins.filter((pin) => pin.shown);
    const missing = shown.map((pin) => !fits(pin));
    const next = JSON.stringify([language, missing, ...shown.map(({ id, name, look }) => [id, name, look])]);
    if (!root || next === drawn) return;
    drawn = next;
    root.hidden = shown.length === 0;
    list.setAttribute("aria-label", t("compare.legend"));
    list.replaceChildren(
      ...shown.map(({ name, look }, i) => h("li", {}, sample(look), h("span", {}, name), missing[i] ? h("span", { class: "unit" }, t("compare.missing")) : null)),
    );
  }

  /** Whether its curves share an axis with those on screen. @param {Pin} pin */
  function fits({ report, design }) {
    const { report: current } = store.state;
    if (turns(design) !== turns(store.lastGood())) return false;
    const tab = /** @type {Tab} */ (tabOf(store.state));
    if (tab === "pressure_angle") return true;
    if (tab === "svaj") return report.units.s === current.units.s;
    return report.units.length === current.units.length && (tab === "rho" || report.summary.contact !== undefined);
  }

  update();
  slate.watch(update);
  store.subscribe(["tab", "report", "language"], update);
}
