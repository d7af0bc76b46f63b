/**
 * Auto: the user says only what the machine must do, and the program that does it is joined by the smoothest laws, seen before it is taken.
 *
 * @import { Design, Lab, ShellContext } from "./types.d.ts"
 */
import { clean } from "./clean.js";
import { h, symbol, write } from "./dom.js";
import { fieldText, parseNumber } from "./numbers.js";
import { heightAt, lift } from "./program.js";
import { riseUnit } from "./segment-row.js";
import { readPalette } from "./stage/palette.js";
import { PLOTS, styleOf } from "./stage/plots.js";
import { autoEn } from "./strings/auto.en.js";
import { autoEs } from "./strings/auto.es.js";
import { addStrings } from "./strings/index.js";

addStrings({ en: autoEn, es: autoEs });

const SHEET = `
#auto { inline-size: min(46rem, 100vw - 2rem); max-inline-size: none; max-block-size: 94dvh; overflow: auto; }
#auto .auto-row { display: grid; grid-template-columns: 1.4rem minmax(7rem, 1fr) repeat(4, minmax(3rem, 4.5rem)) 28px; align-items: center; gap: 2px var(--space-1); padding-block: 2px; }
#auto .auto-row .error { grid-column: 2 / -1; }
#auto .auto-head { color: var(--muted); font-size: var(--size-small); text-align: end; }
#auto .auto-row input { min-inline-size: 0; }
#auto .auto-row button { min-inline-size: 24px; min-block-size: 24px; padding: 0; border-color: transparent; background: none; color: var(--muted); }
#auto .auto-bar { display: flex; flex-wrap: wrap; align-items: center; gap: var(--space-2) var(--space-4); margin-block: var(--space-2); }
#auto canvas { display: block; inline-size: 100%; block-size: 9rem; }
#auto ol.auto-why { display: grid; gap: var(--space-1); margin-block: var(--space-2); padding-inline-start: 1.2rem; list-style: disc; font-size: var(--size-small); }
#auto .primary { border-color: var(--accent); background: var(--accent); color: var(--on-accent); }
#auto .primary:disabled { border-color: var(--line); background: none; color: var(--muted); }
#auto .auto-row.wrong { background: color-mix(in srgb, var(--bad) 12%, transparent); }
#auto .auto-foot { position: sticky; inset-block-end: calc(-1 * var(--space-5)); display: flex; justify-content: end; gap: var(--space-2); margin-block: var(--space-2) calc(-1 * var(--space-5)); padding-block: var(--space-3); background: var(--paper); }
#auto .auto-bar .quiet { color: var(--accent); }
#auto .auto-bar span:has(input) { display: flex; align-items: baseline; gap: var(--space-2); }
@media (max-width: 480px) { #auto .auto-row { grid-template-columns: 0.7rem 7.4rem repeat(4, minmax(2.2rem, 1fr)) 24px; } #auto { padding-inline: var(--space-3); } #auto .auto-row :is(input, select) { padding-inline: 2px; font-size: var(--size-small); } #auto .auto-row select { padding-inline-end: 14px; } }
`;

/** What the machine must do: the fields of each kind of requirement, by the columns of the table. */
const KINDS = /** @type {const} */ ({ dwell: ["from", "to", "s"], line: ["from", "to", "s", "end"], point: ["from", "s", "v"] });
/** @typedef {keyof typeof KINDS} Kind */
/** @typedef {"from" | "to" | "s" | "end" | "v"} Field */
/** @typedef {{ kind: Kind } & Partial<Record<Field, string>>} Demand */

/** The four columns: the last is the height at the end of a line, or the velocity at a point. @type {readonly (readonly Field[])[]} */
const COLUMNS = [["from"], ["to"], ["s"], ["end", "v"]];

/** What the window needs of the engine. @typedef {{ joined: { design: Design, choices: string[] }, error?: undefined } | { error: { path: string, message: string }, joined?: undefined }} Answer */

/** @type {ReturnType<typeof create> | null} */
let made = null;

/** @param {ShellContext} context */
export function openAuto(context) {
  made ??= create(context);
  made.open();
}

/** @param {ShellContext} context */
function create(context) {
  const { store, t, whole } = context;
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(SHEET);
  document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];

  /** @type {Demand[]} */
  let demands = [];
  /** @type {Design | null} */
  let found = null;
  let asked = 0;
  /** Where what was joined is analysed, to be drawn. @type {Lab | null} */
  let preview = null;

  const heading = h("h2", { id: "auto-heading" });
  const about = h("p");
  const list = h("div", { role: "group", "aria-labelledby": "auto-heading" });
  const add = h("button", { type: "button", class: "quiet" });
  const fast = h("input", { type: "checkbox", id: "auto-fast" });
  const fastLabel = h("label", { for: "auto-fast" });
  const least = h("select", { id: "auto-least" });
  const leastLabel = h("label", { for: "auto-least" });
  const problem = h("p", { class: "error", role: "status" });
  const picture = h("canvas", { role: "img" });
  const why = h("ol", { class: "auto-why" });
  const take = h("button", { type: "button", class: "primary" });
  const close = h("button", { type: "button" });
  const dialog = h(
    "dialog",
    { id: "auto", "aria-labelledby": heading.id },
    heading,
    about,
    list,
    h("div", { class: "auto-bar" }, add, h("span", {}, leastLabel, " ", least), h("span", {}, fast, fastLabel)),
    problem,
    picture,
    why,
    h("div", { class: "auto-foot" }, close, take),
  );
  document.body.append(dialog);

  close.addEventListener("click", () => dialog.close());
  add.addEventListener("click", () => {
    demands.push({ kind: "point", from: "", s: "" });
    rows();
    /** @type {HTMLElement | null} */ (list.lastElementChild?.querySelector("select") ?? null)?.focus();
    void join();
  });
  fast.addEventListener("change", () => void join());
  least.addEventListener("change", () => void join());
  take.addEventListener("click", () => {
    const program = found?.segments;
    if (!program) return;
    store.edit(t("edit.auto"), (draft) => {
      draft.segments = structuredClone(program);
    });
    dialog.close();
  });
  store.subscribe(["language"], () => {
    if (dialog.open) word();
  });

  /** What of the program on screen a machine may have asked for; a dwell below and one above when that is nothing. */
  function guess() {
    const { design, language } = store.state;
    const text = (/** @type {number} */ value) => fieldText(clean(value), language);
    let from = 0;
    /** @type {Demand[]} */
    const kept = [];
    design.segments.forEach((segment, k) => {
      const [to, s] = [from + segment.beta, heightAt(design, k)];
      if (segment.law === "dwell") kept.push({ kind: "dwell", from: text(from), to: text(to), s: text(s) });
      if (segment.law === "constant-velocity") kept.push({ kind: "line", from: text(from), to: text(to), s: text(s), end: text(heightAt(design, k + 1)) });
      from = to;
    });
    const moves = kept.some(({ kind, s }) => kind === "line" || s !== "0");
    if (moves) return kept;
    return [/** @type {Demand} */ ({ kind: "dwell", from: "0", to: "60", s: "0" }), /** @type {Demand} */ ({ kind: "dwell", from: "180", to: "240", s: text(lift(design) || 10) })];
  }

  function rows() {
    const unit = riseUnit(store.state.design);
    const head = h("div", { class: "auto-row auto-head", "aria-hidden": "true" }, h("span"), h("span"), ...[["θ", "°"], ["θ", "°"], ["s", unit]].map(([sign = "", of]) => h("span", {}, symbol(sign), ` ${of}`)), h("span", {}, symbol("s"), " · ", symbol("v")), h("span"));
    list.replaceChildren(head, ...demands.map(row));
  }

  /** @param {Demand} demand @param {number} k */
  function row(demand, k) {
    const number = k + 1;
    const kind = h("select", { "aria-label": t("auto.kind.of", { number }) }, ...Object.keys(KINDS).map((id) => h("option", { value: id, selected: id === demand.kind }, t(`auto.kind.${id}`))));
    kind.addEventListener("change", () => {
      demands[k] = { ...demand, kind: /** @type {Kind} */ (kind.value) };
      rows();
      list.querySelectorAll("select")[k]?.focus();
      void join();
    });
    const cells = COLUMNS.map((fields) => {
      const field = fields.find((name) => /** @type {readonly string[]} */ (KINDS[demand.kind]).includes(name));
      if (!field) return h("span");
      const input = h("input", { type: "text", class: "number", inputmode: "decimal", autocomplete: "off", "aria-label": t(`auto.${field}.of`, { number }), placeholder: field === "v" ? t("auto.free") : "", value: demand[field] ?? "" });
      input.addEventListener("input", () => {
        demand[field] = input.value;
        void join();
      });
      return input;
    });
    const remove = h("button", { type: "button", "aria-label": t("auto.remove", { number }), title: t("auto.remove", { number }) }, "×");
    remove.addEventListener("click", () => {
      demands.splice(k, 1);
      rows();
      add.focus();
      void join();
    });
    return h("div", { class: "auto-row" }, h("span", {}, String(number)), kind, ...cells, remove);
  }

  /** The requirements as the engine reads them; none while one of them is no number. */
  function read() {
    /** @param {Demand} demand @param {Field} field */
    const value = (demand, field) => parseNumber(demand[field] ?? "", "°").value;
    const all = demands.map((demand) => {
      const [from, to, s, end, v] = /** @type {const} */ (["from", "to", "s", "end", "v"]).map((field) => value(demand, field));
      if (demand.kind === "dwell") return { dwell: [from, to], s };
      if (demand.kind === "line") return { line: [from, to], s: [s, end] };
      const free = (demand.v ?? "").trim() === "";
      return free ? { at: from, s } : { at: from, s, v };
    });
    const bad = all.findIndex((demand) => Object.values(demand).flat().includes(undefined));
    return bad < 0 ? { all } : { bad };
  }

  async function join() {
    const mine = ++asked;
    const { all, bad } = read();
    if (!all) return tell({ error: { path: "", message: t("auto.unreadable", { number: (bad ?? 0) + 1 }) } });
    /** @type {Partial<Design>} */
    const around = { ...store.lastGood() };
    delete around.segments;
    const module = await whole();
    /** @type {Answer} */
    const answer = module.join_requirements({ ...around, requirements: all, high_speed: fast.checked, least: least.value }, store.state.language);
    if (mine === asked) tell(answer);
  }

  /** @param {Answer} answer */
  function tell({ joined, error }) {
    const place = /^requirements\[(\d+)\]/.exec(error?.path ?? "")?.[1];
    write(problem, error ? (place === undefined ? error.message : t("auto.problem", { number: Number(place) + 1, message: error.message })) : "");
    problem.hidden = !error;
    list.querySelectorAll(".auto-row:not(.auto-head)").forEach((row, k) => row.classList.toggle("wrong", place === String(k)));
    found = joined?.design ?? null;
    take.disabled = found === null;
    why.replaceChildren(...(joined?.choices ?? []).map((sentence) => h("li", {}, sentence)));
    picture.hidden = found === null;
    if (found) void draw(found);
  }

  /** @param {Design} design */
  async function draw(design) {
    const { Lab } = await whole();
    if (!(preview instanceof Lab)) preview = new Lab();
    const lab = preview;
    const [width, height] = [picture.clientWidth, picture.clientHeight];
    if (lab.open(design, 360, store.state.language).report && width > 0) {
      const ratio = Math.max(devicePixelRatio, 2);
      [picture.width, picture.height] = [Math.round(width * ratio), Math.round(height * ratio)];
      lab.draw(picture, "s", styleOf(PLOTS.s, readPalette(), { ...store.state, perSecond: false }, { width, height, ratio, labels: true }));
    }
  }

  function word() {
    write(heading, t("auto.title"));
    write(about, t("auto.about"));
    write(add, t("auto.add"));
    write(fastLabel, t("auto.fast"));
    write(leastLabel, t("auto.least"));
    write(close, t("auto.close"));
    write(take, t("auto.take"));
    picture.setAttribute("aria-label", t("auto.picture"));
    const chosen = least.value || "acceleration";
    least.replaceChildren(...["velocity", "acceleration", "jerk"].map((id) => h("option", { value: id, selected: id === chosen }, t(`auto.least.${id}`))));
    rows();
    void join();
  }

  return {
    open() {
      if (demands.length === 0) demands = guess();
      dialog.showModal();
      word();
    },
  };
}
