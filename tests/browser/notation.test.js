// Notations: the symbols of other books wherever a symbol is shown, a sign that is typed as it is shown, and a design that stays the same.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage } from "./harness.js";
import { LINKS, becomes, en, es, eventually, field, findings, fragment, nextFragment, undo, unfoldFindings, violations } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

/** @param {Page} page @param {RegExp} name @param {typeof en} [say] */
async function choose(page, name, say = en) {
  await page.getByRole("button", { name: say("header.files"), exact: true }).click();
  await page.getByRole("menuitem", { name: say("header.notation") }).click();
  await page.getByRole("menuitemradio", { name }).click();
}

/** What a field is called. @param {Page} page @param {string} key */
const label = (page, key) => page.locator(`#field-${key}-label i`).textContent();

/** Letters of the diagrams in sight. @param {Page} page */
const letters = (page) => page.locator("#diagrams figcaption .symbol:visible").allTextContents();

test("a notation changes every symbol and nothing else, and is one step to undo", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  const radius = await field(page, "base_radius").inputValue();
  await choose(page, /Rothbart/);
  const link = await nextFragment(page, LINKS["9RT"]);
  assert.match(link, /R35_7nrM50/);
  await becomes(() => letters(page), ["y", "y′", "y″", "y‴"]);
  assert.deepEqual([await label(page, "base_radius"), await label(page, "roller_radius"), await label(page, "eccentricity")], ["rb", "Rr", "e"]);
  await becomes(() => page.locator(".readout-phi .symbol").textContent(), "α");
  await becomes(() => page.getByRole("group", { name: en("verdict.figures") }).innerText(), /α −28\.2°[^]*y max 10\smm/);
  assert.equal(await page.locator(".segments-head .symbol").last().textContent(), "h");
  assert.equal(await field(page, "base_radius").inputValue(), radius);
  await page.getByRole("button", { name: "ES", exact: true }).click();
  await becomes(() => page.getByRole("group", { name: es("verdict.figures") }).innerText(), /y máx\. 10\smm/);
  await undo(page).click();
  await becomes(() => fragment(page), LINKS["9RT"]);
  await becomes(() => letters(page), ["s", "v", "a", "j"]);
  assert.equal(await label(page, "base_radius"), "Rb");
});

test("a link speaks the notation that it tells, cures included", async (t) => {
  const { page: maker } = await openPage(t, { fragment: LINKS["9RT"] });
  await field(maker, "base_radius").fill("20");
  await choose(maker, /Shigley/);
  const link = await eventually(() => fragment(maker), (now) => assert.match(now, /R20_7ns/));
  const { page } = await openPage(t, { fragment: link });
  await becomes(() => letters(page), ["y", "y′", "y″", "y‴"]);
  await unfoldFindings(page);
  await becomes(() => findings(page).getByRole("button", { name: /R0 ≥/ }).count(), 1);
  assert.equal(await findings(page).getByText(/Rb/).count(), 0);
});

test("Norton's eccentricity is shown and typed with his sign, and kept with ours", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  const e = field(page, "eccentricity");
  await e.fill("5");
  const ours = await nextFragment(page, LINKS["9RT"]);
  assert.match(ours, /R35_7_5M/);
  await choose(page, /Norton/);
  await becomes(() => label(page, "eccentricity"), "ε");
  assert.equal(await e.inputValue(), "5");
  await field(page, "rotation").selectOption("clockwise");
  await becomes(() => e.inputValue(), "−5");
  await becomes(() => fragment(page), /R35_7_5cnnM/);
  await e.fill("4");
  await becomes(() => fragment(page), /R35_7-4cnnM/);
  assert.equal(await e.inputValue(), "4");
  await choose(page, /LevaLab/);
  await becomes(() => e.inputValue(), "−4");
});

test("the menu of notations works by keyboard and for everyone", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  await page.getByRole("button", { name: en("header.files"), exact: true }).press("Enter");
  await page.keyboard.press("End");
  await page.keyboard.press("Enter");
  const chosen = page.getByRole("menuitemradio", { checked: true });
  await becomes(() => chosen.evaluate((item) => item === document.activeElement), true);
  assert.deepEqual(await violations(page, "menu of notations"), []);
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Enter");
  await becomes(() => label(page, "eccentricity"), "ε");
  assert.deepEqual(await violations(page, "Norton's notation"), []);
});
