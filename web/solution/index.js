/**
 * The window with the worked solution of the cam on screen: it follows the design, the language and, when asked, the cursor; it is copied as
 * LaTeX or Markdown, and printed.
 *
 * @import { ShellContext } from "../types.d.ts"
 */
import { copy } from "../clipboard.js";
import { h } from "../dom.js";
import { fieldText, parseNumber } from "../numbers.js";
import { atRest } from "../rest.js";
import { addStrings } from "../strings/index.js";
import { solutionEn } from "../strings/solution.en.js";
import { solutionEs } from "../strings/solution.es.js";
import { createTexts } from "../texts.js";
import { nodes, reachable } from "./nodes.js";
import { wear } from "./sheet.js";

/** Narrower than this the window takes the whole screen, and what lies behind is out of reach. */
const NARROW = "(max-width: 900px)";

/** @typedef {() => Promise<void>} Open */

/** @type {Open | undefined} */
let view;

/** Opens the solution. @param {ShellContext} context */
export async function open(context) {
  view ??= createView(context);
  await view();
}

/**
 * @param {ShellContext} context
 * @returns {Open}
 */
function createView({ store, workshop, t, announce }) {
  addStrings({ en: solutionEn, es: solutionEs });
  wear();
  const texts = createTexts(t);
  const heading = texts.text(h("h2", { id: "solution-heading" }), "solution.title");
  const close = texts.text(h("button", { type: "button", class: "solution-close" }), "solution.close");
  const theta = h("input", { id: "solution-theta", type: "text", inputmode: "decimal", size: "9", autocomplete: "off", "aria-describedby": "solution-error" });
  const unit = h("span", { class: "unit" });
  const error = h("span", { id: "solution-error", class: "error", role: "status" });
  const follows = h("input", { id: "solution-follows", type: "checkbox" });
  const segment = h("select", { id: "solution-segment" });
  const latex = texts.text(h("button", { type: "button", class: "quiet" }), "solution.latex");
  const markdown = texts.text(h("button", { type: "button", class: "quiet" }), "solution.markdown");
  const paper = texts.text(h("button", { type: "button", class: "quiet" }), "solution.print");
  const text = h("article", { class: "solution", tabindex: "0", "aria-labelledby": heading.id });
  texts.attribute(theta, "placeholder", "solution.theta.free");
  const bar = h(
    "div",
    { class: "solution-bar" },
    h("span", { class: "solution-field" }, texts.text(h("label", { for: segment.id }), "solution.segment"), segment),
    h("span", { class: "solution-field" }, texts.text(h("label", { for: theta.id }), "solution.theta"), theta, unit),
    h("span", { class: "solution-field" }, follows, texts.text(h("label", { for: follows.id }), "solution.follows")),
    h("span", { class: "solution-field solution-do" }, latex, markdown, paper),
  );
  const dialog = h("dialog", { id: "solution", "aria-labelledby": heading.id }, h("div", { class: "solution-head" }, heading, close), bar, error, text);
  document.body.append(dialog);
  /** What had the focus when the window was opened. @type {Element | null} */
  let before = null;
  /** Where numbers are put in; nothing lets the solution choose. @type {number | undefined} */
  let place;

  /** The arguments of the calculation. */
  function asked() {
    const chosen = segment.value === "" ? undefined : Number(segment.value);
    return /** @type {const} */ ([store.lastGood(), store.state.language, place, chosen]);
  }

  async function draw() {
    if (!dialog.open) return;
    arrange();
    const made = (await workshop()).solution(...asked());
    if (!made) return;
    const { scrollTop } = text;
    // The title is that of the window.
    text.replaceChildren(...nodes(made.slice(1)));
    text.lang = store.state.language;
    reachable(text);
    text.scrollTop = scrollTop;
  }

  /** The list of segments and the unit, as the design has them. */
  function arrange() {
    const { report } = store.state;
    const laws = (report.program ?? store.lastGood().segments).map(({ law }) => law);
    const count = report.program ? laws.length / 2 : laws.length;
    const names = [t("solution.all"), ...laws.slice(0, count).map((law, k) => `${k + 1}. ${t(`law.${law}`)}`)];
    const chosen = Number(segment.value) < count ? segment.value : "";
    if (names.join("\n") !== Array.from(segment.options, (option) => option.text).join("\n")) {
      segment.replaceChildren(...names.map((name, k) => h("option", { value: k === 0 ? "" : k - 1 }, name)));
      segment.value = chosen;
    }
    unit.textContent = report.travels ? report.units.length : "°";
    if (follows.checked) {
      place = store.state.cursor;
      theta.value = fieldText(Number(place.toFixed(2)), store.state.language);
      tell("");
    }
  }

  /** @param {string} problem */
  function tell(problem) {
    error.textContent = problem;
    theta.setAttribute("aria-invalid", String(problem !== ""));
  }

  const rested = atRest(() => void draw());
  store.subscribe(["report", "language"], (_, changed) => {
    if (changed.has("language")) texts.refresh();
    if (changed.has("language") && place !== undefined) theta.value = fieldText(Number(place.toFixed(6)), store.state.language);
    rested();
  });
  store.subscribe(["cursor"], () => {
    if (dialog.open && follows.checked) rested();
  });

  theta.addEventListener("change", () => {
    follows.checked = false;
    const typed = theta.value.trim();
    const { value, problem } = typed === "" ? { value: undefined } : parseNumber(typed, unit.textContent ?? "", store.state.language);
    tell(problem ?? "");
    if (problem) return;
    place = value;
    void draw();
  });
  follows.addEventListener("change", () => void draw());
  segment.addEventListener("change", () => {
    text.scrollTop = 0;
    void draw();
  });
  for (const [button, to] of /** @type {const} */ ([[latex, "latex"], [markdown, "markdown"]])) {
    button.addEventListener("click", async () => {
      const done = await copy((await workshop()).solution_text(...asked(), to));
      const sentence = t(done ? "solution.copied" : "solution.uncopied", { what: t(`solution.${to}.name`) });
      announce(sentence);
      error.textContent = sentence;
    });
  }
  paper.addEventListener("click", () => {
    const { title } = store.lastGood();
    const sheet = h("article", { class: "solution on-paper", lang: store.state.language }, h("h1", {}, title ? `${t("solution.title")}: ${title}` : t("solution.title")));
    sheet.append(...Array.from(text.children, (child) => child.cloneNode(true)));
    document.body.append(sheet);
    print();
    sheet.remove();
  });
  close.addEventListener("click", () => dialog.close());
  // Beside the cam the window leaves the page in use: what had Escape for itself has kept it.
  addEventListener("keydown", (event) => {
    const free = event.target instanceof HTMLElement && !event.target.matches("input:not([type=range]), select, textarea") && !event.target.closest("dialog");
    if (event.key === "Escape" && dialog.open && free && !event.defaultPrevented) dialog.close();
  });
  dialog.addEventListener("keydown", (event) => {
    if (event.key === "Escape") dialog.close();
    // Keys of the animation are not for who reads; undo is.
    if (!event.ctrlKey && !event.metaKey) event.stopPropagation();
  });
  dialog.addEventListener("close", () => {
    if (before instanceof HTMLElement) before.focus();
  });
  const header = document.getElementById("header");
  if (header) new ResizeObserver(() => dialog.style.setProperty("--solution-top", `${header.getBoundingClientRect().bottom}px`)).observe(header);
  matchMedia(NARROW).addEventListener("change", () => {
    if (dialog.open) dialog.close();
  });

  return async function show() {
    before = document.activeElement;
    if (!dialog.open) {
      if (matchMedia(NARROW).matches) dialog.showModal();
      else dialog.show();
    }
    text.scrollTop = 0;
    await draw();
    text.focus();
  };
}
