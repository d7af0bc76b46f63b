/**
 * The data of a free law, edited beneath its segment.
 *
 * @import { FreeEditor } from "./free-parts.js"
 * @import { LawEntry, ShellContext } from "./types.d.ts"
 */
import { createConditionTable } from "./condition-table.js";
import { createFormulaField, createOrdinatesField, createTableField } from "./free-text.js";

/** @type {Record<string, (context: ShellContext, place: { id: string, index: () => number }, law: LawEntry) => FreeEditor>} */
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
  return editor(context, place, law);
}
