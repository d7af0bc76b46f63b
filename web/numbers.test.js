import assert from "node:assert/strict";
import { test } from "node:test";
import { createFormat, fieldText, parseNumber, restingText } from "./numbers.js";

/** @type {[string, number][]} */
const READABLE = [
  ["1,5", 1.5],
  ["1.5", 1.5],
  ["-3", -3],
  ["−3", -3],
  ["+2", 2],
  [" 12 ", 12],
  ["1,5e3", 1500],
  ["2E-3", 0.002],
  [".5", 0.5],
  ["5,", 5],
  ["48 185,28", 48185.28],
  ["48\u202f185.28", 48185.28],
  ["1 000 000", 1e6],
  ["35 mm", 35],
  ["30°", 30],
];

/** @type {[string, string][]} */
const UNREADABLE = [
  ["", "empty"],
  ["   ", "empty"],
  ["1.234,5", "two-signs"],
  ["1,2,3", "two-signs"],
  ["1,5e", "exponent"],
  ["1e-", "exponent"],
  ["1e999", "huge"],
  ["abc", "unreadable"],
  ["-", "unreadable"],
  ["12 3", "unreadable"],
  ["1/3", "unreadable"],
  ["0x10", "unreadable"],
  ["Infinity", "unreadable"],
  ["NaN", "unreadable"],
];

test("comma, point, spaces, minus signs and the field's unit are understood", () => {
  for (const [text, value] of READABLE) {
    assert.deepEqual(parseNumber(text, "mm"), { value }, text);
  }
});

test("what is not a number says why", () => {
  for (const [text, problem] of UNREADABLE) assert.deepEqual(parseNumber(text, "mm"), { problem }, text);
});

test("a field gives back exactly the number it shows, in both languages", () => {
  for (const value of [0, 1.5, -3, 0.1 + 0.2, 360 / 7, 1e-9, -2.5e21, 48185.28, Number.MIN_VALUE, Number.MAX_VALUE]) {
    for (const language of /** @type {const} */ (["en", "es"])) {
      assert.deepEqual(parseNumber(fieldText(value, language)), { value }, `${value} ${language}`);
    }
  }
});

test("numbers are shown in the language's form", () => {
  const en = createFormat(() => "en");
  const es = createFormat(() => "es");
  assert.equal(en.number(1.5), "1.5");
  assert.equal(es.number(1.5), "1,5");
  assert.equal(es.number(-48185.28), "−48\u202f185,28");
  assert.equal(en.number(1029.6), "1029.6");
  assert.equal(en.number(0.1 + 0.2), "0.3");
  assert.equal(en.number(3, { digits: 2, unit: "mm" }), "3.00\u00a0mm");
  assert.equal(es.angle(-28.18), "−28,2°");
  assert.equal(en.angle(-0.01), "0.0°");
  assert.equal(en.number(null), "–");
  assert.equal(en.number(-Infinity), "−∞");
});

test("a field at rest shows all of a number that it has room for, and that there is more of one that it has not", () => {
  assert.equal(restingText(256.32, 6, "es"), "256,32");
  assert.equal(restingText(0.1 + 0.2, 6, "en"), "0.3");
  // Rounded, seven of them would add up to more than a turn.
  assert.equal(restingText(360 / 7, 6, "es"), "51,4…");
  assert.equal(restingText(359.999999, 6, "en"), "359.…");
  assert.equal(restingText(-1.377952755905, 7, "en"), "−1.37…");
  assert.equal(restingText(0.000123456789, 7, "en"), "0.000123…");
  assert.equal(restingText(1.23456789e-9, 7, "en"), "1.23…e-9");
  assert.equal(restingText(123456789, 6, "en"), "123456789");
});

test("a quantity keeps four figures and never rounds whole digits away", () => {
  const { quantity } = createFormat(() => "en");
  assert.equal(quantity(48185.28), "48\u202f185");
  assert.equal(quantity(12.3456), "12.35");
  assert.equal(quantity(0.00123456), "0.001235");
  assert.equal(quantity(10), "10.00");
  assert.equal(quantity(10, { trim: true, unit: "mm" }), "10\u00a0mm");
  assert.equal(quantity(100, { trim: true }), "100");
  assert.equal(quantity(0), "0");
  assert.equal(quantity(-1.234e-7), "−1.234·10⁻⁷");
  assert.equal(quantity(9.99999), "10.00");
});
