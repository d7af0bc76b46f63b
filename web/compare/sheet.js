/** The look of the comparison: it comes with it, so that a first visit does not load it. */

const SHEET = `
:root { --look-1: #ad1457; --look-2: #00757f; --look-3: #6d4c41; --look-4: #6b6a00; --look-5: #3949ab; --look-6: #50626c; }
@media screen {
  :root[data-theme="dark"] { --look-1: #f48fb1; --look-2: #4dd0e1; --look-3: #d7a98c; --look-4: #d4d85a; --look-5: #a5b0f0; --look-6: #b0bec5; }
}
@media screen and (forced-colors: active) {
  :root:not([data-paper]) { --look-1: LinkText; --look-2: LinkText; --look-3: LinkText; --look-4: GrayText; --look-5: GrayText; --look-6: GrayText; }
}
.compare-legend { display: flex; flex-wrap: wrap; gap: 0 var(--space-4); padding-block: var(--space-1); font-size: var(--size-small); max-block-size: 5.2em; overflow: auto; scrollbar-width: thin; }
.compare-legend li { display: flex; align-items: center; gap: var(--space-1); max-inline-size: 100%; }
.compare-legend li > span { overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
.compare-sample { flex: none; inline-size: 42px; block-size: 8px; fill: none; stroke-width: calc(var(--stroke) * 1.2px); }
#compare { inline-size: min(98vw, 96rem); max-inline-size: none; max-block-size: 94dvh; margin-block-start: 3dvh; padding: var(--space-4); overflow: hidden; }
#compare[open] { display: flex; flex-direction: column; gap: var(--space-2); }
#compare section:not([hidden]) { display: flex; flex-direction: column; gap: var(--space-2); min-block-size: 0; }
.compare-head { display: flex; flex-wrap: wrap; align-items: center; gap: var(--space-2) var(--space-4); }
.compare-head h2 { margin: 0; }
.compare-close { margin-inline-start: auto; }
#compare > .compare-status { min-block-size: 1.4em; margin: 0; color: var(--ink); }
#compare > .compare-status:empty { display: none; }
.compare-bar { display: flex; flex-wrap: wrap; gap: var(--space-2); }
.compare-add { border-color: var(--accent); background: none; color: var(--accent); }
.compare-empty { max-inline-size: 90ch; color: var(--muted); text-wrap: pretty; }
.compare-scroll { overflow: auto; min-block-size: 0; }
.compare-table { inline-size: 100%; border-collapse: collapse; white-space: nowrap; }
.compare-table thead th { position: sticky; inset-block-start: 0; z-index: 2; padding: var(--space-1) var(--space-2); background: var(--paper); color: var(--muted); font-size: var(--size-small); font-weight: 400; text-align: end; vertical-align: bottom; box-shadow: inset 0 -1px var(--line); }
.compare-table thead th:is(:first-child, .compare-judged, .compare-sized) { text-align: start; }
.compare-table thead button { min-inline-size: 0; padding: 0 var(--space-1); color: inherit; font-size: inherit; }
.compare-table [aria-sort]:not([aria-sort="none"]) { color: var(--ink); font-weight: 600; }
.compare-arrow { display: inline-block; inline-size: 1.3em; font-size: 0.8em; text-align: center; }
.compare-table td { padding: var(--space-1) var(--space-2); text-align: end; }
.compare-table tbody :is(th, td) { vertical-align: middle; }
.compare-line { display: block; }
td .compare-line + .compare-line { color: var(--muted); }
td .compare-line:only-child { color: inherit; }
.compare-table tbody :is(th, td) { border-block-end: 1px solid var(--grid); }
.compare-table .compare-name { position: sticky; inset-inline-start: 0; z-index: 1; padding: var(--space-1) var(--space-2) var(--space-1) 0; background: var(--paper); font-weight: 400; text-align: start; }
.compare-table thead th:first-child { inset-inline-start: 0; z-index: 3; padding-inline-start: 0; }
.compare-name > span { display: inline-flex; align-items: center; gap: var(--space-2); }
.compare-name input[type="text"] { inline-size: 13em; field-sizing: content; min-inline-size: 7em; max-inline-size: 18em; }
.compare-name > .compare-current { margin-inline-end: var(--space-1); padding: 0 0.4em; border: 1px solid var(--line); border-radius: var(--radius); color: var(--muted); font-size: var(--size-small); }
.compare-own .compare-name { font-weight: 600; }
.compare-table td:is(.compare-geometry, .compare-do), .compare-table td:has(.compare-verdict) { text-align: start; }
.compare-geometry span { display: block; }
.compare-geometry span + span { color: var(--muted); }
.compare-actions { gap: 2px; }
.compare-actions button { min-inline-size: var(--row); color: var(--accent); }
.compare-name > .compare-actions { display: flex; margin-block-start: 1px; gap: 2px; }
[data-projector] .compare-table { font-size: 0.82em; }
.compare-letter { white-space: nowrap; }
.compare-verdict { display: inline-flex; align-items: center; vertical-align: middle; gap: 0.4em; }
.compare-verdict .light { inline-size: 1.2rem; block-size: 1.2rem; flex: none; }
.compare-verdict .mark { fill: none; stroke: var(--paper); stroke-width: 2.5; stroke-linecap: round; stroke-linejoin: round; }
.compare-verdict[data-level="acceptable"] { color: var(--good); }
.compare-verdict[data-level="low-speed"] { color: var(--low); }
.compare-verdict[data-level="unacceptable"] { color: var(--bad); }
.compare-verdict .shape { fill: currentcolor; }
.compare-laws .thumbnail { flex: none; inline-size: 34px; block-size: 18px; fill: none; stroke: var(--a); stroke-width: 1.5; }
.compare-laws .thumbnail .zero { stroke: var(--grid); stroke-width: 1; }
button[data-count]::after { content: attr(data-count) / ""; margin-inline-start: 0.4em; padding: 0 0.45em; border-radius: 1em; background: var(--accent); color: var(--on-accent); font-size: var(--size-small); }
@media screen and (max-width: 720px) {
  .compare-name > .compare-current { display: block; inline-size: fit-content; margin-block-end: var(--space-1); }
  #compare { inline-size: 100vw; max-block-size: 100dvh; block-size: 100dvh; margin: 0; padding: var(--space-3); border: 0; border-radius: 0; }
  .compare-name input[type="text"] { inline-size: 8em; field-sizing: fixed; }
  .compare-table .compare-name { max-inline-size: 62vw; white-space: normal; }
}
@media print { #compare { display: none !important; } }
`;

/** Puts it on, once. */
export function wear() {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(SHEET);
  document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
}
