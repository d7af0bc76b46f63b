/** The animation's clock and hand wheel. Pure. */

const TURN = 360;

/**
 * What the cursor runs through: a turn, in degrees, or the travel of a cam that goes back and forth, in its unit of length.
 * @typedef {object} Cycle
 * @property {number} span
 * @property {boolean} travels
 * @property {number} unit   the usual step
 */

/** @type {Readonly<Cycle>} */
const FULL_TURN = Object.freeze({ span: TURN, travels: false, unit: 1 });

/** Steps of a travel are the power of ten that goes so many times into it. */
const STEPS = 40;

/**
 * @param {{ span: number, travels: boolean }} report
 * @returns {Readonly<Cycle>}
 */
export const cycleOf = ({ span, travels }) => (travels ? { span, travels, unit: 10 ** Math.floor(Math.log10(span / STEPS)) } : FULL_TURN);

/**
 * A place, kept within the travel or brought into the turn.
 * @param {Readonly<Cycle>} cycle
 * @param {number} place
 */
export const inside = (cycle, place) => (cycle.travels ? Math.min(Math.max(place, 0), cycle.span) : wrap(place));


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
 * Where a cursor that goes back and forth is after so many seconds, and which way it goes then.
 * @param {Readonly<Cycle>} cycle
 * @param {number} cursor
 * @param {number} rate  travels per second, with the sign of its way
 * @param {number} seconds
 * @returns {{ cursor: number, back: boolean }}  `back` when it has turned round at an end
 */
export function bounced({ span }, cursor, rate, seconds) {
  const moved = cursor + rate * span * Math.min(Math.max(seconds, 0), LONGEST_FRAME);
  const lap = ((moved % (2 * span)) + 2 * span) % (2 * span);
  return { cursor: Math.min(lap, 2 * span - lap), back: moved < 0 || moved > span };
}

/**
 * The next whole multiple of |step| in its direction.
 * @param {number} cursor
 * @param {number} step  degrees or length, signed
 * @param {Readonly<Cycle>} [cycle]
 */
export function stepped(cursor, step, cycle = FULL_TURN) {
  const size = Math.abs(step);
  const steps = cursor / size;
  const nearest = Math.round(steps);
  const next = Math.abs(steps - nearest) < ON_STEP ? nearest + Math.sign(step) : step > 0 ? Math.ceil(steps) : Math.floor(steps);
  // Tenths are divided, not multiplied: 3 × 0.1 would show as 0.30000000000000004.
  return inside(cycle, size < 1 ? next / Math.round(1 / size) : next * size);
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
 * How far a key moves the cursor: 1°, with Shift 10°, with Alt 0.1°; the like of a length.
 * @param {{ shiftKey: boolean, altKey: boolean }} event
 * @param {Readonly<Cycle>} [cycle]
 */
export const stride = (event, { unit } = FULL_TURN) => (event.shiftKey ? 10 * unit : event.altKey ? unit / 10 : unit);

/**
 * The cursor after a key, or null when the key is not one of its own.
 * @param {number} cursor
 * @param {{ key: string, shiftKey: boolean, altKey: boolean }} event
 * @param {Readonly<Cycle>} [cycle]
 */
export function afterKey(cursor, event, cycle = FULL_TURN) {
  switch (event.key) {
    case "ArrowLeft":
    case "ArrowDown":
      return stepped(cursor, -stride(event, cycle), cycle);
    case "ArrowRight":
    case "ArrowUp":
      return stepped(cursor, stride(event, cycle), cycle);
    case "PageDown":
      return stepped(cursor, -10 * cycle.unit, cycle);
    case "PageUp":
      return stepped(cursor, 10 * cycle.unit, cycle);
    case "Home":
      return 0;
    case "End":
      return cycle.travels ? cycle.span : TURN - stride(event);
    default:
      return null;
  }
}

/**
 * Decimals that a place is shown with: one more than its steps while it runs by, and a second when it stands where one is not enough.
 * @param {{ cursor: number, playing: boolean }} state
 * @param {Readonly<Cycle>} [cycle]
 */
export function decimalsOf({ cursor, playing }, { unit } = FULL_TURN) {
  const least = Math.max(0, 1 - Math.round(Math.log10(unit)));
  return playing || Math.round((cursor / unit) * 100) % 10 === 0 ? least : least + 1;
}

/**
 * The change that a key brings to the animation, or null when the key is not one of its own.
 * @param {{ cursor: number, playing: boolean, report: { span: number, travels: boolean } }} state
 * @param {{ key: string, shiftKey: boolean, altKey: boolean }} event
 */
export function played({ cursor, playing, report }, event) {
  if (event.key === " ") return { playing: !playing };
  const next = afterKey(cursor, event, cycleOf(report));
  return next === null ? null : { cursor: next, playing: false };
}
