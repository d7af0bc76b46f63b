/**
 * What the editors of free laws share: how one is put together from its fields, and how it speaks and forgets.
 *
 * @import { ShellContext, State } from "./types.d.ts"
 */

/**
 * A field of an editor, of a number or of a text.
 * @typedef {object} Field
 * @property {HTMLElement} error
 * @property {(state: Readonly<State>) => void} update
 * @property {() => void} speak
 * @property {() => void} reset
 */

/**
 * @typedef {object} FreeEditor
 * @property {HTMLElement} root
 * @property {(state: Readonly<State>) => void} update
 * @property {() => void} speak      words again, after a change of language or place
 * @property {() => void} reset      forgets what could not be read
 * @property {() => string[]} paths  places of the design whose errors it tells by itself
 */

/**
 * An editor of fields that come and go.
 * @param {ShellContext} context
 * @param {object} parts
 * @param {HTMLElement} parts.root
 * @param {() => readonly Field[]} parts.fields
 * @param {() => void} parts.word                            its own words
 * @param {(state: Readonly<State>) => void} [parts.arrange] before its fields follow the design
 * @param {(state: Readonly<State>) => void} [parts.follow]  after they did
 * @param {() => string[]} parts.paths
 * @returns {FreeEditor}
 */
export function assemble({ store }, { root, fields, word, arrange, follow, paths }) {
  /** @param {Readonly<State>} state */
  function update(state) {
    arrange?.(state);
    for (const field of fields()) field.update(state);
    follow?.(state);
  }

  function speak() {
    word();
    for (const field of fields()) field.speak();
    update(store.state);
  }

  speak();
  return {
    root,
    update,
    speak,
    reset() {
      for (const field of fields()) field.reset();
    },
    paths,
  };
}
