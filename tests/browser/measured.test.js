// Measured data: long and wide texts are asked about, reduced within a residual that is shown, and taken.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { test } from "node:test";
import { root } from "./browser.js";
import { becomes, en, es, eventually, fragment, openStill, undo } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

const TABLE = "1.table.R40_10L180p0p45_.9p90_5p135_9.1p180_10L180_0_.02p0_10p45_9.08p90_5.03p135_.93p180.4C60MS";

const file = (/** @type {string} */ name) => path.join(root, "crates/format/tests/measured", name);

/** @param {Page} page @param {typeof en} [say] */
const panelOf = (page, say = en) => page.getByRole("group", { name: say("measured.title", { number: 1 }) });
/** @param {Page} page @param {typeof en} [say] */
const pointsOf = (page, say = en) => page.getByRole("textbox", { name: say("free.points", { number: 1 }), exact: true });

/** Pastes a text as the clipboard would. @param {Page} page @param {import("playwright-core").Locator} field @param {string} text */
async function paste(page, field, text) {
  await field.focus();
  await page.keyboard.press("Control+a");
  await page.evaluate((text) => navigator.clipboard.writeText(text), text);
  await page.keyboard.press("Control+v");
}

test("361 pasted lines are kept, reduced within a residual that is shown, and taken by Enter", async (t) => {
  const { page } = await openStill(t, { fragment: TABLE, permissions: ["clipboard-read", "clipboard-write"] });
  const before = await fragment(page);
  const text = await readFile(file("degree-by-degree.csv"), "utf8");
  await paste(page, pointsOf(page), text);
  const panel = panelOf(page);
  await panel.waitFor();
  assert.equal(await pointsOf(page).inputValue(), text.replaceAll("\r", ""), "the text stays as it came");
  assert.equal(await fragment(page), before, "and the design as it was");
  const status = panel.getByRole("status");
  await becomes(() => status.innerText(), /^\d+ of 361 points\. Largest residual: 0\.00\d+\smm, at \d+°\.$/);
  const usual = await status.innerText();
  // The bound that stands in its field is one that the curve keeps.
  const bound = Number(await panel.getByLabel(en("measured.within"), { exact: true }).inputValue());
  assert(bound >= Number(/residual: ([\d.]+)/.exec(usual)?.[1]) && bound < 0.01, `${bound} in the field of: ${usual}`);
  const count = panel.getByLabel(en("measured.count"), { exact: true });
  await count.fill("7");
  await eventually(() => status.innerText(), (now) => assert(now.startsWith("7 of 361") && now !== usual, now));
  await panel.getByLabel(en("measured.within"), { exact: true }).fill("0.0005");
  await becomes(() => count.inputValue(), /^[1-9]\d$/);
  const chosen = await count.inputValue();
  await page.keyboard.press("Enter");
  await becomes(() => panel.isVisible(), false);
  await becomes(() => pointsOf(page).inputValue().then((now) => now.split("\n").length), Number(chosen));
  await undo(page).click();
  await becomes(() => fragment(page), before);
});

test("columns are chosen by their headings, in Spanish too, and Escape takes nothing", async (t) => {
  const { page } = await openStill(t, { fragment: TABLE, locale: "es-ES", permissions: ["clipboard-read", "clipboard-write"] });
  const before = await fragment(page);
  await paste(page, pointsOf(page, es), "n\tángulo [deg]\tpar [Nm]\televación [mm]\n1\t0\t1,5\t0\n2\t60\t1,7\t5\n3\t120\t1,1\t7\n4\t180\t1,5\t10\n");
  const panel = panelOf(page, es);
  const options = () => panel.getByLabel(es("measured.lift"), { exact: true }).evaluate((select) => [...(/** @type {HTMLSelectElement} */ (select)).selectedOptions].map(({ text }) => text));
  await becomes(options, ["elevación [mm]: 0; 5; 7 …"]);
  await panel.getByLabel(es("measured.lift"), { exact: true }).selectOption("1");
  await becomes(() => panel.getByRole("alert").innerText(), "Elija dos columnas distintas para θ y s.");
  assert(await panel.getByRole("button", { name: es("measured.take") }).isDisabled());
  await panel.getByLabel(es("measured.lift"), { exact: true }).selectOption("2");
  await becomes(() => panel.getByRole("status").innerText(), /^4 de 4 puntos/);
  await panel.getByLabel(es("measured.count"), { exact: true }).press("Escape");
  await becomes(() => panel.isVisible(), false);
  assert.equal(await fragment(page), before);
  await becomes(() => pointsOf(page, es).inputValue().then((now) => now.split("\n").length), 5);
});

test("a file of measured data is opened and taken whole", async (t) => {
  const { page } = await openStill(t, { fragment: TABLE });
  const chooser = page.waitForEvent("filechooser");
  await page.getByRole("button", { name: en("measured.open") }).first().click();
  await (await chooser).setFiles(file("cam-editor.csv"));
  const panel = panelOf(page);
  await panel.waitFor({ state: "visible" });
  await panel.getByRole("button", { name: en("measured.take") }).click();
  await becomes(() => pointsOf(page).inputValue(), "0\t0\n60\t5\n120\t12\n180\t16\n240\t9\n360\t0");
});

test("a line that cannot be read is named, and the text stays", async (t) => {
  const { page } = await openStill(t, { fragment: TABLE });
  const text = "0 0\n60 five5\n180 10";
  await pointsOf(page).fill(text);
  await becomes(() => page.locator(".free-text .error").first().innerText(), "Line 2 is not two numbers, as in 12.5 and 3.25.");
  await page.getByRole("textbox", { name: en("header.title") }).focus();
  assert.equal(await pointsOf(page).inputValue(), text);
});
