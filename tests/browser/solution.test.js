// The worked solution: opened from the header or with an example, it follows edits, language, θ and the cursor; it is copied and printed.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage } from "./harness.js";
import { LINKS, announced, becomes, en, es, eventually, field, violations } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

/** @param {Page} page @param {typeof en} [say] */
const open = (page, say = en) => page.getByRole("button", { name: say("header.solution"), exact: true }).click();
/** @param {Page} page */
const solution = (page) => page.locator("#solution .solution");
/** What is read, its italic letters as plain ones, without what only layout needs. @param {Page} page */
const text = async (page) => (await solution(page).innerText()).normalize("NFKC").replaceAll(/[\u2061-\u2064\s]+/g, "");
/** @param {Page} page @param {RegExp} wanted */
const says = (page, wanted) => eventually(() => text(page), (said) => assert.match(said, wanted));

test("the solution of R1 shows its figures as mathematics, and follows the design, the language and θ", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS.R1 });
  await open(page);
  await says(page, /v=−0\.18831m\/rad/);
  const spaces = await solution(page).locator("math").evaluateAll((all) => all.map(({ namespaceURI, localName }) => `${namespaceURI} ${localName}`));
  assert(spaces.length > 60 && spaces.every((name) => name === "http://www.w3.org/1998/Math/MathML math"), String(spaces.length));
  for (const figure of [/0\.6x30?/, /251\.18°/, /φ=−30\.37°/]) await says(page, figure);

  await page.getByLabel(en("solution.theta")).fill("200,5");
  await page.getByLabel(en("solution.theta")).press("Enter");
  await says(page, /Numbersputinatθ=200\.5°/);
  await page.getByLabel(en("solution.theta")).fill("2.0.0");
  await page.getByLabel(en("solution.theta")).press("Enter");
  await becomes(() => page.getByLabel(en("solution.theta")).getAttribute("aria-invalid"), "true");
  await says(page, /θ=200\.5°/);

  await field(page, "base_radius").fill("0.3");
  await says(page, /Rb=0\.3m/);
  await page.getByRole("button", { name: "ES", exact: true }).click();
  await says(page, /Sustituciónenθ=200,5°/);
  assert.equal(await page.getByLabel(es("solution.theta")).inputValue(), "200,5");
  await page.getByLabel(es("solution.segment")).selectOption("2");
  await eventually(() => text(page), (said) => assert(said.includes("Tramo3") && !said.includes("Tramo1"), said.slice(0, 200)));
});

test("θ follows the cursor when it is asked to, and the window gives the focus back", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["9RT"] });
  await open(page);
  await page.getByLabel(en("solution.follows")).check();
  await page.getByRole("slider").first().focus();
  await page.keyboard.press("ArrowRight");
  const cursor = await page.getByLabel(en("solution.theta")).inputValue();
  await eventually(() => page.getByLabel(en("solution.theta")).inputValue(), (value) => assert.notEqual(value, "0", cursor));
  await solution(page).focus();
  await page.keyboard.press("Escape");
  await page.locator("#solution").waitFor({ state: "hidden" });
  assert.equal(await page.evaluate(() => document.activeElement?.id), "solve");
});

test("beside it the cam, what moves it and the verdict stay in sight, and the diagrams come back with its end", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS.R1, viewport: { width: 1366, height: 768 } });
  const right = (/** @type {string} */ part) => page.locator(part).evaluate((element) => element.getBoundingClientRect().right);
  await open(page);
  await says(page, /Verdict/);
  const left = await page.locator("#solution").evaluate((element) => element.getBoundingClientRect().left);
  for (const part of ["#mechanism canvas", "#transport", "#verdict"]) await eventually(() => right(part), (edge) => assert(edge <= left + 1, `${part}: ${edge} of ${left}`));
  const sharp = () => page.locator("#mechanism canvas").evaluate((canvas) => canvas instanceof HTMLCanvasElement && canvas.width === canvas.getBoundingClientRect().width * devicePixelRatio);
  await becomes(sharp, true);
  assert.equal(await page.locator("#diagrams").isVisible(), false);
  await page.keyboard.press("Escape");
  await becomes(() => page.locator("#diagrams").isVisible(), true);
  await eventually(() => right("#mechanism canvas"), (edge) => assert(edge > left, String(edge)));
});

test("on a tablet the cam stays in sight beside it, and Escape ends it from there too", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS.R1, viewport: { width: 1024, height: 768 } });
  const edge = (/** @type {string} */ part, /** @type {"left" | "right"} */ side) => page.locator(part).evaluate((element, side) => element.getBoundingClientRect()[side], side);
  await open(page);
  await says(page, /Verdict/);
  const left = await edge("#solution", "left");
  for (const part of ["#mechanism canvas", "#transport", "#verdict"]) await eventually(() => edge(part, "right"), (right) => assert(right > 300 && right <= left + 1, `${part}: ${right} of ${left}`));
  assert.equal(await page.locator("#design").isVisible(), false);
  assert.equal(await page.evaluate(() => document.documentElement.scrollHeight), 768);
  await page.locator("#mechanism canvas").focus();
  await page.keyboard.press("Escape");
  await becomes(() => page.locator("#design").isVisible(), true);
});

test("it is copied as LaTeX and as Markdown, and printed alone on its paper", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS.R1, permissions: ["clipboard-read", "clipboard-write"] });
  await open(page);
  await says(page, /Verdict/);
  const copied = () => page.evaluate(() => navigator.clipboard.readText());
  await page.getByRole("button", { name: en("solution.latex") }).click();
  await becomes(() => announced(page), en("solution.copied", { what: "LaTeX" }));
  assert.match(await copied(), /^\\documentclass[\s\S]*c_\{0\} = 0\.2[\s\S]*\\end\{document\}\n$/);
  await page.getByRole("button", { name: en("solution.markdown") }).click();
  await becomes(copied, /^# Worked solution: Example R1/);
  const paper = page.evaluate(() => {
    return new Promise((resolve) => {
      window.print = () => {
        dispatchEvent(new Event("beforeprint"));
        resolve([...document.body.children].filter((child) => child.matches(".on-paper, .report")).map(({ className }) => className));
        dispatchEvent(new Event("afterprint"));
      };
    });
  });
  await page.getByRole("button", { name: en("solution.print") }).click();
  assert.deepEqual(await paper, ["solution on-paper"]);
  assert.equal(await page.locator(".on-paper").count(), 0, "and nothing of it is left");
});

test("a solved example opens with its solution", async (t) => {
  const { page } = await openPage(t);
  await page.getByRole("button", { name: en("header.examples") }).click();
  await page.locator('[data-solution="R6"]').click();
  await says(page, /c3=612\.72,c4=−4057\.26,c5=10696\.57/);
  assert.equal(await page.evaluate(() => document.querySelector(".gallery")?.hasAttribute("open")), false);
});

test("axe finds nothing in it, light or dark, and on a phone nothing is wider than the screen", async (t) => {
  /** @type {string[]} */
  const found = [];
  const { page } = await openPage(t, { fragment: LINKS.R1 });
  await open(page);
  await says(page, /Verdict/);
  found.push(...(await violations(page, "solution")));
  const phone = await openPage(t, { fragment: LINKS.R1, viewport: { width: 390, height: 844 }, colorScheme: "dark", locale: "es-ES" });
  await open(phone.page, es);
  await says(phone.page, /Veredicto/);
  found.push(...(await violations(phone.page, "solution on a phone")));
  const widths = await solution(phone.page).evaluate((root) => [root.scrollWidth, root.clientWidth]);
  assert.equal(widths[0], widths[1]);
  const wide = await solution(phone.page).locator(".formula").evaluateAll((all) => all.filter((one) => one.scrollWidth > one.clientWidth).map((one) => one.getAttribute("tabindex")));
  assert(wide.length > 3 && wide.every((tabindex) => tabindex === "0"), String(wide));
  assert.deepEqual(found, []);
});
