/** The look of the solution, on screen and on paper: it comes with it, so that a first visit does not load it. */

const SHEET = `
body { --solution-width: min(50rem, 60vw); }
#solution { position: fixed; inset: var(--solution-top, 0) 0 0 auto; z-index: 20; inline-size: var(--solution-width); block-size: auto; max-inline-size: none; max-block-size: none; margin: 0; padding: 0; border-width: 0 0 0 1px; border-radius: 0; overflow: hidden; }
#solution[open] { display: flex; flex-direction: column; }
.solution-head { display: flex; align-items: center; justify-content: space-between; padding: var(--space-3) var(--space-5) 0; }
.solution-head h2 { margin: 0; }
.solution-bar { display: flex; flex-wrap: wrap; align-items: center; gap: var(--space-2) var(--space-4); padding: var(--space-2) var(--space-5); }
.solution-field { display: inline-flex; align-items: center; gap: var(--space-2); }
.solution-field select { max-inline-size: 15rem; }
#solution-theta { inline-size: 9.5rem; }
.solution-do { gap: var(--space-1); margin-inline-start: -0.5rem; }
#solution > .error { padding-inline: var(--space-5); }
#solution > .error:empty { display: none; }
#solution > .solution { flex: 1; min-block-size: 0; padding: 0 var(--space-5) var(--space-5); border-block-start: 1px solid var(--grid); overflow: auto; }
.solution { line-height: 1.5; text-wrap: pretty; }
.solution h3 { margin: 1.6em 0 0.4em; font-size: 1.2em; }
.solution h4 { margin: 1.4em 0 0.4em; font-size: 1em; }
.solution p { margin: 0.5em 0; max-inline-size: 75ch; }
.solution ul { margin: 0.5em 0; padding-inline-start: 1.3em; list-style: disc; }
.solution li + li { margin-block-start: 0.4em; }
.solution math { font-family: "STIX Two Math", "Cambria Math", "Latin Modern Math", "Libertinus Math", var(--font-math); font-size: 1.08em; }
.solution .formula { display: flex; flex-wrap: wrap; align-items: center; gap: 0.35em 1.8em; margin: 0.5em 0; padding: 0.15em 0 0.15em 1.5em; overflow-x: auto; overflow-y: hidden; }
.solution .formula math { flex: none; margin: 0; }
.solution .cells { margin: 0.75em 0; overflow-x: auto; }
.solution table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
.solution caption { color: var(--muted); text-align: start; }
.solution :is(th, td) { padding: 0.2em 1.2em 0.2em 0; border-block-end: 1px solid var(--grid); text-align: start; white-space: nowrap; }
.solution th { color: var(--muted); font-weight: 400; }
.solution mtable.lines > mtr > mtd { padding-inline: 0; text-align: start; }
.solution mtable.lines > mtr > mtd:first-child { padding-inline-end: 0.25em; text-align: end; }
.on-paper { display: none; }
@media screen and (max-width: 900px) {
  #solution { inset: 0; inline-size: auto; border-width: 0; }
  .solution-head, .solution-bar, #solution > .solution, #solution > .error { padding-inline: var(--space-3); }
  .solution .formula { padding-inline-start: 0; }
  .solution-bar { gap: 0 var(--space-3); padding-block: 0; }
  #solution-theta { inline-size: 6.5rem; }
  .solution-do button { min-inline-size: 0; }
}
/* The cam and its verdict step aside; so do the diagrams where there is room for three, and the cam alone where there is room for two. */
@media screen and (min-width: 901px) {
  body:has(> #solution[open]) main { margin-inline-end: var(--solution-width); }
}
@media screen and (min-width: 901px) and (max-width: 1799px) {
  body:has(> #solution[open]) main { grid-template: "design mechanism" minmax(0, 1fr) "design transport" auto "verdict verdict" auto / var(--design) minmax(0, 1fr); }
  body:has(> #solution[open]) #verdict { grid-template-columns: minmax(0, 1fr); block-size: auto; max-block-size: 40dvh; }
  body:has(> #solution[open]) .figures { justify-content: start; padding-inline-start: calc(1.7rem + var(--space-2)); }
  body:has(> #solution[open]) .transport-track { min-inline-size: 2.5rem; }
  body:has(> #solution[open]) .transport-angle { inline-size: 4.4em; }
  body:has(> #solution[open]) .transport-rate { flex-wrap: wrap; }
  body:has(> #solution[open]) .transport-wheel-track { flex: 1 1 0; }
  body:has(> #solution[open]) .transport-pace { flex: 1 0 100%; text-align: start; }
  [data-projector] body:has(> #solution[open]) main { grid-template: "mechanism" minmax(0, 1fr) "transport" auto "verdict" auto / minmax(0, 1fr); }
  body:has(> #solution[open]) :is(#diagrams, #readouts) { display: none; }
}
@media screen and (min-width: 901px) and (max-width: 1340px) {
  :root:not([data-projector]) body:has(> #solution[open]) { block-size: 100dvh; min-block-size: 0; overflow: hidden; }
  body:has(> #solution[open]) main { grid-template: "mechanism" minmax(0, 1fr) "transport" auto "verdict" auto / minmax(0, 1fr); }
  body:has(> #solution[open]) #design { display: none; }
}
@media print {
  @page { size: A4 portrait; margin: 15mm; }
  html:has(> body > .on-paper) { font-size: 10pt; }
  body:has(> .on-paper) { display: block; margin: 0; padding: 0; block-size: auto; min-block-size: 0; }
  body:has(> .on-paper) > :not(.on-paper) { display: none !important; }
  .on-paper { display: block; color: #000000; font: 10pt/1.45 var(--font); }
  .on-paper h1 { margin: 0 0 0.5em; font-size: 16pt; }
  .on-paper :is(h3, h4, :is(h3, h4) + p, p:has(+ :is(.formula, .cells)), caption, thead, tr:nth-child(-n + 2), tr:nth-last-child(2)) { break-after: avoid; }
  .on-paper :is(caption, th) { color: #404040; }
  .on-paper :is(th, td) { border-color: #c0c0c0; padding-block: 0.1em; }
  .on-paper :is(.formula, .short, tr, li) { break-inside: avoid; }
  .on-paper :is(.formula, .cells) { overflow: visible; }
  .on-paper .formula { margin-block: 0.35em; }
  .on-paper .wide { font-size: 80%; }
}
`;

/** Puts it on, once. */
export function wear() {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(SHEET);
  document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
}
