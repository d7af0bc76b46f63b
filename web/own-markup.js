/** Text that LevaLab wrote itself and escaped itself, read as a document: nothing else may pass through here. */

/** @type {{ createHTML(text: string): string } | undefined} */
const policy = trustedPolicy();

function trustedPolicy() {
  /** @type {{ createPolicy(name: string, rules: { createHTML(text: string): string }): { createHTML(text: string): string } } | undefined} */
  const factory = Reflect.get(globalThis, "trustedTypes");
  return factory?.createPolicy("levalab-own", { createHTML: (text) => text });
}

/**
 * @param {string} text
 * @param {DOMParserSupportedType} type
 */
export function parseOwn(text, type) {
  return new DOMParser().parseFromString(policy ? policy.createHTML(text) : text, type);
}
