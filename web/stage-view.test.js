import assert from "node:assert/strict";
import test from "node:test";
import { approach, fitView, include, roundLength, worldX, worldY, zoomed } from "./stage/view.js";

const BOX = { left: -40, right: 60, bottom: -40, top: 160 };

test("a fitted view holds the whole box, centred, within its margin", () => {
  const view = fitView(BOX, 400, 300, 10);
  assert.equal(view.scale, 280 / 200);
  assert.equal(worldY(view, 10), 160);
  assert.equal(worldY(view, 290), -40);
  assert.ok(Math.abs(worldX(view, 200) - 10) < 1e-12);
});

test("a box without size and a canvas without room still give a finite view", () => {
  const view = fitView({ left: 0, right: 0, bottom: 0, top: 0 }, 0, 0, 14);
  assert.ok(view.scale > 0);
  assert.ok(!Number.isNaN(view.x) && !Number.isNaN(view.y));
});

test("zooming keeps the point under the pointer", () => {
  const view = fitView(BOX, 400, 300, 10);
  const closer = zoomed(view, 2.5, 120, 80, 0, Infinity);
  assert.ok(Math.abs(worldX(closer, 120) - worldX(view, 120)) < 1e-12);
  assert.ok(Math.abs(worldY(closer, 80) - worldY(view, 80)) < 1e-12);
  assert.equal(closer.scale, view.scale * 2.5);
});

test("zooming stops at its limits, and then moves nothing", () => {
  const view = { scale: 10, x: 5, y: 7 };
  assert.deepEqual(zoomed(view, 3, 100, 100, 1, 10), view);
  assert.equal(zoomed(view, 0.001, 100, 100, 1, 10).scale, 1);
});

test("a gliding view arrives, exactly", () => {
  const view = { scale: 1, x: 0, y: 0 };
  const goal = { scale: 4, x: 200, y: -30 };
  let frames = 0;
  while (!approach(view, goal, 0.25)) frames += 1;
  assert.ok(frames > 5 && frames < 60, `${frames} frames`);
  assert.ok(Math.abs(view.scale - goal.scale) < 1e-12);
  assert.deepEqual([view.x, view.y], [goal.x, goal.y]);
});

test("the scale bar is the longest of 1, 2, 5 that fits", () => {
  for (const [most, expected] of [[1, 1], [1.9, 1], [2, 2], [4.99, 2], [73, 50], [0.0071, 0.005], [1999, 1000]]) {
    assert.ok(Math.abs(roundLength(most) - expected) < 1e-12 * expected, `${most}: ${roundLength(most)}`);
  }
});

test("a box grows to hold a disc, and never shrinks", () => {
  const box = { ...BOX };
  include(box, 100, 0, 5);
  assert.deepEqual(box, { left: -40, right: 105, bottom: -40, top: 160 });
  include(box, 0, 0, 1);
  assert.deepEqual(box, { left: -40, right: 105, bottom: -40, top: 160 });
});
