/** Work that can wait until the hand rests, so that an edit is not kept waiting for it. */

/** Milliseconds without an edit. */
const RESTING = 90;

/**
 * Gives back a function that runs `work` once it has not been called for a moment.
 * @param {() => void} work
 */
export function atRest(work) {
  let timer = 0;
  return () => {
    clearTimeout(timer);
    timer = window.setTimeout(work, RESTING);
  };
}
