/** The look of the panel: it comes with it, so that a first visit does not load it. */

const SHEET = `
:root { --output: #006a73; --output-2: #8a3d00; }
@media screen { :root[data-theme="dark"] { --output: #5cc9d3; --output-2: #f0a868; } }
@media screen and (forced-colors: active) { :root:not([data-paper]) { --output: CanvasText; --output-2: CanvasText; } }
#application-button { align-self: start; margin-block-start: var(--space-2); color: var(--accent); }
#application { grid-area: diagrams-start / diagrams-start / readouts-end / diagrams-end; position: relative; z-index: 2; display: flex; flex-direction: column; gap: var(--space-3); padding: var(--space-2) var(--space-4) var(--space-3) var(--space-3); overflow: hidden auto; scrollbar-width: thin; background: var(--paper); border-inline-start: 1px solid var(--grid); }
#application[hidden], #application [hidden] { display: none; }
[data-projector] #application { grid-area: diagrams; }
.application-head { display: flex; align-items: baseline; gap: var(--space-3); }
.application-head h2 { font-size: var(--size-large); }
.application-head button { margin-inline-start: auto; }
#application p { max-inline-size: 78ch; color: var(--muted); font-size: var(--size-small); text-wrap: pretty; }
#application p.error { color: var(--bad); }
.application-fields { display: grid; grid-template-columns: minmax(0, 1fr) auto 5.5rem minmax(4.5em, auto); align-items: center; gap: var(--space-1) var(--space-2); }
.application-fields select { grid-column: 2 / -1; max-inline-size: 100%; }
.application-fields .error { grid-column: 1 / -1; }
.application-fields .unit { color: var(--muted); font-size: var(--size-small); }
.application-fields .application-name { min-inline-size: 0; }
.application-figures { display: flex; flex-wrap: wrap; gap: 0 var(--space-4); font-size: var(--size-small); }
.application-plots { position: relative; display: flex; flex: none; flex-direction: column; gap: var(--space-1); padding-block-end: var(--flag, 0); }
.application-plots figcaption { display: flex; flex-wrap: wrap; align-items: baseline; gap: 0 0.5em; color: var(--muted); font-size: var(--size-small); }
.application-plots .symbol, .application-plots output { color: var(--curve); font-weight: 600; }
.application-plots figcaption > .symbol { font-size: 1.45em; }
.application-plots output { margin-inline-start: auto; font-size: 1.15em; white-space: nowrap; }
.application-plots figcaption .application-extremes { flex-basis: 100%; }
.application-bar { display: flex; flex-wrap: wrap; align-items: center; justify-content: space-between; gap: var(--space-2); }
.application-targets { display: grid; grid-template-columns: minmax(8.5rem, 10rem) minmax(0, 1fr); gap: var(--space-1) var(--space-3); padding: 0; }
.application-targets > :is(legend, .error, .hint, .application-of, .application-worst) { grid-column: 1 / -1; }
.application-targets legend { font-weight: 600; }
.application-of { display: flex; flex-wrap: wrap; align-items: center; gap: 0 var(--space-3); }
.application-of label { display: flex; align-items: center; gap: var(--space-1); color: var(--muted); font-size: var(--size-small); }
.application-targets textarea { inline-size: 100%; min-block-size: 8.5em; padding: var(--space-1) var(--space-2); border: 1px solid var(--grid); border-radius: var(--radius); background: var(--field); color: inherit; font: inherit; font-variant-numeric: tabular-nums; resize: vertical; }
.application-targets textarea[aria-invalid="true"] { border-color: var(--bad); background: var(--bad-soft); }
.application-scroll { overflow: auto; max-block-size: 20rem; }
.application-errors { inline-size: 100%; border-collapse: collapse; font-size: var(--size-small); white-space: nowrap; }
.application-errors :is(th, td) { padding: 0 0 0 var(--space-2); border-block-end: 1px solid var(--grid); font-weight: 400; text-align: end; }
.application-errors thead th { position: sticky; inset-block-start: 0; background: var(--paper); color: var(--muted); }
.application-errors tbody th { padding: 0; }
.application-errors button { min-inline-size: 24px; min-block-size: 24px; padding: 0 var(--space-1); background: none; color: var(--accent); }
#application .application-worst { color: var(--ink); }
@media screen and (max-width: 1080px) {
  :root:not([data-projector]) #application { position: fixed; inset: 0; z-index: 5; padding: var(--space-3); border: 0; }
}
@media screen and (max-width: 720px) {
  .application-targets { grid-template-columns: minmax(0, 1fr); }
  .application-fields { grid-template-columns: minmax(0, 1fr) auto 6rem minmax(4em, auto); }
  .application-fields select { grid-column: 1 / -1; }
}
@media print { #application { display: none !important; } }
`;

/** Puts it on, once. */
export function wear() {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(SHEET);
  document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
}
