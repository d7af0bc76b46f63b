/** The sentence for a page that cannot start: what is missing, and what the reader can do about it. */
import { MissingModule, forbidden } from "./missing-module.js";

/**
 * The key of the sentence and its values.
 * @param {unknown} error
 * @returns {[key: string, values: Record<string, string>]}
 */
export function whyNotStarted(error) {
  const reason = error instanceof Error ? error.message : String(error);
  if (!("WebAssembly" in globalThis)) return ["start.browser", {}];
  if (forbidden(error)) return ["start.policy", {}];
  if (error instanceof MissingModule) return [`start.${error.kind}`, { reason }];
  return ["start.other", { reason }];
}
