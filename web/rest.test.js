import assert from "node:assert/strict";
import { test } from "node:test";

/** A clock that only work moves, so that the test does not depend on the machine. */
let clock = 0;
Object.assign(globalThis, { window: globalThis });
Object.defineProperty(globalThis, "performance", { value: { now: () => clock } });
const { inSlices } = await import("./rest.js");

test("a long work leaves the page a turn between its slices, none of them long", async () => {
  let left = 100;
  /** When each slice began and ended. @type {number[]} */
  const turns = [];
  const step = (/** @type {number} */ budget) => {
    const part = Math.min(left, budget);
    // Each look takes three milliseconds.
    clock += 3 * part;
    left -= part;
    return left > 0 ? undefined : "done";
  };
  const watch = () => {
    turns.push(clock);
    if (left > 0) setTimeout(watch);
  };
  watch();
  assert.equal(await new Promise((done) => inSlices(step, done)), "done");
  assert.equal(clock, 300);
  const slices = turns.slice(1).map((end, i) => end - turns[i]);
  assert(Math.max(...slices) <= 20, `a slice of ${Math.max(...slices)} ms`);
  assert(slices.filter((slice) => slice > 0).length > 10, `${slices}`);
});

test("a work that is dropped goes no further", async () => {
  let steps = 0;
  const drop = inSlices(
    () => {
      steps++;
      clock += 10;
      return undefined;
    },
    () => assert.fail("it is never done"),
  );
  await new Promise((resolve) => setTimeout(resolve, 40));
  drop();
  const before = steps;
  assert(before > 0);
  await new Promise((resolve) => setTimeout(resolve, 40));
  assert.equal(steps, before);
});
