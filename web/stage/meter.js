/** Script time of an animation frame, told to the performance timeline when `levalabMeasure` is set. */

export const FRAME_MEASURE = "levalab:frame";

let spent = 0;

const wanted = () => Reflect.get(globalThis, "levalabMeasure") === true;

/**
 * Runs one part of a frame.
 * @template {unknown[]} Arguments
 * @param {(...given: Arguments) => void} part
 * @returns {(...given: Arguments) => void}
 */
export function metered(part) {
  return (...given) => {
    if (!wanted()) {
      part(...given);
      return;
    }
    const start = performance.now();
    part(...given);
    spent += performance.now() - start;
  };
}

/** The frame is over: one measure as long as its parts together. */
export function closeFrame() {
  if (spent === 0) return;
  const end = performance.now();
  performance.measure(FRAME_MEASURE, { start: Math.max(0, end - spent), end });
  spent = 0;
}
