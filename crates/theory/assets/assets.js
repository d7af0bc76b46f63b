// What the pages of theory take from the page: `node assets.js FOLLOWERS` prints labels and drawings as JSON. The drawings are
// made by the very modules of the page, in a document that can only be written out.
import { readdir } from "node:fs/promises";

const strings = new URL("../../../web/strings/", import.meta.url);

/** An element that knows how to write itself. */
class Element {
  /** @type {Map<string, string>} */
  attributes = new Map();
  /** @type {(Element | string)[]} */
  children = [];

  /** @param {string} tag */
  constructor(tag) {
    this.tag = tag;
  }

  /** @param {string} name @param {string} value */
  setAttribute(name, value) {
    this.attributes.set(name, value);
  }

  addEventListener() {}

  /** @param {...(Element | string)} children */
  append(...children) {
    this.children.push(...children);
  }

  /** @param {...(Element | string)} children */
  replaceChildren(...children) {
    this.children = children;
  }

  /** @returns {string} */
  toString() {
    const attributes = [...this.attributes].map(([name, value]) => ` ${name}="${escape(String(value))}"`).join("");
    const children = this.children.map((child) => (typeof child === "string" ? escape(child) : child.toString())).join("");
    return `<${this.tag}${attributes}>${children}</${this.tag}>`;
  }
}

/** @param {string} text */
const escape = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll('"', "&quot;");

Object.assign(globalThis, { document: { createElementNS: (/** @type {string} */ _, /** @type {string} */ tag) => new Element(tag) } });
const { createHelpDrawing } = await import("../../../web/help-drawing.js");
const { DRAWINGS } = await import("./drawings.js");

/** Labels of one language: those of every file of strings that speaks it. @param {string} language */
async function labels(language) {
  /** @type {Record<string, string>} */
  const all = {};
  for (const file of await readdir(strings)) {
    if (file !== `${language}.js` && !file.endsWith(`.${language}.js`)) continue;
    for (const words of Object.values(await import(new URL(file, strings).href))) {
      for (const [key, text] of Object.entries(words)) if (typeof text === "string") all[key] = text;
    }
  }
  return all;
}

/** @type {Record<string, string>} */
const drawings = {};
for (const entry of JSON.parse(process.argv[2] ?? "[]")) {
  const drawing = createHelpDrawing({ pick() {}, point() {} });
  void drawing.show(entry, "", "rotating");
  drawing.root.setAttribute("aria-hidden", "true");
  drawings[entry.id] = String(drawing.root);
}
for (const [name, draw] of Object.entries(DRAWINGS)) drawings[name] = String(draw());
console.log(JSON.stringify({ labels: { en: await labels("en"), es: await labels("es") }, drawings }));
