// The keyboard alone: everything is reached, seen to be reached, used, and left again.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  LINKS, announced, baseRadiusCure, becomes, beta, cursor, cursorField, en, es, eventually, field, findings, fragment, frames, law, level, literal, openStill, program, redo, undo,
} from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

/** More stops than the page has. */
const MOST = 200;

/**
 * The page with the nodes met so far: what is loaded late may come between them, so their place in the document does not tell them.
 * @typedef {Window & { met?: Element[] }} Met
 */

/** @param {Page} page */
const focused = (page) =>
  page.evaluate(() => {
    const met = (/** @type {Met} */ (window).met ??= []);
    const node = document.activeElement;
    if (!node || node === document.body) return null;
    const { left, top, right, bottom } = node.getBoundingClientRect();
    // A radio that is only drawn shows its focus on its label.
    const drawn = node.classList.contains("unseen") ? (node.closest("label") ?? node) : node;
    const style = getComputedStyle(drawn);
    const ring = style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 1.5 && style.outlineColor !== "rgba(0, 0, 0, 0)";
    const box = drawn.getBoundingClientRect();
    return {
      name: node.id || node.getAttribute("aria-label") || node.textContent?.trim() || node.tagName,
      ring,
      inWindow: box.left > -1 && box.top > -1 && box.right < innerWidth + 1 && box.bottom < innerHeight + 1,
      index: met.includes(node) ? met.indexOf(node) : met.push(node) - 1,
      size: [right - left, bottom - top],
    };
  });

/** Everything that a Tab has to stop at: of a group of radios the chosen one. @param {Page} page */
const stops = (page) =>
  page.evaluate(() => {
    const met = (/** @type {Met} */ (window).met ??= []);
    return [...document.querySelectorAll("*")].flatMap((node) => {
      if (!node.matches("button, input, select, textarea, summary, a[href], [tabindex]") || node.getAttribute("tabindex") === "-1") return [];
      if (/** @type {HTMLButtonElement} */ (node).disabled || node.closest("dialog:not([open]), [popover]:not(:popover-open), [hidden]") || !node.checkVisibility()) return [];
      if (node.closest("details:not([open])") && node.tagName !== "SUMMARY") return [];
      if (node instanceof HTMLInputElement && node.type === "radio" && !node.checked) return [];
      const index = met.includes(node) ? met.indexOf(node) : met.push(node) - 1;
      return [{ index, name: node.id || node.getAttribute("aria-label") || node.textContent?.trim() || node.tagName }];
    });
  });

/** @param {Page} page */
const playing = (page) => page.locator("#transport button[data-state]").getAttribute("data-state");

/** Presses Tab until the control has the focus. @param {Page} page @param {import("playwright-core").Locator} control */
async function tabTo(page, control) {
  for (let i = 0; i < MOST; i++) {
    if (await control.evaluate((node) => node === document.activeElement)) return;
    await page.keyboard.press("Tab");
  }
  assert.fail("Tab does not get there");
}

for (const fragmentOf of /** @type {const} */ (["9RT", "R1"])) {
  test(`Tab stops at every control of ${fragmentOf}, in sight and with a ring, and leaves at the end`, async (t) => {
    const { page } = await openStill(t, { fragment: LINKS[fragmentOf] });
    await becomes(async () => (await findings(page).getByRole("button").count()) > 2, true);
    const expected = await stops(page);
    const seen = new Set();
    const wrong = [];
    for (let i = 0; i < MOST; i++) {
      await page.keyboard.press("Tab");
      const at = await focused(page);
      if (!at || seen.has(at.index)) break;
      seen.add(at.index);
      if (!at.ring) wrong.push(`${at.name}: no ring`);
      if (!at.inWindow) wrong.push(`${at.name}: out of sight`);
    }
    assert.deepEqual(wrong, []);
    assert.deepEqual(expected.filter(({ index }) => !seen.has(index)).map(({ name }) => name), [], "never reached");
    // Back again from the end.
    await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement)?.blur());
    await page.keyboard.press("Shift+Tab");
    const last = await focused(page);
    await page.keyboard.press("Shift+Tab");
    assert.notEqual((await focused(page))?.index, last?.index, "Shift+Tab is trapped");
  });
}

test("the first stops of Tab skip to the design and to the diagrams, and leaving is a few presses from there", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"], locale: "es-ES" });
  const [design, diagrams] = [page.getByRole("button", { name: es("skip.design"), exact: true }), page.getByRole("button", { name: es("skip.diagrams"), exact: true })];
  const width = async (/** @type {import("playwright-core").Locator} */ skip) => (await skip.boundingBox())?.width ?? 0;
  const has = (/** @type {import("playwright-core").Locator} */ control) => control.evaluate((node) => node === document.activeElement);
  assert((await width(design)) <= 2, "not seen before it has the focus");
  await page.keyboard.press("Tab");
  assert(await has(design));
  assert((await width(design)) > 50);
  await page.keyboard.press("Tab");
  assert(await has(diagrams));
  await page.keyboard.press("Enter");
  assert(await has(page.locator("#diagrams")));
  await page.keyboard.press("Tab");
  assert(await has(page.locator(".diagram-overlay")), "the first control of the diagrams");
  let presses = 4;
  while (await page.evaluate(() => document.activeElement !== document.body)) {
    await page.keyboard.press("Tab");
    presses++;
  }
  assert(presses <= 25, `${presses} presses to leave`);
  await design.focus();
  await page.keyboard.press("Enter");
  assert(await has(page.locator("#design")));
  await page.keyboard.press("Tab");
  assert(await page.locator("#design").evaluate((panel) => panel.contains(document.activeElement)));
  assert.equal(await page.locator("#design").getAttribute("tabindex"), null, "a click beside its controls gives it no focus");
  assert.equal(await fragment(page), LINKS["9RT"], "the address keeps the design");
  await page.getByRole("button", { name: es("header.projector"), exact: true }).click();
  await becomes(() => design.isVisible(), false);
});

test("question marks of a group are one stop of Tab, and arrows lead from each to the next", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const term = () => page.evaluate(() => document.activeElement?.getAttribute("data-term") ?? null);
  const described = () => page.evaluate(() => document.activeElement?.getAttribute("aria-describedby") ?? null);
  /** @type {Record<string, number>} */
  const stopped = {};
  for (let i = 0; i < MOST; i++) {
    await page.keyboard.press("Tab");
    if (await page.evaluate(() => document.activeElement === document.body)) break;
    const group = await page.evaluate(() => (document.activeElement?.matches(".mark") ? document.activeElement.closest("section")?.id : undefined));
    if (group) stopped[group] = (stopped[group] ?? 0) + 1;
  }
  assert.deepEqual(stopped, { design: 1, readouts: 1, verdict: 1 });

  await tabTo(page, page.locator('#readouts [data-term="theta"]'));
  assert.equal(await page.locator(`#${await described()}`).textContent(), en("mark.how"));
  const way = [];
  for (const key of ["ArrowRight", "ArrowDown", "ArrowLeft", "End", "ArrowRight", "ArrowUp", "Home", "ArrowRight"]) {
    await page.keyboard.press(key);
    way.push(await term());
  }
  assert.deepEqual(way, ["t", "s", "t", "sliding", "theta", "sliding", "theta", "t"]);
  assert.equal(await described(), null, "said once, where Tab arrives");
  await becomes(() => cursor(page), 0);
  // Tab leaves the group, and comes back to where it was left.
  await page.keyboard.press("Tab");
  assert.equal(await term(), null);
  await page.keyboard.press("Shift+Tab");
  assert.equal(await term(), "t");
  // A stop that goes out of sight leaves its place to another.
  await page.locator('#design [data-term="rotation"]').click();
  await page.keyboard.press("Escape");
  await page.getByRole("dialog").waitFor({ state: "hidden" });
  await field(page, "kind").selectOption("translating");
  await page.locator('#design [data-term="rotation"]').waitFor({ state: "hidden" });
  await field(page, "kind").focus();
  await page.keyboard.press("Tab");
  assert.equal(await term(), "kind");
});

test("Space plays and pauses when nothing has the focus, as the help says", async (t) => {
  const { page } = await openStill(t);
  await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement)?.blur());
  await page.keyboard.press("Space");
  await becomes(() => playing(page), "playing");
  await page.keyboard.press("Space");
  await becomes(() => playing(page), "paused");
});

test("Space plays and pauses on the mechanism, the diagrams and the button", async (t) => {
  const { page } = await openStill(t);
  await page.locator("#mechanism canvas").focus();
  await page.keyboard.press("Space");
  await becomes(() => playing(page), "playing");
  await page.getByRole("slider", { name: en("diagram.cursor") }).focus();
  await page.keyboard.press("Space");
  await becomes(() => playing(page), "paused");
  await page.getByRole("button", { name: en("transport.play"), exact: true }).focus();
  await page.keyboard.press("Space");
  await becomes(() => playing(page), "playing");
  await page.keyboard.press("Enter");
  await becomes(() => playing(page), "paused");
});

test("arrows move the cursor on the mechanism, the diagrams and the scrubber", async (t) => {
  const { page } = await openStill(t);
  const places = [page.locator("#mechanism canvas"), page.getByRole("slider", { name: en("diagram.cursor") }), page.getByRole("slider", { name: en("transport.scrub"), exact: true })];
  for (const place of places) {
    await place.focus();
    await page.keyboard.press("Home");
    await becomes(() => cursor(page), 0);
    for (const [key, theta] of /** @type {const} */ ([["ArrowRight", 1], ["Shift+ArrowRight", 10], ["ArrowRight", 11], ["Alt+ArrowRight", 11.1], ["Alt+ArrowLeft", 11], ["ArrowLeft", 10], ["ArrowLeft", 9]])) {
      await page.keyboard.press(key);
      await becomes(() => cursor(page), theta);
    }
  }
  const slider = page.getByRole("slider", { name: en("diagram.cursor") });
  assert.equal(await slider.getAttribute("aria-valuenow"), "9.0");
  assert.match((await slider.getAttribute("aria-valuetext")) ?? "", /9\.0°/);
});

test("arrows move the cursor when nothing has the focus, as the help says", async (t) => {
  const { page } = await openStill(t);
  await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement)?.blur());
  await page.keyboard.press("ArrowRight");
  await becomes(() => cursor(page), 1);
  await page.keyboard.press("ArrowLeft");
  await becomes(() => cursor(page), 0);
});

test("single steps, the angle by its field, direction and speed", async (t) => {
  const { page } = await openStill(t);
  await page.getByRole("button", { name: en("transport.forth") }).focus();
  await page.keyboard.press("Enter");
  await page.keyboard.press("Enter");
  await becomes(() => cursor(page), 2);
  await page.getByRole("button", { name: en("transport.back") }).focus();
  await page.keyboard.press("Enter");
  await becomes(() => cursor(page), 1);
  await cursorField(page).focus();
  await page.keyboard.type("143");
  await page.keyboard.press("Enter");
  await becomes(() => cursor(page), 143);
  const wheel = page.getByRole("slider", { name: en("transport.speed") });
  await wheel.focus();
  const before = await wheel.getAttribute("aria-valuetext");
  await page.keyboard.press("ArrowRight");
  await eventually(() => wheel.getAttribute("aria-valuetext"), (now) => assert.notEqual(now, before));
  const reverse = page.getByRole("button", { name: en("transport.reverse") });
  await reverse.focus();
  await page.keyboard.press("Enter");
  await becomes(() => reverse.getAttribute("aria-pressed"), "true");
});

test("segments: the menu opens, its arrows turn, Escape closes it and gives the focus back", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const more = page.getByRole("button", { name: en("segments.actions", { number: 2 }), exact: true });
  await tabTo(page, more);
  await page.keyboard.press("Enter");
  const item = (/** @type {string} */ action) => page.getByRole("menuitem", { name: en(`action.${action}`), exact: true });
  const has = (/** @type {import("playwright-core").Locator} */ control) => control.evaluate((node) => node === document.activeElement);
  await becomes(() => has(item("insert-before")), true);
  await page.keyboard.press("ArrowUp");
  assert(await has(item("delete")));
  await page.keyboard.press("ArrowDown");
  assert(await has(item("insert-before")));
  await page.keyboard.press("Escape");
  await item("delete").waitFor({ state: "hidden" });
  assert(await has(more), "Escape loses the focus");

  await page.keyboard.press("Enter");
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Enter");
  await becomes(async () => (await program(page)).length, 9);
  assert(await has(law(page, 3)), "the focus is on the new segment");
  await page.keyboard.press("Tab");
  assert(await has(beta(page, 3)));
});

test("segments: Alt with arrows moves them, and the focus goes with them; deleting leaves the focus in the table", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await law(page, 1).focus();
  await page.keyboard.press("Alt+ArrowDown");
  await becomes(async () => (await program(page)).slice(0, 2), ["dwell 40 0", "modified-sine 50 10"]);
  assert(await law(page, 2).evaluate((node) => node === document.activeElement));
  await becomes(() => announced(page), en("segments.moved", { number: 2, count: 8 }));
  await page.keyboard.press("Alt+ArrowUp");
  await becomes(() => fragment(page), LINKS["9RT"]);
  await page.getByRole("button", { name: en("segments.actions", { number: 8 }), exact: true }).focus();
  await page.keyboard.press("Enter");
  await page.getByRole("menuitem", { name: en("action.delete"), exact: true }).focus();
  await page.keyboard.press("Enter");
  await becomes(async () => (await program(page)).length, 7);
  assert(await page.getByRole("group", { name: en("design.program") }).evaluate((node) => node.contains(document.activeElement)));
});

test("a cure by the keyboard; the focus does not get lost", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.R1 });
  await becomes(() => baseRadiusCure(page).count(), 1);
  await tabTo(page, baseRadiusCure(page));
  await page.keyboard.press("Enter");
  await becomes(() => level(page), "low-speed");
  await frames(page);
  assert(await page.locator("#verdict").evaluate((node) => node.contains(document.activeElement)), "the focus left the verdict");
  await page.keyboard.press("Control+z");
  await becomes(() => level(page), "unacceptable");
});

test("undo and redo keep the focus while they have something to do", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await field(page, "base_radius").fill("36");
  await law(page, 1).selectOption("cycloidal");
  await undo(page).focus();
  await page.keyboard.press("Enter");
  await becomes(() => law(page, 1).inputValue(), "modified-sine");
  assert(await undo(page).evaluate((node) => node === document.activeElement));
  await redo(page).focus();
  await page.keyboard.press("Enter");
  await becomes(() => law(page, 1).inputValue(), "cycloidal");
});

test("the help opens with ?, holds the focus, and Escape closes it", async (t) => {
  const { page } = await openStill(t);
  const help = page.getByRole("button", { name: en("header.help"), exact: true });
  await tabTo(page, help);
  await page.keyboard.press("Enter");
  const dialog = page.getByRole("dialog", { name: en("help.title") });
  await dialog.waitFor();
  for (let i = 0; i < 4; i++) {
    await page.keyboard.press("Tab");
    assert(await dialog.evaluate((node) => node.contains(document.activeElement) || document.activeElement === document.body), "Tab leaves the open window");
  }
  await page.keyboard.press("Escape");
  await dialog.waitFor({ state: "hidden" });
  assert(await help.evaluate((node) => node === document.activeElement));
  await page.keyboard.press("?");
  await dialog.waitFor();
});

test("letters typed into a field are text, not commands", async (t) => {
  const { page } = await openStill(t);
  const title = page.getByRole("textbox", { name: en("header.title") });
  await title.fill("");
  await title.focus();
  await page.keyboard.type("p? x");
  assert.equal(await title.inputValue(), "p? x");
  assert.equal(await page.getByRole("dialog").count(), 0);
  await page.getByRole("group", { name: en("design.program") }).waitFor();
});

test("the layers are switched by the keyboard", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const summary = page.locator("#mechanism summary", { hasText: new RegExp(`^${literal(en("stage.layers"))}`) });
  await tabTo(page, summary);
  await page.keyboard.press("Enter");
  const pitch = page.getByRole("checkbox", { name: en("stage.layer.pitch") });
  await pitch.waitFor();
  const was = await pitch.isChecked();
  await tabTo(page, pitch);
  await page.keyboard.press("Space");
  assert.equal(await pitch.isChecked(), !was);
  await page.keyboard.press("Escape");
  await pitch.waitFor({ state: "hidden" });
  assert(await summary.evaluate((node) => node === document.activeElement));
});
