/**
 * The tournament of the laws: the same program moved by every law that fits, in an order that the user chooses.
 *
 * @import { ShellContext } from "../types.d.ts"
 * @import { Workshop } from "../workshop.js"
 * @import { Slate } from "./slate.js"
 */
import { h, symbol } from "../dom.js";
import { createThumbnail } from "../law-thumbnail.js";
import { FIGURES, letter, quantity, verdict } from "./cells.js";
import { MOST } from "./slate.js";

/** @typedef {"verdict" | "v" | "a" | "j" | "phi" | "rb"} Rank */

/** A contender: the place of its law, its smallest base radius, its figures. @typedef {{ law: number, radius: number, figures: Float64Array }} Contender */

/** @type {Record<Rank, (contender: Contender) => number[]>} */
const KEYS = {
  verdict: ({ figures }) => [at(figures, "level"), at(figures, "a")],
  v: ({ figures }) => [at(figures, "v")],
  a: ({ figures }) => [at(figures, "a")],
  j: ({ figures }) => [at(figures, "j")],
  phi: ({ figures }) => [at(figures, "steepest")],
  rb: ({ radius }) => [Number.isNaN(radius) ? Infinity : radius],
};

/** @param {Float64Array} figures @param {keyof typeof FIGURES} name */
const at = (figures, name) => figures[FIGURES[name]] ?? NaN;

/**
 * @param {ShellContext} context
 * @param {Slate} slate
 * @param {(sentence: string) => void} say
 */
export function createTournament({ store, workshop, t, format, catalogue }, slate, say) {
  const about = h("p", { class: "compare-empty" });
  const head = h("thead");
  const body = h("tbody");
  const table = h("table", { class: "compare-table compare-laws" }, h("caption", { class: "unseen" }), head, body);
  const scroll = h("div", { class: "compare-scroll", tabindex: "0", role: "region" }, table);
  const root = h("section", {}, about, scroll);
  /** @type {Rank} */
  let rank = "verdict";
  let upwards = true;
  /** The report of the design whose tournament is shown. @type {unknown} */
  let judged = null;
  /** Of the tournament on screen. @type {Workshop | null} */
  let engine = null;
  /** @type {Contender[]} */
  let contenders = [];

  /** Asks the engine once a design; false when the tournament does not arrive. */
  async function judge() {
    const { report } = store.state;
    if (judged === report) return true;
    engine = await workshop().catch((/** @type {unknown} */ error) => {
      console.warn(error);
      return null;
    });
    if (!engine) return false;
    judged = report;
    const numbers = engine.tournament_of(store.lastGood());
    const width = 2 + Object.keys(FIGURES).length;
    contenders = Array.from({ length: numbers.length / width }, (_, i) => {
      const [law = -1, radius = NaN] = numbers.subarray(i * width);
      return { law, radius, figures: numbers.slice(i * width + 2, (i + 1) * width) };
    });
    return true;
  }

  async function update() {
    if (!(await judge())) {
      about.textContent = t("demand.missing");
      return;
    }
    show();
  }

  function show() {
    const focused = document.activeElement instanceof HTMLElement && table.contains(document.activeElement) ? document.activeElement.dataset["key"] : undefined;
    const { perSecond, report } = store.state;
    const { units } = report;
    about.textContent = t("compare.laws.about", { count: contenders.filter(({ law }) => law >= 0).length });
    scroll.setAttribute("aria-label", t("compare.laws.table"));
    /** @type {HTMLElement} */ (table.caption).textContent = t("compare.laws.table");
    /** @type {readonly ("v" | "a" | "j" | "V" | "A" | "J")[]} */
    const peaks = perSecond ? ["V", "A", "J"] : ["v", "a", "j"];
    const ranks = /** @type {const} */ (["v", "a", "j"]);
    head.replaceChildren(
      h(
        "tr",
        {},
        h("th", { scope: "col" }, t("segments.law")),
        ...peaks.map((name, i) => column(ranks[i] ?? "a", letter(name, ranks[i] ?? "a", true), units[name], `|${name}|`)),
        column("phi", letter("φ", "phi", true), "°", "|φ|"),
        column("rb", h("span", {}, symbol("Rb"), " ≥"), units.length, "Rb"),
        column("verdict", h("span", {}, t("app.verdict")), "", t("app.verdict")),
        h("th", { scope: "col" }, h("span", { class: "unseen" }, t("compare.actions"))),
      ),
    );
    const ranked = contenders.toSorted((one, other) => (upwards ? 1 : -1) * compare(KEYS[rank](one), KEYS[rank](other)));
    body.replaceChildren(...ranked.map((contender) => row(contender, peaks)));
    if (focused) /** @type {HTMLElement | null} */ (table.querySelector(`[data-key="${focused}"]`) ?? table.querySelector("button"))?.focus();
  }

  /**
   * @param {Rank} name
   * @param {HTMLElement} sign
   * @param {string} unit
   * @param {string} spoken
   */
  function column(name, sign, unit, spoken) {
    const chosen = rank === name;
    const sort = h("button", { type: "button", class: "quiet", "data-key": name, title: t("compare.sort", { name: spoken }) }, sign, unit ? h("span", { class: "unit" }, ` ${unit}`) : null, h("span", { class: "compare-arrow", "aria-hidden": "true" }, chosen ? (upwards ? "▲" : "▼") : ""));
    sort.addEventListener("click", () => {
      upwards = rank === name ? !upwards : true;
      rank = name;
      show();
    });
    return h("th", { scope: "col", class: name === "verdict" && "compare-judged", "aria-sort": chosen ? (upwards ? "ascending" : "descending") : "none" }, sort);
  }

  /** The design on screen by one law. @param {number} law */
  const byLaw = (law) => engine?.design_by_law(store.lastGood(), law);

  /**
   * @param {Contender} contender
   * @param {readonly ("v" | "a" | "j" | "V" | "A" | "J")[]} peaks
   */
  function row({ law, radius, figures }, peaks) {
    const entry = catalogue.laws[law];
    const name = entry ? t(`law.${entry.id}`) : t("compare.asIs");
    const thumbnail = createThumbnail();
    thumbnail.draw(entry?.thumbnail ?? [], false);
    const use = action(`use ${law}`, t("compare.use"), t("compare.use.of", { name }), () => {
      const design = byLaw(law);
      if (design) store.replace(design, t("edit.laws", { name }));
      say(t("compare.used", { name }));
    });
    const pin = action(`pin ${law}`, t("compare.pin.short"), t("compare.pin.of", { name }), () => {
      const design = entry ? byLaw(law) : store.lastGood();
      if (!design) return;
      const title = design.title || t("app.untitled");
      const done = slate.pin(design, entry ? `${title} · ${name}` : title);
      say(t(`compare.${done}`, { name, count: slate.pins.length, most: MOST }));
    });
    return h(
      "tr",
      { class: entry ? false : "compare-own" },
      h("th", { scope: "row", class: "compare-name" }, h("span", {}, thumbnail.root, name)),
      ...peaks.map((peak) => h("td", {}, quantity(format, at(figures, peak)))),
      h("td", {}, format.number(at(figures, "steepest"), { digits: 1 })),
      h("td", {}, Number.isNaN(radius) ? t("compare.none") : quantity(format, radius)),
      h("td", {}, verdict(t, at(figures, "level"))),
      h("td", { class: "compare-do" }, h("span", { class: "compare-actions" }, entry ? use : null, pin)),
    );
  }

  /**
   * @param {string} key
   * @param {string} text
   * @param {string} name
   * @param {() => void} onclick
   */
  const action = (key, text, name, onclick) => h("button", { type: "button", class: "quiet", "data-key": key, "aria-label": name, onclick }, text);

  return { root, update };
}

/** @param {number[]} one @param {number[]} other */
function compare(one, other) {
  const i = one.findIndex((value, k) => value !== other[k]);
  return i < 0 ? 0 : (one[i] ?? 0) < (other[i] ?? 0) ? -1 : 1;
}
