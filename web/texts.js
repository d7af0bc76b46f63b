/**
 * Texts that follow the language: each is written once with its key, and again when the language changes.
 *
 * @import { Translate } from "./types.d.ts"
 */

/** @typedef {() => Record<string, string | number>} Values */

/** @param {Translate} t */
export function createTexts(t) {
  /** @type {(() => void)[]} */
  const writers = [];

  /** @param {() => void} write */
  function add(write) {
    writers.push(write);
    write();
  }

  return {
    /**
     * @template {Element} Node
     * @param {Node} node
     * @param {string} key
     * @param {Values} [values]
     */
    text(node, key, values) {
      add(() => (node.textContent = t(key, values?.())));
      return node;
    },

    /**
     * @template {Element} Node
     * @param {Node} node
     * @param {string} attribute
     * @param {string} key
     * @param {Values} [values]
     */
    attribute(node, attribute, key, values) {
      add(() => node.setAttribute(attribute, t(key, values?.())));
      return node;
    },

    /** Anything else that is made of words. */
    also: add,

    refresh() {
      for (const write of writers) write();
    },
  };
}

/** @typedef {ReturnType<typeof createTexts>} Texts */
