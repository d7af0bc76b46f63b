import assert from "node:assert/strict";
import { test } from "node:test";
import { changeFollower } from "./follower-change.js";
import * as program from "./program.js";

/** @returns {import("./types.d.ts").Design} */
function nine() {
  return {
    format: "levalab/1",
    title: "9RT",
    length_unit: "mm",
    speed: { value: 1, unit: "rad/s" },
    cam: { kind: "rotating", rotation: "counterclockwise", base_radius: 35 },
    follower: { motion: "translating", contact: "roller", roller_radius: 7, eccentricity: 0 },
    segments: [10, 0, -10, 0, 10, 0, -10, 0].map((rise) => (rise ? { law: "cycloidal", beta: 50, rise } : { law: "dwell", beta: 40, rise: 0 })),
  };
}

/** @param {import("./types.d.ts").Design} design */
function isClosed(design) {
  return program.degreesLeft(design) === 0 && program.heightAt(design) === 0;
}

test("what is left of the turn is told without the noise of sums", () => {
  const design = nine();
  assert.equal(program.degreesLeft(design), 0);
  design.segments = Array.from({ length: 7 }, () => ({ law: "dwell", beta: 360 / 7, rise: 0 }));
  assert.equal(program.degreesLeft(design), 0);
  design.segments.pop();
  assert.equal(program.degreesLeft(design), 51.4285714286);
});

test("each way to complete the turn completes it", () => {
  const short = nine();
  short.segments.pop();
  for (const complete of [program.fillWithDwell, program.stretchLast, program.spread]) {
    const draft = structuredClone(short);
    complete(draft);
    assert.ok(isClosed(draft), complete.name);
  }
  const open = nine();
  open.segments.splice(6);
  open.segments.push({ law: "dwell", beta: 30, rise: 0 });
  program.fillWithReturn(open);
  assert.ok(isClosed(open));
  assert.deepEqual(open.segments.at(-1), { law: "cycloidal", beta: 60, rise: -10 });
});

test("a turn that is too long is spread or shortened", () => {
  const long = nine();
  program.duplicate(long, 1);
  assert.equal(program.degreesLeft(long), -40);
  assert.equal(program.canStretchLast(long), false);
  program.spread(long);
  assert.equal(program.degreesLeft(long), 0);
});

test("the last move closes the height", () => {
  const design = nine();
  design.segments[4] = { law: "cycloidal", beta: 50, rise: 7.3 };
  program.closeWithLastMove(design);
  assert.equal(design.segments[6]?.rise, -7.3);
});

test("an inserted segment leaves a good program good", () => {
  for (let index = 0; index <= 8; index++) {
    const design = nine();
    program.insert(design, index, Math.min(index, 7));
    assert.equal(design.segments.length, 9);
    assert.ok(isClosed(design));
  }
});

test("moving a segment keeps all the others in order", () => {
  const design = nine();
  const moved = design.segments[2];
  program.move(design, 2, 5);
  assert.equal(design.segments[5], moved);
  assert.ok(isClosed(design));
});

test("a law that moves gets a rise that closes the program", () => {
  const design = nine();
  design.segments[6] = { law: "dwell", beta: 50, rise: 0 };
  program.changeLaw(design, 6, { id: "scca", moves: true, free: null, parameters: [{ key: "b", quantity: "ratio", default: 0.25 }] });
  assert.deepEqual(design.segments[6], { law: "scca", beta: 50, rise: -10, b: 0.25 });
  program.changeLaw(design, 6, { id: "dwell", moves: false, free: null, parameters: [] });
  assert.deepEqual(design.segments[6], { law: "dwell", beta: 50, rise: 0 });
});

test("a cure's edits go where their paths say", () => {
  const design = nine();
  program.applyEdits(design, [
    { path: ["cam", "base_radius"], value: 43.3 },
    { path: ["segments", 2, "law"], value: "polynomial-4-5-6-7" },
  ]);
  assert.equal(design.cam.base_radius, 43.3);
  assert.equal(design.segments[2]?.law, "polynomial-4-5-6-7");
});

const length = (/** @type {string} */ key) => ({ key, symbol: key, quantity: /** @type {const} */ ("length"), default: null, optional: false });

test("another follower keeps what it can and swings about as far as it rose", () => {
  const design = nine();
  changeFollower(design, {
    id: "oscillating-roller",
    motion: "oscillating",
    contact: "roller",
    parameters: [length("roller_radius"), length("arm"), length("pivot_distance"), { key: "pivot_angle", symbol: "δ", quantity: "angle", default: 0, optional: true }],
  });
  assert.deepEqual(design.follower, { motion: "oscillating", contact: "roller", roller_radius: 7, arm: 65, pivot_distance: 65, pivot_angle: 0 });
  assert.equal(design.segments[0]?.rise, 8.8);
  assert.ok(isClosed(design));

  changeFollower(design, { id: "translating-curved", motion: "translating", contact: "curved", parameters: [length("face_radius"), length("eccentricity")] });
  assert.deepEqual(design.follower, { motion: "translating", contact: "curved", face_radius: 7, eccentricity: 0 });
  assert.equal(design.segments[0]?.rise, 10);
  assert.ok(isClosed(design));
});
