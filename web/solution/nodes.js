/**
 * Nodes from the tree that the engine gives: no markup is ever read.
 *
 * @import { SolutionNode } from "../types.d.ts"
 */

const HTML = "http://www.w3.org/1999/xhtml";
const MATHML = "http://www.w3.org/1998/Math/MathML";

/**
 * @param {readonly SolutionNode[]} tree
 * @param {string} [space]  of what holds them
 * @returns {Node[]}
 */
export function nodes(tree, space = HTML) {
  return tree.map((node) => (typeof node === "string" ? document.createTextNode(node) : element(node, space)));
}

/**
 * @param {Exclude<SolutionNode, string>} node
 * @param {string} space
 */
function element([tag, attributes, ...children], space) {
  const own = tag === "math" ? MATHML : space;
  const made = document.createElementNS(own, tag);
  for (let i = 0; i + 1 < attributes.length; i += 2) made.setAttribute(attributes[i] ?? "", attributes[i + 1] ?? "");
  made.append(...nodes(children, own));
  return made;
}

/** What is wider than its place can be scrolled by the keyboard too. @param {Element} root */
export function reachable(root) {
  for (const wide of root.querySelectorAll(".formula, .cells")) if (wide.scrollWidth > wide.clientWidth) wide.setAttribute("tabindex", "0");
}
