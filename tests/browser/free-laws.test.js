// The editors of free laws: conditions, knots, tables, ordinates and formulas, what is wrong with them, and their marks on the diagram.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { root } from "./browser.js";
import { becomes, descriptions, en, es, eventually, fragment, nextFragment, openStill, undo } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

/** Published links, by name. */
const LINKS = Object.fromEntries(
  readFileSync(path.join(root, "crates/format/tests/published-links.txt"), "utf8")
    .trim()
    .split("\n")
    .map((line) => line.split(" ", 2)),
);

/** @param {Page} page @param {string} key @param {Record<string, string | number>} values */
const labelled = (page, key, values) => page.getByRole("textbox", { name: en(key, values), exact: true });

/** @param {Page} page @param {number} number */
const knots = (page, number) => labelled(page, "free.knots", { number });
/** @param {Page} page @param {string} sign @param {string} at @param {number} number */
const cell = (page, sign, at, number) => labelled(page, "conditions.value", { sign, at, number });

test("a cell that is emptied frees its condition, and one that is filled adds it", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.conditions });
  const start = await fragment(page);
  await cell(page, "v", "60°", 1).fill("");
  const freed = await nextFragment(page, start);
  assert.match(freed, /N120s0v0a0s60_4\.5s120_10v120a120/);
  await cell(page, "v", "60°", 1).fill("-2,5");
  await becomes(() => fragment(page), /s60_4\.5v60-2\.5s120/);
  await page.getByRole("group", { name: en("conditions.title", { number: 1 }) }).getByText(en("conditions.degree", { count: 8, degree: 7 })).waitFor();
  // What is typed in one visit of a field is undone at once.
  await undo(page).click();
  await becomes(() => fragment(page), start);
});

test("conditions are inherited from the neighbours, added and removed", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.conditions });
  const table = page.getByRole("group", { name: en("conditions.title", { number: 1 }) });
  await cell(page, "v", "120°", 1).fill("9");
  await becomes(() => fragment(page), /v120_9a120B/);
  await table.getByRole("button", { name: en("conditions.inherit.after") }).click();
  await becomes(() => fragment(page), /s120_10v120a120B/);
  await table.getByRole("button", { name: en("conditions.add") }).click();
  await becomes(() => fragment(page), /s30_/);
  await table.getByRole("button", { name: en("conditions.remove", { at: "30°" }) }).click();
  await becomes(() => fragment(page), /N120s0v0a0s60/);
});

test("a row of conditions stays where it is while its place is typed, and goes to its place when it is left", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.conditions });
  const table = page.getByRole("group", { name: en("conditions.title", { number: 1 }) });
  await table.getByRole("button", { name: en("conditions.add") }).click();
  const places = table.locator("input[id$='-at']");
  const values = () => places.evaluateAll((all) => all.map((input) => (input instanceof HTMLInputElement ? input.value : "")));
  const before = await values();
  const own = before.findIndex((value, k) => k > 0 && value !== before.at(-1));
  const typed = places.nth(own);
  await typed.focus();
  await page.keyboard.type("23,84");
  assert.equal(await typed.inputValue(), "23,84");
  assert.equal(await typed.evaluate((input) => input === document.activeElement), true, "the focus is lost");
  await typed.press("Tab");
  await eventually(values, (now) => assert(now.includes("23.84"), now.join()));
  const sorted = (await values()).map(Number);
  assert.deepEqual(sorted, [...sorted].sort((a, b) => a - b));
  assert.equal((await values()).length, before.length, "a row was lost on the way");
  // On a phone a value may be negative, a place may not.
  assert.equal(await typed.getAttribute("inputmode"), "decimal");
  assert.equal(await table.locator("input[id$='-s']").first().getAttribute("inputmode"), "text");
});

test("conditions that depend on each other are told beside the segment, and the last good cam stays", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.conditions });
  for (const [sign, at] of /** @type {const} */ ([["v", "0°"], ["a", "0°"], ["v", "120°"], ["a", "120°"]])) await cell(page, sign, at, 1).fill("");
  await becomes(() => fragment(page), /N120s0s60_4\.5v60_3s120_10B/);
  const good = await fragment(page);
  // A parabola's slope in the middle is that of its chord.
  await cell(page, "s", "60°", 1).fill("");
  await page.locator(".segment .error").getByText("No single polynomial meets them", { exact: false }).waitFor();
  assert.equal(await fragment(page), good);
});

test("knots are those of the engine until they are told, and what makes no spline is explained beside them", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.spline });
  const field = knots(page, 1);
  const start = await fragment(page);
  await eventually(() => field.getAttribute("placeholder"), (usual) => assert.match(String(usual), /^\d+(\.\d+)? {2}90 {2}\d+(\.\d+)?$/));
  await field.fill("50 80 140");
  await becomes(() => fragment(page), /a180k50k80k140C/);
  await field.fill("50 40 140");
  await eventually(() => descriptions(field), (told) => assert(told.some((text) => text?.includes("each after the one before it")), told.join("\n")));
  await field.fill("50 140");
  await eventually(() => descriptions(field), (told) => assert(told.some((text) => text?.includes("need 3")), told.join("\n")));
  await field.fill("50 x");
  await eventually(() => descriptions(field), (told) => assert(told.includes(en("numbers.unreadable")), told.join("\n")));
  await field.fill("");
  await becomes(() => fragment(page), start);
});

test("a table is pasted as a spreadsheet gives it, with decimal commas and a heading", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.table, locale: "es-ES" });
  const field = page.getByRole("textbox", { name: es("free.points", { number: 1 }), exact: true });
  await field.fill("θ (°)\ts (mm)\n10\t0\n40,5\t1,25\n90\t5\n150\t9,5\n190\t10\n");
  await becomes(() => fragment(page), /L180p0p30\.5_1\.25p80_5p140_9\.5p180_10L/);
  await field.fill("0;0\n90;5,5\n180;10");
  await becomes(() => fragment(page), /L180p0p90_5\.5p180_10L/);
  await field.fill("0 0\n90 5 5\n180 10");
  await eventually(() => descriptions(field), (told) => assert(told.some((sentence) => sentence?.startsWith("En la línea 2 ")), told.join("\n")));
  // A table shorter than its segment is told, and the segment can follow it.
  await field.fill("0;0\n90;5,5\n150;10");
  await page.getByRole("button", { name: es("table.span", { angle: "150°" }) }).click();
  await becomes(() => page.getByText(es("segments.left", { angle: "30°", whole: "360°" }), { exact: false }).count(), 1);
});

test("a smoothed table lists what the curve leaves of each point", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.table });
  const residuals = page.getByRole("region", { name: en("residuals.title", { number: 2 }) });
  const summary = page.locator(".free-text summary");
  await becomes(() => summary.count(), 2);
  assert.equal(await summary.first().isVisible(), false);
  await eventually(() => summary.last().innerText(), (text) => assert(text.startsWith(en("residuals.summary", { value: "@", at: "@" }).split("@")[0] ?? "")));
  await summary.last().click();
  await eventually(() => residuals.getByRole("row").count(), (rows) => assert.equal(rows, 6));
  const before = await residuals.innerText();
  await page.locator("[id$='-smoothing']").last().fill("0.1");
  await becomes(() => fragment(page), /L180_0_\.1p0_10/);
  await eventually(() => residuals.innerText(), (now) => assert.notEqual(now, before));
  await page.locator("[id$='-smoothing']").last().fill("-1");
  await eventually(() => descriptions(page.locator("[id$='-smoothing']").last()), (told) => assert(told.some((text) => text?.includes("from 0 to")), told.join("\n")));
});

test("points of a table are drawn on the diagram of s, and only there", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.table });
  const points = page.locator(".mark-points");
  await eventually(() => points.getAttribute("d"), (drawn) => assert.equal(String(drawn).split("M").length - 1, 10));
  await page.locator("input[name=diagram-tab][value=pressure_angle]").check({ force: true });
  await becomes(() => page.locator(".diagram-marks").isVisible(), false);
});

test("ordinates of a Bézier curve are moved on the diagram, by pointer and by keys", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.bezier });
  const start = await fragment(page);
  const handle = page.getByRole("slider", { name: en("ordinate.of", { item: 4, number: 1 }) });
  await handle.focus();
  await handle.press("ArrowUp");
  await becomes(() => fragment(page), /Z180o_0_0_0_13\.5_10_10_10C/);
  assert.equal(await handle.getAttribute("aria-valuenow"), "13.5");
  await handle.press("Alt+ArrowDown");
  await becomes(() => fragment(page), /o_0_0_0_13\.4_10/);
  await page.locator("body").click({ position: { x: 5, y: 5 } });
  const { x, y, width, height } = (await handle.boundingBox()) ?? assert.fail("no handle");
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  for (let by = 5; by <= 40; by += 5) await page.mouse.move(x + width / 2, y + height / 2 + by);
  await page.mouse.up();
  const value = Number(await handle.getAttribute("aria-valuenow"));
  assert(value < 13, `dragged down to ${value}`);
  await becomes(() => labelled(page, "free.ordinates", { number: 1 }).inputValue(), `0  0  0  ${value}  10  10  10`);
  await becomes(() => fragment(page), new RegExp(`o_0_0_0_${value}_10_10_10C`.replace("_0.", "_.").replaceAll(".", "\\.")));
  await undo(page).click();
  await becomes(() => fragment(page), /13\.4/);
  await undo(page).click();
  await becomes(() => fragment(page), start);
});

test("what is wrong with a formula points at the character, in the language of the page", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.formula });
  const field = labelled(page, "free.expression", { number: 2 });
  for (const [text, told] of [["10 x^2 +", "at character 9"], ["10 - foo(x)", "foo"], ["10 (1 - x", "at character 4"], ["10 − 10 sqrt(x)", "not smooth"]]) {
    await field.fill(text ?? "");
    await eventually(() => descriptions(field), (sentences) => assert(sentences.some((sentence) => sentence?.includes(told ?? "")), `${text}: ${sentences.join("\n")}`));
  }
  await page.getByRole("button", { name: "ES", exact: true }).click();
  const campo = page.getByRole("textbox", { name: es("free.expression", { number: 2 }), exact: true });
  await campo.fill("10 − 10 sen(x π/2");
  await eventually(() => descriptions(campo), (sentences) => assert(sentences.some((sentence) => sentence?.includes("carácter 12")), sentences.join("\n")));
  await campo.fill("10 − 10 sen(x π/2)^2,0");
  await becomes(() => campo.getAttribute("aria-invalid"), null);
});

test("a formula says beside its field when it is in radians: where the follower swings", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.formula });
  const swinging = labelled(page, "free.expression.swing", { number: 2 });
  assert.equal(await swinging.count(), 0);
  await page.locator('input[name="follower"][value="oscillating-roller"]').check({ force: true });
  await swinging.waitFor();
  assert((await descriptions(swinging)).some((sentence) => sentence?.startsWith(en("free.expression.swing.hint"))));
  await undo(page).click();
  await labelled(page, "free.expression", { number: 2 }).waitFor();
});

test("every editor of free data explains its term", async (t) => {
  for (const [name, term] of [["conditions", "conditions"], ["spline", "knots"], ["bezier", "ordinates"], ["table", "points"], ["table", "smoothing"], ["formula", "expression"]]) {
    const { page } = await openStill(t, { fragment: LINKS[name ?? ""] });
    await page.locator(`.program button[data-term="${term}"]`).first().click();
    await page.getByRole("dialog").waitFor();
    // The card of a term that the page of terms has not is one sentence that leads nowhere.
    assert.equal(await page.getByRole("dialog").getByRole("link").count(), 1, `${term} is not explained`);
  }
});
