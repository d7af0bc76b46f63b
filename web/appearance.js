/**
 * Language, theme and projector view on the root element, remembered between visits.
 *
 * @import { Keeper, Store, ViewState } from "./types.d.ts"
 */
import { keep, recall } from "./memory.js";
import { firstLanguage } from "./strings/index.js";

/** What is remembered of the view. @type {("language" | "theme" | "perSecond" | "tab" | "layers" | "margins" | "projectorSpeed" | "projectorValues")[]} */
const REMEMBERED = ["language", "theme", "perSecond", "tab", "layers", "margins", "projectorSpeed", "projectorValues"];

/** @type {Record<string, readonly unknown[]>} */
const KNOWN = {
  language: ["en", "es"],
  theme: ["light", "dark", "system"],
  perSecond: [true, false],
  tab: ["svaj", "pressure_angle", "rho", "contact"],
  projectorSpeed: [true, false],
  projectorValues: [true, false],
};

/**
 * The view as it was left, checked, since storage can hold anything.
 * @param {ViewState} usual
 * @returns {Partial<ViewState>}
 */
export function rememberedView(usual) {
  const kept = recall("view");
  /** @type {Record<string, unknown>} */
  const view = { language: firstLanguage(navigator.languages ?? [navigator.language]) };
  if (typeof kept !== "object" || kept === null) return view;
  for (const [key, value] of Object.entries(kept)) {
    if (Object.hasOwn(KNOWN, key) && KNOWN[key]?.includes(value)) view[key] = value;
    if (key === "margins") view[key] = Object.fromEntries(entriesOf(value).filter(([, margin]) => isMargin(margin)).slice(0, 9));
    if (key === "layers") {
      const known = entriesOf(value).filter(([name, shown]) => Object.hasOwn(usual.layers, name) && typeof shown === "boolean");
      view[key] = { ...usual.layers, ...Object.fromEntries(known) };
    }
  }
  return view;
}

/** @param {unknown} value @returns {[string, unknown][]} */
const entriesOf = (value) => (typeof value === "object" && value !== null ? Object.entries(value) : []);

/** @param {unknown} margin */
const isMargin = (margin) => typeof margin === "number" && Number.isFinite(margin) && margin >= 0;

/** @param {Store & Keeper} store */
export function follow(store) {
  const root = document.documentElement;
  const dark = matchMedia("(prefers-color-scheme: dark)");

  function apply() {
    const { theme, language, projector } = store.state;
    root.dataset["theme"] = theme === "system" ? (dark.matches ? "dark" : "light") : theme;
    root.lang = language;
    root.toggleAttribute("data-projector", projector);
  }

  apply();
  dark.addEventListener("change", () => {
    apply();
    store.touch("theme");
  });
  store.subscribe(["theme", "language", "projector"], apply);
  store.subscribe(REMEMBERED, (state) => keep("view", Object.fromEntries(REMEMBERED.map((key) => [key, state[key]]))));
  store.subscribe(["stale"], ({ stale }) => root.toggleAttribute("data-stale", stale));
}
