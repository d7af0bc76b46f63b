/** What the browser keeps between visits, and what a tab keeps for itself. Everything works without it. */

const PREFIX = "levalab:";

/** @typedef {"localStorage" | "sessionStorage"} Keeper  for every tab, or for this one alone */

/**
 * @param {string} name
 * @param {Keeper} [keeper]
 * @returns {unknown}
 */
export function recall(name, keeper = "localStorage") {
  try {
    const text = window[keeper].getItem(PREFIX + name);
    return text === null ? null : JSON.parse(text);
  } catch {
    return null;
  }
}

/**
 * @param {string} name
 * @param {unknown} value
 * @param {Keeper} [keeper]
 */
export function keep(name, value, keeper = "localStorage") {
  try {
    window[keeper].setItem(PREFIX + name, JSON.stringify(value));
  } catch {
    // Private windows, full or forbidden storage: nothing to do, the link still holds the design.
  }
}

/** @param {string} name */
export function forget(name) {
  try {
    localStorage.removeItem(PREFIX + name);
  } catch {
    // Then nothing is kept either.
  }
}

/** The names that begin so. @param {string} beginning @returns {string[]} */
export function kept(beginning) {
  try {
    return Object.keys(localStorage).flatMap((key) => (key.startsWith(PREFIX + beginning) ? [key.slice(PREFIX.length)] : []));
  } catch {
    return [];
  }
}
