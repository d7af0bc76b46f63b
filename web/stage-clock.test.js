import assert from "node:assert/strict";
import test from "node:test";
import { FASTEST, SLOWEST, WHEEL, afterKey, positionOf, rateAt, stepped, turned, wrap } from "./stage/clock.js";

/** @param {string} name */
const key = (name, modifiers = {}) => ({ key: name, shiftKey: false, altKey: false, ...modifiers });

test("angles wrap into one turn", () => {
  for (const [theta, expected] of [[0, 0], [360, 0], [-1, 359], [725, 5], [-720, 0]]) assert.equal(wrap(theta) + 0, expected);
});

test("the clock turns by rate and time, backwards too, past 360°", () => {
  assert.equal(turned(350, 0.25, 0.1), 359);
  assert.equal(turned(355, 0.5, 0.1), 13);
  assert.equal(turned(5, -0.5, 0.1), 347);
  assert.equal(turned(5, 0, 0.1), 5);
});

test("a tab that slept does not make the cam leap, nor a clock that ran back", () => {
  assert.equal(turned(0, 1, 3600), 36);
  assert.equal(turned(10, 1, -5), 10);
});

test("steps go to the next whole step", () => {
  for (const [cursor, step, expected] of [
    [143, 1, 144], [143.27, 1, 144], [143.27, -1, 143], [0, -1, 359], [359.5, 1, 0],
    [12, 10, 20], [20, -10, 10], [0.2, 0.1, 0.3], [0, -0.1, 359.9], [143.2, 0.1, 143.3],
  ]) assert.equal(stepped(cursor, step), expected, `${cursor} by ${step}`);
});

test("a whole turn of tenths comes back to where it began", () => {
  let cursor = 0;
  for (let i = 0; i < 3600; i++) cursor = stepped(cursor, 0.1);
  assert.equal(cursor, 0);
});

test("the hand wheel stands still in the middle and is the same both ways", () => {
  assert.equal(rateAt(0), 0);
  assert.equal(rateAt(3), 0);
  assert.ok(Math.abs(rateAt(WHEEL) - FASTEST) < 1e-12);
  assert.equal(rateAt(-60), -rateAt(60));
  let before = 0;
  for (let position = 6; position <= WHEEL; position++) {
    assert.ok(rateAt(position) > before);
    before = rateAt(position);
  }
  assert.ok(rateAt(6) >= SLOWEST);
});

test("a rate is shown where the wheel would give it", () => {
  assert.equal(positionOf(0), 0);
  for (const position of [-100, -57, -6, 6, 40, 100]) assert.equal(positionOf(rateAt(position)), position);
  assert.equal(positionOf(50), WHEEL);
  assert.equal(positionOf(-1e-9), -5);
});

test("keys move the cursor by 1°, 10° and 0.1°, and to the ends", () => {
  assert.equal(afterKey(10, key("ArrowRight")), 11);
  assert.equal(afterKey(10, key("ArrowLeft", { shiftKey: true })), 0);
  assert.equal(afterKey(10, key("ArrowUp", { altKey: true })), 10.1);
  assert.equal(afterKey(10, key("Home")), 0);
  assert.equal(afterKey(10, key("End")), 359);
  assert.equal(afterKey(10, key("x")), null);
});
