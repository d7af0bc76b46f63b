/** How this page came here: as files from a server, packed or straight from the checkout, or as a single file. */

/**
 * Packed, and from a server: it can be kept for use without the network. A page from disk cannot, nor one in a frame that denies it an
 * origin of its own.
 */
export function hasWorker() {
  const possible = location.protocol.startsWith("http") && globalThis.origin !== "null" && "serviceWorker" in navigator;
  return possible && "packed" in document.documentElement.dataset;
}

/** A single file, often opened from disk: nothing can be loaded when it is first asked for. */
export const isSingleFile = () => document.documentElement.dataset["packed"] === "file";
