/**
 * The slate as a table: a line for the design on screen and for each that is pinned, with its figures and what can be done with it.
 *
 * @import { Design, Report, ShellContext } from "../types.d.ts"
 * @import { Pin, Slate } from "./slate.js"
 */
import { h, symbol } from "../dom.js";
import { FIGURES, letter, quantity, verdict } from "./cells.js";
import { sample } from "./looks.js";
import { MOST } from "./slate.js";
import { isUnfinished } from "../unfinished.js";

/** Symbols of the geometry, in the order in which it is told. @type {readonly [string, string][]} */
const GEOMETRY = [["roller_radius", "Rf"], ["face_radius", "Rf"], ["eccentricity", "e"], ["arm", "A"], ["pivot_distance", "m"], ["face_offset", "f"]];

/** Peaks per radian, and under each the one per second. @type {readonly ["v" | "a" | "j", "V" | "A" | "J"][]} */
const PEAKS = [["v", "V"], ["a", "A"], ["j", "J"]];

/**
 * @param {ShellContext} context
 * @param {Slate} slate
 * @param {(sentence: string) => void} say
 */
export function createSlateTable({ store, lab, t, format }, slate, say) {
  const add = h("button", { type: "button", class: "compare-add" });
  const back = h("button", { type: "button", class: "quiet" });
  const empty = h("p", { class: "compare-empty" });
  const head = h("thead");
  const body = h("tbody");
  const table = h("table", { class: "compare-table" }, h("caption", { class: "unseen" }), head, body);
  const scroll = h("div", { class: "compare-scroll", tabindex: "0", role: "region" }, table);
  const root = h("section", {}, h("div", { class: "compare-bar" }, add, back), scroll, empty);

  add.addEventListener("click", () => {
    const done = slate.pin(store.lastGood());
    const instead = isUnfinished({ store }) ? ` ${t("banner.unfinished")}` : "";
    say(t(`compare.${done}`, { name: titleOf(store.lastGood()), count: slate.pins.length, most: MOST }) + instead);
  });
  back.addEventListener("click", () => {
    const pin = slate.restore();
    if (pin) say(t("compare.restored", { name: pin.name }));
    add.focus();
  });

  /** @param {Design} design */
  const titleOf = (design) => design.title || t("app.untitled");

  /** A unit in the head when all share it; otherwise in each cell. @param {(report: Report) => string} unit */
  function shared(unit) {
    const units = new Set([store.state.report, ...slate.pins.map(({ report }) => report)].map(unit));
    return units.size === 1 ? [...units][0] : undefined;
  }

  function update() {
    const focused = document.activeElement instanceof HTMLElement && table.contains(document.activeElement) ? document.activeElement.dataset["key"] : undefined;
    add.textContent = t("compare.pin");
    add.disabled = slate.pins.length >= MOST;
    back.hidden = slate.removed === null;
    back.textContent = t("compare.restore", { name: slate.removed?.name ?? "" });
    empty.textContent = slate.pins.length === 0 ? t("compare.empty", { most: MOST }) : t("compare.count", { count: slate.pins.length, most: MOST });
    scroll.setAttribute("aria-label", t("compare.table"));
    /** @type {HTMLElement} */ (table.caption).textContent = t("compare.table");

    const length = shared(({ units }) => units.length);
    const travel = shared(({ units }) => units.s);
    const unit = (/** @type {string | undefined} */ text) => (text ? h("span", { class: "unit" }, ` ${text}`) : null);
    head.replaceChildren(
      h(
        "tr",
        {},
        h("th", { scope: "col" }, t("compare.design")),
        h("th", { scope: "col", class: "compare-sized" }, t("compare.geometry"), unit(length)),
        h("th", { scope: "col" }, letter("s", "s"), " ", t("compare.max"), unit(travel)),
        ...PEAKS.map((names) => h("th", { scope: "col" }, ...names.map((name) => h("span", { class: "compare-line" }, letter(name, names[0], true), unit(travel && store.state.report.units[name]))))),
        h("th", { scope: "col" }, letter("φ", "phi"), unit("°")),
        h("th", { scope: "col" }, letter("ρ", "rho"), " ", t("compare.min"), unit(length)),
        h("th", { scope: "col" }, t("compare.face"), unit(length)),
        h("th", { scope: "col", class: "compare-judged" }, t("app.verdict")),
      ),
    );
    const design = store.lastGood();
    const current = h("th", { scope: "row", class: "compare-name" }, h("span", { class: "compare-current" }, t("compare.current")), " ", titleOf(design));
    body.replaceChildren(
      h("tr", { class: "compare-own" }, current, ...figures(design, store.state.report, lab().figures(), length, travel)),
      ...slate.pins.map((pin, place) => row(pin, place, length, travel)),
    );
    if (focused) focus(focused);
  }

  /** The same control as before, or the name beside it when it is gone or can do no more. @param {string} key */
  function focus(key) {
    const [, id] = key.split(" ");
    const control = [`[data-key="${key}"]:enabled`, `[data-key="name ${id}"]`].map((found) => table.querySelector(found)).find(Boolean);
    if (control instanceof HTMLElement) control.focus();
    else add.focus();
  }

  /**
   * @param {Design} design
   * @param {Report} report
   * @param {Float64Array} figures
   * @param {string | undefined} length
   * @param {string | undefined} travel
   */
  function figures(design, report, figures, length, travel) {
    const own = length ? undefined : report.units.length;
    const sizes = GEOMETRY.flatMap(([key, name]) => (typeof design.follower[key] === "number" ? [[name, design.follower[key]]] : []));
    const { cam } = design;
    const geometry = [["Rb", cam.base_radius], ["dc", cam.breadth], ["ℓ", cam.length], ...sizes].filter(([, value]) => typeof value === "number");
    const peak = (/** @type {"v" | "a" | "j" | "V" | "A" | "J"} */ name) => quantity(format, figures[FIGURES[name]], travel ? undefined : report.units[name]);
    const [least, greatest] = [figures[FIGURES.least], figures[FIGURES.greatest]];
    return [
      h(
        "td",
        { class: "compare-geometry" },
        h("span", {}, t(`follower.${design.follower.motion}-${design.follower.contact}`), "conjugate" in design ? ` · ${t("compare.pair")}` : null),
        h("span", {}, ...geometry.flatMap(([name, value]) => [symbol(String(name), name === "A"), ` ${quantity(format, Number(value) * (name === "e" ? (report.notation?.eccentricity ?? 1) : 1) + 0, own)}\u2003`])),
      ),
      h("td", {}, quantity(format, figures[FIGURES.lift], travel ? undefined : report.units.s)),
      ...PEAKS.map((names) => h("td", {}, ...names.map((name) => h("span", { class: "compare-line" }, peak(name))))),
      h("td", {}, `${format.number(least, { digits: 1 })} … ${format.number(greatest, { digits: 1 })}`),
      h("td", {}, quantity(format, figures[FIGURES.rho], own)),
      h("td", {}, quantity(format, figures[FIGURES.face], own)),
      h("td", {}, verdict(t, figures[FIGURES.level] ?? 2)),
    ];
  }

  /**
   * @param {Pin} pin
   * @param {number} place
   * @param {string | undefined} length
   * @param {string | undefined} travel
   */
  function row(pin, place, length, travel) {
    const { id, name } = pin;
    const box = h("input", { type: "checkbox", "data-key": `shown ${id}`, "aria-label": t("compare.shown", { name }), title: t("compare.shown", { name }) });
    box.checked = pin.shown;
    box.addEventListener("change", () => slate.set(id, { shown: box.checked }));
    const field = h("input", { type: "text", value: name, "data-key": `name ${id}`, "aria-label": t("compare.name", { number: place + 1 }), autocomplete: "off" });
    field.addEventListener("change", () => {
      const next = field.value.trim() || titleOf(pin.design);
      field.value = next;
      slate.set(id, { name: next });
    });
    const load = button("load", id, t("compare.load"), t("compare.load.of", { name }), () => {
      store.replace(pin.design, t("edit.pinned", { name: pin.name }));
      say(t("compare.loaded", { name: pin.name }));
    });
    const up = button("up", id, "↑", t("compare.up", { name }), () => move(pin, -1));
    const down = button("down", id, "↓", t("compare.down", { name }), () => move(pin, 1));
    up.disabled = place === 0;
    down.disabled = place === slate.pins.length - 1;
    const remove = button("remove", id, "×", t("compare.remove", { name }), () => {
      const next = slate.pins[place + 1] ?? slate.pins[place - 1];
      slate.remove(id);
      say(t("compare.removed", { name: pin.name }));
      if (next) focus(`remove ${next.id}`);
      else add.focus();
    });
    const line = h(
      "tr",
      {},
      h("th", { scope: "row", class: "compare-name" }, h("span", {}, box, sample(pin.look), field), h("span", { class: "compare-actions" }, load, up, down, remove)),
      ...figures(pin.design, pin.report, pin.figures, length, travel),
    );
    line.addEventListener("keydown", (event) => {
      const by = { ArrowUp: -1, ArrowDown: 1 }[event.key];
      if (!event.altKey || !by) return;
      event.preventDefault();
      move(pin, by);
    });
    return line;
  }

  /** @param {Pin} pin @param {number} by */
  function move(pin, by) {
    if (slate.move(pin.id, by)) say(t("compare.moved", { name: pin.name, number: slate.pins.findIndex(({ id }) => id === pin.id) + 1, count: slate.pins.length }));
  }

  /**
   * @param {string} action
   * @param {number} id
   * @param {string} text
   * @param {string} name
   * @param {() => void} onclick
   */
  const button = (action, id, text, name, onclick) => h("button", { type: "button", class: "quiet", "data-key": `${action} ${id}`, "aria-label": name, title: name, onclick }, text);

  return { root, update };
}
