/**
 * The examples library: a window with a picture, a verdict and a few sentences of each cam.
 *
 * @import { Example, Lab, ShellContext } from "./types.d.ts"
 * @import { Check } from "./recent.js"
 */
import { h, s } from "./dom.js";
import { loadSolution } from "./header.js";
import { onDemand } from "./on-demand.js";
import * as library from "./pkg/examples.js";
import { shelve } from "./shelf.js";
import { addStrings } from "./strings/index.js";
import { examplesEn } from "./strings/examples.en.js";
import { examplesEs } from "./strings/examples.es.js";
import { createTexts } from "./texts.js";

addStrings({ en: examplesEn, es: examplesEs });

const EXAMPLES = /** @type {Example[]} */ (/** @type {unknown} */ (library.EXAMPLES));

/** @type {Example["group"][]} */
const GROUPS = ["classic", "solved", "more"];

/** Steps of an outline: enough for a picture of a few millimetres. */
const OUTLINE = 180;

/** Room around an outline, as a part of its size. */
const MARGIN = 0.06;

/**
 * @param {ShellContext} context
 * @param {Check} check  brings a design into the form that the page works with
 */
export function createGallery(context, check) {
  const { store, lab, t, banner } = context;
  const texts = createTexts(t);
  const heading = texts.text(h("h2", { id: "examples-heading" }), "examples.title");
  const close = h("button", { type: "button", class: "quiet" }, "×");
  texts.attribute(close, "aria-label", "examples.close");
  const sections = h("div", { class: "groups" });
  const dialog = h("dialog", { class: "gallery", "aria-labelledby": heading.id }, h("div", { class: "head" }, heading, close), sections);
  /** Pictures and verdicts do not change: they are made once. @type {Map<string, Portrait>} */
  const portraits = new Map();

  function draw() {
    sections.replaceChildren(
      ...GROUPS.map((group) => {
        const title = h("h3", { id: `examples-${group}` }, t(`examples.${group}`));
        const cards = EXAMPLES.filter((example) => example.group === group).map(card);
        return h("section", { "aria-labelledby": title.id }, title, h("ul", {}, ...cards));
      }),
    );
  }

  /** What it goes by: its number in the books, or what it is. @param {Example} example */
  const nameOf = (example) => (keyOf(example) ? t(keyOf(example)) : example.id);

  /** @param {Example} example */
  function card(example) {
    const { title, note } = example[store.state.language];
    const portrait = portraits.get(example.id) ?? portray(lab(), example);
    portraits.set(example.id, portrait);
    const level = h("span", { class: `level ${portrait.level}` }, t(`examples.level.${portrait.level}`));
    const name = h("strong", {}, `${nameOf(example)} · ${title}`);
    const open = h("button", { type: "button", class: "sample", "data-example": example.id }, picture(portrait), h("span", { class: "words" }, name, level, h("span", { class: "about" }, note)));
    open.addEventListener("click", () => show(example));
    if (example.group !== "solved") return h("li", {}, open);
    const solved = h("button", { type: "button", class: "quiet solved", "data-solution": example.id, "aria-label": t("examples.solution.of", { name: example.id }) }, t("examples.solution"));
    onDemand(context, solved, () => loadSolution(context), (solution) => {
      show(example);
      void solution.open(context);
    });
    return h("li", {}, open, solved);
  }

  /** @param {Example} example */
  function show(example) {
    dialog.close();
    banner.hide();
    const found = check(example.design).design;
    if (!found) return;
    const design = shelve(found, t, keyOf(example));
    store.replace(design, t("edit.example", { name: nameOf(example) }));
    store.set({ cursor: 0 });
  }

  close.addEventListener("click", () => dialog.close());
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close();
  });
  store.subscribe(["language"], () => {
    texts.refresh();
    if (dialog.open) draw();
  });
  document.body.append(dialog);

  return function show() {
    draw();
    dialog.showModal();
    (/** @type {HTMLElement | null} */ (sections.querySelector("button")) ?? close).focus();
  };
}

/** The key of its name, where that is a word; a number of the books needs none. @param {Example} example */
const keyOf = ({ id, group }) => (group === "more" ? `examples.name.${id}` : "");

/** @typedef {{ level: string, path: string, box: string }} Portrait */

/**
 * @param {Lab} current  an engine of its own looks at the example, so that the cam on screen stays
 * @param {Example} example
 * @returns {Portrait}
 */
function portray(current, { design }) {
  const Own = /** @type {new () => Lab} */ (current.constructor);
  const lab = new Own();
  const opened = lab.open(design, OUTLINE, "en");
  if (!opened.report) return { level: "unacceptable", path: "", box: "0 0 1 1" };
  const [x, y] = [lab.column("x"), lab.column("y")];
  const points = Array.from(x, (value, i) => /** @type {const} */ ([value, -(y[i] ?? 0)]));
  const [left, right] = [Math.min(...x), Math.max(...x)];
  const [top, bottom] = [-Math.max(...y), -Math.min(...y)];
  const size = Math.max(right - left, bottom - top) * (1 + 2 * MARGIN);
  const corner = [(left + right - size) / 2, (top + bottom - size) / 2];
  const digits = (/** @type {number} */ value) => Number(value.toPrecision(4));
  return {
    level: opened.report.verdict.level,
    path: `M${points.map((point) => point.map(digits).join(" ")).join("L")}Z`,
    box: [...corner, size, size].map(digits).join(" "),
  };
}

/** @param {Portrait} portrait */
function picture({ path, box }) {
  const size = Number(box.split(" ")[2]);
  return s("svg", { viewBox: box, class: "portrait", "aria-hidden": "true" }, s("path", { d: path }), s("circle", { r: size / 40 }));
}
