// The module as it is shipped, optimiser and all, computes what the command line computes.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { CATALOGUE } from "../../web/pkg/catalogue.js";
import { Lab, edit, initSync, read_design } from "../../web/pkg/levalab_wasm.js";
import { design_by_law, initSync as initWorkshop, tournament_of } from "../../web/pkg/levalab_workshop_wasm.js";

/** Both run the same arithmetic; only sin, cos and their like may differ, in the last digits. Relative to the column's scale. */
const TOLERANCE = 1e-12;

/** Scales that a column has by its nature, deg: the pressure angle of a flat follower is zero, but for rounding. */
const SCALES = /** @type {Record<string, number>} */ ({ pressure_angle: 90 });

const SAMPLES = 720;
const root = path.resolve(import.meta.dirname, "../..");
const { LEVALAB_CLI: cli, LEVALAB_MODULE: module } = process.env;
assert(cli && module, "LEVALAB_CLI and LEVALAB_MODULE name what to compare: run `cargo xtask test wasm`");
initSync({ module: readFileSync(path.join(module, "levalab_wasm_bg.wasm")) });
initWorkshop({ module: readFileSync(path.join(module, "levalab_workshop_wasm_bg.wasm")) });

const examples = readdirSync(path.join(root, "examples")).filter((name) => name.endsWith(".lev.json"));
assert(examples.length > 0, "no examples");

/** Kinds of cam and pairs, which no example may be. */
const LIFT = [{ law: "polynomial-4-5-6-7", beta: 110, rise: 9 }, { law: "dwell", beta: 40 }, { law: "cycloidal", beta: 140, rise: -9 }, { law: "dwell", beta: 70 }];
const ROLLER = { motion: "translating", contact: "roller", roller_radius: 8 };
const KINDS = {
  "roller pair": { cam: { kind: "rotating", base_radius: 50 }, follower: { ...ROLLER, eccentricity: 5 }, conjugate: { distance: 130, roller_radius: 6 }, segments: LIFT },
  "swinging pair": { cam: { kind: "rotating", base_radius: 80 }, follower: { motion: "oscillating", contact: "flat", face_offset: 8, pivot_distance: 150 }, conjugate: { angle: 85 }, segments: LIFT },
  "constant breadth": { cam: { kind: "constant-breadth", base_radius: 48, breadth: 100, generator: "circular-arc", sides: 5 }, follower: { motion: "translating", contact: "flat" } },
  groove: { cam: { kind: "grooved", base_radius: 50 }, follower: ROLLER, segments: LIFT },
  wedge: { cam: { kind: "translating", length: 200 }, speed: { value: 30, unit: "mm/s" }, follower: ROLLER, segments: [{ law: "cycloidal", beta: 120, rise: 20 }, { law: "dwell", beta: 80 }] },
};

for (const [name, part] of Object.entries(KINDS)) {
  test(`${name}: every column agrees, those of a second cam too`, () => {
    const design = { format: "levalab/1", title: "", ...part };
    const json = execFileSync(/** @type {string} */ (cli), ["analyze", "-", "--samples", String(SAMPLES), "--json"], { input: JSON.stringify(design), encoding: "utf8", maxBuffer: 1e8 });
    const native = JSON.parse(json);
    const lab = new Lab();
    const opened = lab.open(/** @type {any} */ (design), SAMPLES, "en");
    assert(!("error" in opened), JSON.stringify(opened));
    assert.equal(opened.report.conjugate === null, native.conjugate === undefined);
    for (const second of native.conjugate ? [false, true] : [false]) {
      const { columns, verdict } = second ? native.conjugate : native;
      for (const [column, expected] of Object.entries(columns)) compare(column, lab.column(/** @type {any} */ (column), second), /** @type {any} */ (expected));
      /** @type {import("../../web/types.d.ts").Report | null} */
      const report = second ? opened.report.conjugate : opened.report;
      assert.deepEqual(report?.verdict.findings.filter(({ cam }) => cam !== (second ? 1 : 2)).map(({ message }) => message), verdict.findings.map((/** @type {any} */ { message }) => message));
    }
  });
}

for (const example of examples) {
  test(`${example}: every column agrees`, () => {
    const file = path.join(root, "examples", example);
    const json = execFileSync(/** @type {string} */ (cli), ["analyze", file, "--samples", String(SAMPLES), "--json"], { encoding: "utf8", maxBuffer: 1e8 });
    /** @type {Record<string, (number | null)[]>} */
    const columns = JSON.parse(json).columns;
    const lab = new Lab();
    const opened = lab.open(JSON.parse(readFileSync(file, "utf8")), SAMPLES, "en");
    assert(!("error" in opened), JSON.stringify(opened));
    for (const [name, expected] of Object.entries(columns)) {
      compare(name, lab.column(/** @type {any} */ (name)), expected);
    }
  });
}

/** @type {import("../../web/types.d.ts").Edit[][]} */
const EDITS = [
  [{ path: ["cam", "base_radius"], value: 61.5 }, { op: "scale", factor: 0.5 }],
  [{ op: "insert", at: 1, from: 0 }, { op: "law", segment: 1, law: "scca" }, { op: "close" }],
  [{ op: "duplicate", segment: 0 }, { op: "spread" }, { op: "close" }],
  [{ op: "law", segment: 0, law: "polynomial" }, { op: "add-condition", segment: 0 }],
  [{ op: "kind", kind: "translating" }],
  [{ op: "kind", kind: "constant-breadth" }, { op: "generator", generator: "mirror" }, { op: "kind", kind: "grooved" }],
  [{ op: "follower", follower: "oscillating-roller" }],
  [{ op: "follower", follower: "translating-flat" }, { op: "pair", tie: "distance" }],
  [{ op: "convert", unit: "in" }, { op: "relabel", unit: "cm" }],
  [{ op: "application", application: "pump" }, { op: "new" }],
  [{ op: "delete", segments: [0, 99] }],
];

for (const example of examples) {
  test(`${example}: an edit of the page gives the design, or the reason, of the command`, () => {
    const file = path.join(root, "examples", example);
    const design = JSON.parse(readFileSync(file, "utf8"));
    let good = 0;
    for (const edits of EDITS) {
      /** @type {{ status: number | null, stdout: string, stderr: string }} */
      const told = spawnSync(/** @type {string} */ (cli), ["edit", file, JSON.stringify(edits), "--lang", "es"], { encoding: "utf8" });
      const draft = edit(design, edits, "es");
      const found = draft.design ? read_design(draft.design, "es") : draft;
      if (told.status === 0) {
        good += 1;
        assert.deepEqual(found.design, JSON.parse(told.stdout), JSON.stringify(edits));
      } else {
        assert(found.error && told.stderr.endsWith(`${found.error.path}: ${found.error.message}\n`), `${JSON.stringify(edits)}: ${told.stderr} ${JSON.stringify(found)}`);
      }
    }
    assert(good > 0, "every edit is refused");
  });
}

/**
 * @param {string} name
 * @param {Float64Array} found
 * @param {(number | null)[]} expected null where a value is not finite
 */
function compare(name, found, expected) {
  assert.equal(found.length, expected.length, `${name}: rows`);
  const scale = SCALES[name] ?? Math.max(...expected.map((value) => Math.abs(value ?? 0)), Number.MIN_VALUE);
  expected.forEach((value, row) => {
    if (value === null) return assert(!Number.isFinite(found[row]), `${name}[${row}]: ${found[row]}, natively not finite`);
    const error = Math.abs(found[row] - value) / scale;
    assert(error <= TOLERANCE, `${name}[${row}]: ${found[row]}, natively ${value}`);
  });
}

for (const example of examples) {
  test(`${example}: a tournament tells what each design tells on its own`, () => {
    const lab = new Lab();
    const design = JSON.parse(readFileSync(path.join(root, "examples", example), "utf8"));
    lab.open(design, SAMPLES, "en");
    const { laws } = CATALOGUE;
    const numbers = tournament_of(design);
    const width = 2 + lab.figures().length;
    assert.deepEqual(numbers.slice(2, width), lab.figures());
    const count = numbers.length / width;
    // A motion that is ready-made has no law to change.
    assert(Number.isInteger(count) && (design.segments ? count > 5 : count === 1), `${count} contenders`);
    for (let i = 1; i < count; i++) {
      const [place, , ...figures] = numbers.slice(i * width, (i + 1) * width);
      const { id } = laws[place];
      const alone = new Lab();
      const opened = alone.open(design_by_law(design, place), SAMPLES, "en");
      assert(!("error" in opened), JSON.stringify(opened));
      assert.deepEqual([...alone.figures()], figures, id);
      assert.equal(["acceptable", "low-speed", "unacceptable"].indexOf(opened.report.verdict.level), figures[0], id);
      const { v, pressure_angle: angle } = opened.report.summary;
      if (Number.isFinite(figures[2])) assert.equal(Math.max(Math.abs(v?.min ?? NaN), Math.abs(v?.max ?? NaN)), figures[2], id);
      // Of a pair, the worse of both cams.
      const other = opened.report.conjugate?.summary.pressure_angle ?? angle;
      assert.deepEqual([Math.min(angle?.min ?? NaN, other?.min ?? NaN), Math.max(angle?.max ?? NaN, other?.max ?? NaN)], figures.slice(8, 10), id);
    }
  });
}
