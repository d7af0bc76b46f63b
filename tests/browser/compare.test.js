// Designs pinned beside each other: their curves and outlines, their table, what the browser keeps of them; the tournament of the laws.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage } from "./harness.js";
import {
  LINKS, announced, becomes, diagram, en, eventually, field, fragment, frames, inkOf, law, level, mechanism, nextFragment, openExample, program, undo,
} from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

/** @param {Page} page */
const legend = (page) => page.locator("#legend").getByRole("listitem").allTextContents();
/** @param {Page} page */
const rows = (page) => page.getByRole("table", { name: en("compare.table") }).locator("tbody tr");
/** Names in the table, but for the design on screen. @param {Page} page */
const names = (page) => rows(page).getByRole("textbox").evaluateAll((fields) => fields.map((field) => /** @type {HTMLInputElement} */ (field).value));
/** @param {Page} page */
const open = (page) => page.getByRole("button", { name: new RegExp(`^${en("header.compare")}`) }).click();

/** @param {Page} page @param {string[]} ids */
async function pinExamples(page, ids) {
  for (const [i, id] of ids.entries()) {
    await openExample(page, id);
    await page.locator("#pin").click();
    await becomes(async () => (await legend(page)).length, i + 1);
  }
}

test("a pinned design stays beside the next in diagrams and mechanism, through closing and reloading", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  await page.locator("body").press("c");
  await becomes(() => announced(page), en("compare.pinned", { name: "Example 9RT", count: 1, most: 12 }));
  await becomes(() => legend(page), ["Example 9RT"]);
  await openExample(page, "R5");
  await field(page, "base_radius").fill("60");
  for (const place of [diagram(page, "s"), diagram(page, "a"), mechanism(page)]) {
    await eventually(() => inkOf(place, "look-1", 30), ({ count }) => assert(count > 100, `${count} pixels`));
  }
  // The range holds both: R5 lifts 22 and is the higher of the two; alone, 9RT would fill the plot with 10.
  const high = (/** @type {{ columns: ({ top: number } | null)[] }} */ { columns }) => Math.min(...columns.map((column) => column?.top ?? Infinity));
  const [own, pinned] = [await inkOf(diagram(page, "s"), "s", 20), await inkOf(diagram(page, "s"), "look-1", 20)];
  assert(high(own) < high(pinned), `${high(own)} ${high(pinned)}`);
  await page.reload();
  await becomes(() => legend(page), ["Example 9RT"]);
  await eventually(() => inkOf(mechanism(page), "look-1", 30), ({ count }) => assert(count > 100));
});

test("what is pinned is the design of the click, even when what pins it comes later than the next edit", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  /** @type {() => void} */
  let release = () => {};
  const gate = new Promise((resolve) => (release = () => resolve(undefined)));
  await page.route("**/*.js", async (route) => {
    await gate;
    await route.continue();
  });
  const asked = page.waitForRequest("**/*.js");
  await page.locator("#pin").click();
  await asked;
  await field(page, "base_radius").fill("45");
  await nextFragment(page, LINKS["9RT"]);
  release();
  await becomes(() => legend(page), ["Example 9RT"]);
  await open(page);
  await becomes(() => rows(page).nth(1).innerText(), /R\s?b\s*35\b/);
});

test("the slate can be renamed, put in order by keyboard, shown or not, and given back", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  await pinExamples(page, ["9RT", "R5", "2RO"]);
  await open(page);
  await becomes(() => names(page), ["Example 9RT", "Example R5", "Example 2RO"]);
  const text = await rows(page).nth(2).innerText();
  assert.match(text, /25\.21.*\n?.*1030/s, "peaks of R5 per radian and per second");

  await page.getByLabel(en("compare.name", { number: 2 })).fill("Parabolic");
  await page.getByLabel(en("compare.name", { number: 2 })).press("Tab");
  await page.getByRole("button", { name: en("compare.up", { name: "Parabolic" }) }).focus();
  await page.keyboard.press("Enter");
  await becomes(() => names(page), ["Parabolic", "Example 9RT", "Example 2RO"]);
  assert.equal(await page.evaluate(() => document.activeElement?.closest("tr")?.querySelector("input[type=text]")?.getAttribute("value")), "Parabolic", "the focus stays on the row");
  await page.keyboard.press("Alt+ArrowDown");
  await becomes(() => names(page), ["Example 9RT", "Parabolic", "Example 2RO"]);

  await page.getByRole("checkbox", { name: en("compare.shown", { name: "Example 9RT" }) }).uncheck();
  await becomes(async () => (await legend(page)).map((text) => text.split("(")[0]), ["Parabolic", "Example 2RO"]);
  await page.getByRole("button", { name: en("compare.remove", { name: "Parabolic" }) }).click();
  await becomes(() => names(page), ["Example 9RT", "Example 2RO"]);
  await page.getByRole("button", { name: en("compare.restore", { name: "Parabolic" }) }).click();
  await becomes(() => names(page), ["Example 9RT", "Parabolic", "Example 2RO"]);

  const before = await fragment(page);
  await page.getByRole("button", { name: en("compare.load.of", { name: "Example 9RT" }) }).click();
  await nextFragment(page, before);
  await page.keyboard.press("Escape");
  await becomes(() => page.locator("#compare").isVisible(), false);
  assert((await program(page))[0]?.startsWith("modified-sine"), "9RT is back");
  await undo(page).click();
  await becomes(() => fragment(page), before);
});

test("an oscillating follower is not drawn on an axis of millimetres, and the legend says so", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  await pinExamples(page, ["2RO"]);
  await openExample(page, "9RT");
  await becomes(async () => (await legend(page)).join(), /Example 2RO.*other units/);
  await eventually(() => inkOf(diagram(page, "s"), "look-1", 20), ({ count }) => assert.equal(count, 0));
  await page.getByRole("radio", { name: /^φ / }).check({ force: true });
  await becomes(() => legend(page), ["Example 2RO"]);
  await eventually(() => inkOf(diagram(page, "pressure_angle"), "look-1", 20), ({ count }) => assert(count > 100));
});

test("no more are pinned than can be told apart, none twice, and rubbish in the storage is left alone", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  await page.locator("#pin").click();
  await becomes(async () => (await legend(page)).length, 1);
  await page.locator("#pin").click();
  await becomes(() => announced(page), en("compare.already", { name: "Example 9RT" }));
  for (let i = 2; i <= 13; i++) {
    await field(page, "base_radius").fill(String(40 + i));
    await frames(page);
    await page.locator("#pin").click();
    if (i <= 12) await becomes(async () => (await legend(page)).length, i);
  }
  await eventually(() => page.locator("#banner").textContent(), (text) => assert(text?.includes("12"), text ?? ""));
  assert.equal((await legend(page)).length, 12);
  await page.evaluate(() => {
    const [first] = JSON.parse(localStorage.getItem("levalab:slate") ?? "[]");
    localStorage.setItem("levalab:slate", JSON.stringify([null, 7, { name: "x" }, { ...first, name: "kept", design: { ...first.design, cam: { kind: "square" } } }, { ...first, name: 5 }]));
  });
  await page.reload();
  await becomes(() => legend(page), ["Example 9RT"]);
  await page.evaluate(() => localStorage.setItem("levalab:slate", "{"));
  await page.reload();
  await frames(page, 5);
  await becomes(() => level(page), "low-speed");
  assert.deepEqual(await legend(page), []);
});

test("the tournament ranks the laws, tells what each design tells on its own, and adopts one with a click", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  await open(page);
  await page.getByRole("radio", { name: en("compare.view.laws") }).check({ force: true });
  const table = page.getByRole("table", { name: en("compare.laws.table") });
  const first = () => table.locator("tbody tr").first().innerText();
  await becomes(first, /acceptable/);
  await table.getByRole("button", { name: /\|v\|/ }).click();
  await becomes(first, /Constant velocity/);
  assert.equal(await table.locator("th[aria-sort=ascending]").count(), 1);
  await table.getByRole("button", { name: /\|v\|/ }).press("Enter");
  await becomes(first, /Cubic 1/);
  assert.equal(await table.locator("th[aria-sort=descending]").count(), 1);

  const cycloidal = table.getByRole("row", { name: /^Cycloidal/ });
  const told = await cycloidal.innerText();
  await cycloidal.getByRole("button", { name: en("compare.pin.of", { name: "Cycloidal" }) }).click();
  await becomes(() => legend(page), ["Example 9RT · Cycloidal"]);
  await cycloidal.getByRole("button", { name: en("compare.use.of", { name: "Cycloidal" }) }).click();
  await becomes(async () => (await program(page)).filter((row) => row.startsWith("cycloidal")).length, 4);
  await page.keyboard.press("Escape");
  const summary = (await diagram(page, "v").getAttribute("aria-label")) ?? "";
  await eventually(async () => (await diagram(page, "v").getAttribute("aria-label")) ?? summary, (text) => {
    const greatest = / to ([\d.]+)/.exec(text)?.[1] ?? "none";
    assert(told.includes(greatest), `${greatest} in ${told}`);
  });
  assert.equal(await law(page, 1).inputValue(), "cycloidal");
  await undo(page).click();
  await becomes(() => law(page, 1).inputValue(), "modified-sine");
});
