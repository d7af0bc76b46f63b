/** The worked solution, in English. */
/** @type {Record<string, import("./index.js").Phrase>} */
export const solutionEn = {
  "solution.title": "Worked solution",
  "solution.close": "Close",
  "solution.segment": "Show",
  "solution.all": "The whole solution",
  "solution.theta": "Numbers at θ",
  "solution.theta.free": "max |v|",
  "solution.follows": "at the cursor",
  "solution.latex": "Copy LaTeX",
  "solution.latex.name": "LaTeX",
  "solution.markdown": "Copy Markdown",
  "solution.markdown.name": "Markdown",
  "solution.print": "Print",
  "solution.copied": "The solution is on the clipboard as {what}.",
  "solution.uncopied": "The browser does not let the page write {what} to the clipboard.",
};
