/** Where the calculation comes from in the single-file page: text in the page itself, since a page on disk may load nothing. */
import { freshGlue } from "levalab:glue";

/** @returns {Promise<WebAssembly.Module>} */
export function compile() {
  const text = atob(document.getElementById("levalab-module")?.textContent ?? "");
  const bytes = new Uint8Array(text.length);
  // A plain loop: `Uint8Array.from` with a function takes twenty times as long.
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return WebAssembly.compile(bytes);
}

export const glue = async () => freshGlue();
