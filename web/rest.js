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

/** Milliseconds of one slice of a long work: a frame is drawn between two of them. */
const SLICE = 8;

/** Milliseconds after which a step of a work was too long, so that the next step gets a smaller budget. */
const STEP = 4;

/** The largest budget of a step: its parts differ in length, and one that was quick says little about the next. */
const LARGEST_BUDGET = 4;

/**
 * Starts a long work in slices, each a task of its own, until it returns something.
 * @template T
 * @param {(budget: number) => T | undefined} step  goes on with the work; `undefined` while it is not done
 * @param {(result: T) => void} done
 * @returns {() => void} drops the work
 */
export function inSlices(step, done) {
  let budget = 1;
  let timer = window.setTimeout(slice);
  function slice() {
    const start = performance.now();
    for (let now = start; now < start + SLICE; ) {
      const result = step(budget);
      if (result !== undefined) return done(result);
      const spent = performance.now() - now;
      budget = spent > STEP ? Math.max(1, budget >> 1) : Math.min(LARGEST_BUDGET, budget * 2);
      now += spent;
    }
    timer = window.setTimeout(slice);
  }
  return () => clearTimeout(timer);
}
