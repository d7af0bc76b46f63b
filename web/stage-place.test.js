import assert from "node:assert/strict";
import test from "node:test";
import { headlined } from "./stage/place.js";

/** @param {object | null} conjugate @param {number} [cam] @param {boolean} [second] */
const state = (conjugate, cam, second = false) => /** @type {any} */ ({ second, report: { verdict: { cam }, conjugate } });

test("a cam that is no pair has no number", () => {
  const alone = state(null);
  assert.deepEqual(headlined(alone), { report: alone.report, cam: undefined });
});

test("figures are of the cam that the headline is about, whichever is in sight", () => {
  const conjugate = {};
  for (const second of [false, true]) {
    const worse = state(conjugate, 2, second);
    assert.equal(headlined(worse).report, conjugate);
    assert.equal(headlined(worse).cam, 2);
    const better = state(conjugate, 1, second);
    assert.equal(headlined(better).report, better.report);
    assert.equal(headlined(better).cam, 1);
  }
});

test("a headline about both cams leaves the figures to the cam in sight", () => {
  const conjugate = {};
  assert.equal(headlined(state(conjugate, undefined, true)).report, conjugate);
  const first = state(conjugate, undefined, false);
  assert.deepEqual(headlined(first), { report: first.report, cam: 1 });
});
