/**
 * What is seen of the mechanism: all of it, until a hand chooses otherwise; and the way there.
 *
 * @import { View } from "./view.js"
 */
import { approach, zoomed } from "./view.js";

/** Share of the way that a moving view covers in a frame. */
const GLIDE = 0.22;
/** How far the scale may leave that of the fitted picture. */
const FARTHEST = 0.2;
const NEAREST = 60;

/**
 * @param {View} view                 as it is drawn, moved in place
 * @param {() => View | null} fitted  the one that shows everything; none as long as there is no room
 * @param {() => void} moved          has it drawn, with whatever else has changed and only once a frame
 */
export function createSight(view, fitted, moved) {
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  /** @type {View | null} */
  let goal = null;
  let chosen = false;
  let gliding = false;

  /**
   * Shows everything, gliding there unless motion is unwanted.
   * @param {boolean} atOnce
   */
  function look(atOnce) {
    const all = fitted();
    if (!all) return;
    goal = all;
    if (atOnce || still.matches) Object.assign(view, goal);
    else if (!gliding) {
      gliding = true;
      requestAnimationFrame(glide);
    }
  }

  function glide() {
    if (goal && !approach(view, goal, GLIDE)) requestAnimationFrame(glide);
    else gliding = false;
    moved();
  }

  /** @param {View} wanted  at once */
  function settle(wanted) {
    chosen = true;
    goal = wanted;
    Object.assign(view, wanted);
    moved();
  }

  return {
    look,
    /** True once the user has chosen what to see: then only a wholly other mechanism moves the view. */
    chosen: () => chosen,
    /** True once anything has been looked at. */
    found: () => goal !== null,

    forget() {
      chosen = false;
    },

    fit() {
      chosen = false;
      look(false);
      moved();
    },

    /** @param {number} factor @param {number} px @param {number} py */
    zoom(factor, px, py) {
      const all = fitted();
      if (goal && all) settle(zoomed(view, factor, px, py, all.scale * FARTHEST, all.scale * NEAREST));
    },

    /** @param {number} dx @param {number} dy */
    pan: (dx, dy) => settle({ scale: view.scale, x: view.x + dx, y: view.y + dy }),
  };
}
