/**
 * The pointer on the board: a press that stays is a click, one that moves is a drag, in the round steps of the scale that it began with.
 *
 * @import { Row } from "../stage/overlay.js"
 * @import { Place } from "./telling.js"
 */
import { steps, stepped, valueAt } from "../hand.js";
import { factor } from "../scrub.js";
import { thetaAt } from "../stage/overlay.js";
import { TURN } from "./demands.js";

/** Pixels that a press may move and is still a click. */
const SLACK = 4;

/** @typedef {{ at: Place, by: Place, gesture: string }} Reach  where the hand is, and the steps that it goes by */
/** @typedef {{ move: (reach: Reach) => void, click?: (reach: Reach) => void, done?: () => void }} Work */

let gestures = 0;

/**
 * @param {HTMLElement} layer
 * @param {() => Row | null} scale
 * @param {(held: boolean) => void} hold  told when a hand takes something and when it leaves it
 */
export function createHand(layer, scale, hold) {
  /** @type {{ work: Work, row: Row, gesture: string, id: number, x: number, y: number, far: boolean } | null} */
  let held = null;

  /** @param {PointerEvent} event @param {Row} row @returns {{ at: Place, by: Place }} */
  function reach(event, row) {
    const { left, top } = layer.getBoundingClientRect();
    const [theta, s] = [thetaAt(row, event.clientX - left + row.area.left), valueAt(row, event.clientY - top + row.area.top)];
    const by = steps(row);
    const fine = Math.min(1, factor(event));
    return { at: { theta, s }, by: { theta: by.theta * fine, s: by.s * fine } };
  }

  function leave() {
    if (!held) return;
    const { work } = held;
    held = null;
    hold(false);
    work.done?.();
  }

  layer.addEventListener("pointermove", (event) => {
    if (event.pointerId !== held?.id) return;
    held.far ||= Math.hypot(event.clientX - held.x, event.clientY - held.y) > SLACK;
    if (held.far) held.work.move({ ...reach(event, held.row), gesture: held.gesture });
  });
  layer.addEventListener("pointerup", (event) => {
    if (event.pointerId !== held?.id) return;
    if (!held.far) held.work.click?.({ ...reach(event, held.row), gesture: held.gesture });
    leave();
  });
  layer.addEventListener("lostpointercapture", leave);

  return {
    reach,
    busy: () => held !== null,

    /**
     * Takes hold of something; what is to be done with it is told by where the press was.
     * @param {PointerEvent} event
     * @param {(reach: Reach) => Work} begin
     */
    take(event, begin) {
      const row = scale();
      if (event.button !== 0 || !row || held) return;
      const gesture = `draw:${++gestures}`;
      const work = begin({ ...reach(event, row), gesture });
      layer.setPointerCapture(event.pointerId);
      held = { work, row, gesture, id: event.pointerId, x: event.clientX, y: event.clientY, far: false };
      hold(true);
    },

    /** What is under way, if anything. */
    gesture: () => held?.gesture,
    drop: leave,
  };
}

/**
 * A place in whole steps, on the board.
 * @param {{ at: Place, by: Place }} reach
 * @returns {Place}
 */
export const snapped = ({ at, by }) => ({ theta: Math.min(Math.max(stepped(at.theta, by.theta), 0), TURN), s: Math.max(0, stepped(at.s, by.s)) });
