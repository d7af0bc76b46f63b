// Auto: what the machine must do becomes a program, seen and explained before it is taken, with one undo.
import assert from "node:assert/strict";
import { test } from "node:test";
import { LINKS, becomes, en, es, eventually, fragment, openStill, undo } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

/** @param {Page} page */
const dialog = (page) => page.getByRole("dialog", { name: en("auto.title") });

/** @param {Page} page @param {string} field @param {number} number */
const cell = (page, field, number) => dialog(page).getByRole("textbox", { name: en(`auto.${field}.of`, { number }), exact: true });

test("the dwells of the program at hand are joined anew, with reasons, and one undo takes it back", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const start = await fragment(page);
  await page.getByRole("button", { name: en("segments.auto"), exact: true }).click();
  const reasons = dialog(page).getByRole("listitem");
  await becomes(() => reasons.count(), 4);
  assert.match(await reasons.first().innerText(), /modified trapezoidal.*lowest peak/);
  await dialog(page).getByLabel(en("auto.fast")).check();
  await eventually(() => reasons.first().innerText(), (text) => assert.match(text, /4-5-6-7.*only one/));
  await dialog(page).getByLabel(en("auto.fast")).uncheck();
  await dialog(page).getByLabel(en("auto.least")).selectOption("velocity");
  await eventually(() => reasons.first().innerText(), (text) => assert.match(text, /^From 0° to 50°: modified sine/));
  assert.equal(await fragment(page), start, "nothing is taken before it is asked for");
  await dialog(page).getByRole("button", { name: en("auto.take") }).click();
  await becomes(() => fragment(page), /R35_7M50_10D40M50-10D40M50_10D40M50-10D40/);
  await undo(page).click();
  await becomes(() => fragment(page), start);
});

test("lines and points are typed in, and what cannot be met is told with its requirement", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await page.getByRole("button", { name: en("segments.auto"), exact: true }).click();
  for (let left = 4; left > 1; left--) await dialog(page).getByRole("button", { name: en("auto.remove", { number: left }) }).click();
  await cell(page, "from", 1).fill("0");
  await cell(page, "to", 1).fill("60");
  await cell(page, "s", 1).fill("0");
  const status = dialog(page).getByRole("status");
  await eventually(() => status.innerText(), (text) => assert.match(text, /Nothing moves/));
  await dialog(page).getByRole("button", { name: en("auto.add") }).click();
  await eventually(() => status.innerText(), (text) => assert.equal(text, en("auto.unreadable", { number: 2 })));
  await cell(page, "from", 2).fill("180");
  await cell(page, "s", 2).fill("12,5");
  await becomes(() => dialog(page).getByRole("button", { name: en("auto.take") }).isEnabled(), true);
  await dialog(page).getByRole("button", { name: en("auto.add") }).click();
  await dialog(page).getByRole("combobox", { name: en("auto.kind.of", { number: 3 }) }).selectOption("line");
  for (const [field, text] of [["from", "170"], ["to", "240"], ["s", "8"], ["end", "4"]]) await cell(page, field ?? "", 3).fill(text ?? "");
  await eventually(() => status.innerText(), (text) => assert.match(text, /^Requirement 2: It begins before requirement 3 ends/));
  await cell(page, "from", 3).fill("210");
  await becomes(() => dialog(page).getByRole("button", { name: en("auto.take") }).isEnabled(), true);
  await dialog(page).getByRole("button", { name: en("auto.take") }).click();
  await becomes(() => fragment(page), /D60.*V30-4/);
});

test("it speaks the language of the page, and stays away from cams that it does not serve", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"], locale: "es-ES" });
  await page.getByRole("button", { name: es("segments.auto"), exact: true }).click();
  await eventually(() => page.getByRole("dialog").getByRole("listitem").first().innerText(), (text) => assert.match(text, /trapezoidal modificada/));
  await page.getByRole("button", { name: es("auto.close"), exact: true }).click();
});
