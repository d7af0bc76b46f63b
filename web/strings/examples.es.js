/** La biblioteca de ejemplos, en español. */
/** @type {Record<string, import("./index.js").Phrase>} */
export const examplesEs = {
  "examples.title": "Ejemplos",
  "examples.close": "Cerrar",
  "examples.classic": "Las doce levas clásicas",
  "examples.solved": "Problemas resueltos, con las erratas de sus soluciones impresas",
  "examples.more": "Otras clases de leva",
  "examples.name.WEDGE": "Cuña",
  "examples.name.GROOVE": "Leva de ranura",
  "examples.name.ARCS": "Siete arcos",
  "examples.level.acceptable": "aceptable",
  "examples.level.low-speed": "no para altas velocidades",
  "examples.level.unacceptable": "inaceptable",
  "examples.solution": "Abrir con su solución desarrollada",
  "examples.solution.of": "Abrir {name} con su solución desarrollada",
};
