/** The animation's clock and hand wheel. Pure. */

const TURN = 360;

/** Turns per second at the two ends of the hand wheel's travel: one turn a minute, and two a second. */
export const SLOWEST = 1 / 60;
export const FASTEST = 2;

/** The wheel's positions run from −100 to 100; within so many of the middle it stands still. */
export const WHEEL = 100;
const DEAD = 5;

/** Nearer than this to a whole step counts as standing on it. */
const ON_STEP = 1e-6;

/** A frame that took longer (a tab that slept) moves the cam no further than this. */
const LONGEST_FRAME = 0.1;

/**
 * Into 0 ≤ θ < 360, exactly where nothing has to be added.
 * @param {number} theta
 */
export function wrap(theta) {
  const rest = theta % TURN;
  return rest < 0 ? (rest + TURN) % TURN : rest;
}

/**
 * Where the cursor is after so many seconds.
 * @param {number} cursor
 * @param {number} rate  turns per second
 * @param {number} seconds
 */
export const turned = (cursor, rate, seconds) => wrap(cursor + rate * TURN * Math.min(Math.max(seconds, 0), LONGEST_FRAME));

/**
 * The next whole multiple of |step| in its direction.
 * @param {number} cursor
 * @param {number} step  degrees, signed
 */
export function stepped(cursor, step) {
  const size = Math.abs(step);
  const steps = cursor / size;
  const nearest = Math.round(steps);
  const next = Math.abs(steps - nearest) < ON_STEP ? nearest + Math.sign(step) : step > 0 ? Math.ceil(steps) : Math.floor(steps);
  // Tenths are divided, not multiplied: 3 × 0.1 would show as 0.30000000000000004.
  return wrap(size < 1 ? next / Math.round(1 / size) : next * size);
}

/**
 * Turns per second at a position of the hand wheel: even ratios for even travel.
 * @param {number} position
 */
export function rateAt(position) {
  const travel = (Math.abs(position) - DEAD) / (WHEEL - DEAD);
  return travel <= 0 ? 0 : Math.sign(position) * SLOWEST * (FASTEST / SLOWEST) ** travel;
}

/** @param {number} rate */
export function positionOf(rate) {
  if (rate === 0) return 0;
  const travel = Math.log(Math.abs(rate) / SLOWEST) / Math.log(FASTEST / SLOWEST);
  return Math.sign(rate) * Math.round(DEAD + Math.min(Math.max(travel, 0), 1) * (WHEEL - DEAD));
}

/**
 * How far a key moves the cursor: 1°, with Shift 10°, with Alt 0.1°.
 * @param {{ shiftKey: boolean, altKey: boolean }} event
 */
export const stride = (event) => (event.shiftKey ? 10 : event.altKey ? 0.1 : 1);

/**
 * The cursor after a key, or null when the key is not one of its own.
 * @param {number} cursor
 * @param {{ key: string, shiftKey: boolean, altKey: boolean }} event
 */
export function afterKey(cursor, event) {
  switch (event.key) {
    case "ArrowLeft":
    case "ArrowDown":
      return stepped(cursor, -stride(event));
    case "ArrowRight":
    case "ArrowUp":
      return stepped(cursor, stride(event));
    case "PageDown":
      return stepped(cursor, -10);
    case "PageUp":
      return stepped(cursor, 10);
    case "Home":
      return 0;
    case "End":
      return TURN - stride(event);
    default:
      return null;
  }
}

/**
 * Decimals that a cam angle is shown with: one while it runs by, and a second when it stands where one is not enough.
 * @param {{ cursor: number, playing: boolean }} state
 */
export const decimalsOf = ({ cursor, playing }) => (playing || Math.round(cursor * 100) % 10 === 0 ? 1 : 2);

/**
 * The change that a key brings to the animation, or null when the key is not one of its own.
 * @param {{ cursor: number, playing: boolean }} state
 * @param {{ key: string, shiftKey: boolean, altKey: boolean }} event
 */
export function played({ cursor, playing }, event) {
  if (event.key === " ") return { playing: !playing };
  const next = afterKey(cursor, event);
  return next === null ? null : { cursor: next, playing: false };
}
