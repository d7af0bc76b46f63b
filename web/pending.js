/**
 * Fields of the design that hold what is no number yet. While there is one, the root is marked, and the style sheet dims what is drawn
 * of the last good design. A rule of the style sheet that looked for such fields by itself (`:has()`) would be asked again, and all of
 * the page restyled, whenever a text is written anywhere.
 */

/**
 * Notes on a field whether it waits for the rest of its number.
 * @param {HTMLInputElement} input
 * @param {boolean} waits
 */
export function notePending(input, waits) {
  if (input.hasAttribute("data-pending") === waits) return;
  input.toggleAttribute("data-pending", waits);
  markPending();
}

/** Marks the root as its fields are: also when a field has come or gone with its row. */
export function markPending() {
  document.documentElement.toggleAttribute("data-pending", document.querySelector("#design input[data-pending]") !== null);
}
