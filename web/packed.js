/** How this page came here: as files from a server, packed or straight from the checkout, or as a single file. */

/** Packed for a server: it can be kept for use without the network. */
export const hasWorker = () => document.documentElement.dataset["packed"] === "site" && "serviceWorker" in navigator;

/** A single file, often opened from disk: nothing can be loaded when it is first asked for. */
export const isSingleFile = () => document.documentElement.dataset["packed"] === "file";
