import assert from "node:assert/strict";
import { test } from "node:test";
import { createStore } from "./store.js";

/** @typedef {import("./types.d.ts").Design} Design */
/** @typedef {import("./types.d.ts").Report} Report */

/** A store whose analysis refuses negative base radii, and whose frames come when asked. */
function bench() {
  const store = createStore();
  /** @type {(() => void)[]} */
  const frames = [];
  /** @type {unknown[]} */
  const failures = [];
  /** @type {string[]} */
  const refusals = [];
  store.connect({
    analyse: (design) =>
      (design.cam.base_radius ?? 0) > 0
        ? { report: /** @type {Report} */ (/** @type {unknown} */ ({ link: `1.${design.cam.base_radius}` })), outline: null }
        : { error: { path: "cam.base_radius", message: "must be positive" }, outline: null },
    apply(design, edits) {
      const draft = structuredClone(design);
      for (const edit of edits) {
        if (!("value" in edit && "path" in edit)) return { error: { path: "", message: "not possible" } };
        draft.cam.base_radius = Number(edit.value);
      }
      return { design: draft };
    },
    refused: (error) => refusals.push(error.message),
    failed: (error) => failures.push(error),
    frame: (draw) => frames.push(draw),
  });
  assert.ok(store.start(/** @type {Design} */ (/** @type {unknown} */ ({ title: "", cam: { base_radius: 35 } }))));
  const frame = () => {
    const due = frames.splice(0);
    for (const draw of due) draw();
    return due.length;
  };
  frame();
  return { store, frame, failures, refusals };
}

/** @param {number} radius */
const toRadius = (radius) => [{ path: ["cam", "base_radius"], value: radius }];

test("an edit never touches the design that was there", () => {
  const { store } = bench();
  const { design } = store.state;
  store.edit("radius", toRadius(40));
  assert.equal(design.cam.base_radius, 35);
  assert.equal(store.state.design.cam.base_radius, 40);
});

test("the last good report stays while the design is wrong", () => {
  const { store } = bench();
  store.edit("radius", toRadius(-1));
  assert.equal(store.state.error?.path, "cam.base_radius");
  assert.equal(store.state.stale, true);
  assert.equal(store.state.report.link, "1.35");
  assert.equal(store.lastGood().cam.base_radius, 35);
  store.edit("radius", toRadius(36));
  assert.equal(store.state.error, null);
  assert.equal(store.state.stale, false);
});

test("an edit that is refused changes nothing, leaves no undo step, and is told once", () => {
  const { store, refusals } = bench();
  store.edit("radius", toRadius(36));
  store.undo();
  const { design } = store.state;
  assert.deepEqual(store.edit("segments", [{ op: "spread" }]), { path: "", message: "not possible" });
  assert.equal(store.state.design, design);
  assert.deepEqual([store.canUndo(), store.canRedo()], [false, true]);
  assert.deepEqual(refusals, ["not possible"]);
  store.edit("segments", [{ op: "spread" }], { told: true });
  assert.deepEqual(refusals, ["not possible"]);
});

test("a gesture is one undo step", () => {
  const { store } = bench();
  for (const radius of [36, 37, 38]) store.edit("radius", toRadius(radius), { gesture: "drag:1" });
  store.edit("radius", toRadius(50), { gesture: "drag:2" });
  store.undo();
  assert.equal(store.state.design.cam.base_radius, 38);
  store.undo();
  assert.equal(store.state.design.cam.base_radius, 35);
  assert.equal(store.canUndo(), false);
  store.redo();
  store.redo();
  assert.equal(store.state.design.cam.base_radius, 50);
  assert.equal(store.canRedo(), false);
});

test("a gesture that is over does not go on", () => {
  const { store } = bench();
  store.edit("radius", toRadius(36), { gesture: "field" });
  store.endGesture();
  store.edit("radius", toRadius(37), { gesture: "field" });
  store.undo();
  assert.equal(store.state.design.cam.base_radius, 36);
});

test("a cancelled gesture leaves no trace", () => {
  const { store } = bench();
  store.edit("radius", toRadius(36), { gesture: "field" });
  store.cancel("field");
  assert.equal(store.state.design.cam.base_radius, 35);
  assert.equal(store.canUndo(), false);
  store.cancel("field");
  assert.equal(store.state.design.cam.base_radius, 35);
});

test("a new edit forgets what was undone", () => {
  const { store } = bench();
  store.edit("radius", toRadius(36));
  store.undo();
  store.edit("radius", toRadius(37));
  assert.equal(store.canRedo(), false);
});

test("another design put in place can be undone", () => {
  const { store } = bench();
  store.replace(/** @type {Design} */ ({ ...store.state.design, title: "other" }), "link opened");
  assert.equal(store.undoLabel(), "link opened");
  store.undo();
  assert.equal(store.state.design.title, "");
});

test("many changes are drawn in one frame, and only by whom they concern", () => {
  const { store, frame } = bench();
  /** @type {string[][]} */
  const seen = [];
  store.subscribe(["cursor", "report"], (_, changed) => seen.push([...changed].sort()));
  store.subscribe(["language"], () => assert.fail("nothing changed here"));
  store.set({ cursor: 1 });
  store.set({ cursor: 2 });
  store.edit("radius", toRadius(36));
  assert.equal(frame(), 1);
  assert.deepEqual(seen, [["cursor", "design", "report"]]);
  store.set({ cursor: 2 });
  assert.equal(frame(), 0);
});

test("a listener that leaves is not called, and one that fails does not stop the others", () => {
  const { store, frame, failures } = bench();
  let calls = 0;
  const leave = store.subscribe(["cursor"], () => assert.fail("it left"));
  store.subscribe(["cursor"], () => {
    throw new Error("broken");
  });
  store.subscribe(["cursor"], () => (calls += 1));
  leave();
  store.set({ cursor: 5 });
  frame();
  assert.equal(calls, 1);
  assert.equal(failures.length, 1);
});

test("each edit is measured once, with the frame that shows it", () => {
  const { store, frame } = bench();
  performance.clearMeasures();
  store.edit("radius", toRadius(36), { gesture: "drag" });
  store.edit("radius", toRadius(37), { gesture: "drag" });
  frame();
  const [measure, ...others] = performance.getEntriesByName("levalab:edit");
  assert.equal(others.length, 0);
  assert.ok(measure && measure.duration >= 0);
  store.set({ cursor: 9 });
  frame();
  assert.equal(performance.getEntriesByName("levalab:edit").length, 1);
});
