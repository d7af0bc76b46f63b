/** La solución desarrollada, en español. */
/** @type {Record<string, import("./index.js").Phrase>} */
export const solutionEs = {
  "solution.title": "Solución desarrollada",
  "solution.close": "Cerrar",
  "solution.segment": "Mostrar",
  "solution.all": "Toda la solución",
  "solution.theta": "Sustituir en θ",
  "solution.theta.free": "|v| máx.",
  "solution.follows": "en el cursor",
  "solution.latex": "Copiar LaTeX",
  "solution.latex.name": "LaTeX",
  "solution.markdown": "Copiar Markdown",
  "solution.markdown.name": "Markdown",
  "solution.print": "Imprimir",
  "solution.copied": "La solución está en el portapapeles como {what}.",
  "solution.uncopied": "El navegador no deja que la página escriba {what} en el portapapeles.",
};
