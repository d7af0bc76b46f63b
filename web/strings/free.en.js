/** The editors of free laws, in English. */
/** @type {Record<string, import("./index.js").Phrase>} */
export const freeEn = {
  "edit.condition": "condition of a polynomial",
  "conditions.title": "Conditions of segment {number}",
  "conditions.at": "place {at} of segment {number}",
  "conditions.value": "{sign} at {at} of segment {number}",
  "conditions.add": "Add a point",
  "conditions.remove": "Remove the place at {at}",
  "conditions.inherit.before": "Take s, v and a from the segment before; once more, j too",
  "conditions.inherit.after": "Take s, v and a from the segment after; once more, j too",
  "conditions.degree": { one: "{count} condition: a constant", other: "{count} conditions, degree {degree}" },
};
