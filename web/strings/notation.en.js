/** The choice of a notation, in English. */
/** @type {Record<string, import("./index.js").Phrase>} */
export const notationEn = {
  "edit.notation": "notation",
  "notation.title": "Symbols of",
  "notation.levalab": "LevaLab: s v a j, L, e",
  "notation.norton": "Norton: s v a j, h, ε (+ eases the rise)",
  "notation.shigley": "Uicker, Pennock, Shigley: y y' y'' y''', R₀, ε",
  "notation.rothbart": "Rothbart: y y' y'' y''', h, α",
  "notation.cardona-clos": "Cardona, Clos: d d' d'' d'''",
  "notation.capitals": "Capitals: S V A J",
};
