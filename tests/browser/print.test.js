// The report on paper: how many pages, what stands on them, and that it is drawn in lines.
import assert from "node:assert/strict";
import { test } from "node:test";
import { LINKS, en, es, openStill } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

/**
 * Asks for the report and prints it.
 * @param {Page} page
 * @param {typeof en} say
 * @param {string} step
 */
async function printed(page, say, step) {
  await page.keyboard.press("Control+p");
  const dialog = page.locator(".export-dialog[open]");
  await dialog.waitFor();
  await page.evaluate(() => {
    Object.assign(globalThis, { print: () => Object.assign(globalThis, { asked: true }) });
    // What stands there while the browser prints: the page has been told before us.
    addEventListener("beforeprint", () => {
      const report = document.querySelector(".report");
      const drawings = [...(report?.querySelectorAll("svg") ?? [])].map((svg) => svg.getAttribute("width"));
      Object.assign(globalThis, { report: { text: report?.textContent ?? "", drawings, pictures: report?.querySelectorAll("img, canvas").length } });
    });
  });
  await dialog.locator("select").selectOption(step);
  await dialog.getByRole("button", { name: say("print.go") }).click();
  await page.waitForFunction(() => "asked" in globalThis);
  const pdf = (await page.pdf({ preferCSSPageSize: true })).toString("latin1");
  const shown = await page.evaluate(() => Reflect.get(globalThis, "report"));
  assert.equal(await page.locator(".report").count(), 0, "the report stays after printing");
  return { ...shown, pages: pdf.match(/\/Type\s*\/Page\b/g)?.length, bitmaps: pdf.match(/\/Subtype\s*\/Image\b/g)?.length ?? 0, boxes: pdf.match(/\/MediaBox\s*\[[^\]]*\]/g) };
}

/** @type {[keyof typeof LINKS, typeof en, string, string, RegExp[]][]} */
const CASES = [
  ["9RT", es, "es-ES", "10", [/Radio base Rb35\u00a0mm/, /Escala 1:1/, /100 mm: compruébelos/, /No apta para altas velocidades/, /→ Con la ley/, /350°/]],
  ["9RT", en, "en-GB", "5", [/Base radius Rb35\u00a0mm/, /Scale 1:1/, /Not for high speeds/, /355°/]],
  ["2RO", es, "es-ES", "0", [/Brazo A80\u00a0mm/, /Escala 1:1/, /Aceptable/]],
  ["R1", en, "en-GB", "10", [/0\.2\u00a0m/, /Scale 1:5/, /The pressure angle reaches/]],
];

for (const [name, say, locale, step, texts] of CASES) {
  test(`${name} in ${locale} fits on one to three pages, all lines`, async (t) => {
    const { page } = await openStill(t, { fragment: LINKS[name], locale });
    const { text, drawings, pictures, pages, bitmaps, boxes } = await printed(page, say, step);
    for (const expected of texts) assert.match(text, expected);
    assert.equal(pages, step === "0" ? 2 : 3);
    assert.deepEqual([pictures, bitmaps], [0, 0], "something is drawn in pixels");
    assert.equal(drawings.length, 7, "the cam and six diagrams");
    assert.match(drawings[0], /mm$/, "the cam is not to scale");
    for (const box of boxes) assert.match(box, /\[0 0 59[45][.\d]* 84[12][.\d]*\]/, "not A4");
  });
}

test("the report prints from the projector view as well", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await page.getByRole("button", { name: en("header.projector") }).click();
  const { pages, text } = await printed(page, en, "10");
  assert.equal(pages, 3);
  assert.match(text, /Scale 1:1/);
});
