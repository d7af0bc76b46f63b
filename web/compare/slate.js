/**
 * The slate: designs that are pinned, each analysed in a laboratory of its own, kept in the browser and drawn beside the design on
 * screen.
 *
 * @import { Design, Lab, Report, ShellContext } from "../types.d.ts"
 * @import { CompareEngine } from "../compare.js"
 */
import { keep, recall } from "../memory.js";
import { onAppearance } from "../stage/palette.js";
import { LOOKS, readLook } from "./looks.js";

/** Designs that can be pinned: more could not be told apart in a diagram. */
export const MOST = LOOKS;

/** Stations of a turn that are drawn. */
const SAMPLES = 720;

/**
 * @typedef {object} Pin
 * @property {number} id
 * @property {string} name
 * @property {Design} design
 * @property {boolean} shown   in diagrams and mechanism
 * @property {number} look
 * @property {Lab} lab
 * @property {Report} report
 * @property {Float64Array} figures
 * @property {Path2D} outline
 */

/** @typedef {ReturnType<typeof createSlate>} Slate */

/**
 * @param {ShellContext} context
 * @param {CompareEngine} engine
 */
export function createSlate({ store, lab, t, catalogue }, engine) {
  /** @type {Pin[]} */
  let pins = [];
  /** @type {{ pin: Pin, place: number } | null} */
  let removed = null;
  /** @type {(() => void)[]} */
  const watchers = [];
  let last = 0;
  let known = lab();

  /**
   * @param {string} name
   * @param {Design} design
   * @param {boolean} shown
   * @param {number} look
   * @returns {Pin | null}
   */
  function analysed(name, design, shown, look) {
    const own = engine.another();
    const { report } = own.open(design, SAMPLES, store.state.language);
    return report ? { id: ++last, name, design, shown, look, lab: own, report, figures: own.figures(), outline: outlineOf(own) } : null;
  }

  /** The first look that nobody has. */
  const freeLook = () => [...Array(LOOKS).keys()].find((look) => pins.every((pin) => pin.look !== look)) ?? 0;

  /** What was kept, checked, since storage can hold anything. */
  function read() {
    const kept = recall("slate");
    pins = [];
    removed = null;
    for (const entry of Array.isArray(kept) ? kept.slice(0, MOST) : []) {
      const { design } = engine.check(entry?.design ?? null);
      if (!design) continue;
      const name = typeof entry.name === "string" ? entry.name.slice(0, catalogue.limits.title) : design.title;
      const pin = analysed(name, design, entry.shown !== false, freeLook());
      if (pin) pins.push(pin);
    }
  }

  /** Lays the curves behind those of the design on screen, and tells everyone. */
  function lay() {
    const engineNow = lab();
    engineNow.alone();
    const beside = pins.filter(({ shown }) => shown).map((pin) => {
      const { colour, dash } = readLook(pin.look);
      engineNow.beside(pin.lab, colour, Float64Array.from(dash));
      const { mechanism, units } = pin.report;
      return { name: pin.name, outline: pin.outline, sense: mechanism.sense, reach: mechanism.reach, unit: turns(pin.design) ? units.length : "", colour, dash };
    });
    store.set({ beside });
    for (const watch of watchers) watch();
  }

  function changed() {
    keep("slate", pins.map(({ name, design, shown }) => ({ name, design, shown })));
    lay();
  }

  /** @param {number} id */
  const placeOf = (id) => pins.findIndex((pin) => pin.id === id);

  read();
  lay();
  store.subscribe(["report"], () => {
    // A fresh engine after a panic knows none of the old laboratories.
    if (lab() === known) return;
    known = lab();
    pins = pins.flatMap(({ name, design, shown, look }) => analysed(name, design, shown, look) ?? []);
    lay();
  });
  onAppearance(lay);
  addEventListener("beforeprint", lay, { capture: true });
  addEventListener("afterprint", lay);
  addEventListener("storage", ({ key }) => {
    if (key !== "levalab:slate") return;
    read();
    lay();
  });

  return {
    get pins() {
      return /** @type {readonly Pin[]} */ (pins);
    },

    get removed() {
      return removed?.pin ?? null;
    },

    /** @param {() => void} watch */
    watch: (watch) => void watchers.push(watch),

    /**
     * @param {Design} design
     * @param {string} [name]
     * @returns {"pinned" | "already" | "full"}
     */
    pin(design, name = design.title || t("app.untitled")) {
      const file = engine.saveFile(design);
      if (pins.some((pin) => engine.saveFile(pin.design) === file)) return "already";
      if (pins.length >= MOST) return "full";
      const pin = analysed(name.slice(0, catalogue.limits.title), structuredClone(design), true, freeLook());
      if (pin) pins.push(pin);
      changed();
      return "pinned";
    },

    /**
     * @param {number} id
     * @param {{ name?: string, shown?: boolean }} change
     */
    set(id, change) {
      const pin = pins[placeOf(id)];
      if (!pin) return;
      Object.assign(pin, change);
      changed();
    },

    /**
     * @param {number} id
     * @param {number} by  places down
     */
    move(id, by) {
      const place = placeOf(id);
      const to = place + by;
      if (place < 0 || to < 0 || to >= pins.length) return false;
      pins.splice(to, 0, ...pins.splice(place, 1));
      changed();
      return true;
    },

    /** @param {number} id */
    remove(id) {
      const place = placeOf(id);
      const [pin] = place < 0 ? [] : pins.splice(place, 1);
      if (!pin) return;
      removed = { pin, place };
      changed();
    },

    /** Brings back what was removed last. */
    restore() {
      if (!removed || pins.length >= MOST) return null;
      const { pin, place } = removed;
      removed = null;
      if (pins.some(({ look }) => look === pin.look)) pin.look = freeLook();
      pins.splice(place, 0, pin);
      changed();
      return pin;
    },
  };
}

/** A cam that travels has no place among those that turn. @param {Design} design */
export const turns = (design) => design.cam.kind !== "translating";

/** The profile in the cam's own frame. @param {Lab} lab */
function outlineOf(lab) {
  const [x, y] = [lab.column("x"), lab.column("y")];
  const path = new Path2D();
  x.forEach((px, i) => path.lineTo(px, /** @type {number} */ (y[i])));
  path.closePath();
  return path;
}
