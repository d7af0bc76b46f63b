/** The question that another unit is, in Spanish. */
/** @type {Record<string, import("./index.js").Phrase>} */
export const unitsEs = {
  "edit.convert": "conversión a {unit}",
  "edit.relabel": "números ahora en {unit}",
  "unit.question": "De {from} a {to}:",
  "unit.convert.cam": "La misma leva: {before} = {after}",
  "unit.convert.speed": "La misma velocidad: {before} = {after}",
  "unit.relabel": "Los mismos números: {before} → {after}",
  "unit.cancel": "Dejar {unit}",
  "unit.refused": "No se puede convertir: {reason}",
};
