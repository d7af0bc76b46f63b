// The packed page opens anywhere, and keeps to itself.
import assert from "node:assert/strict";
import { test } from "node:test";
import { drawn } from "./browser.js";
import { openPage } from "./harness.js";
import { becomes, cursor, en, eventually, field, fragment, law, level, mechanism, picture, verdict } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

test("the page draws under any path, within its policy, asking no other host", async (t) => {
  const { page } = await openPage(t);
  assert.match(await page.title(), /LevaLab$/);
});

test("the policy allows nothing but the page's own files", async (t) => {
  const { page } = await openPage(t);
  const policy = await page.locator('meta[http-equiv="Content-Security-Policy"]').getAttribute("content");
  const rules = new Set(policy?.split(";").map((rule) => rule.trim()));
  for (const rule of ["default-src 'none'", "script-src 'self' 'wasm-unsafe-eval'", "connect-src 'self'", "base-uri 'none'", "form-action 'none'"]) {
    assert(rules.has(rule), rule);
  }
});

test("what the first picture needs of the module arrives once, asked for before the script that uses it runs", async (t) => {
  const { page } = await openPage(t);
  const loads = await page.evaluate(() =>
    performance.getEntriesByType("resource").map(({ name, startTime }) => ({ name, startTime })),
  );
  const modules = loads.filter(({ name }) => name.endsWith("levalab_first.wasm"));
  const script = loads.find(({ name }) => name.endsWith("main.js"));
  assert.equal(modules.length, 1);
  assert(script && modules[0].startTime < script.startTime + 50, "the hint in index.html was not used");
});

for (const [locale, language] of [["en-GB", "en"], ["es-ES", "es"]]) {
  test(`the first picture takes four scripts, the words of one language among them (${locale})`, async (t) => {
    const { page } = await openPage(t, { locale });
    const scripts = await page.evaluate(() => {
      const [{ startTime: drawn }] = performance.getEntriesByName("levalab:drawn");
      const loads = performance.getEntriesByType("resource").filter(({ name, startTime }) => name.endsWith(".js") && startTime < drawn);
      return loads.map(({ name }) => name.split("/").at(-1)).sort();
    });
    assert.deepEqual(scripts, ["early.js", "levalab_wasm.js", "main.js", `page.${language}.js`]);
  });
}

/**
 * The page at its address while the whole module waits until it is let through.
 * @param {import("node:test").TestContext} t
 * @param {import("playwright-core").BrowserContextOptions & { fragment?: string }} [options]
 */
async function openWithoutWhole(t, { fragment = "", ...screen } = {}) {
  const { page, url } = await openPage(t, { ...screen, ready: false });
  /** @type {() => void} */
  let release = () => {};
  const gate = new Promise((resolve) => (release = () => resolve(undefined)));
  let asked = false;
  await page.route("**/levalab_wasm_bg.wasm", async (route) => {
    asked = true;
    await gate;
    await route.continue();
  });
  await page.goto("about:blank");
  await page.goto(url + (fragment && `#${fragment}`));
  return { page, whole: { release, asked: () => asked } };
}

/** Screens from a phone to a projector, of both languages and themes. @type {import("playwright-core").BrowserContextOptions[]} */
const SCREENS = [
  { locale: "en-GB" },
  { locale: "es-ES", colorScheme: "dark" },
  { locale: "es-ES", viewport: { width: 390, height: 844 }, deviceScaleFactor: 3, isMobile: true, hasTouch: true },
  { locale: "en-GB", viewport: { width: 1920, height: 1080 }, deviceScaleFactor: 1.5, colorScheme: "dark" },
];

for (const screen of SCREENS) {
  const { width } = screen.viewport ?? { width: 1366 };
  test(`the first picture, its animation and an edit do without the whole module (${screen.locale}, ${width} wide)`, async (t) => {
    const { page, whole } = await openWithoutWhole(t, screen);
    await drawn(page);
    await becomes(() => level(page), "low-speed");
    const before = await cursor(page);
    await eventually(() => cursor(page), (now) => assert.notEqual(now, before, "the cam stands still"));
    await field(page, "base_radius").fill("36");
    await becomes(() => fragment(page), /\.R36_7/);
    assert.equal(await level(page), "low-speed");
    whole.release();
    await eventually(() => page.locator("#verdict .cures button").count(), (count) => assert(count > 0, "no cure is offered"));
  });
}

/** A polynomial through nine conditions. */
const GAIT = "1.Example_R6.R2_1uiw12.566N256.32s0v0a0s56.88_1.177s123.84_.847s198.72_1.139s256.32v256.32a256.32D103.68.1VXCG1";

test("what only the whole module can do waits for it, and is done then", async (t) => {
  const { page, whole } = await openWithoutWhole(t, { fragment: GAIT });
  await eventually(async () => whole.asked(), (asked) => assert(asked, "such a link asks for the whole at once"));
  assert.equal(await page.evaluate(() => performance.getEntriesByName("levalab:drawn").length), 0, "drawn without what it needs");
  whole.release();
  await drawn(page);
  await becomes(() => page.title(), /^Example R6/);
  await becomes(() => field(page, "base_radius").inputValue(), "2");
});

test("an edit for which the whole module is missing says so, and is done when that has come", async (t) => {
  const { page, whole } = await openWithoutWhole(t);
  await drawn(page);
  await law(page, 1).selectOption("double-harmonic");
  await verdict(page).getByText(en("banner.arriving")).waitFor();
  assert.equal(await level(page), "waiting", "nothing is wrong");
  whole.release();
  await verdict(page).getByText(en("banner.arriving")).waitFor({ state: "hidden" });
  await becomes(() => level(page), "unacceptable");
  await becomes(() => law(page, 1).inputValue(), "double-harmonic");
});

test("the whole module takes over what the first picture was drawn with", async (t) => {
  const { page, whole } = await openWithoutWhole(t);
  await drawn(page);
  whole.release();
  await eventually(() => page.locator("#verdict .cures button").count(), (count) => assert(count > 0, "no cure is offered"));
  await page.locator(".stage-layers summary").click();
  await page.getByRole("checkbox", { name: en("stage.layer.stations") }).check();
  const before = await picture(mechanism(page));
  await eventually(() => picture(mechanism(page)), (now) => assert.notDeepEqual(now, before, "the cam stands still"));
});
