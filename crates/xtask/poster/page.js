// The page's own parts, put together in a document that is only written out: the first design as every visitor sees it before the
// cam begins to turn.
import { readFile } from "node:fs/promises";
import { parseHTML } from "linkedom";

/** @import { Design, Language, ShellContext } from "../../../web/types.d.ts" */

const root = new URL("../../../", import.meta.url);

/** Points into which a turn is divided, as on the page. */
const SAMPLES = 720;

/** The parts of the page in the order in which `web/main.js` mounts them, each with the section that it fills. */
const PARTS = [
  ["mechanism", "mechanism"], ["diagrams", "diagrams"], ["header", "header"], ["design-panel", "design"],
  ["transport", "transport"], ["readouts", "readouts"], ["verdict", "verdict"],
];

/** The kinds of node that the modules of the page tell apart. */
const NODES = ["Node", "Text", "Event", "Element", "SVGElement", ...["", "Button", "Canvas", "Input", "Select", "TextArea"].map((kind) => `HTML${kind}Element`)];

/** The sections that the parts fill. */
export const SECTIONS = PARTS.map(([, section]) => /** @type {string} */ (section));

/** The outline of a canvas drawing, kept as the calls that made it. */
export class Outline {
  /** @type {[name: string, ...numbers: number[]][]} */
  calls = [];
}
for (const name of ["moveTo", "lineTo", "arc", "rect", "closePath"]) {
  Object.assign(Outline.prototype, {
    /** @this {Outline} @param {number[]} numbers */
    [name](...numbers) {
      this.calls.push([name, ...numbers]);
    },
  });
}

/** Observes nothing: nothing has a size here. */
class Observer {
  observe() {}
}

/**
 * Lets properties of elements that can be written out only as attributes or as text be kept there.
 * @param {any} window
 * @param {Document} document
 */
function reflect({ HTMLElement, HTMLInputElement, HTMLSelectElement }, document) {
  for (const name of ["clientWidth", "clientHeight", "offsetWidth", "offsetHeight", "offsetTop", "offsetLeft"]) {
    Object.defineProperty(HTMLElement.prototype, name, { get: () => 0 });
  }
  // Elements whose value is what they hold.
  Object.defineProperty(document.createElement("output").constructor.prototype, "value", {
    get() {
      return this.textContent;
    },
    set(text) {
      if (this.localName === "output") this.textContent = text;
      else this.setAttribute("value", text);
    },
  });
  Object.defineProperty(HTMLSelectElement.prototype, "value", {
    get() {
      return this.querySelector("option[selected]")?.value ?? this.querySelector("option")?.value ?? "";
    },
    set(value) {
      for (const option of this.querySelectorAll("option")) option.toggleAttribute("selected", option.value === value);
    },
  });
  Object.defineProperty(HTMLInputElement.prototype, "checked", {
    get() {
      return this.hasAttribute("checked");
    },
    set(on) {
      this.toggleAttribute("checked", on);
    },
  });
}

/**
 * Gives the modules of the page the browser that they expect.
 * @param {string} styles  the text of the style sheets
 */
async function becomeBrowser(styles) {
  const { window, document } = /** @type {any} */ (parseHTML(await readFile(new URL("index.html", root), "utf8")));
  reflect(window, document);
  window.HTMLCanvasElement.prototype.getContext = () => null;
  const tokens = tokensOf(styles);
  for (const name of NODES) Object.assign(globalThis, { [name]: window[name] });
  Object.assign(globalThis, {
    // Work that is put off belongs to the living page.
    window: Object.assign(Object.create(globalThis), { setTimeout() {} }), document,
    location: new URL("page:"), ResizeObserver: Observer, IntersectionObserver: Observer, MutationObserver: Observer, Path2D: Outline, devicePixelRatio: 1,
    matchMedia: () => ({ matches: false, addEventListener() {} }),
    getComputedStyle: () => ({ getPropertyValue: (/** @type {string} */ name) => tokens.get(name) ?? "" }),
    addEventListener() {}, requestAnimationFrame() {},
  });
  return document;
}

/** The custom properties of the sheets: colours by name, so that they follow the theme, all else by value. @param {string} styles */
function tokensOf(styles) {
  /** @type {Map<string, string>} */
  const tokens = new Map();
  for (const [, name = "", value = ""] of styles.matchAll(/(--[\w-]+):\s*([^;]*);/g)) {
    if (!tokens.has(name)) tokens.set(name, value.startsWith("#") ? `var(${name})` : value);
  }
  return tokens;
}

/**
 * The page in a language.
 * @typedef {object} Opened
 * @property {ShellContext} context
 * @property {Map<string, Element>} sections  by id
 * @property {Design[]} designs  the first design in every form in which the page keeps it
 */

/**
 * Gives a function that puts the page together in a language, with the first design open and nothing turned yet.
 * @param {string} styles
 * @returns {Promise<(language: Language) => Promise<Opened>>}
 */
export async function startPage(styles) {
  const document = await becomeBrowser(styles);
  const web = (/** @type {string} */ module) => import(new URL(`web/${module}.js`, root).href);
  const module = await web("pkg/levalab_wasm");
  const { initSync, Lab, read_design } = module;
  initSync({ module: await readFile(new URL("web/pkg/levalab_wasm_bg.wasm", root)) });
  const [{ CATALOGUE: catalogue }, { createStore }, { createTranslate, learn }, { connectNumbers, createFormat }, { shelve }, { speakIn }] = await Promise.all(
    ["pkg/catalogue", "store", "strings/index", "numbers", "shelf", "signs"].map(web),
  );
  connectNumbers(() => module);
  return async (language) => {
    await learn(language);
    const lab = new Lab();
    const store = createStore();
    const t = createTranslate(() => language);
    const context = /** @type {ShellContext} */ (/** @type {unknown} */ ({ store, lab: () => lab, t, format: createFormat(() => language), catalogue, announce() {} }));
    store.set({ language, playing: true });
    store.connect({
      analyse(/** @type {Design} */ design) {
        const opened = lab.open(design, SAMPLES, language);
        speakIn(opened.report?.notation);
        return opened;
      },
    });
    const design = shelve(catalogue.first, t);
    if (!store.start(design)) throw new Error(`the first design does not open: ${store.state.error?.message}`);
    /** @type {Map<string, Element>} */
    const sections = new Map();
    for (const [module, id] of PARTS) {
      const section = document.getElementById(String(id));
      if (!section) throw new Error(`index.html has no #${id}`);
      // As it was before the other language.
      section.replaceChildren();
      for (const name of section.getAttributeNames()) if (name !== "id") section.removeAttribute(name);
      const { mount } = await web(String(module));
      mount(section, context, {});
      sections.set(String(id), section);
    }
    store.drawNow();
    return { context, sections, designs: [design, read_design(design, language).design] };
  };
}
