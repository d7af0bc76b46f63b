// The module that writes files, as it is shipped, writes what the command line writes.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { initSync, make } from "../../web/pkg/levalab_export_wasm.js";

const root = path.resolve(import.meta.dirname, "../..");
const { LEVALAB_CLI: cli, LEVALAB_MODULE: module } = process.env;
assert(cli && module, "LEVALAB_CLI and LEVALAB_MODULE name what to compare: run `cargo xtask test wasm`");
initSync({ module: readFileSync(path.join(module, "levalab_export_wasm_bg.wasm")) });

/** Only sin, cos and their like may differ, in the last digits, and tables keep twelve of them. */
const TOLERANCE = 1e-9;

/** @param {string} name @param {string[]} options */
function native(name, options) {
  const file = path.join(root, "examples", `${name}.lev.json`);
  return execFileSync(/** @type {string} */ (cli), ["export", file, "-o", "-", "--lang", "es", ...options], { maxBuffer: 1e8 });
}

/** @param {string} name @param {import("../../web/types.d.ts").ExportOrder} order */
function here(name, order) {
  const design = JSON.parse(readFileSync(path.join(root, "examples", `${name}.lev.json`), "utf8"));
  const { bytes, error } = make(design, order, "es");
  assert(bytes, error);
  return Buffer.from(bytes);
}

for (const name of ["9RT", "2RO", "10EX", "R1"]) {
  test(`${name}: tables agree`, () => {
    const cells = (/** @type {Buffer} */ text) => text.toString().split(/[;\r\n]+/).map((cell) => Number(cell.replace(",", ".")) || cell);
    const [expected, found] = [cells(native(name, ["--to", "csv"])), cells(here(name, { to: "csv" }))];
    assert.equal(found.length, expected.length);
    expected.forEach((cell, k) => {
      if (typeof cell === "string") return assert.equal(found[k], cell);
      assert(Math.abs(Number(found[k]) - cell) <= TOLERANCE * Math.max(1, Math.abs(cell)) * 1e3, `${found[k]}, natively ${cell}`);
    });
  });

  test(`${name}: drawing, workbook, CAD and solid are the same in size`, () => {
    for (const to of /** @type {const} */ (["svg", "dxf", "stl"])) {
      const [expected, found] = [native(name, ["--to", to]), here(name, { to })];
      assert(Math.abs(found.length - expected.length) <= 0.001 * expected.length, `${to}: ${found.length}, natively ${expected.length}`);
    }
    assert.equal(here(name, { to: "xlsx" }).subarray(0, 2).toString(), "PK");
  });
}
