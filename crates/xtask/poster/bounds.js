// The sizes of a drawing at which some part of it is shown: as classes, with the rules that show and hide them.

/**
 * The sizes at which something is shown: from `from` on, up to but not including `to`.
 * @typedef {{ from: number, to: number }} Span
 */

/**
 * Finds the sizes at which each of several things is there.
 * @template Item
 * @param {Span} sizes
 * @param {(size: number) => Map<string, Item>} at  what is there at a size, by name
 */
export function spans(sizes, at) {
  /** @type {(Span & { item: Item })[]} */
  const found = [];
  /** @type {Map<string, Span & { item: Item }>} */
  let open = new Map();
  for (let size = sizes.from; size <= sizes.to; size++) {
    const now = at(size);
    const next = new Map();
    for (const [name, item] of now) {
      const span = open.get(name) ?? { from: size, to: Infinity, item };
      if (!open.has(name)) found.push(span);
      next.set(name, span);
    }
    for (const [name, span] of open) if (!now.has(name)) span.to = size;
    open = next;
  }
  return found;
}

/** The bounds of spans that elements name in their classes, as rules. */
export class Bounds {
  /** @type {Map<string, number>} */
  #from = new Map();
  /** @type {Map<string, number>} */
  #to = new Map();

  /**
   * The classes of what is shown in a span.
   * @param {"h" | "w"} axis
   * @param {Span} span
   * @param {Span} sizes  all that there are
   */
  classes(axis, { from, to }, sizes) {
    const names = [];
    if (from > sizes.from) names.push(this.#name(this.#from, `${axis}from-`, from));
    if (to < sizes.to) names.push(this.#name(this.#to, `${axis}to-`, to));
    return names.join(" ");
  }

  /** @param {Map<string, number>} bounds @param {string} prefix @param {number} size */
  #name(bounds, prefix, size) {
    bounds.set(prefix + size, size);
    return prefix + size;
  }

  toString() {
    const side = (/** @type {string} */ name) => (name.startsWith("h") ? "height" : "width");
    const from = [...this.#from].map(([name, size]) => `.${name}{display:none}@container(min-${side(name)}:${size}px){.${name}{display:inline}}`);
    const to = [...this.#to].map(([name, size]) => `@container(min-${side(name)}:${size}px){.${name}{display:none}}`);
    return [...from, ...to].join("");
  }
}
