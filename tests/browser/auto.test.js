// Auto: what the machine must do is drawn or typed and becomes a program, seen and explained before it is taken, with one undo.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage } from "./harness.js";
import { LINKS, becomes, diagram, en, es, eventually, fragment, frames, undo } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

/** @param {Page} page */
const dialog = (page) => page.getByRole("dialog", { name: en("auto.title") });

/** @param {Page} page @param {string} field @param {number} number */
const cell = (page, field, number) => dialog(page).getByRole("textbox", { name: en(`auto.${field}.of`, { number }), exact: true });

/** @param {Page} page @param {"dwell" | "line" | "point"} kind */
const tool = (page, kind) => dialog(page).getByRole("radio", { name: new RegExp(`^${en(`auto.kind.${kind}`)} `) });

/** What a requirement is called on the diagram. @param {"dwell" | "line" | "point"} kind @param {number} number */
const nameOf = (kind, number) => en("auto.handle", { number, kind: en(`auto.kind.${kind}`) });

/** @param {Page} page @param {string} name */
const handle = (page, name) => dialog(page).getByRole("slider", { name, exact: true });

/** The numbers in the table, row by row. @param {Page} page */
const typed = (page) => dialog(page).locator(".auto-row:not(.auto-head)").evaluateAll((rows) => rows.map((row) => [...row.querySelectorAll("input")].map(({ value }) => value).join(" ")));

/** Parts of the greatest height that the board has above it and below the base circle. */
const [ABOVE, BELOW] = [0.3, 0.04];

/** Where a place lies on the board, when `top` is the greatest height. @param {Page} page @param {number} theta @param {number} s @param {number} top */
async function onBoard(page, theta, s, top) {
  const box = await dialog(page).getByRole("group", { name: en("auto.drawing") }).boundingBox();
  assert(box);
  const high = top * (1 + ABOVE);
  return { x: box.x + (box.width * theta) / 360, y: box.y + (box.height * (high - s)) / (high * (1 + BELOW)) };
}

/** @param {Page} page @param {{ x: number, y: number }} from @param {{ x: number, y: number }} to */
async function drag(page, from, to) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  for (let part = 1; part <= 4; part++) await page.mouse.move(from.x + ((to.x - from.x) * part) / 4, from.y + ((to.y - from.y) * part) / 4);
  await page.mouse.up();
}

/** @param {Page} page @param {string} name */
async function middle(page, name) {
  const box = await handle(page, name).boundingBox();
  assert(box);
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** @param {Page} page */
async function openEmpty(page) {
  await page.getByRole("button", { name: en("segments.auto"), exact: true }).click();
  await dialog(page).getByRole("listitem").first().waitFor();
  await dialog(page).getByRole("button", { name: en("auto.none") }).click();
  await becomes(() => dialog(page).getByRole("status").innerText(), en("auto.nothing"));
  await frames(page);
}

test("a program is drawn by hand alone, from an empty diagram to what is taken", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  await openEmpty(page);
  assert.equal(await dialog(page).getByRole("button", { name: en("auto.take") }).isEnabled(), false);
  await drag(page, await onBoard(page, 0, 0, 10), await onBoard(page, 50, 0.2, 10));
  await becomes(() => typed(page), ["0 50 0"]);
  await drag(page, await middle(page, en("auto.handle.to", { name: nameOf("dwell", 1) })), await onBoard(page, 62, 3, 10));
  await becomes(() => typed(page), ["0 60 0"]);
  await frames(page);
  await drag(page, await onBoard(page, 240, 10, 10), await onBoard(page, 180, 10, 10));
  await becomes(() => typed(page), ["0 60 0", "180 240 10"]);
  await frames(page, 4);
  const bar = await middle(page, nameOf("dwell", 2));
  const [low, high] = [await onBoard(page, 0, 0, 10), await onBoard(page, 0, 10, 10)];
  // Further than the board is high: the hand takes it along.
  await drag(page, bar, { x: bar.x, y: bar.y - (low.y - high.y) });
  await becomes(() => typed(page), ["0 60 0", "180 240 20"]);
  await frames(page, 4);
  await tool(page, "point").check({ force: true });
  const click = await onBoard(page, 120, 12, 20);
  await page.mouse.click(click.x, click.y);
  await becomes(() => typed(page), ["0 60 0", "180 240 20", "120 12 "]);
  assert.equal(await handle(page, nameOf("point", 3)).getAttribute("aria-valuetext"), `${en("auto.spot", { theta: "120°", s: "12\u00a0mm" })}, ${en("auto.free")}`);
  await becomes(() => dialog(page).getByRole("button", { name: en("auto.take") }).isEnabled(), true);
  await dialog(page).getByRole("button", { name: en("auto.take") }).click();
  await becomes(() => fragment(page), /D60.*D60/);
  await becomes(async () => (await diagram(page, "s").getAttribute("aria-label")) ?? "", /from 0\smm to 20\smm/);
});

test("a requirement is moved and removed by keys, and each change can be taken back in the window", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  const start = await fragment(page);
  await openEmpty(page);
  await tool(page, "line").check({ force: true });
  await dialog(page).getByRole("button", { name: en("auto.add") }).click();
  await becomes(() => typed(page), ["165 195 2.5 7.5"]);
  const line = nameOf("line", 1);
  await handle(page, en("auto.handle.to", { name: line })).focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Shift+ArrowRight");
  await page.keyboard.press("Alt+ArrowUp");
  await becomes(() => typed(page), ["165 206 2.5 7.6"]);
  await page.keyboard.press("Shift+Tab");
  await page.keyboard.press("Shift+Tab");
  await page.keyboard.press("ArrowLeft");
  await becomes(() => typed(page), ["164 205 2.5 7.6"]);
  assert.equal(await handle(page, line).getAttribute("aria-valuetext"), en("auto.told.line", { from: "164°", to: "205°", s: "2.5\u00a0mm", end: "7.6\u00a0mm" }));
  await cell(page, "from", 1).fill("150,5");
  await becomes(() => handle(page, line).getAttribute("aria-valuenow"), "150.5");
  await handle(page, line).press("Delete");
  await becomes(() => typed(page), []);
  await page.keyboard.press("Control+z");
  await becomes(() => typed(page), ["150,5 205 2.5 7.6"]);
  for (let steps = 0; steps < 2; steps++) await page.keyboard.press("Control+z");
  await becomes(() => typed(page), ["165 206 2.5 7.6"]);
  await page.keyboard.press("Control+y");
  await becomes(() => typed(page), ["164 205 2.5 7.6"]);
  assert.equal(await fragment(page), start, "what is behind the window is not taken back");
});

test("the tangent of a point is turned to a velocity, which is free again when it is removed", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  await openEmpty(page);
  const click = await onBoard(page, 180, 10, 10);
  await page.mouse.click(click.x, click.y);
  await becomes(() => typed(page), ["180 10 "]);
  await frames(page, 4);
  const name = en("auto.handle.slope", { name: nameOf("point", 1) });
  // Half a radian to the right, and 4 mm higher.
  await drag(page, await middle(page, name), await onBoard(page, 180 + 90 / Math.PI, 14 - 1e-6, 10));
  await eventually(() => typed(page), ([row]) => assert.match(row, /^180 10 (7|8|9)(\.\d)?$/));
  await handle(page, name).press("Shift+ArrowDown");
  await eventually(() => typed(page), ([row]) => assert.match(row, /^180 10 −(1|2|3)(\.\d)?$/));
  await handle(page, name).press("Delete");
  await becomes(() => typed(page), ["180 10 "]);
});

test("a finger draws and moves on a phone, and nothing scrolls away under it", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"], viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await openEmpty(page);
  const devtools = await page.context().newCDPSession(page);
  /** @param {{ x: number, y: number }} from @param {{ x: number, y: number }} to */
  async function stroke(from, to) {
    await devtools.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [from] });
    for (let part = 1; part <= 5; part++) {
      await devtools.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: [{ x: from.x + ((to.x - from.x) * part) / 5, y: from.y + ((to.y - from.y) * part) / 5 }] });
    }
    await devtools.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  }
  await stroke(await onBoard(page, 90, 10, 10), await onBoard(page, 150, 8, 10));
  await becomes(() => typed(page), ["90 150 10"]);
  await frames(page, 4);
  const scrolled = await dialog(page).evaluate((element) => element.scrollTop);
  const bar = await middle(page, nameOf("dwell", 1));
  await stroke(bar, { x: bar.x, y: (await onBoard(page, 120, 5, 10)).y });
  await becomes(() => typed(page), ["90 150 5"]);
  assert.equal(await dialog(page).evaluate((element) => element.scrollTop), scrolled);
});

test("what is held is let go as it was with Escape, and the window stays", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  await page.getByRole("button", { name: en("segments.auto"), exact: true }).click();
  await dialog(page).getByRole("listitem").first().waitFor();
  const before = await typed(page);
  const bar = await middle(page, nameOf("dwell", 1));
  await page.mouse.move(bar.x, bar.y);
  await page.mouse.down();
  await page.mouse.move(bar.x + 40, bar.y + 30, { steps: 4 });
  await eventually(() => typed(page), (now) => assert.notDeepEqual(now, before));
  await page.keyboard.press("Escape");
  await becomes(() => typed(page), before);
  await page.mouse.up();
  assert.equal(await dialog(page).isVisible(), true);
});

test("the dwells of the program at hand are joined anew, with reasons, and one undo takes it back", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  const start = await fragment(page);
  await page.getByRole("button", { name: en("segments.auto"), exact: true }).click();
  const reasons = dialog(page).getByRole("listitem");
  // Four gaps alike have one reason.
  await becomes(() => reasons.count(), 1);
  assert.match(await reasons.first().innerText(), /^From 0° to 50°, from 90° to 140°, from 180° to 230° and from 270° to 320°: modified trapezoidal.*lowest peak/);
  await dialog(page).getByLabel(en("auto.fast")).check();
  await eventually(() => reasons.first().innerText(), (text) => assert.match(text, /4-5-6-7.*only one/));
  await dialog(page).getByLabel(en("auto.fast")).uncheck();
  await dialog(page).getByLabel(en("auto.least")).selectOption("velocity");
  await eventually(() => reasons.first().innerText(), (text) => assert.match(text, /^From 0° to 50°.*: modified sine/));
  assert.equal(await fragment(page), start, "nothing is taken before it is asked for");
  await dialog(page).getByRole("button", { name: en("auto.take") }).click();
  await becomes(() => fragment(page), /R35_7M50_10D40M50-10D40M50_10D40M50-10D40/);
  await undo(page).click();
  await becomes(() => fragment(page), start);
});

test("lines and points are typed in, and what cannot be met is told with its requirement", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  await page.getByRole("button", { name: en("segments.auto"), exact: true }).click();
  for (let left = 4; left > 1; left--) await dialog(page).getByRole("button", { name: en("auto.remove", { number: left }) }).click();
  await cell(page, "from", 1).fill("0");
  await cell(page, "to", 1).fill("60");
  await cell(page, "s", 1).fill("0");
  const status = dialog(page).getByRole("status");
  await eventually(() => status.innerText(), (text) => assert.match(text, /Nothing moves/));
  await tool(page, "point").check({ force: true });
  await dialog(page).getByRole("button", { name: en("auto.add") }).click();
  await cell(page, "from", 2).fill("");
  await eventually(() => status.innerText(), (text) => assert.equal(text, en("auto.problem", { number: 2, message: en("auto.unreadable") })));
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
  const { page } = await openPage(t, { fragment: LINKS["9RT"], locale: "es-ES" });
  await page.getByRole("button", { name: es("segments.auto"), exact: true }).click();
  await eventually(() => page.getByRole("dialog").getByRole("listitem").first().innerText(), (text) => assert.match(text, /trapezoidal modificada/));
  await page.getByRole("button", { name: es("auto.close"), exact: true }).click();
  const auto = page.getByRole("button", { name: es("segments.auto"), exact: true, includeHidden: true });
  for (const [kind, hidden] of /** @type {const} */ ([["translating", true], ["constant-breadth", true], ["grooved", false]])) {
    await page.locator("#field-kind").selectOption(kind);
    await becomes(() => auto.isHidden(), hidden);
  }
});
