/** The look and the words of the editors of free laws and of their marks on the diagram: they come with them, so that a first visit does not load them. */
import { freeEn } from "./strings/free.en.js";
import { freeEs } from "./strings/free.es.js";
import { addStrings } from "./strings/index.js";

const SHEET = `
.parameters:has(.conditions) { padding-inline-start: 0.75rem; }
.conditions { flex: 1 0 100%; padding-block-end: var(--space-1); font-size: var(--size-small); }
.conditions .row { display: grid; grid-template-columns: 3.8rem repeat(4, minmax(0, 1fr)) 24px 24px; align-items: center; column-gap: 2px; }
.conditions .head { color: var(--muted); text-align: end; }
.conditions .head span { padding-inline-end: var(--space-1); }
.conditions .row input.number { min-block-size: max(24px, var(--row)); padding-inline: 3px; }
.conditions .row .error { grid-column: 1 / -1; padding-block-end: 3px; }
.conditions .row button { min-inline-size: 24px; min-block-size: 24px; padding: 0; border-color: transparent; background: none; color: var(--muted); }
.conditions .row button:hover { color: var(--ink); }
.conditions .foot { display: flex; align-items: center; justify-content: space-between; gap: var(--space-2); }
.conditions .foot .quiet { color: var(--accent); }
.conditions .hint { color: var(--muted); }
.parameters:has(.free-text) { padding-inline-start: 1.5rem; }
.free-text { flex: 1 0 100%; display: grid; gap: 2px; padding-block-end: var(--space-1); font-size: var(--size-small); }
.free-text label { color: var(--muted); }
.free-text :is(input, textarea) { inline-size: 100%; font-family: var(--font-math); font-size: var(--size); }
.free-text textarea { font-variant-numeric: tabular-nums; resize: vertical; }
.free-text .hint { color: var(--muted); }
.free-text .quiet { justify-self: start; color: var(--accent); }
.free-text .ask { display: flex; align-items: center; gap: 2px; }
.conditions .free-text { padding-block-start: 2px; }
.free-text details { color: var(--muted); }
.free-text summary { cursor: pointer; }
.free-text .residuals { max-block-size: 11em; overflow: auto; scrollbar-width: thin; }
.free-text .residuals table { inline-size: 100%; border-collapse: collapse; font-variant-numeric: tabular-nums; }
.free-text .residuals :is(th, td) { padding: 0 var(--space-2); font-weight: 400; text-align: end; }
.free-text .residuals td { color: var(--ink); }
.free-text .residuals thead th { position: sticky; inset-block-start: 0; background: var(--paper); }
.diagram-marks { position: absolute; inset: 0; pointer-events: none; }
.diagram-marks[hidden] { display: none; }
.diagram-marks svg { position: absolute; inset: 0; inline-size: 100%; block-size: 100%; overflow: hidden; }
.mark-points { fill: var(--paper); stroke: var(--s); stroke-width: 1.5; }
.mark-sides { fill: none; stroke: var(--s); stroke-width: 1; stroke-dasharray: 2 3; }
.mark-handles > .mark-handle { position: absolute; inset-block-start: -12px; inset-inline-start: -12px; inline-size: 24px; block-size: 24px; min-inline-size: 0; min-block-size: 0; padding: 0; border: 0; border-radius: 50%; background: none; cursor: ns-resize; pointer-events: auto; touch-action: none; }
.mark-handle::before { content: ""; position: absolute; inset: 6px; border: 2px solid var(--s); border-radius: 50%; background: var(--paper); }
.mark-handle:is(:hover, :focus-visible)::before { background: var(--s); }
@media print { .diagram-marks { display: none; } }
`;

let dressed = false;

/** Puts them on, once. */
export function dress() {
  if (dressed) return;
  dressed = true;
  addStrings({ en: freeEn, es: freeEs });
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(SHEET);
  document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
}
