/** The question that another unit is, in English. */
/** @type {Record<string, import("./index.js").Phrase>} */
export const unitsEn = {
  "edit.convert": "conversion to {unit}",
  "edit.relabel": "numbers now in {unit}",
  "unit.question": "From {from} to {to}:",
  "unit.convert.cam": "Same cam: {before} = {after}",
  "unit.convert.speed": "Same speed: {before} = {after}",
  "unit.relabel": "Same numbers: {before} → {after}",
  "unit.cancel": "Keep {unit}",
  "unit.refused": "It cannot be converted: {reason}",
};
