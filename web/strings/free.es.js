/** Los editores de las leyes libres, en español. */
/** @type {Record<string, import("./index.js").Phrase>} */
export const freeEs = {
  "edit.condition": "condición de un polinomio",
  "conditions.title": "Condiciones del tramo {number}",
  "conditions.at": "lugar {at} del tramo {number}",
  "conditions.value": "{sign} en {at} del tramo {number}",
  "conditions.add": "Añadir un punto",
  "conditions.remove": "Quitar el lugar en {at}",
  "conditions.inherit.before": "Tomar s, v y a del tramo anterior; otra vez, también j",
  "conditions.inherit.after": "Tomar s, v y a del tramo siguiente; otra vez, también j",
  "conditions.degree": { one: "{count} condición: una constante", other: "{count} condiciones, grado {degree}" },
};
