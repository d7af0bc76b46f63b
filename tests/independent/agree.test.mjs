// The core against formulas written a second time in another language. LEVALAB_CLI names the command, AGREE_DESIGNS how many
// designs of each kind to draw.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import path from "node:path";
import process from "node:process";
import { test } from "node:test";
import { FOLLOWERS, disagreements, randomDesign } from "./agree.mjs";
import { FREE_LAWS, MATCHED_LAWS } from "./motion.mjs";

const root = path.resolve(import.meta.dirname, "../..");
const binary = process.env.LEVALAB_CLI ?? path.join(root, "target/debug/levalab");
const each = Number(process.env.AGREE_DESIGNS ?? 12);

/** @type {Set<string>} */
const drawn = new Set();

const kinds = /** @type {(keyof typeof FOLLOWERS)[]} */ (Object.keys(FOLLOWERS));
for (const [number, kind] of kinds.entries()) {
  for (const rotation of /** @type {const} */ (["counterclockwise", "clockwise"])) {
    test(`${kind}, ${rotation}: the command agrees with the textbook's own formulas`, () => {
      for (let k = 0; k < each; k++) {
        const design = randomDesign(kind, rotation, 1000 * number + k);
        for (const { law } of design.segments ?? []) drawn.add(law);
        // A grid of whole degrees has rows on joints, the other has none.
        const samples = k % 2 === 0 ? 360 : 307;
        assert.deepEqual(disagreements(binary, design, samples), [], JSON.stringify(design));
      }
    });
  }
}

/** The first cells of the rows of a table of the documentation, which a test of levalab-format holds to the catalogue. @param {string} heads */
function documented(heads) {
  const lines = readFileSync(path.join(root, "docs/design-format.md"), "utf8").split("\n");
  const first = lines.indexOf(heads) + 2;
  const rows = lines.slice(first, lines.findIndex((line, at) => at >= first && !line.startsWith("|")));
  return rows.map((row) => [...row.matchAll(/^\| `([^`]+)`(?: \| `([^`]+)`)?/g)].flatMap(([, one, other]) => [one, other].filter(Boolean)).join("-"));
}

test("every law and follower has formulas here", () => {
  const laws = documented("| law | name | takes | code | version |");
  assert(laws.length > 20, "the table is found");
  assert.deepEqual([...FREE_LAWS, ...MATCHED_LAWS].sort(), laws.sort());
  assert.deepEqual(Object.keys(FOLLOWERS).sort(), documented("| motion | contact | name | parameters | code | version |").sort());
});

test("every law had its turn", () => {
  assert.deepEqual([...FREE_LAWS, ...MATCHED_LAWS].filter((law) => !drawn.has(law)), []);
});

const examples = readdirSync(path.join(root, "examples")).filter((name) => name.endsWith(".lev.json"));
for (const example of examples) {
  test(`${example}: the command agrees with the textbook's own formulas`, () => {
    const design = JSON.parse(readFileSync(path.join(root, "examples", example), "utf8"));
    assert.deepEqual(disagreements(binary, design, 720), []);
  });
}
