// Spanish and English: by the browser's preference and by the switch, everywhere, with each language's numbers.
import assert from "node:assert/strict";
import { test } from "node:test";
import { drawn } from "./browser.js";
import { openPage } from "./harness.js";
import {
  LINKS, baseRadiusCure, becomes, beta, diagram, en, es, eventually, field, findings, fragment, frames, literal, mechanism, openExample, readout, setCursor, undo, verdict,
} from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

/** What a key of the strings looks like when nobody translated it. */
const KEY = /^[a-z]+\.[a-z.]+$/;

/** Proper names and international words, the same in both languages. */
const SHARED = /^(LevaLab|SVAJ|SCCA|Example R1|Example R1 · LevaLab|Ctrl [A-Z]|Alt [↑↓]|Esc|Manual|English|Español|rpm|rev\/s|.{1,2}\/rad[²³]?)$/;

/** @param {Page} page @param {"es" | "en"} language */
const switchTo = (page, language) => page.getByRole("button", { name: language.toUpperCase(), exact: true }).click();

/**
 * Every text that is seen or heard now.
 * @param {Page} page
 * @returns {Promise<string[]>}
 */
function texts(page) {
  return page.evaluate(() => {
    const found = new Set([document.title]);
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) if (walker.currentNode.parentElement?.checkVisibility()) found.add(walker.currentNode.textContent ?? "");
    for (const node of document.querySelectorAll("*")) {
      if (!node.checkVisibility()) continue;
      for (const name of ["aria-label", "aria-valuetext", "aria-description", "aria-roledescription", "title", "placeholder", "alt", "label"]) found.add(node.getAttribute(name) ?? "");
      if (node instanceof HTMLInputElement && node.type === "text") found.add(node.value);
    }
    return [...found].map((text) => text.trim()).filter(Boolean);
  });
}

/** Shows as much of the page as can be seen at a time, in three sights. @param {Page} page @param {typeof en} say */
async function everyText(page, say) {
  const seen = new Set(await texts(page));
  const look = async () => {
    await frames(page);
    for (const text of await texts(page)) seen.add(text);
  };
  await page.getByRole("radio", { name: /φ/ }).check({ force: true });
  await look();
  await page.getByRole("radio", { name: /ρ/ }).check({ force: true });
  await look();
  await page.getByRole("radio", { name: /SVAJ/ }).check({ force: true });
  await page.getByRole("button", { name: say("segments.actions", { number: 1 }), exact: true }).click();
  await look();
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: say("header.help"), exact: true }).click();
  // It is loaded when it is first asked for: Escape before that would close nothing.
  await page.locator("dialog[open]").waitFor();
  await look();
  await page.keyboard.press("Escape");
  await field(page, "base_radius").fill("-1");
  await look();
  await field(page, "base_radius").fill("x");
  await look();
  await field(page, "base_radius").fill("0.2");
  return [...seen];
}

/** What the diagrams write on their canvases. @param {Page} page */
async function watchDrawnText(page) {
  await page.addInitScript(() => {
    const drawn = /** @type {string[]} */ ([]);
    const write = CanvasRenderingContext2D.prototype.fillText;
    CanvasRenderingContext2D.prototype.fillText = function (text, ...where) {
      if (this.canvas.isConnected) drawn.push(text);
      return write.call(this, text, ...where);
    };
    Object.assign(window, { drawnText: drawn });
  });
  await page.reload();
  await drawn(page);
  return () => page.evaluate(() => /** @type {Window & { drawnText?: string[] }} */ (window).drawnText?.splice(0) ?? []);
}

for (const [locale, language, sentence] of /** @type {const} */ ([
  ["es-ES", "es", /presión/],
  ["es-MX", "es", /presión/],
  ["fr-FR", "en", /pressure/],
])) {
  test(`a browser in ${locale} gets the page in ${language}`, async (t) => {
    const { page } = await openPage(t, { locale, fragment: LINKS.R1 });
    assert.equal(await page.locator("html").getAttribute("lang"), language);
    assert.match(await verdict(page).innerText(), sentence);
    await page.getByText({ es, en }[language]("design.follower"), { exact: true }).first().waitFor();
  });
}

test("the switch changes everything at once, and is remembered", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS.R1 });
  const english = await findings(page).first().innerText();
  await switchTo(page, "es");
  await becomes(() => page.locator("html").getAttribute("lang"), "es");
  await becomes(() => findings(page).first().innerText(), /^El ángulo de presión/);
  assert.equal(await page.getByRole("button", { name: "ES", exact: true }).getAttribute("aria-pressed"), "true");
  assert.equal(await fragment(page), LINKS.R1, "a language is no edit");
  await page.reload();
  await becomes(() => page.locator("html").getAttribute("lang"), "es");
  await switchTo(page, "en");
  await becomes(() => page.locator("html").getAttribute("lang"), "en");
  await becomes(() => findings(page).first().innerText(), english);
});

test("an error is said again in the other language", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  await field(page, "base_radius").fill("-5");
  await beta(page, 1).fill("12x");
  const english = await verdict(page).innerText();
  await page.getByText("“x” is not a unit").waitFor();
  await switchTo(page, "es");
  await page.getByText("«x» no es una unidad").waitFor();
  await becomes(() => page.locator("html").getAttribute("lang"), "es");
  await eventually(() => verdict(page).innerText(), (now) => assert.notEqual(now, english));
});

test("numbers have a decimal comma in Spanish and a point in English, on the diagrams too", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS.R1 });
  const drawnText = await watchDrawnText(page);
  await setCursor(page, "200.4");
  assert.match((await drawnText()).join(" "), /\b0\.1\b/);
  assert.deepEqual((await texts(page)).filter((text) => /\d,\d/.test(text)), [], "decimal commas in English");
  assert.match((await readout(page, "theta").textContent()) ?? "", /^200\.4/);
  assert.equal(await field(page, "base_radius").inputValue(), "0.2");

  await switchTo(page, "es");
  await becomes(() => field(page, "base_radius").inputValue(), "0,2");
  await becomes(() => readout(page, "theta").textContent(), /^200,4/);
  await frames(page);
  const spanish = (await drawnText()).join(" ");
  assert.match(spanish, /\b0,1\b/);
  assert.doesNotMatch(spanish, /\d\.\d/);
  await becomes(() => mechanism(page).getAttribute("aria-label"), /0,2\sm/);
  await becomes(() => diagram(page, "v", es).getAttribute("aria-label"), /−0,1883\sm\/rad/);
  await becomes(() => verdict(page).innerText(), /31,8°/);
  await becomes(async () => (await texts(page)).filter((text) => /\d\.\d/.test(text)), []);
});

test("a decimal point is understood in Spanish, a comma in English", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"], locale: "es-ES" });
  const radius = field(page, "base_radius");
  await radius.fill("36.5");
  await becomes(() => fragment(page), /\.R36\.5_/);
  await radius.press("Enter");
  assert.equal(await radius.inputValue(), "36,5");
  const angle = page.getByRole("textbox", { name: es("transport.angle") });
  await angle.fill("12.5");
  await angle.press("Enter");
  await becomes(() => readout(page, "theta").textContent(), /^12,5/);
});

test("no text is missing, and none is left in the other language", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS.R1 });
  await becomes(() => baseRadiusCure(page).count(), 1);
  const english = await everyText(page, en);
  await switchTo(page, "es");
  await becomes(() => baseRadiusCure(page).first().textContent(), /^Con /);
  // The drawings are told in words only once the hand rests.
  await becomes(() => mechanism(page).getAttribute("aria-label"), /^Leva/);
  await becomes(() => diagram(page, "j", es).count(), 1);
  const spanish = await everyText(page, es);
  for (const all of [english, spanish]) assert.deepEqual(all.filter((text) => KEY.test(text)), [], "keys instead of words");
  const both = new Set(english);
  assert.deepEqual(spanish.filter((text) => /\p{L}{3}/u.test(text) && both.has(text) && !SHARED.test(text)), [], "the same in both languages");
  assert(spanish.some((text) => new RegExp(literal(es("segments.actions", { number: 1 }))).test(text)));
});

test("what the page brings along is named in its language: the first cam and the examples", async (t) => {
  const { page } = await openPage(t, { locale: "es-ES" });
  const title = page.getByRole("textbox", { name: es("header.title") });
  assert.equal(await title.inputValue(), "Ejemplo 9RT");
  await page.getByRole("button", { name: es("header.examples"), exact: true }).click();
  await page.locator('[data-example="R5"]').click();
  await becomes(() => title.inputValue(), "Ejemplo R5");
  await becomes(() => fragment(page), /^1\.Ejemplo_R5\./);
  for (const [id, name] of [["GROOVE", "Leva de ranura"], ["WEDGE", "Cuña"], ["ARCS", "Siete arcos"]]) {
    await page.getByRole("button", { name: es("header.examples"), exact: true }).click();
    await page.locator(`[data-example="${id}"]`).click();
    await becomes(() => title.inputValue(), name ?? "");
  }
});

test("what the page brought along follows the language until it is changed", async (t) => {
  const { page } = await openPage(t, { locale: "es-ES" });
  const title = page.getByRole("textbox").first();
  await switchTo(page, "en");
  await becomes(() => title.inputValue(), "Example 9RT");
  await becomes(() => undo(page).isDisabled(), true);
  await openExample(page, "WEDGE");
  await becomes(() => title.inputValue(), "Wedge");
  await switchTo(page, "es");
  await becomes(() => title.inputValue(), "Cuña");
  await field(page, "roller_radius").fill("9");
  await becomes(() => undo(page).isEnabled(), true);
  await switchTo(page, "en");
  await becomes(() => field(page, "roller_radius").inputValue(), "9");
  assert.equal(await title.inputValue(), "", "changed, it is no longer the example");
});
