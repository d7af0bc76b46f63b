/** The page's colours, strokes and dashes as a canvas can use them, read from the CSS tokens when they change. */

/** @typedef {"s" | "v" | "a" | "j" | "phi" | "rho" | "q" | "base" | "prime" | "pitch" | "axis"} DashName */

/** @typedef {ReturnType<typeof readPalette>} Palette */

/** @param {Element} [root] */
export function readPalette(root = document.documentElement) {
  const style = getComputedStyle(root);
  /** @param {string} name */
  const token = (name) => style.getPropertyValue(`--${name}`).trim();
  /** @param {string} name */
  const dash = (name) => (token(`dash-${name}`).match(/[\d.]+/g) ?? []).map(Number);
  return {
    ink: token("ink"), muted: token("muted"), grid: token("grid"), line: token("line"),
    paper: token("paper"), panel: token("panel"), accent: token("accent"),
    s: token("s"), v: token("v"), a: token("a"), j: token("j"), phi: token("phi"), rho: token("rho"), q: token("q"),
    cam: token("cam"), camEdge: token("cam-edge"), steel: token("steel"),
    base: token("base-circle"), prime: token("prime-circle"), pitch: token("pitch-curve"),
    good: token("good"), low: token("low"), bad: token("bad"),
    font: token("font"), fontMath: token("font-math") || token("font"),
    size: parseFloat(token("size")) || 13,
    chartSize: parseFloat(token("chart-font-size")) || 11,
    stroke: parseFloat(token("stroke")) || 1.5,
    dash: {
      s: dash("s"), v: dash("v"), a: dash("a"), j: dash("j"), phi: dash("phi"), rho: dash("rho"), q: dash("q"),
      base: dash("base"), prime: dash("prime"), pitch: dash("pitch"), axis: dash("axis"),
    },
  };
}

/** The palette of paper, whatever the theme on screen. */
export function paperPalette() {
  const root = document.documentElement;
  const { theme } = root.dataset;
  root.dataset["theme"] = "light";
  const palette = readPalette(root);
  if (theme === undefined) delete root.dataset["theme"];
  else root.dataset["theme"] = theme;
  return palette;
}

/**
 * Calls `fn` when theme or projector mode change the tokens.
 * @param {() => void} fn
 */
export function onAppearance(fn) {
  let theme = appearance();
  new MutationObserver(() => {
    if (appearance() === theme) return;
    theme = appearance();
    fn();
  }).observe(document.documentElement, { attributes: true });
}

function appearance() {
  const { theme, projector } = document.documentElement.dataset;
  return `${theme} ${projector}`;
}
