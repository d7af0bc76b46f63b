/**
 * What a free law is made from, edited beneath its segment; loaded when the first such law is met.
 *
 * @import { LawEntry, ShellContext, State } from "./types.d.ts"
 */
import { createConditionTable } from "./condition-table.js";
import { createFormulaField, createOrdinatesField, createTableField } from "./free-text.js";
import { addStrings } from "./strings/index.js";
import { freeEn } from "./strings/free.en.js";
import { freeEs } from "./strings/free.es.js";

addStrings({ en: freeEn, es: freeEs });

/**
 * @typedef {object} FreeEditor
 * @property {HTMLElement} root
 * @property {(state: Readonly<State>) => void} update
 * @property {() => void} speak      words again, after a change of language or place
 * @property {() => void} reset      forgets what could not be read
 * @property {() => string[]} paths  places of the design whose errors it tells by itself
 */

/** @type {Record<string, (context: ShellContext, place: { id: string, index: () => number }) => FreeEditor>} */
const EDITORS = { conditions: createConditionTable, points: createTableField, ordinates: createOrdinatesField, expression: createFormulaField };

/**
 * @param {ShellContext} context
 * @param {LawEntry} law
 * @param {{ id: string, index: () => number }} place
 * @returns {FreeEditor}
 */
export function createFreeEditor(context, law, place) {
  const editor = EDITORS[law.free?.key ?? ""];
  if (!editor) throw new Error(`no editor for ${law.id}`);
  return editor(context, place);
}
