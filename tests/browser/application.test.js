// What the follower drives: chosen, edited, drawn with the points to hit, kept in the link, taken back.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage } from "./harness.js";
import {
  LINKS as PUBLISHED, becomes, cursor, en, es, eventually, field, fragment, inkOf, level, numberOf, setCursor, undo, violations,
} from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

const R6 = "1.Example_R6.R2_1uiw12.566op_30_.75p0p56.88_110.282p123.84_79.338p198.72_106.667p256.32N256.32s0v0a0s56.88_1.177168358s123.84_.84686697s198.72_1.138581249s256.32v256.32a256.32D103.68.0yVAoK";
const WEDGE = "1.Wedge.R0_8w50t150C60_20D30C60-12.197YKJ";

/** @param {Page} page @param {typeof en} [say] */
async function openPanel(page, say = en) {
  const button = page.getByRole("button", { name: say("design.application"), exact: true });
  await button.click();
  await becomes(() => button.getAttribute("aria-expanded"), "true");
  await becomes(() => page.evaluate(() => document.activeElement?.id), "application-heading");
  return button;
}

/** @param {Page} page */
const panel = (page) => page.getByRole("region", { name: en("application.title"), exact: true });
/** @param {Page} page */
const kind = (page) => page.locator("#application-kind");
/** @param {Page} page */
const targets = (page) => page.locator("#application-targets");
/** What is told at the cursor, the main output first. @param {Page} page */
const values = (page) => page.locator("#application output").allTextContents();
/** The cells of the table of errors. @param {Page} page */
const errors = (page) => page.locator(".application-errors tbody tr").evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent)));

test("R6 shows its force against angle and time, its measured points and the error at each", async (t) => {
  const { page } = await openPage(t, { fragment: R6 });
  await openPanel(page);
  await becomes(() => kind(page).inputValue(), "piston-force");
  await becomes(() => page.locator(".application-figures").textContent(), /K = 93\.68\slbf\/in/);
  await becomes(() => page.locator(".application-extremes").first().textContent(), /126\.2\slbf at 74\.4°/);
  const told = await errors(page);
  assert.deepEqual(told.map(([place]) => place), ["0", "56.88", "123.84", "198.72", "256.32"]);
  assert.deepEqual(told[1].slice(2, 4), ["110.282", "110.282"]);
  assert.ok(told.every((cells) => /^(0|[+−]\d\.\d+·10⁻[⁸⁹])$/.test(cells[4] ?? "")), `s = F/K to nine decimals: ${told.map((cells) => cells[4])}`);
  await becomes(() => page.locator(".application-worst").textContent(), /lbf at 198\.72°/);
  const drawing = page.locator("#application canvas.diagram-canvas").first();
  await eventually(() => inkOf(drawing, "output"), ({ count }) => assert.ok(count > 300, `${count} points of the curve`));
  const byAngle = await drawing.getAttribute("aria-label");
  assert.match(byAngle ?? "", /force.*126\.2\slbf.*5 points/);

  // One cursor for the page: a point of the table, the panel's own slider, the field of the transport.
  await page.getByRole("button", { name: en("application.targets.go", { place: "56.88°" }) }).click();
  await becomes(async () => (await cursor(page)).toFixed(1), "56.9");
  await becomes(() => values(page), ["F = 110.3\u00a0lbf", "p = 62.41\u00a0psi"]);
  await setCursor(page, "300");
  await becomes(() => values(page), ["F = 0\u00a0lbf", "p = 0\u00a0psi"]);
  const slider = page.getByRole("slider", { name: en("application.cursor") });
  await slider.focus();
  await page.keyboard.press("ArrowRight");
  await becomes(() => slider.getAttribute("aria-valuenow"), "301.0");
  await page.getByRole("radio", { name: new RegExp(en("application.against.time")) }).check({ force: true });
  await becomes(() => slider.getAttribute("aria-valuetext"), /θ 301\.0°, t 0\.4181\ss/);
});

test("an application is chosen, edited, kept in the link, and taken back", async (t) => {
  const { page } = await openPage(t, { fragment: PUBLISHED["9RT"] });
  const button = await openPanel(page);
  await becomes(() => kind(page).inputValue(), "");
  assert.equal(await page.locator("#application canvas").first().isVisible(), false);
  await kind(page).selectOption("pump");
  await becomes(() => page.locator("#application-piston_radius").inputValue(), "10");
  await eventually(() => fragment(page), (link) => assert.match(link, /R35_7ou_10M50/));
  await becomes(() => page.locator(".application-extremes").first().textContent(), /each turn delivers 6283\smm³, 1000\smm³\/s/);
  await page.locator("#application-piston_radius").fill("20");
  await eventually(() => fragment(page), (link) => assert.match(link, /R35_7ou_20M50/));
  await page.locator("#application-piston_radius").fill("-1");
  await becomes(() => page.locator("#application-piston_radius-error").textContent(), /\w/);
  await becomes(() => level(page), "stopped");
  await page.locator("#application-piston_radius").press("Escape");
  await becomes(() => page.locator("#application-piston_radius").inputValue(), "10");
  await kind(page).selectOption("valve");
  await becomes(() => page.locator("#application-seat_angle").inputValue(), "45");
  await undo(page).click();
  await undo(page).click();
  await becomes(() => fragment(page), PUBLISHED["9RT"]);
  await becomes(() => kind(page).inputValue(), "");
  await page.locator("#application-kind").focus();
  await page.keyboard.press("Escape");
  await becomes(() => panel(page).count(), 0);
  await becomes(() => page.evaluate(() => document.activeElement?.id), "application-button");
  assert.equal(await button.getAttribute("aria-expanded"), "false");
});

test("points are pasted from a spreadsheet with its head and decimal commas, by angle or by time", async (t) => {
  const { page } = await openPage(t, { fragment: PUBLISHED["9RT"], locale: "es-ES" });
  await openPanel(page, es);
  await kind(page).selectOption("force");
  await page.locator("#application-stiffness").fill("2,5");
  await targets(page).fill("ángulo\tfuerza\n50\t25\n70,5\t24,5");
  await becomes(() => errors(page).then((rows) => rows.map((row) => row.slice(2))), [["25", "25", "0"], ["24,5", "25", "+0,5"]]);
  await eventually(() => fragment(page), (link) => assert.match(link, /ok_2\.5p50_25p70\.5_24\.5M50/));
  const byAngle = await fragment(page);
  await page.locator(".application-of select").last().selectOption("time");
  await eventually(() => fragment(page), (link) => assert.match(link, /ok_2\.5tp\.8726646/));
  await becomes(() => errors(page).then((rows) => rows.map((row) => row[4])), ["0", "+0,5"]);
  await undo(page).click();
  await becomes(() => fragment(page), byAngle);
  await targets(page).fill("50\t25\n70,5\tx");
  await becomes(() => page.locator("#application-targets-error").textContent(), es("application.targets.unreadable", { line: 2 }));
  await becomes(() => targets(page).getAttribute("aria-invalid"), "true");
  assert.equal(await fragment(page), byAngle);
  await targets(page).fill("50\t25\n400\t1");
  await becomes(() => page.locator("#application-targets-error").textContent(), /400°.*360°/);
});

test("a follower that swings drives nothing, and says why; a wedge delivers there and back", async (t) => {
  const { page } = await openPage(t, { fragment: R6 });
  await openPanel(page);
  await page.getByRole("radio", { name: en("follower.oscillating-roller") }).check({ force: true });
  await becomes(() => panel(page).getByText(en("application.swings")).isVisible(), true);
  await becomes(() => kind(page).isVisible(), false);
  assert.equal(await targets(page).isVisible(), false);
  await eventually(() => fragment(page), (link) => assert.doesNotMatch(link, /op_30/));
  await undo(page).click();
  await becomes(() => fragment(page), R6);
  await becomes(() => kind(page).isVisible(), true);
  await page.goto(`${page.url().split("#")[0]}#${WEDGE}`);
  await becomes(() => kind(page).inputValue(), "");
  await kind(page).selectOption("pump");
  const radius = numberOf(await page.locator("#application-piston_radius").inputValue());
  const delivered = new RegExp(`each journey there and back delivers ${Math.trunc(Math.PI * radius * radius * 32 / 1000)}`);
  await becomes(async () => (await page.locator(".application-extremes").first().textContent())?.replaceAll("\u202f", "") ?? "", delivered);
});

/** A force with two points to hit. @param {Page} page */
async function furnish(page) {
  await kind(page).selectOption("piston-force");
  await targets(page).fill("50\t25\n70.5\t24.5");
  await becomes(() => errors(page).then(({ length }) => length), 2);
}

test("axe finds nothing in the panel, wide and narrow, light and dark, right and wrong", async (t) => {
  /** @type {string[]} */
  const found = [];
  const { page } = await openPage(t, { fragment: PUBLISHED["9RT"] });
  await openPanel(page);
  await furnish(page);
  found.push(...(await violations(page, "application")));
  await targets(page).fill("1\tx");
  await field(page, "base_radius").fill("-1");
  found.push(...(await violations(page, "application, wrong")));
  const phone = await openPage(t, { fragment: PUBLISHED["9RT"], locale: "es-ES", colorScheme: "dark", viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await openPanel(phone.page, es);
  await furnish(phone.page);
  found.push(...(await violations(phone.page, "application, dark phone")));
  assert.equal(await phone.page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true, "the page is wider than the phone");
  assert.deepEqual(found, []);
});
