// Design files: opened, refused with the place of what is wrong, saved as they were.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { test } from "node:test";
import { root } from "./browser.js";
import { openPage } from "./harness.js";
import { LINKS, banner, becomes, en, field, fragment, level, nextFragment, undo, verdict } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

const NINE = await readFile(path.join(root, "examples/9RT.lev.json"), "utf8");
const TEN = await readFile(path.join(root, "examples/10EX.lev.json"), "utf8");

/**
 * Opens a file with the page's own button.
 * @param {Page} page
 * @param {string | Buffer} text
 * @param {string} [name]
 */
async function openFile(page, text, name = "cam.lev.json") {
  const chosen = page.waitForEvent("filechooser");
  await chooseFromFiles(page, en("header.open"));
  await (await chosen).setFiles({ name, mimeType: "application/json", buffer: Buffer.from(text) });
}

/** @param {Page} page @param {string} item */
async function chooseFromFiles(page, item) {
  await page.getByRole("button", { name: en("header.files"), exact: true }).click();
  await page.getByRole("menuitem", { name: item, exact: true }).click();
}

/** @param {Page} page */
async function save(page) {
  const download = page.waitForEvent("download");
  await chooseFromFiles(page, en("header.save"));
  const file = await download;
  return { name: file.suggestedFilename(), text: await readFile(await file.path(), "utf8") };
}

/** 9RT with something changed. @param {(design: any) => void} change */
function changed(change) {
  const design = JSON.parse(NINE);
  change(design);
  return JSON.stringify(design);
}

test("a design file opens, and undo brings back what was there", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS.R1 });
  await openFile(page, TEN);
  await becomes(() => fragment(page), LINKS["10EX"]);
  assert.equal(await level(page), "acceptable");
  await undo(page).click();
  await becomes(() => fragment(page), LINKS.R1);
});

test("a file that is wrong is refused with the place of what is wrong", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS.R1 });
  const said = await verdict(page).innerText();
  /** @type {[string | Buffer, RegExp][]} */
  const wrong = [
    [changed((design) => (design.segments[2].beta = "fifty")), /segments\[2\]\.beta/],
    [changed((design) => (design.segments[1].beta = 41)), /segments/],
    [changed((design) => (design.cam.base_radius = -1)), /cam\.base_radius/],
    [changed((design) => (design.cam.colour = "red")), /cam\.colour/],
    [changed((design) => delete design.follower.roller_radius), /follower(\.roller_radius)?/],
    [changed((design) => (design.format = "levalab/3")), /format: .*newer/],
    [changed((design) => (design.segments[0].law = "guess")), /segments\[0\]\.law/],
    [NINE.replace("35", "1e999"), /cam\.base_radius/],
    [NINE.slice(0, 100), /ends in the middle of the design, in line \d+, column \d+/],
    ["", /ends in the middle of the design, in line 1, column 1/],
    ["[]", /./],
    ["null", /./],
    ["\u0000\u0001PNG", /not JSON from line 1, column 1 on/],
    [NINE.replace('"base_radius": 35', '"base_radius": 35, "base_radius": 90'), /cam\.base_radius: This field is there twice/],
    [NINE.replace("35", "35,5"), /decimal comma in line \d+, column \d+/],
    [NINE.replace("35", '"35,5"'), /cam\.base_radius: "35,5" is a text; a number has no quotes and a decimal point/],
    [NINE.replace("Example", "\\ud83d"), /half a character in line \d+, column \d+/],
    [Buffer.from(NINE.replace("Example", "Dise\u00f1o"), "latin1"), /not text in UTF-8/],
    ["[".repeat(5000), /nested deeper than in any design, in line 1, column 17/],
    ['{"a":'.repeat(5000), /nested deeper than in any design/],
    [`[${"[".repeat(5000)}${"]".repeat(5000)}]`, /nested deeper than in any design/],
    [NINE + " ".repeat(2 ** 20), /more than 1\s048\s576 bytes/],
  ];
  for (const [text, place] of wrong) {
    await openFile(page, text);
    const told = await becomes(() => banner(page).innerText(), new RegExp(en("banner.file", { reason: "" }).trim()));
    assert.match(told.replace(en("banner.file", { reason: "" }).trim(), ""), place, text.toString().slice(0, 80));
    assert.equal(await verdict(page).innerText(), said, "the cam did not stay");
    await banner(page).getByRole("button", { name: en("banner.close"), exact: true }).click();
    await becomes(() => banner(page).innerText(), "");
  }
  assert.equal(await fragment(page), LINKS.R1);
  await openFile(page, NINE);
  await becomes(() => fragment(page), LINKS["9RT"]);
});

test("a file with a byte-order mark opens like one without", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS.R1 });
  await openFile(page, `\ufeff${NINE}`);
  await becomes(() => fragment(page), LINKS["9RT"]);
});

test("a saved file is the design, whole and readable", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  const nine = await save(page);
  assert.equal(nine.name, "Example-9RT.lev.json");
  const saved = JSON.parse(nine.text);
  assert.equal(saved.format, "levalab/1");
  assert.deepEqual(saved.segments.map((/** @type {any} */ { law, beta }) => [law, beta]), JSON.parse(NINE).segments.map((/** @type {any} */ { law, beta }) => [law, beta]));
  assert.match(nine.text, /\n {2}"/, "it is not laid out to be read");

  await field(page, "base_radius").fill("36.125");
  await page.getByRole("textbox", { name: en("header.title") }).fill('Ñandú: 1/2 "x" <b>');
  const mine = await nextFragment(page, LINKS["9RT"]);
  await becomes(() => page.title(), 'Ñandú: 1/2 "x" <b> · LevaLab');
  const { name, text } = await save(page);
  assert.match(name, /^[^\\/:*?"<>|]+\.lev\.json$/);
  assert.equal(JSON.parse(text).title, 'Ñandú: 1/2 "x" <b>');
  await openFile(page, NINE);
  await becomes(() => fragment(page), LINKS["9RT"]);
  await openFile(page, text, name);
  await becomes(() => field(page, "base_radius").inputValue(), "36.125");
  await becomes(() => page.title(), 'Ñandú: 1/2 "x" <b> · LevaLab');
  assert.notEqual(mine, LINKS["9RT"]);
});

test("while the design is wrong, what is saved is the last good one", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  await field(page, "base_radius").fill("-5");
  await becomes(() => level(page), "stopped");
  assert.equal(JSON.parse((await save(page)).text).cam.base_radius, 35);
});
