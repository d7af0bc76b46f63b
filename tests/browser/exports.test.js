// Files for other programs from the page: each kind is what it says, and nothing of it is loaded before it is asked for.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { openPage } from "./harness.js";
import { LINKS, becomes, en, es, openExample } from "./user.js";
import { exportsEn } from "../../web/strings/exports.en.js";

/** @typedef {import("playwright-core").Page} Page */

/** @param {Page} page @param {typeof en} [say] */
async function openExports(page, say = en) {
  await page.getByRole("button", { name: say("header.files"), exact: true }).click();
  await page.getByRole("menuitem", { name: say("header.export"), exact: true }).click();
  const dialog = page.locator(".export-dialog[open]");
  await dialog.waitFor();
  return dialog;
}

/**
 * Orders a file and reads it.
 * @param {Page} page
 * @param {string} format
 * @param {Record<string, string>} [choices] by the end of the id of their fields
 * @param {typeof en} [say]
 */
async function exported(page, format, choices = {}, say = en) {
  const dialog = await openExports(page, say);
  await dialog.locator("#export-format").selectOption(format);
  for (const [field, value] of Object.entries(choices)) {
    const control = dialog.locator(`#export-${field}`);
    if ((await control.evaluate((element) => element.tagName)) === "SELECT") await control.selectOption(value);
    else await control.fill(value);
  }
  const download = page.waitForEvent("download");
  await dialog.locator("button.primary").click();
  const file = await download;
  await dialog.waitFor({ state: "hidden" });
  return { name: file.suggestedFilename(), bytes: await readFile(await file.path()) };
}

test("what the follower drives is drawn for a design that drives something, and not offered for another", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  const dialog = await openExports(page);
  await dialog.locator("#export-format").selectOption("svg");
  const option = dialog.locator('#export-what option[value="application"]');
  assert.equal(await option.evaluate((one) => /** @type {HTMLOptionElement} */ (one).hidden), true);
  await page.keyboard.press("Escape");
  await openExample(page, "R6");
  const svg = (await exported(page, "svg", { what: "application" })).bytes.toString();
  for (const said of ["force (lbf)", "pressure (psi)"]) assert(svg.includes(said), said);
});

test("every kind of file comes out of the page", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  const xlsx = await exported(page, "xlsx");
  assert.equal(xlsx.name, "Example-9RT.xlsx");
  assert.equal(xlsx.bytes.subarray(0, 2).toString(), "PK");

  const csv = (await exported(page, "csv", { step: "10" })).bytes.toString();
  assert.match(csv, /^\uFEFF"Cam angle θ \(°\)",/);
  assert.equal(csv.trim().split("\n").length, 38);

  const dxf = (await exported(page, "dxf", { step: "1" })).bytes.toString();
  assert.equal(dxf.match(/^LWPOLYLINE/gm)?.length, 2);

  const stl = (await exported(page, "stl", { step: "2", thickness: "10", bore: "20", "keyway-width": "6", "keyway-depth": "2.8" })).bytes;
  assert.equal(stl.length, 84 + 50 * stl.readUInt32LE(80));

  const svg = (await exported(page, "svg", { what: "cam", bore: "" })).bytes.toString();
  assert.match(svg, /^<svg [^>]*width="[\d.]+mm"/);

  const png = await exported(page, "png", { what: "svaj", width: "800" });
  assert.equal(png.name, "Example-9RT-svaj.png");
  assert.equal(png.bytes.subarray(1, 4).toString(), "PNG");
  assert.equal(png.bytes.readUInt32BE(16), 800);
  assert(png.bytes.length > 20_000, "the picture is empty");
});

test("in Spanish a table has the signs of Spanish spreadsheets", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"], locale: "es-ES" });
  const { name, bytes } = await exported(page, "csv", { table: "motion", step: "10" }, es);
  assert.equal(name, "Example-9RT-motion.csv");
  const rows = bytes.toString().split("\r\n");
  assert.match(rows[0] ?? "", /^\uFEFF"Ángulo de la leva θ \(°\)";"Tiempo/);
  assert.match(rows[2] ?? "", /^10;0,17453/);
});

test("what cannot be made is told in the window, which stays", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  const dialog = await openExports(page);
  await dialog.locator("#export-format").selectOption("stl");
  await dialog.locator("#export-bore").fill("80");
  await dialog.locator("button.primary").click();
  await becomes(() => dialog.getByRole("alert").innerText(), /profile comes to/);
  await dialog.locator("#export-bore").fill("wide");
  await dialog.locator("button.primary").click();
  await becomes(() => dialog.getByRole("alert").innerText(), /wide/);
  assert(await dialog.isVisible());
  await page.keyboard.press("Escape");
  await dialog.waitFor({ state: "hidden" });
});

test("nothing of it is loaded before it is asked for", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  const loaded = () => page.evaluate(() => performance.getEntriesByType("resource").some(({ name }) => name.includes("export")));
  assert.equal(await loaded(), false);
  const dialog = await openExports(page);
  await becomes(loaded, true);
  // Every control has its words.
  for (const label of await dialog.locator("label:visible").allInnerTexts()) assert(Object.values(exportsEn).includes(label), label);
});
