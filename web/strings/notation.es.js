/** The choice of a notation, in Spanish. */
/** @type {Record<string, import("./index.js").Phrase>} */
export const notationEs = {
  "edit.notation": "notación",
  "notation.title": "Símbolos de",
  "notation.levalab": "LevaLab: s v a j, L, e",
  "notation.norton": "Norton: s v a j, h, ε (+ alivia la subida)",
  "notation.shigley": "Uicker, Pennock, Shigley: y y' y'' y''', R₀, ε",
  "notation.rothbart": "Rothbart: y y' y'' y''', h, α",
  "notation.cardona-clos": "Cardona, Clos: d d' d'' d'''",
  "notation.capitals": "Mayúsculas: S V A J",
};
