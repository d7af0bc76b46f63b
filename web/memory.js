/** What the browser keeps between visits. Everything works without it. */

/**
 * @param {"design" | "view"} name
 * @returns {unknown}
 */
export function recall(name) {
  try {
    const text = localStorage.getItem(`levalab:${name}`);
    return text === null ? null : JSON.parse(text);
  } catch {
    return null;
  }
}

/**
 * @param {"design" | "view"} name
 * @param {unknown} value
 */
export function keep(name, value) {
  try {
    localStorage.setItem(`levalab:${name}`, JSON.stringify(value));
  } catch {
    // Private windows, full or forbidden storage: nothing to do, the link still holds the design.
  }
}
