/**
 * Hands on the cursor of diagrams: drag, keys and wheel.
 *
 * @import { Report, Store } from "../types.d.ts"
 * @import { Row } from "./overlay.js"
 */
import { cycleOf, inside, played, stepped, stride } from "./clock.js";
import { isFramed, sharedGestures } from "./framed.js";
import { thetaAt } from "./overlay.js";

/** A turn ends where it begins: its last place on a diagram lies so much before, degrees. */
const LAST = 0.1;

/**
 * The place under a pointer, within the cycle.
 * @param {Row} row
 * @param {MouseEvent} event
 * @param {Readonly<Report>} report
 */
export const placeUnder = (row, event, { travels, span }) => Math.min(Math.max(thetaAt(row, event.offsetX), 0), travels ? span : span - LAST);

/**
 * Drag and keys.
 * @param {HTMLCanvasElement} overlay
 * @param {Store} store
 * @param {() => Row | undefined} row     that the places are read on
 * @param {(event: PointerEvent) => void} [passing]  a pointer that moves over the diagrams and does not hold the cursor
 */
export function moveCursor(overlay, store, row, passing) {
  /** @param {PointerEvent} event */
  function drag(event) {
    const { report } = store.state;
    const cycle = cycleOf(report);
    const tenth = 10 / cycle.unit;
    const on = row();
    if (on) store.set({ cursor: inside(cycle, Math.round(placeUnder(on, event, report) * tenth) / tenth), playing: false });
  }

  overlay.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    overlay.setPointerCapture(event.pointerId);
    drag(event);
  });
  overlay.addEventListener("pointermove", (event) => {
    if (overlay.hasPointerCapture(event.pointerId)) drag(event);
    else passing?.(event);
  });
  overlay.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey) return;
    const change = played(store.state, event);
    if (!change) return;
    store.set(change);
    event.preventDefault();
  });
}

/**
 * A step a notch, as with the arrow keys.
 * @param {HTMLCanvasElement} overlay
 * @param {Store} store
 * @param {() => string} hint  how the wheel is used in a frame of another page
 */
export function wheelCursor(overlay, store, hint) {
  const shared = sharedGestures(overlay, () => ({ wheel: hint() }));
  overlay.addEventListener(
    "wheel",
    (event) => {
      // Ctrl with the wheel is the browser's own zoom, but in a frame it is what leaves the plain wheel to the page around.
      if ((event.ctrlKey && !isFramed()) || !shared.ownsWheel(event)) return;
      event.preventDefault();
      const way = Math.sign(event.deltaY || event.deltaX);
      const cycle = cycleOf(store.state.report);
      if (way !== 0) store.set({ cursor: stepped(store.state.cursor, way * stride(event, cycle), cycle), playing: false });
    },
    { passive: false },
  );
}
