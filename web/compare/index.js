/**
 * Comparison of designs: the slate of what is pinned, its legend, and the window with the tables.
 *
 * @import { Design, ShellContext } from "../types.d.ts"
 * @import { CompareEngine } from "../compare.js"
 */
import { addStrings } from "../strings/index.js";
import { compareEn } from "../strings/compare.en.js";
import { compareEs } from "../strings/compare.es.js";
import { createLegend } from "./legend.js";
import { createPanel } from "./panel.js";
import { wear } from "./sheet.js";
import { MOST, createSlate } from "./slate.js";

/** @typedef {{ open: () => void, pin: (design: Readonly<Design>) => void }} Comparison */

/**
 * @param {ShellContext} context
 * @param {CompareEngine} engine
 * @param {HTMLButtonElement} button  which opens the window, and shows how many designs are pinned
 * @returns {Comparison}
 */
export function startComparison(context, engine, button) {
  const { t, announce, banner } = context;
  addStrings({ en: compareEn, es: compareEs });
  wear();
  const slate = createSlate(context, engine);
  createLegend(context, slate);
  const panel = createPanel(context, slate);

  function count() {
    if (slate.pins.length > 0) button.dataset["count"] = String(slate.pins.length);
    else delete button.dataset["count"];
  }
  slate.watch(count);
  count();

  return {
    open: () => panel.open(),
    pin(design) {
      const done = slate.pin(design);
      const sentence = t(`compare.${done}`, { name: design.title || t("app.untitled"), count: slate.pins.length, most: MOST });
      announce(sentence);
      if (done === "full") banner.show("compare.full", { most: String(MOST) });
    },
  };
}
