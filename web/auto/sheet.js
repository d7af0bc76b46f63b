/** The look of Auto: it comes with it, so that a first visit does not load it. */

const SHEET = `
#auto { inline-size: min(68rem, 100vw - 2rem); max-inline-size: none; max-block-size: 96dvh; margin-block-start: 2dvh; padding: var(--space-4) var(--space-5); overflow: auto; }
#auto h2 { margin-block-end: var(--space-1); }
#auto > p { margin-block: 0 var(--space-2); }
#auto .auto-tools { display: flex; flex-wrap: wrap; align-items: center; gap: var(--space-1) var(--space-3); }
#auto .auto-tools label > span::before { content: ""; display: inline-block; inline-size: 18px; block-size: 12px; margin-inline-end: 0.45em; vertical-align: -1px; background: radial-gradient(circle closest-side, currentcolor 95%, transparent) left / 6px 100% no-repeat, radial-gradient(circle closest-side, currentcolor 95%, transparent) right / 6px 100% no-repeat, linear-gradient(currentcolor, currentcolor) center / 12px 2px no-repeat; }
#auto .auto-tools label:nth-of-type(2) > span::before { rotate: -32deg; }
#auto .auto-tools label:nth-of-type(3) > span::before { background: radial-gradient(circle closest-side, currentcolor 95%, transparent) center / 8px 100% no-repeat; }
#auto .auto-history { display: flex; }
#auto .auto-history button { display: grid; place-items: center; min-inline-size: var(--row); padding: 0; }
#auto .auto-said { flex: 1 1 13rem; min-block-size: 1.4em; margin: 0; color: var(--muted); font-variant-numeric: tabular-nums; }
#auto .auto-said.telling { color: var(--ink); }
#auto .auto-plot { position: relative; margin-block-start: var(--space-2); }
#auto canvas { display: block; inline-size: 100%; block-size: clamp(11rem, 34dvh, 24rem); }
#auto .auto-layer { position: absolute; inset: var(--top, 0) auto auto var(--left, 0); inline-size: var(--width, 0); block-size: var(--height, 0); cursor: crosshair; outline-offset: 2px; touch-action: none; }
#auto .held .auto-layer { cursor: grabbing; }
#auto .auto-demand { display: contents; --tint: var(--accent); }
#auto .auto-demand.wrong { --tint: var(--bad); }
#auto .auto-demand[hidden] { display: none; }
#auto .auto-layer button { position: absolute; inset: 0 auto auto 0; min-inline-size: 24px; min-block-size: 24px; padding: 0; border: 0; border-radius: 12px; background: none; touch-action: none; translate: var(--x) var(--y); }
#auto .auto-layer button[hidden], #auto .auto-tangent[hidden] { display: none; }
#auto .auto-layer button::before { content: ""; position: absolute; border: 2px solid var(--tint); background: var(--paper); }
#auto .auto-whole { --long: calc(hypot(var(--dx), var(--dy)) * 1px); inline-size: var(--long); block-size: 24px; margin: -12px calc(max(24px, var(--long)) / -2); rotate: atan2(var(--dy), var(--dx)); cursor: grab; }
#auto .auto-layer .auto-whole::before { inset: 9px calc((100% - var(--long)) / 2); border: 0; border-radius: 3px; background: var(--tint); }
#auto [data-kind="point"] .auto-whole { inline-size: 24px; rotate: none; }
#auto .auto-layer [data-kind="point"] .auto-whole::before { inset: 5px; border: 2px solid var(--paper); border-radius: 50%; background: var(--tint); box-shadow: 0 0 0 2px var(--tint); }
#auto :is(.auto-from, .auto-to, .auto-slope) { inline-size: 24px; block-size: 24px; }
#auto .auto-slope { margin: -12px; cursor: move; }
#auto .auto-layer .auto-slope::before { inset: 7px; border-radius: 50%; }
#auto .auto-demand:not(.lit) > .auto-slope, #auto [data-free]:not(.lit) > .auto-tangent { visibility: hidden; }
#auto [data-free] > .auto-tangent { background: repeating-linear-gradient(90deg, var(--tint) 0 3px, transparent 3px 6px); }
#auto .auto-from { margin: -12px -18px; }
#auto .auto-to { margin: -12px -6px; }
#auto [data-kind="dwell"] :is(.auto-from, .auto-to) { cursor: ew-resize; }
#auto [data-kind="line"] :is(.auto-from, .auto-to) { cursor: move; }
#auto .auto-layer :is(.auto-from, .auto-to)::before { inset: 6px auto auto 12px; inline-size: 12px; block-size: 12px; box-sizing: border-box; border-radius: 50%; }
#auto .auto-layer .auto-to::before { inset-inline-start: 0; }
#auto .lit > :is(.auto-from, .auto-to)::before { background: var(--tint); }
#auto .auto-layer button:focus-visible { outline: 2px solid var(--focus); outline-offset: -1px; }
#auto .auto-tangent { position: absolute; inset: 0 auto auto 0; inline-size: var(--long); block-size: 2px; margin: -1px calc(var(--long) / -2); background: var(--tint); translate: var(--x) var(--y); rotate: atan2(var(--dy), var(--dx)); pointer-events: none; }
#auto .auto-problem { min-block-size: 1.3em; margin-block: var(--space-1); }
#auto .auto-problem.error { color: var(--bad); }
#auto .auto-halves { display: grid; grid-template-columns: minmax(0, 32rem) minmax(0, 1fr); gap: var(--space-2) var(--space-4); align-items: start; }
#auto .auto-row { display: grid; grid-template-columns: 1.2rem minmax(8.2rem, 1fr) repeat(4, minmax(3rem, 4.2rem)) 28px; align-items: center; gap: 2px var(--space-1); padding: 2px var(--space-1); border-radius: var(--radius); }
#auto .auto-row.lit { background: var(--hover); }
#auto .auto-row.lit select { background-color: var(--paper); }
#auto .auto-head { color: var(--muted); font-size: var(--size-small); text-align: end; }
#auto .auto-row input { min-inline-size: 0; }
#auto .auto-row button { min-inline-size: 24px; min-block-size: 24px; padding: 0; border-color: transparent; background: none; color: var(--muted); }
#auto .auto-row.wrong { background: color-mix(in srgb, var(--bad) 12%, transparent); }
#auto .auto-bar { display: flex; flex-wrap: wrap; align-items: center; gap: var(--space-1) var(--space-4); margin-block: var(--space-1); }
#auto .auto-bar .quiet { color: var(--accent); }
#auto .auto-bar .quiet:disabled { color: var(--muted); }
#auto .auto-bar span:has(input) { display: flex; align-items: baseline; gap: var(--space-2); }
#auto .auto-why { display: grid; gap: var(--space-1); margin-block: var(--space-2); padding-inline-start: 1.2rem; list-style: disc; font-size: var(--size-small); }
#auto .primary { border-color: var(--accent); background: var(--accent); color: var(--on-accent); }
#auto .primary:disabled { border-color: var(--line); background: none; color: var(--muted); }
#auto .auto-foot { position: sticky; z-index: 1; inset-block-end: calc(-1 * var(--space-4)); display: flex; justify-content: end; gap: var(--space-2); margin-block: var(--space-2) calc(-1 * var(--space-4)); padding-block: var(--space-3); background: var(--paper); }
@media (max-width: 900px) { #auto .auto-halves { grid-template-columns: minmax(0, 1fr); } }
@media (max-width: 480px) {
  #auto { inline-size: 100vw; max-block-size: 100dvh; margin-block-start: 0; border-block-start: 0; padding-inline: var(--space-3); border-inline: 0; border-radius: 0; }
  #auto .auto-said { display: grid; align-content: center; block-size: 2.9em; line-height: 1.4; }
  #auto .auto-row { grid-template-columns: 0.7rem 7.4rem repeat(4, minmax(2.2rem, 1fr)) 24px; padding-inline: 0; }
  #auto .auto-row :is(input, select) { padding-inline: 2px; font-size: var(--size-small); }
  #auto .auto-row select { padding-inline-end: 14px; }
}
@media (forced-colors: active) {
  #auto .auto-layer button::before, #auto .auto-tangent, #auto .auto-tools label > span::before { forced-color-adjust: none; }
  #auto .auto-row.lit { outline: 2px solid Highlight; }
  #auto .auto-row.wrong { outline: 2px dashed; }
}
`;

/** Puts it on, once. */
export function wear() {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(SHEET);
  document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
}
