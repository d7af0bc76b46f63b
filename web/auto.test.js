import assert from "node:assert/strict";
import { test } from "node:test";
import "../tests/module.js";
import { asked, drawn, moved, placed, suggested, turned, turnedInto } from "./auto/demands.js";
import { createList } from "./auto/list.js";
import { round, stepped, steps, valueAt } from "./hand.js";
import { atValue } from "./stage/overlay.js";

/** @typedef {import("./auto/demands.js").Demand} Demand */
/** @typedef {import("./auto/demands.js").Placed} Placed */

const BY = { theta: 5, s: 0.5 };
/** @type {Placed} */
const DWELL = { kind: "dwell", from: 60, to: 120, s: 10, end: 10 };
/** @type {Placed} */
const LINE = { kind: "line", from: 60, to: 120, s: 10, end: 4 };

test("what is typed stands on the diagram as soon as no number is missing", () => {
  assert.deepEqual(placed({ kind: "dwell", from: "0", to: "60°", s: "2,5" }), { kind: "dwell", from: 0, to: 60, s: 2.5, end: 2.5, v: undefined });
  assert.equal(placed({ kind: "line", from: "0", to: "60", s: "2" }), undefined);
  assert.equal(placed({ kind: "point", from: "90", s: "12", v: "-3" })?.v, -3);
});

test("the engine is asked for all of them, or the first that lacks a number is told", () => {
  assert.deepEqual(asked([{ kind: "dwell", from: "0", to: "60", s: "0" }, { kind: "point", from: "90", s: "1", v: "" }]).all, [{ dwell: [0, 60], s: 0 }, { at: 90, s: 1 }]);
  assert.equal(asked([{ kind: "point", from: "90", s: "1" }, { kind: "point", from: "90", s: "1", v: "x" }]).bad, 1);
});

test("a part is brought to a round place, and stays within the turn, above the base circle and a step wide", () => {
  assert.deepEqual(moved(DWELL, "whole", { theta: 71.9, s: 12.2 }, BY), { from: 70, to: 130, s: 12 });
  assert.deepEqual(moved(DWELL, "whole", { theta: 400, s: -3 }, BY), { from: 300, to: 360, s: 0 });
  assert.deepEqual(moved(DWELL, "to", { theta: 10, s: 3 }, BY), { to: 65 });
  assert.deepEqual(moved(DWELL, "from", { theta: 133, s: 3 }, BY), { from: 115 });
  assert.deepEqual(moved(LINE, "to", { theta: 142, s: 7.3 }, BY), { to: 140, end: 7.5 });
  assert.deepEqual(moved(LINE, "whole", { theta: 60, s: 1 }, BY), { from: 60, to: 120, s: 6, end: 0 });
  assert.deepEqual(moved({ kind: "point", from: 90, to: 90, s: 1, end: 1 }, "whole", { theta: 371, s: 2 }, BY), { from: 360, s: 2 });
});

test("a tangent is turned to a round velocity, the finer the further it is pulled, and never upright", () => {
  /** @type {Placed} */
  const point = { kind: "point", from: 90, to: 90, s: 10, end: 10 };
  const away = (/** @type {number} */ radians, /** @type {number} */ up) => turned(point, { theta: 90 + (radians * 180) / Math.PI, s: 10 + up }, BY);
  assert.deepEqual([away(0.5, 4.2), away(-0.5, 4.2), away(2, 8.6), away(0.01, 3)], [{ v: 8 }, { v: -8 }, { v: 4.5 }, {}]);
});

test("what is drawn from right to left is the same as from left to right", () => {
  const [one, other] = [{ theta: 240, s: 20 }, { theta: 180, s: 12 }];
  assert.deepEqual(drawn("line", one, other), { from: 180, to: 240, s: 12, end: 20 });
  assert.deepEqual(drawn("dwell", one, other), { from: 180, to: 240, s: 20 });
  assert.deepEqual(drawn("point", one, other), { from: 180, s: 12 });
});

test("a new requirement goes where there is most room, at the height of the others", () => {
  assert.deepEqual(suggested("point", [DWELL], 8), { from: 240, s: 10 });
  assert.deepEqual(suggested("dwell", [], 8), { from: 165, to: 195, s: 8 });
  assert.deepEqual(suggested("line", [DWELL, { ...DWELL, from: 121, to: 355 }], 8), { from: 15, to: 45, s: 2.5, end: 7.5 });
});

test("another kind keeps the place", () => {
  assert.deepEqual(turnedInto(LINE, "point"), { from: 60, s: 10 });
  assert.deepEqual(turnedInto({ kind: "point", from: 340, to: 340, s: 1, end: 1 }, "line"), { from: 340, to: 360, s: 1, end: 1 });
});

test("a gesture is taken back at once, and what is under way as if it had never been", () => {
  const list = createList(() => "es");
  list.begin([]);
  const text = () => list.all.map(({ from }) => from).join();
  /** @param {number} from @param {string} gesture */
  const put = (from, gesture) => list.edit((draft) => void (draft[0] = { kind: "point", ...list.texts({ from }) }), gesture);
  put(1, "a");
  put(2.5, "a");
  assert.equal(text(), "2,5");
  put(3, "b");
  list.cancel("b");
  assert.equal(text(), "2,5");
  list.undo();
  assert.equal(text(), "");
  list.redo();
  assert.equal(text(), "2,5");
  list.endGesture();
  put(4, "a");
  list.undo();
  assert.equal(text(), "2,5");
});

test("a hand finds the value that a diagram drew there, and its steps are round and as wide as it can tell", () => {
  const row = { area: { left: 40, top: 5, width: 720, height: 200, x_min: 0, x_max: 360, y_min: -1, y_max: 25 }, x: 3, y: 7, place: 0, colour: "" };
  for (const value of [-1, 0, 12.5, 25]) assert.equal(stepped(valueAt(row, atValue(row, value)), 0.001), value);
  assert.deepEqual(steps(row), { theta: 5, s: 1 });
  assert.deepEqual([0.52, 0.5, 1.01, 5.2, 0.0021].map(round), [1, 0.5, 2, 10, 0.005]);
});
