/** The page's colours, strokes and dashes as a canvas can use them, read from the CSS tokens when they change. */

/** @typedef {"s" | "v" | "a" | "j" | "phi" | "rho" | "q" | "base" | "prime" | "pitch" | "axis"} DashName */

/** @typedef {ReturnType<typeof readPalette>} Palette */

const forced = matchMedia("(forced-colors: active)");
const dark = matchMedia("(prefers-color-scheme: dark)");

/** @param {Element} [root] */
export function readPalette(root = document.documentElement) {
  const style = getComputedStyle(root);
  /** @param {string} name */
  const plain = (name) => style.getPropertyValue(`--${name}`).trim();
  const token = forced.matches ? mixed(plain) : plain;
  /** @param {string} name */
  const dash = (name) => (plain(`dash-${name}`).match(/[\d.]+/g) ?? []).map(Number);
  return {
    ink: token("ink"), muted: token("muted"), grid: token("grid"), line: token("line"),
    paper: token("paper"), panel: token("panel"), accent: token("accent"),
    s: token("s"), v: token("v"), a: token("a"), j: token("j"), phi: token("phi"), rho: token("rho"), q: token("q"),
    cam: token("cam"), camEdge: token("cam-edge"), steel: token("steel"),
    base: token("base-circle"), prime: token("prime-circle"), pitch: token("pitch-curve"),
    good: token("good"), low: token("low"), bad: token("bad"),
    font: plain("font"), fontMath: plain("font-math") || plain("font"),
    size: parseFloat(plain("size")) || 13,
    chartSize: parseFloat(plain("chart-font-size")) || 11,
    stroke: parseFloat(plain("stroke")) || 1.5,
    lit: parseFloat(plain("lit")) || 0.13,
    dash: {
      s: dash("s"), v: dash("v"), a: dash("a"), j: dash("j"), phi: dash("phi"), rho: dash("rho"), q: dash("q"),
      base: dash("base"), prime: dash("prime"), pitch: dash("pitch"), axis: dash("axis"),
    },
  };
}

/**
 * One colour of the page as a canvas can use it.
 * @param {string} name  without --
 */
export function readColour(name) {
  const plain = () => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
  return forced.matches ? mixed(plain)(name) : plain();
}

/**
 * Colours of the system and mixtures of them as six digits, which is all that the diagrams understand: the browser is asked to paint them.
 * @param {(name: string) => string} plain
 * @returns {(name: string) => string}
 */
function mixed(plain) {
  const probe = document.createElement("span");
  probe.style.setProperty("forced-color-adjust", "none");
  const surface = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
  return (name) => {
    if (!surface) return plain(name);
    document.documentElement.append(probe);
    probe.style.color = plain(name);
    surface.fillStyle = getComputedStyle(probe).color;
    probe.remove();
    // Some systems' highlights let the ground shine through: for a line it is taken as it is.
    surface.clearRect(0, 0, 1, 1);
    surface.fillRect(0, 0, 1, 1);
    const [red, green, blue] = surface.getImageData(0, 0, 1, 1).data;
    return `#${[red, green, blue].map((channel) => (channel ?? 0).toString(16).padStart(2, "0")).join("")}`;
  };
}

/** The palette of paper, whatever the theme on screen. */
export function paperPalette() {
  const root = document.documentElement;
  const { theme } = root.dataset;
  root.dataset["theme"] = "light";
  root.dataset["paper"] = "";
  const palette = readPalette(root);
  delete root.dataset["paper"];
  if (theme === undefined) delete root.dataset["theme"];
  else root.dataset["theme"] = theme;
  return palette;
}

/**
 * Calls `fn` when theme, projector mode or the system's own colours change the tokens.
 * @param {() => void} fn
 */
export function onAppearance(fn) {
  let theme = appearance();
  new MutationObserver(() => {
    if (appearance() === theme) return;
    theme = appearance();
    fn();
  }).observe(document.documentElement, { attributes: true });
  forced.addEventListener("change", fn);
  dark.addEventListener("change", () => forced.matches && fn());
}

function appearance() {
  const { theme, projector } = document.documentElement.dataset;
  return `${theme} ${projector}`;
}
