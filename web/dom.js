/** Making elements without markup: text only ever goes in as text. */

import { parts, sign } from "./signs.js";

const SVG = "http://www.w3.org/2000/svg";

/** @typedef {Node | string | null | undefined | false} Child */

/**
 * @param {Element} element
 * @param {Record<string, unknown>} attributes  `onclick` and its like are listeners, the rest attributes; false leaves out
 * @param {Child[]} children
 */
function fill(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name.slice(2), /** @type {EventListener} */ (value));
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, value === true ? "" : String(value));
  }
  for (const child of children) if (child) element.append(child);
}

/**
 * `h("button", { type: "button", onclick }, "Share")`
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {Record<string, unknown>} [attributes]
 * @param {...Child} children
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  fill(element, attributes, children);
  return element;
}

/**
 * The same for SVG.
 * @template {keyof SVGElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {Record<string, unknown>} [attributes]
 * @param {...Child} children
 * @returns {SVGElementTagNameMap[Tag]}
 */
export function s(tag, attributes = {}, ...children) {
  const element = document.createElementNS(SVG, tag);
  fill(element, attributes, children);
  return element;
}

/**
 * Writes a text only when it is another, and into the text node that is there: a new node would be styled and placed anew.
 * @param {Node} node
 * @param {string} text
 */
export function write(node, text) {
  const { firstChild } = node;
  if (firstChild instanceof Text && firstChild === node.lastChild) {
    if (firstChild.data !== text) firstChild.data = text;
  } else if (node.textContent !== text) node.textContent = text;
}

/**
 * Sets an attribute only when its value is another.
 * @param {Element} element
 * @param {string} name
 * @param {string} value
 */
export function writeAttribute(element, name, value) {
  if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}

/**
 * Hides an element or shows it. Setting `hidden` to the value that it has would restyle the element all the same.
 * @param {HTMLElement} element
 * @param {boolean} hidden
 */
export function hide(element, hidden) {
  if (element.hidden !== hidden) element.hidden = hidden;
}

/**
 * A symbol as in the books: italic letter, upright index. "Rb" and "R_b" give R with b below. It is that of the notation in use, unless
 * its letter is the follower's own.
 * @param {string} ours
 * @param {boolean} [fixed]
 */
export function symbol(ours, fixed = false) {
  const node = h("i", { class: "symbol" });
  const dress = () => {
    const { letter, index } = parts(fixed ? ours : sign(ours));
    node.replaceChildren(letter);
    if (index) node.append(h("sub", {}, index));
  };
  dress();
  if (!fixed) {
    node.dataset["sign"] = "";
    node.addEventListener("sign", dress);
  }
  return node;
}
