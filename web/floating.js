/** Where something that floats goes: beside what it is about, within the window. */

const GAP = 8;
const EDGE = 6;

/**
 * @param {HTMLElement} floating
 * @param {DOMRect} about
 */
export function beside(floating, about) {
  const { offsetWidth: width, offsetHeight: height } = floating;
  const within = (/** @type {number} */ at, /** @type {number} */ size, /** @type {number} */ room) => Math.max(EDGE, Math.min(at, room - size - EDGE));
  const across = within(about.left + about.width / 2 - width / 2, width, innerWidth);
  const down = within(about.top + about.height / 2 - height / 2, height, innerHeight);
  /** Right, left, below, above; over it where there is no room at all. @type {[number, number, boolean][]} */
  const places = [
    [about.right + GAP, down, about.right + GAP + width < innerWidth],
    [about.left - GAP - width, down, about.left - GAP - width > 0],
    [across, about.bottom + GAP, about.bottom + GAP + height < innerHeight],
    [across, about.top - GAP - height, about.top - GAP - height > 0],
  ];
  const [left, top] = places.find(([, , fits]) => fits) ?? [across, innerHeight - height - EDGE];
  floating.style.left = `${left}px`;
  floating.style.top = `${top}px`;
}
