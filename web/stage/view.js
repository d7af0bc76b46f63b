/** The window on the mechanism: world lengths (y up) to CSS pixels (y down). Pure, so that it is tested without a canvas. */

/**
 * @typedef {object} View
 * @property {number} scale  CSS pixels for a unit of length
 * @property {number} x      where the cam's centre falls, in CSS pixels
 * @property {number} y
 */

/** @typedef {{ left: number, bottom: number, right: number, top: number }} Box  in world lengths */

/** Closer than this share to its goal, a moving view has arrived: a tenth of a pixel on a large screen. */
const ARRIVED = 1e-4;

/**
 * The view that shows the whole box, centred, with a margin of so many pixels.
 * @param {Box} box
 * @param {number} width
 * @param {number} height
 * @param {number} margin
 * @returns {View}
 */
export function fitView(box, width, height, margin) {
  const across = box.right - box.left || 1;
  const up = box.top - box.bottom || 1;
  const scale = Math.min(Math.max(width - 2 * margin, 1) / across, Math.max(height - 2 * margin, 1) / up);
  return {
    scale,
    x: width / 2 - (scale * (box.left + box.right)) / 2,
    y: height / 2 + (scale * (box.bottom + box.top)) / 2,
  };
}

/**
 * @param {View} view
 * @param {number} px
 */
export const worldX = (view, px) => (px - view.x) / view.scale;

/**
 * @param {View} view
 * @param {number} py
 */
export const worldY = (view, py) => (view.y - py) / view.scale;

/**
 * Larger or smaller about the point under the pointer, within limits of the scale.
 * @param {View} view
 * @param {number} factor
 * @param {number} px
 * @param {number} py
 * @param {number} least
 * @param {number} most
 * @returns {View}
 */
export function zoomed(view, factor, px, py, least, most) {
  const scale = Math.min(Math.max(view.scale * factor, least), most);
  const by = scale / view.scale;
  return { scale, x: px + (view.x - px) * by, y: py + (view.y - py) * by };
}

/**
 * Moves `view` a share of the way to `goal`, in place. True when it has arrived.
 * @param {View} view
 * @param {View} goal
 * @param {number} share
 */
export function approach(view, goal, share) {
  const away = Math.abs(Math.log(goal.scale / view.scale)) + (Math.abs(goal.x - view.x) + Math.abs(goal.y - view.y)) / 1000;
  const step = away < ARRIVED ? 1 : share;
  view.scale *= (goal.scale / view.scale) ** step;
  view.x += (goal.x - view.x) * step;
  view.y += (goal.y - view.y) * step;
  return step === 1;
}

/**
 * The longest of 1, 2, 5 × 10ⁿ that is not above `most`: for the scale bar.
 * @param {number} most
 */
export function roundLength(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  for (const digit of [5, 2]) if (digit * power <= most) return digit * power;
  return power;
}

/**
 * Widens `box` so that it holds a disc.
 * @param {Box} box
 * @param {number} x
 * @param {number} y
 * @param {number} radius
 */
export function include(box, x, y, radius = 0) {
  box.left = Math.min(box.left, x - radius);
  box.right = Math.max(box.right, x + radius);
  box.bottom = Math.min(box.bottom, y - radius);
  box.top = Math.max(box.top, y + radius);
}
