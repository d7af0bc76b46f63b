/**
 * Hands on the mechanism: drag the cam to turn it, drag the ground to pan, wheel and pinch to zoom, keys for all of it.
 *
 * @import { Store } from "../types.d.ts"
 * @import { View } from "./view.js"
 */
import { cycleOf, inside, played } from "./clock.js";
import { sharedGestures } from "./framed.js";
import { worldX, worldY } from "./view.js";

/** What a notch of the wheel and a press of + or − multiply the scale by. */
const NOTCH = 1.0015;
export const STEP = 1.25;
/** Pixels that Ctrl and an arrow move the picture. */
const SHOVE = 40;

/**
 * @typedef {object} Target
 * @property {HTMLCanvasElement} canvas
 * @property {Store} store
 * @property {() => View} view
 * @property {() => 1 | -1} sense
 * @property {(x: number, y: number) => boolean} onCam  whether a world point lies on the cam
 * @property {(factor: number, px: number, py: number) => void} zoom
 * @property {(dx: number, dy: number) => void} pan
 * @property {() => void} fit
 * @property {(point: { x: number, y: number } | null) => void} hover  world point under the pointer
 * @property {() => { wheel: string, finger: string }} hints  how wheel and fingers reach the picture in a frame of another page
 */

/** @param {Target} target */
export function handle(target) {
  const { canvas, store } = target;
  /** @type {Map<number, { x: number, y: number }>} */
  const fingers = new Map();
  /** Angle of the pointer about the cam's centre while the cam is held, rad; its place across, of a cam that travels. */
  let held = NaN;
  const shared = sharedGestures(canvas, target.hints);

  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || !shared.ownsPress(event)) return;
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    held = NaN;
    if (fingers.size === 1) {
      const { x, y } = world(event);
      if (target.onCam(x, y)) {
        held = store.state.report.travels ? x : Math.atan2(y, x);
        store.set({ playing: false });
      }
    }
    dress(event);
  });

  canvas.addEventListener("pointermove", (event) => {
    const point = world(event);
    target.hover(point);
    const finger = fingers.get(event.pointerId);
    if (!finger) {
      dress(event);
      return;
    }
    const dx = event.offsetX - finger.x;
    const dy = event.offsetY - finger.y;
    if (fingers.size === 2) pinch(event.pointerId, event.offsetX, event.offsetY);
    else if (Number.isNaN(held)) target.pan(dx, dy);
    else turn(point);
    finger.x = event.offsetX;
    finger.y = event.offsetY;
  });

  for (const name of /** @type {const} */ (["pointerup", "pointercancel"])) {
    canvas.addEventListener(name, (event) => {
      fingers.delete(event.pointerId);
      held = NaN;
      dress(event);
    });
  }
  canvas.addEventListener("pointerleave", () => target.hover(null));
  canvas.addEventListener("dblclick", () => target.fit());
  canvas.addEventListener(
    "wheel",
    (event) => {
      if (!shared.ownsWheel(event)) return;
      event.preventDefault();
      const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * 32 : event.deltaY;
      target.zoom(NOTCH ** -pixels, event.offsetX, event.offsetY);
    },
    { passive: false },
  );
  canvas.addEventListener("keydown", key);

  /** @param {MouseEvent} event */
  function world(event) {
    const view = target.view();
    return { x: worldX(view, event.offsetX), y: worldY(view, event.offsetY) };
  }

  /** @param {MouseEvent} event */
  function dress(event) {
    const { x, y } = world(event);
    canvas.dataset["grip"] = fingers.size > 0 ? (Number.isNaN(held) ? "panning" : "turning") : target.onCam(x, y) ? "cam" : "ground";
  }

  /** @param {{ x: number, y: number }} point */
  function turn({ x, y }) {
    const { report, cursor } = store.state;
    if (report.travels) {
      store.set({ cursor: inside(cycleOf(report), cursor - (x - held)) });
      held = x;
      return;
    }
    const angle = Math.atan2(y, x);
    let moved = angle - held;
    if (moved > Math.PI) moved -= 2 * Math.PI;
    if (moved < -Math.PI) moved += 2 * Math.PI;
    held = angle;
    store.set({ cursor: inside(cycleOf(report), cursor + (target.sense() * moved * 180) / Math.PI) });
  }

  /**
   * @param {number} id
   * @param {number} x
   * @param {number} y
   */
  function pinch(id, x, y) {
    const moving = fingers.get(id);
    const [still] = [...fingers].filter(([other]) => other !== id).map(([, finger]) => finger);
    if (!moving || !still) return;
    const before = Math.hypot(moving.x - still.x, moving.y - still.y);
    const after = Math.hypot(x - still.x, y - still.y);
    target.pan((x - moving.x) / 2, (y - moving.y) / 2);
    if (before > 0) target.zoom(after / before, (x + still.x) / 2, (y + still.y) / 2);
  }

  /** @param {KeyboardEvent} event */
  function key(event) {
    if (event.metaKey) return;
    if (event.ctrlKey) {
      const [dx, dy] = { ArrowLeft: [SHOVE, 0], ArrowRight: [-SHOVE, 0], ArrowUp: [0, SHOVE], ArrowDown: [0, -SHOVE] }[event.key] ?? [0, 0];
      if (dx === 0 && dy === 0) return;
      target.pan(dx, dy);
      event.preventDefault();
      return;
    }
    const [x, y] = [canvas.clientWidth / 2, canvas.clientHeight / 2];
    if (event.key === "+" || event.key === "=") target.zoom(STEP, x, y);
    else if (event.key === "-") target.zoom(1 / STEP, x, y);
    else if (event.key === "0") target.fit();
    else {
      const change = played(store.state, event);
      if (!change) return;
      store.set(change);
    }
    event.preventDefault();
  }
}
