/** The examples library, in English. */
/** @type {Record<string, import("./index.js").Phrase>} */
export const examplesEn = {
  "examples.title": "Examples",
  "examples.close": "Close",
  "examples.classic": "The twelve classic cams",
  "examples.solved": "Solved problems, with the slips of their printed solutions",
  "examples.more": "More kinds of cam",
  "examples.name.WEDGE": "Wedge",
  "examples.name.GROOVE": "Grooved cam",
  "examples.name.ARCS": "Seven arcs",
  "examples.level.acceptable": "acceptable",
  "examples.level.low-speed": "not for high speeds",
  "examples.level.unacceptable": "unacceptable",
  "examples.solution": "Open with its worked solution",
  "examples.solution.of": "Open {name} with its worked solution",
};
