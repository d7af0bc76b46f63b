/** Dragging a label sideways changes its number. */
import { sum } from "./numbers.js";

/** Pixels of drag a step; less than `SLACK` is a click. */
const PIXELS = 4;
const SLACK = 3;

let gestures = 0;

/**
 * @param {HTMLElement} handle
 * @param {object} options
 * @param {() => number} options.value
 * @param {() => number} options.step
 * @param {(value: number, gesture: string) => void} options.change
 * @param {(gesture: string) => void} options.cancel
 * @param {() => void} options.end
 */
export function scrub(handle, { value, step, change, cancel, end }) {
  handle.classList.add("scrub");
  handle.addEventListener("pointerdown", (down) => {
    if (down.button !== 0) return;
    const gesture = `scrub:${++gestures}`;
    const start = value();
    let steps = 0;
    let last = down.clientX;
    let moved = false;

    /** @param {PointerEvent} event */
    function move(event) {
      if (!moved && Math.abs(event.clientX - down.clientX) < SLACK) return;
      if (!moved) handle.setPointerCapture(down.pointerId);
      moved = true;
      steps += ((event.clientX - last) / PIXELS) * factor(event);
      last = event.clientX;
      const unit = step() * Math.min(1, factor(event));
      change(sum(start, Math.round((steps * step()) / unit) * unit), gesture);
    }

    /** @param {KeyboardEvent} event */
    function key(event) {
      if (event.key !== "Escape") return;
      event.preventDefault();
      cancel(gesture);
      stop();
    }

    function stop() {
      handle.removeEventListener("pointermove", move);
      removeEventListener("keydown", key, true);
      if (moved) {
        handle.addEventListener("click", (click) => click.preventDefault(), { once: true });
        setTimeout(end);
      }
    }

    handle.addEventListener("pointermove", move);
    handle.addEventListener("pointerup", stop, { once: true });
    handle.addEventListener("pointercancel", stop, { once: true });
    addEventListener("keydown", key, true);
  });
}

/**
 * Shift is ten times, Alt a tenth.
 * @param {{ shiftKey: boolean, altKey: boolean }} event
 */
export function factor({ shiftKey, altKey }) {
  return shiftKey ? 10 : altKey ? 0.1 : 1;
}
