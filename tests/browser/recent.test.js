// Recent designs, several tabs that do not fight, files that are dropped.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { test } from "node:test";
import { drawn, root } from "./browser.js";
import { openPage } from "./harness.js";
import { LINKS, banner, becomes, en, es, eventually, field, fragment, openExample, undo } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

const TEN = await readFile(path.join(root, "examples/10EX.lev.json"), "utf8");

/** @param {Page} page @param {typeof en} [say] */
async function openRecent(page, say = en) {
  await page.getByRole("button", { name: say("header.files"), exact: true }).click();
  await page.getByRole("menuitem", { name: say("header.recent"), exact: true }).click();
  const dialog = page.getByRole("dialog", { name: say("recent.title") });
  await dialog.waitFor();
  return dialog;
}

/** What the browser keeps, as base radius of each entry. @param {Page} page */
const keptRadii = (page) =>
  page.evaluate(() => {
    const entries = Object.entries(localStorage).filter(([key]) => key.startsWith("levalab:recent:"));
    return entries.map(([, text]) => JSON.parse(text).design.cam.base_radius).sort((a, b) => a - b);
  });

/** @param {Page} page @param {string} title @param {string} radius */
async function design(page, title, radius) {
  await page.getByLabel(en("header.title"), { exact: true }).fill(title);
  await field(page, "base_radius").fill(radius);
  await eventually(() => keptRadii(page), (radii) => assert(radii.includes(Number(radius)), `${radius} is not among ${radii}`));
}

/** @param {Page} page @param {{ name: string, text: string }[]} files */
async function drop(page, files) {
  await page.evaluate((files) => {
    const carried = new DataTransfer();
    for (const { name, text } of files) carried.items.add(new File([text], name));
    for (const type of ["dragenter", "dragover", "drop"]) {
      document.body.dispatchEvent(new DragEvent(type, { dataTransfer: carried, bubbles: true, cancelable: true }));
    }
  }, files);
}

test("designs that were worked on are listed, newest first, open again and can be undone", async (t) => {
  const { page } = await openPage(t);
  assert.deepEqual(await keptRadii(page), [], "an example nobody touched is no work");
  await design(page, "First", "36");
  await openExample(page, "R5");
  await openExample(page, "9RT");
  await design(page, "Second", "37");
  const dialog = await openRecent(page);
  const items = dialog.getByRole("listitem");
  await becomes(() => items.locator("strong").allTextContents(), ["Second", "First"]);
  assert.match((await items.first().textContent()) ?? "", /Translating roller · .*2\d{3}/);
  await items.nth(1).getByRole("button").first().click();
  await becomes(() => field(page, "base_radius").inputValue(), "36");
  await undo(page).click();
  await becomes(() => field(page, "base_radius").inputValue(), "37");
});

test("an entry can be taken from the list, and all of them, in either language, by keyboard", async (t) => {
  const { page } = await openPage(t, { locale: "es-ES" });
  await page.getByLabel(es("header.title"), { exact: true }).fill("Leva una");
  await eventually(() => keptRadii(page), (radii) => assert.equal(radii.length, 1));
  const dialog = await openRecent(page, es);
  await becomes(() => dialog.getByRole("listitem").count(), 1);
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement?.getAttribute("aria-label")), es("recent.remove.of", { title: "Leva una" }));
  await page.keyboard.press("Enter");
  await dialog.getByText(es("recent.none")).waitFor();
  assert.deepEqual(await keptRadii(page), []);
  await page.keyboard.press("Escape");
  await becomes(() => dialog.isVisible(), false);
});

test("the list is bounded, and what cannot be read is taken away", async (t) => {
  const { page } = await openPage(t);
  await page.evaluate((design) => {
    for (let i = 0; i < 40; i++) {
      const other = { ...design, title: `Number ${i}` };
      localStorage.setItem(`levalab:recent:old${i}`, JSON.stringify({ saved: 1e12 + i, design: other }));
    }
    const broken = [{ saved: 2e12, design: { format: "levalab/1" } }, { saved: "then", design }, { design }, 7, null, { saved: 1e99, design }];
    for (const [i, entry] of broken.entries()) localStorage.setItem(`levalab:recent:broken${i}`, JSON.stringify(entry));
    localStorage.setItem("levalab:recent:text", "no JSON");
  }, JSON.parse(TEN));
  await design(page, "Newest", "36");
  const dialog = await openRecent(page);
  await becomes(() => dialog.getByRole("listitem").count(), 16);
  const titles = await dialog.getByRole("listitem").locator("strong").allTextContents();
  assert.deepEqual(titles.slice(0, 3), ["Newest", "Number 39", "Number 38"]);
  assert.equal(await page.evaluate(() => Object.keys(localStorage).filter((key) => key.includes("broken") || key.endsWith("text")).length), 0);
});

test("two tabs keep a design each, and each sees the other's in its list", async (t) => {
  const { page, url } = await openPage(t);
  await design(page, "Here", "36");
  const other = await page.context().newPage();
  await other.goto(url);
  await drawn(other);
  await becomes(() => field(other, "base_radius").inputValue(), "36");
  await design(other, "There", "37");
  await design(page, "Here", "38");
  await design(other, "There", "39");
  assert.deepEqual(await keptRadii(page), [38, 39], "one entry for each tab");
  // Each comes back with its own.
  for (const [tab, radius] of /** @type {const} */ ([[page, "38"], [other, "39"]])) {
    await tab.reload();
    await drawn(tab);
    assert.equal(await field(tab, "base_radius").inputValue(), radius);
  }
  const dialog = await openRecent(page);
  const theirs = dialog.getByRole("listitem").filter({ hasText: "There" });
  await becomes(() => theirs.textContent(), new RegExp(en("recent.elsewhere")));
  // What the other tab does now is seen here.
  await design(other, "Changed there", "40");
  await becomes(() => dialog.getByRole("listitem").locator("strong").allTextContents(), ["Changed there", "Here"]);
  // Opened here too, it is another design from the first change on.
  await dialog.getByRole("listitem").first().getByRole("button").first().click();
  await design(page, "Mine now", "41");
  assert.deepEqual(await keptRadii(page), [38, 40, 41]);
});

test("a design without an address of its own comes back with its tab, not with its neighbour's", async (t) => {
  const { page, url } = await openPage(t);
  await design(page, "Here", "36");
  const other = await page.context().newPage();
  await other.goto(`${url}#${LINKS.R1}`);
  await drawn(other);
  await field(other, "base_radius").fill("0.3");
  await eventually(() => fragment(other), (now) => assert.match(now, /\.R\.3_/));
  await page.goto("about:blank");
  await page.goto(url);
  await drawn(page);
  assert.equal(await field(page, "base_radius").inputValue(), "36");
});

test("a dropped file opens; a wrong one is told; a text on its way is left alone", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS.R1 });
  await page.waitForFunction(() => document.querySelector(".dropping"));
  await drop(page, [{ name: "cam.lev.json", text: TEN }]);
  await becomes(() => fragment(page), LINKS["10EX"]);
  await undo(page).click();
  await becomes(() => fragment(page), LINKS.R1);
  await drop(page, [{ name: "picture.png", text: "\u0000PNG" }]);
  await becomes(() => banner(page).innerText(), /The text is not JSON from line 1, column 1 on/);
  const prevented = await page.evaluate(() => {
    const carried = new DataTransfer();
    carried.setData("text/plain", "35");
    return !document.body.dispatchEvent(new DragEvent("dragover", { dataTransfer: carried, bubbles: true, cancelable: true }));
  });
  assert.equal(prevented, false);
  assert.equal(await page.locator(".dropping").isVisible(), false);
});
