import assert from "node:assert/strict";
import { test } from "node:test";
import "../tests/module.js";
import { pastedPoints } from "./pasted.js";

const POINTS = [[0, 0], [60, 5], [120, 12.5], [360, 0]];

test("a table of a cam editor is read past its words, and one of a text past its comments", () => {
  const editor = "CYCLIC;YES;\nTABLE_BEGIN;;\n0;0;SPLINE\n60;5;SPLINE\n120;12.5;SPLINE\n360;0;SPLINE\nTABLE_END;;\n";
  assert.deepEqual(pastedPoints(editor), { points: POINTS });
  const commented = "# measured\n0,0 0,0 // point 1\n60,0 5,0 // point 2\n\n120,0 12,5 // point 3\n360,0 0,0 // point 4\n";
  assert.deepEqual(pastedPoints(commented), { points: POINTS });
  assert.deepEqual(pastedPoints("theta;s\n0;0\n60;5\n120;12,5\n360;0"), { points: POINTS });
});

test("what cannot be read is told by its line", () => {
  assert.deepEqual(pastedPoints("0 0\n60 five5\n360 0"), { line: 2 });
  assert.deepEqual(pastedPoints("0 0 0\n60 5 1"), { line: 1 }, "which of three columns?");
  assert.deepEqual(pastedPoints("\nnothing but words\nhere"), { line: 2 }, "a text without points is not an empty table");
  assert.deepEqual(pastedPoints(" \n"), { points: [] });
});
