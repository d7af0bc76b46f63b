/** What the single file carries as text within itself, since a page on disk may load nothing. */

/** @param {string} id  of the script that holds it in base 64 */
export function inlined(id) {
  const text = atob(document.getElementById(id)?.textContent ?? "");
  const bytes = new Uint8Array(text.length);
  // A plain loop: `Uint8Array.from` with a function takes twenty times as long.
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return bytes;
}
