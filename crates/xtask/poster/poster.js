// Prints as JSON what the packed page shows before any script of it has run: the first design, in both languages.
// `node poster.js '["web/styles/tokens.css", …]'`
//
// `sections` holds the contents of each section of `index.html` and the attributes that it needs, `styles` the rules that belong to them,
// and `known` the texts, by language, that an address or a store may hold without another picture being meant.
import { readFile } from "node:fs/promises";
import { Bounds } from "./bounds.js";
import { charts } from "./charts.js";
import { Styles, branch, createTaker, joined, written } from "./markup.js";
import { SECTIONS, startPage } from "./page.js";
import { mechanism } from "./stage.js";

/** @import { Language } from "../../../web/types.d.ts" */
/** @import { Tree } from "./markup.js" */

/** What a screen reader reads of it; all else is for the eyes until it works. */
const READ = ["stage-frame", "verdict-line"];

const root = new URL("../../../", import.meta.url);
const files = /** @type {string[]} */ (JSON.parse(process.argv[2] ?? "[]"));
const sheets = (await Promise.all(files.map((file) => readFile(new URL(file, root), "utf8")))).join("\n");
const open = await startPage(sheets);
const styles = new Styles();
const bounds = new Bounds();
let rules = "";

/** The first design in a language: what fills each section, and what else tells of the same design. @param {Language} language */
async function picture(language) {
  const { context, sections, designs } = await open(language);
  const { mechanismInWords } = await import(new URL("web/stage/in-words.js", root).href);
  const drawn = await charts(context, bounds);
  rules = drawn.rules;
  const stage = await mechanism(context);
  const diagrams = [...drawn.charts.values()];
  let placed = false;
  /** @param {Element} element @returns {Tree | null | undefined} */
  function instead(element) {
    const { classList } = element;
    // Its size is that of a window without any.
    if (classList.contains("diagram")) element.removeAttribute("style");
    // Wide as its column, whatever it offers.
    if (classList.contains("law")) for (const option of element.querySelectorAll("option:not([selected]), optgroup:not(:has([selected]))")) option.remove();
    if (classList.contains("stage-canvas")) {
      placed = true;
      return branch("div", {}, stage, branch("p", { class: "unseen" }, mechanismInWords(context)));
    }
    if (classList.contains("diagram-canvas")) return diagrams.shift() ?? null;
    return ["diagram-overlay", "menu", "stage-layers-list"].some((name) => classList.contains(name)) ? null : undefined;
  }
  const take = createTaker(sheets, styles, instead);
  const taken = SECTIONS.map((id) => [...(sections.get(id)?.children ?? [])].flatMap((child) => take(child) ?? []));
  if (!placed || diagrams.length > 0) throw new Error("the page has no canvas for what is drawn");
  const { link } = context.store.state.report;
  const texts = [link, ...designs.map((design) => JSON.stringify(design)), JSON.stringify(context.store.state.layers)];
  const level = sections.get("verdict")?.getAttribute("data-level") ?? "";
  return { taken, texts: [...new Set(texts)], level };
}

/** An outer element of the picture, by which it is found when it goes. @param {Tree} tree @returns {Tree} */
function marked(tree) {
  if (typeof tree === "string") return tree;
  const read = READ.includes(tree.attributes["class"] ?? "");
  return { ...tree, attributes: { ...tree.attributes, "data-poster": "", ...(read ? {} : { inert: "" }) } };
}

const en = await picture("en");
const es = await picture("es");
const contents = SECTIONS.map((id, index) => {
  const [english = [], spanish = []] = [en.taken[index], es.taken[index]];
  const html = english.flatMap((tree, place) => joined(tree, spanish[place] ?? "")).map((tree) => written(marked(tree))).join("");
  return [id, { html, attributes: id === "verdict" ? ` data-level="${en.level}"` : "" }];
});
console.log(JSON.stringify({ sections: Object.fromEntries(contents), styles: `${rules}${bounds}${styles}`, known: { en: en.texts, es: es.texts } }));
