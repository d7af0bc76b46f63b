// The worked solution as LaTeX, of every example in all notations and of every law, in both languages: another reader of LaTeX reads every
// formula of it without a complaint, and between them stands only what every LaTeX can set.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import katex from "katex";
import { CATALOGUE } from "../../web/pkg/catalogue.js";
import { initSync, solution_text } from "../../web/pkg/levalab_workshop_wasm.js";

const root = path.resolve(import.meta.dirname, "../..");
const { LEVALAB_CLI: cli, LEVALAB_MODULE: module } = process.env;
assert(cli && module, "LEVALAB_CLI and LEVALAB_MODULE name what writes LaTeX: run `cargo xtask test wasm`");
initSync({ module: readFileSync(path.join(module, "levalab_workshop_wasm_bg.wasm")) });

const NOTATIONS = ["norton", "shigley", "rothbart", "cardona-clos", "capitals"];
const examples = readdirSync(path.join(root, "examples")).filter((name) => name.endsWith(".lev.json"));

/** What the fonts of every LaTeX have, besides ASCII. */
const LETTERS = /^[\x20-\x7e\n\u00a1-\u00ff…–“”]*$/;

/** The formulas of a document, those in its lines and those that stand by themselves. */
const FORMULA = /\\\[([^]*?)\\\]|(?<!\\)\$([^$]+)(?<!\\)\$/g;

/** @param {any} design @param {"en" | "es"} language */
function solved(design, language) {
  const text = solution_text(design, language, undefined, undefined, "latex");
  assert.match(text.replaceAll(FORMULA, ""), LETTERS);
  const formulas = [...text.matchAll(FORMULA)];
  assert(formulas.length > 20, `${formulas.length} formulas`);
  for (const [, alone, within] of formulas) katex.renderToString(alone ?? within, { displayMode: alone !== undefined, strict: "error", throwOnError: true });
  return text;
}

for (const example of examples) {
  test(`${example}: every formula of its solution is LaTeX`, () => {
    const file = path.join(root, "examples", example);
    const design = JSON.parse(readFileSync(file, "utf8"));
    for (const language of /** @type {const} */ (["en", "es"])) {
      /** @type {string} */
      const written = execFileSync(/** @type {string} */ (cli), ["solve", file, "--to", "latex", "--lang", language], { encoding: "utf8" });
      assert.equal(solved(design, language), written, "the page copies what the command line writes");
      for (const notation of NOTATIONS) solved({ ...design, notation }, language);
    }
  });
}

for (const { id, free, parameters } of CATALOGUE.laws.filter(({ moves }) => moves)) {
  test(`${id}: every formula of the law is LaTeX`, () => {
    const beta = free ? 1 : 120;
    const shape = parameters.map(({ key, quantity, default: usual }) => [key, quantity === "span" ? Number(usual) * beta : usual]);
    const first = { law: id, beta, ...Object.fromEntries(shape), ...(free && { [free.key]: free.first }), ...(Array.isArray(free?.first) ? {} : { rise: 1 }) };
    const back = { law: "polynomial-4-5-6-7", beta: 200, rise: -1 };
    const design = {
      format: "levalab/1", title: "", speed: { value: 1, unit: "rad/s" }, cam: { kind: "rotating", base_radius: 40 },
      follower: { motion: "translating", contact: "roller", roller_radius: 5 }, segments: [first, back, { law: "dwell", beta: 160 - beta }],
    };
    for (const language of /** @type {const} */ (["en", "es"])) solved(design, language);
  });
}
