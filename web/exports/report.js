/**
 * The report on paper: design, cam to scale, diagrams, verdict and table, made anew each time the browser prints.
 *
 * @import { ShellContext } from "../types.d.ts"
 * @import { Make } from "./writers.js"
 */
import { h } from "../dom.js";
import { driving } from "./report/application.js";
import { diagrams, drawn } from "./report/drawings.js";
import { motion } from "./report/motion.js";
import { opening } from "./report/opening.js";
import { TALL, section } from "./report/paper.js";
import { verdict } from "./report/verdict.js";
import { dressed } from "./words.js";
import { loadExports } from "./writers.js";

/** Height of head and figures on the first page, mm. */
const HEAD = 22;
/** A cam that would have less than this goes on a page of its own, mm. */
const LEAST = 110;

/** @typedef {{ ready: (rows: number) => Promise<void> }} OnPaper */

/** @type {OnPaper | null} */
let onPaper = null;

/** The report that takes the place of the page on paper; there is one. @param {ShellContext} context */
export const reportOnPaper = (context) => (onPaper ??= createReport(context));

/** @param {ShellContext} context @returns {OnPaper} */
function createReport(context) {
  /** @type {Make | null} */
  let make = null;
  /** @type {HTMLElement | null} */
  let placed = null;
  let step = 10;

  let clothed = false;
  void dressed.then(() => (clothed = true));

  addEventListener("beforeprint", () => {
    placed?.remove();
    // A solution that is printed is the whole paper.
    if (!clothed || document.querySelector("body > .on-paper")) return;
    placed = compose(context, make, step);
    document.body.append(placed);
  });
  addEventListener("afterprint", () => {
    placed?.remove();
    placed = null;
  });

  return {
    /**
     * Loads what the report needs. Without the module that draws the cam to scale there is a report all the same.
     * @param {number} rows  degrees between rows of the table, 0 for none
     */
    async ready(rows) {
      step = rows;
      await dressed;
      make = await loadExports().catch((error) => {
        console.warn(error);
        return null;
      });
    },
  };
}

/**
 * @param {ShellContext} context
 * @param {Make | null} make
 * @param {number} step
 */
function compose(context, make, step) {
  const { store, t } = context;
  const design = store.lastGood();
  const first = opening(context, design);
  const left = TALL - HEAD - first.height;
  const apart = left < LEAST;
  const cam = drawn(context, design, make, apart ? TALL - 12 : left);
  const said = verdict(context);
  const driven = driving(context, design, context.module());
  return h(
    "article",
    { class: "report", lang: store.state.language },
    h("header", {}, h("h1", {}, design.title || t("app.untitled")), h("p", {}, `LevaLab · ${t("report.unit", { unit: design.length_unit })} · ${new Intl.DateTimeFormat(store.state.language, { dateStyle: "long" }).format()}`)),
    ...first.nodes,
    h("figure", { class: apart ? "cam page" : "cam" }, cam),
    h("div", { class: "page" }, section(t("report.verdict"), ...said.nodes), section(t("report.diagrams"), ...diagrams(context, said.height + (driven?.height ?? 0))), ...(driven ? [section(driven.title, ...driven.nodes)] : [])),
    step > 0 && h("div", { class: "page" }, section(t("report.table"), motion(context, step))),
  );
}
