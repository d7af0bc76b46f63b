// Elements as trees: taken from a document without what only a living page needs, joined in two languages, written as HTML.

/**
 * An element: its tag, its attributes and what it holds.
 * @typedef {{ tag: string, attributes: Record<string, string>, children: Tree[] }} Branch
 * @typedef {Branch | string} Tree
 */

/** Attributes that change how an element looks; others are kept when the style sheets name them. */
const LOOKS = new Set([
  "class", "type", "value", "min", "max", "step", "disabled", "checked", "selected", "placeholder", "viewBox", "d", "x", "y", "cx", "cy", "r", "rx", "x1", "x2",
  "y1", "y2", "width", "height", "points", "fill", "stroke", "stroke-width", "text-anchor", "transform",
]);

/** Elements without an end tag. */
const VOID = new Set(["input", "br"]);

/** Elements of a drawing that hold text. */
const DRAWN_TEXT = new Set(["text", "tspan"]);

/**
 * @param {string} tag
 * @param {Record<string, string | number>} [attributes]
 * @param {...Tree} children
 * @returns {Branch}
 */
export function branch(tag, attributes = {}, ...children) {
  return { tag, attributes: Object.fromEntries(Object.entries(attributes).map(([name, value]) => [name, String(value)])), children };
}

/**
 * Takes elements from a document.
 * @param {string} styles  the text of the style sheets that dress them
 * @param {Styles} classes  gets the styles that elements carry themselves
 * @param {(element: Element) => Tree | null | undefined} [instead]  what stands in the place of an element; null for nothing
 */
export function createTaker(styles, classes, instead = () => undefined) {
  /** @param {string} name @param {string} value */
  const matters = (name, value) => LOOKS.has(name) || (name === "id" ? styles.includes(`#${value} `) : styles.includes(`[${name}`));

  /** @param {Element} element @returns {Tree | null} */
  function take(element) {
    const other = instead(element);
    if (other !== undefined) return other;
    if (element.hasAttribute("hidden") || (element.classList.contains("unseen") && element.localName !== "input")) return null;
    /** @type {Record<string, string>} */
    const attributes = {};
    for (const { name, value } of element.attributes) if (matters(name, value)) attributes[name] = value;
    const own = element.getAttribute("style");
    if (own) attributes["class"] = `${attributes["class"] ?? ""} ${classes.name(own)}`.trim();
    return { tag: element.tagName.toLowerCase(), attributes, children: [...element.childNodes].flatMap((node) => held(node) ?? []) };
  }

  /** @param {Node} node @returns {Tree | null} */
  const held = (node) => (node.nodeType === 1 ? take(/** @type {Element} */ (node)) : node.textContent || null);
  return take;
}

/** The styles that elements carry themselves, as classes: the page's policy allows no `style` attributes. */
export class Styles {
  /** @type {Map<string, string>} */
  #names = new Map();

  /** @param {string} style */
  name(style) {
    const name = this.#names.get(style) ?? `poster-${this.#names.size.toString(36)}`;
    this.#names.set(style, name);
    return name;
  }

  /** The rules. */
  toString() {
    return [...this.#names].map(([style, name]) => `.${name}{${style}}`).join("");
  }
}

/**
 * One tree out of the same in English and in Spanish: what differs stands in it twice, in the classes `in-en` and `in-es`.
 * @param {Tree} en
 * @param {Tree} es
 * @param {string} [within]  the tag around them
 * @returns {Tree[]}
 */
export function joined(en, es, within = "") {
  if (typeof en === "string" || typeof es === "string") {
    if (en === es) return [en];
    const tag = DRAWN_TEXT.has(within) ? "tspan" : "span";
    return [inLanguage(typeof en === "string" ? branch(tag, {}, en) : en, "en"), inLanguage(typeof es === "string" ? branch(tag, {}, es) : es, "es")];
  }
  // A list holds no elements but its options.
  const whole = en.tag === "select" && JSON.stringify(en) !== JSON.stringify(es);
  const alike = !whole && en.tag === es.tag && en.children.length === es.children.length && JSON.stringify(en.attributes) === JSON.stringify(es.attributes);
  if (!alike) return [inLanguage(en, "en"), inLanguage(es, "es")];
  return [{ ...en, children: en.children.flatMap((child, index) => joined(child, es.children[index] ?? "", en.tag)) }];
}

/** @param {Branch} tree @param {string} language @returns {Branch} */
function inLanguage(tree, language) {
  return { ...tree, attributes: { ...tree.attributes, class: `${tree.attributes["class"] ?? ""} in-${language}`.trim() } };
}

/** @param {Tree} tree @returns {string} */
export function written(tree) {
  if (typeof tree === "string") return tree.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
  const { tag, attributes, children } = tree;
  const kept = Object.entries(attributes).filter(([name, value]) => name !== "class" || value !== "");
  const start = tag + kept.map(([name, value]) => (value === "" ? ` ${name}` : ` ${name}="${value.replaceAll("&", "&amp;").replaceAll('"', "&quot;")}"`)).join("");
  return VOID.has(tag) ? `<${start}>` : `<${start}>${children.map(written).join("")}</${tag}>`;
}
