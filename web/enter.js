/** Enter in a field, as in a form: without one, since a frame of another page may forbid forms to do anything. */

/**
 * Presses the button when Enter is pressed in one of the fields; Escape and Tab stay with the browser.
 * @param {HTMLElement} fields  the element that holds them
 * @param {HTMLButtonElement} button
 */
export function pressOnEnter(fields, button) {
  fields.addEventListener("keydown", (event) => {
    const field = event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement;
    if (!field || event.key !== "Enter" || event.isComposing) return;
    event.preventDefault();
    button.click();
  });
}
