// The report on paper: how many pages, what stands on them, and that it is drawn in lines.
import assert from "node:assert/strict";
import { test } from "node:test";
import { LINKS, en, es, eventually, openStill } from "./user.js";

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

const MORE = {
  R6: "1.Example_R6.R2_1uiw12.566op_30_.75p0p56.88_110.282p123.84_79.338p198.72_106.667p256.32N256.32s0v0a0s56.88_1.177168358s123.84_.84686697s198.72_1.138581249s256.32v256.32a256.32D103.68.0yVAoK",
  pair: "1.7CRT.R170_10kd380_10S36_20S36-20S36_20S36-20S36_20S36-20S36_20S36-20S36_20S36-20.11DfvS",
  wedge: "1.Wedge.R0_8w50t150C60_20D30C60-12.197YKJ",
  breadth: "1.harmonic_flat.F40b100h.4ThtCJ",
  many: `1.Sixty-0jfour.R200_5${"S5.625_2S5.625-2".repeat(32)}.2hzuE1`,
};

/** Those that need more room, or other words: what they must say, and how many drawings they have. @type {[keyof typeof MORE, typeof en, string, string, RegExp[], number][]} */
const FULL = [
  ["R6", es, "es-ES", "5", [/Fuerza de un pistón sobre fluido encerrado/, /Rigidez K = 93,68\slbf\/in/, /fuerza \(lbf\): de 0\slbf/, /110,282110,282/], 9],
  ["pair", en, "en-GB", "5", [/Cam 1Cam 2/, /s₂ displacement \(mm\)/, /ρ₂ radius of curvature/, /s₂ \(mm\)φ₂ \(°\)ρ₂ \(mm\)x₂ \(mm\)/], 13],
  ["wedge", es, "es-ES", "10", [/LevaTraslación \(cuña\)/, /Velocidad50\smm\/sφ/, /perfilx \(mm\)s \(mm\)/, /v velocidad(?! \()/, /sobreaceleración \(1\/mm²\)/], 7],
  ["breadth", en, "en-GB", "10", [/1Simple harmonic0°120°20/, /4Dwell300°60°/], 7],
  ["many", en, "en-GB", "5", [/644-5-6-7 polynomial354\.375°5\.625°−2/], 7],
];

for (const [name, say, locale, step, texts, count] of FULL) {
  test(`${name} in ${locale}: all that belongs to it stands on three pages`, async (t) => {
    const { page } = await openStill(t, { fragment: MORE[name], locale });
    const { text, drawings, pictures, pages } = await printed(page, say, step);
    for (const expected of texts) assert.match(text, expected);
    assert.deepEqual([pages, drawings.length, pictures], [3, count, 0]);
  });
}

test("the browser's own print gives the report, though nothing was asked for before", async (t) => {
  const { page } = await openStill(t, { fragment: MORE.R6 });
  await page.evaluate(() => addEventListener("afterprint", () => Object.assign(globalThis, { seen: [...document.querySelectorAll(".report")].map((report) => report.textContent) })));
  await eventually(
    async () => {
      await page.pdf({ preferCSSPageSize: true });
      return page.evaluate(() => String(Reflect.get(globalThis, "seen")));
    },
    (seen) => assert.match(seen, /Program.*Verdict.*Force of a piston on enclosed fluid.*Motion/s),
  );
});

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
