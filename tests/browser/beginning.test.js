// How a design begins and changes: New, an example that becomes one's own, several segments at once, kinds that are tried, Back.
import assert from "node:assert/strict";
import { test } from "node:test";
import { LINKS, actOnSegment, announced, becomes, en, field, fragment, level, nextFragment, openExample, openStill, program, undo } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

/** @param {Page} page */
const title = (page) => page.getByRole("textbox", { name: en("header.title") });
/** @param {Page} page @param {number} number */
const grip = (page, number) => page.getByRole("group", { name: en("design.program") }).getByRole("listitem").nth(number - 1).getByRole("button").first();

test("New begins with a radial roller on one dwell, without a title, in the reader's units", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.R1 });
  await page.getByRole("button", { name: en("header.files"), exact: true }).click();
  await page.getByRole("menuitem", { name: en("header.new"), exact: true }).click();
  await becomes(() => program(page), ["dwell 360 0"]);
  assert.deepEqual([await title(page).inputValue(), await page.locator("#field-length-unit").inputValue()], ["", "m"]);
  assert.deepEqual([await field(page, "base_radius").inputValue(), await field(page, "roller_radius").inputValue()], ["0.04", "0.01"]);
  assert.notEqual(await level(page), "stopped");
  await undo(page).click();
  await becomes(() => fragment(page), LINKS.R1);
});

test("an example loses its title with the first change, and one step of undo gives both back", async (t) => {
  const { page } = await openStill(t, { locale: "en-US" });
  await openExample(page, "R5");
  await becomes(() => title(page).inputValue(), "Example R5");
  const radius = await field(page, "base_radius").inputValue();
  await field(page, "base_radius").fill("77");
  await becomes(() => title(page).inputValue(), "");
  await undo(page).click();
  await becomes(() => title(page).inputValue(), "Example R5");
  assert.equal(await field(page, "base_radius").inputValue(), radius);
  await title(page).fill("Mine");
  await field(page, "base_radius").fill("78");
  await becomes(() => page.title(), "Mine · LevaLab");
});

test("a design from a link keeps its title", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["2RO"] });
  await field(page, "arm").fill("81");
  await nextFragment(page, LINKS["2RO"]);
  assert.equal(await title(page).inputValue(), "Example 2RO");
});

test("several segments are selected by pointer and keys and deleted in one step", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const before = await program(page);
  await grip(page, 2).click({ modifiers: ["Control"] });
  await grip(page, 4).click({ modifiers: ["Shift"] });
  assert.equal(await announced(page), en("segments.selected", { count: 3 }));
  assert.equal(await grip(page, 3).getAttribute("aria-pressed"), "true");
  await grip(page, 3).click({ modifiers: ["Control"] });
  await grip(page, 4).focus();
  await page.keyboard.press("Delete");
  await becomes(() => program(page), before.filter((_, k) => k !== 1 && k !== 3));
  assert.equal(await announced(page), en("segments.removed.several", { number: 2, count: 6 }));
  await undo(page).click();
  await becomes(() => program(page), before);

  await actOnSegment(page, 1, "select");
  await actOnSegment(page, 3, "select");
  await page.getByRole("button", { name: en("segments.actions", { number: 3 }), exact: true }).click();
  await page.getByRole("menuitem", { name: en("action.delete.several", { count: 2 }), exact: true }).click();
  await becomes(() => program(page), before.filter((_, k) => k !== 0 && k !== 2));
});

test("another kind of cam that is tried and left gives one's program back", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const before = await program(page);
  const kind = page.locator("#field-kind");
  await kind.selectOption("constant-breadth");
  await becomes(() => field(page, "breadth").isVisible(), true);
  await kind.selectOption("translating");
  await becomes(() => field(page, "length").isVisible(), true);
  await kind.selectOption("rotating");
  await becomes(() => program(page), before);
  await becomes(() => fragment(page), LINKS["9RT"]);
  // What was changed in the meantime stays changed.
  await kind.selectOption("grooved");
  await field(page, "roller_radius").fill("6");
  await kind.selectOption("rotating");
  await becomes(() => program(page), before);
  assert.equal(await field(page, "roller_radius").inputValue(), "6");
});

test("Back returns to the design before as it was left: an entry for each that was opened, none for an edit", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await field(page, "base_radius").fill("41");
  const mine = await nextFragment(page, LINKS["9RT"]);
  const length = await page.evaluate(() => history.length);
  await openExample(page, "R1");
  await becomes(() => title(page).inputValue(), "Example R1");
  await becomes(() => page.evaluate(() => history.length), length + 1);
  await field(page, "base_radius").fill("0.3");
  await becomes(() => fragment(page), /R\.3_/);
  const example = await fragment(page);
  await page.goBack();
  await becomes(() => field(page, "base_radius").inputValue(), "41");
  await becomes(() => fragment(page), mine);
  await page.goForward();
  await becomes(() => field(page, "base_radius").inputValue(), "0.3");
  await becomes(() => fragment(page), example);
});

test("a change at the last moment is in the entry that Back returns to", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await field(page, "base_radius").fill("42");
  await openExample(page, "R1");
  await becomes(() => title(page).inputValue(), "Example R1");
  await page.goBack();
  await becomes(() => field(page, "base_radius").inputValue(), "42");
});

test("a table that is too long is refused beside its field, and stays there as it was pasted", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await page.getByLabel(en("segments.law.of", { number: 1 }), { exact: true }).selectOption("table");
  const points = page.getByRole("textbox", { name: en("free.points", { number: 1 }), exact: true });
  const link = await nextFragment(page, LINKS["9RT"]);
  const text = Array.from({ length: 200 }, (_, k) => `${k / 4}\t${k / 20}`).join("\n");
  await points.fill(text);
  assert.equal(await points.getAttribute("aria-invalid"), "true");
  await points.blur();
  assert.equal(await points.inputValue(), text);
  assert.equal(await fragment(page), link);
});
