/** The sentence for a page that cannot start: what is missing, and what the reader can do about it. */
import { MissingModule, forbidden } from "./missing-module.js";
import { isSingleFile } from "./packed.js";

/**
 * The key of the sentence, and its values in the language on screen.
 * @param {unknown} error
 * @param {import("./types.d.ts").Translate} t
 * @returns {[key: string, values: () => Record<string, string>]}
 */
export function whyNotStarted(error, t) {
  const reason = error instanceof Error ? error.message : String(error);
  return [keyFor(error), () => ({ reason, remedy: isSingleFile() ? "" : t("start.single") })];
}

/** @param {unknown} error */
function keyFor(error) {
  if (!("WebAssembly" in globalThis)) return "start.browser";
  if (forbidden(error)) return "start.policy";
  return error instanceof MissingModule ? `start.${error.kind}` : "start.other";
}
