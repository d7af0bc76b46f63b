/** Work that can wait: until the hand rests, or until the browser has nothing else to do. */

/** Milliseconds without an edit. */
const RESTING = 90;

/** Milliseconds after which work is no longer put off: on a slow machine that animates, the browser is never idle. */
const PATIENCE = 2000;

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

/**
 * Does `work` when the browser is idle, at the latest after `PATIENCE`.
 * @param {() => void} work
 */
export function whenIdle(work) {
  // Safari has no such callback.
  if ("requestIdleCallback" in globalThis) requestIdleCallback(() => work(), { timeout: PATIENCE });
  else setTimeout(work, PATIENCE / 10);
}
