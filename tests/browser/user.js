// What somebody does on the page and what they see there, in the words of the page itself.
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { root } from "./browser.js";
import { addStrings, createTranslate } from "../../web/strings/index.js";
import { openPage } from "./harness.js";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("playwright-core").Locator} Locator */
/** @typedef {"s" | "v" | "a" | "j" | "pressure_angle" | "rho" | "contact"} Diagram */

/** @typedef {(key: string, values?: Record<string, string | number>) => string} Words */

const strings = new URL("../../web/strings/", import.meta.url);

/** All that the page can say: every file of strings. @param {"en" | "es"} language @returns {Promise<Record<string, string>>} */
async function spoken(language) {
  const names = readdirSync(strings).filter((name) => name === `${language}.js` || name.endsWith(`.${language}.js`));
  const files = await Promise.all(names.map((name) => import(new URL(name, strings).href)));
  return Object.assign({}, ...files.flatMap((file) => Object.values(file)));
}
const all = { en: await spoken("en"), es: await spoken("es") };
addStrings(all);
export const en = words("en", all.en);
export const es = words("es", all.es);

/**
 * The page's own words, and no others: a key that is gone should not go unnoticed.
 * @param {"en" | "es"} language
 * @param {Record<string, unknown>} known
 * @returns {Words}
 */
function words(language, known) {
  const translate = createTranslate(() => language);
  return (key, values) => {
    assert(key in known, `the page has no words "${key}"`);
    return translate(key, values);
  };
}

/** How long something may take that happens at once on an idle machine, ms. */
const PATIENCE = 15_000;
const PAUSE = 20;

/** Published links: they open for ever. */
export const LINKS = {
  "2RO": "1.Example_2RO.A40_10_80_80S120_10D120S120-10.0MVlhp",
  "9RT": "1.Example_9RT.R35_7M50_10D40C50-10D40Q50_10D40S50-10D40.3Qwl0W",
  R1: "1.Example_R1.R.2_.01umw1sQm90_.1V90_.1Qm135-.2D45.3YHdVc",
  "10EX": "1.Example_10EX.F30H180_20H180-20.1IbBNh",
};

/**
 * The page with the cam standing still, as under reduced motion.
 * @param {import("node:test").TestContext} t
 * @param {Parameters<typeof openPage>[1]} [options]
 */
export async function openStill(t, options = {}) {
  return openPage(t, { reducedMotion: "reduce", ...options });
}

/**
 * Looks until the sight passes the check; fails with what the check said last.
 * @template Sight
 * @param {() => Promise<Sight>} look
 * @param {(sight: Sight) => void} check
 * @returns {Promise<Sight>}
 */
export async function eventually(look, check) {
  for (const end = performance.now() + PATIENCE; ; ) {
    try {
      const sight = await look();
      check(sight);
      return sight;
    } catch (error) {
      if (performance.now() > end) throw error;
    }
    await new Promise((resume) => setTimeout(resume, PAUSE));
  }
}

/**
 * @template Sight
 * @param {() => Promise<Sight>} look
 * @param {Sight | RegExp} expected
 */
export function becomes(look, expected) {
  return eventually(look, (sight) => {
    if (expected instanceof RegExp) assert.match(String(sight), expected);
    else assert.deepEqual(sight, expected);
  });
}

/** Lets the page draw so many frames. @param {Page} page @param {number} [count] */
export async function frames(page, count = 2) {
  await page.evaluate(async (count) => {
    for (let i = 0; i < count; i++) await new Promise(requestAnimationFrame);
  }, count);
}

/** The longest piece of a sentence that is the same whatever it tells of. @param {Words} say @param {string} key @param {string} gap */
export const fixedPart = (say, key, gap) => say(key, { [gap]: "\0" }).split("\0").reduce((long, part) => (part.length > long.length ? part : long)).trim();

/** A word or name of the page as part of a pattern. @param {string} text */
export const literal = (text) => text.replaceAll(/[.*+?^${}()|[\]\\]/g, "\\$&");

// Design

/** @param {Page} page @param {string} parameter key in the design file, or `speed` */
export const field = (page, parameter) => page.locator(`#field-${parameter}`);

/** @param {Page} page @param {number} number from 1 @param {Words} [say] */
export const law = (page, number, say = en) => page.getByLabel(say("segments.law.of", { number }), { exact: true });
/** @param {Page} page @param {number} number @param {Words} [say] */
export const beta = (page, number, say = en) => page.getByLabel(say("segments.beta.of", { number }), { exact: true });
/** @param {Page} page @param {number} number @param {Words} [say] */
export const rise = (page, number, say = en) => page.getByLabel(say("segments.rise.of", { number }), { exact: true });

/**
 * The program as it is read in the table.
 * @param {Page} page
 * @returns {Promise<string[]>} "law β L" of each segment
 */
export async function program(page) {
  const rows = page.getByRole("group", { name: en("design.program") }).getByRole("listitem");
  return rows.evaluateAll((items) =>
    items.map((item) => [...item.querySelectorAll("select, input")].slice(0, 3).map((control) => /** @type {HTMLInputElement} */ (control).value).join(" ")),
  );
}

/** @param {Page} page @param {number} number @param {string} action */
export async function actOnSegment(page, number, action) {
  await page.getByRole("button", { name: en("segments.actions", { number }), exact: true }).click();
  await page.getByRole("menuitem", { name: en(`action.${action}`), exact: true }).click();
}

/** @param {Page} page @param {string} id */
export async function openExample(page, id) {
  await page.getByRole("button", { name: en("header.examples"), exact: true }).click();
  await page.locator(`[data-example="${id}"]`).click();
}

/** The button that undoes, whatever the step is. @param {Page} page */
export const undo = (page) => page.locator('button[aria-keyshortcuts="Control+Z"]');
/** @param {Page} page */
export const redo = (page) => page.locator('button[aria-keyshortcuts="Control+Y"]');

// What is seen

/** @param {Page} page */
export const verdict = (page) => page.locator("#verdict");

/** acceptable, low-speed, unacceptable or stopped. @param {Page} page */
export const level = (page) => verdict(page).getAttribute("data-level");

/** @param {Page} page */
export const findings = (page) => verdict(page).getByRole("list").getByRole("listitem");

/** Unfolds the findings where there is no room for them at first. @param {Page} page */
export async function unfoldFindings(page) {
  const folded = verdict(page).locator('button[aria-expanded="false"]');
  if (await folded.isVisible()) await folded.click();
}

/** What is said to those who do not see it. @param {Page} page */
export const announced = (page) => page.locator("#announcer").textContent();

/** The smallest base radius that keeps the pressure angle, offered beside its finding. @param {Page} page */
export const baseRadiusCure = (page) => findings(page).getByRole("button", { name: /R\s?b ≥/ });

/** @param {Page} page @param {string} name */
export const readout = (page, name) => page.locator(`#readout-${name}`);

/** A shown number as a number. @param {string | null} text */
export function numberOf(text) {
  const plain = (text ?? "").replaceAll(/[\s\u202f]/g, "").replace("−", "-").replace(",", ".");
  const value = parseFloat(plain);
  assert(Number.isFinite(value), `"${text}" is no number`);
  return value;
}

/** @param {Page} page */
export const cursorField = (page) => page.getByRole("textbox", { name: en("transport.angle") });

/** @param {Page} page @param {string} theta */
export async function setCursor(page, theta) {
  await cursorField(page).fill(theta);
  await cursorField(page).press("Enter");
  await frames(page);
}

/** @param {Page} page */
export const cursor = async (page) => numberOf(await readout(page, "theta").textContent());

/** What went wrong, across the page. @param {Page} page */
export const banner = (page) => page.locator("#banner");

/** What comes after # in the address. @param {Page} page */
export const fragment = (page) => page.evaluate(() => location.hash.slice(1));

/**
 * The link once it has caught up with an edit: another one than `before`.
 * @param {Page} page
 * @param {string} before
 */
export const nextFragment = (page, before) => eventually(() => fragment(page), (now) => assert.notEqual(now, before, "the link did not change"));

/** What explains a field, as a screen reader finds it: the texts that are in sight. @param {Locator} control */
export function descriptions(control) {
  return control.evaluate((element) =>
    (element.getAttribute("aria-describedby") ?? "")
      .split(" ")
      .filter(Boolean)
      .map((id) => document.getElementById(id))
      .filter((node) => node?.checkVisibility())
      .map((node) => node?.textContent?.trim()),
  );
}

/** @param {Page} page */
export const mechanism = (page) => page.locator("#mechanism canvas");

/** @param {Page} page @param {Diagram} diagram @param {Words} [say] */
export function diagram(page, diagram, say = en) {
  const name = say(`diagram.name.${diagram}`);
  return page.locator("#diagrams").getByRole("img", { name: new RegExp(`^${literal(name)}\\b`, "i") });
}

/**
 * Where a canvas shows a colour of the page: how much of it, and in which columns at which heights.
 * @param {Locator} canvas
 * @param {string} token  name of the colour among the page's CSS variables, without --
 * @param {number} [near]  greatest difference in any channel
 */
export function inkOf(canvas, token, near = 40) {
  return canvas.evaluate(
    (element, { token, near }) => {
      const sheet = /** @type {HTMLCanvasElement} */ (element);
      const hex = getComputedStyle(document.documentElement).getPropertyValue(`--${token}`).trim().slice(1);
      const colour = [0, 2, 4].map((at) => parseInt(hex.slice(at, at + 2), 16));
      const { width, height } = sheet;
      const pixels = sheet.getContext("2d")?.getImageData(0, 0, width, height).data ?? new Uint8ClampedArray();
      /** @type {({ top: number, bottom: number } | null)[]} */
      const columns = Array(width).fill(null);
      let count = 0;
      for (let y = 0; y < height; y++) {
        for (let x = 0; x < width; x++) {
          const at = 4 * (y * width + x);
          if (pixels[at + 3] < 200 || colour.some((channel, i) => Math.abs(channel - pixels[at + i]) > near)) continue;
          count++;
          const column = columns[x];
          if (column) column.bottom = y;
          else columns[x] = { top: y, bottom: y };
        }
      }
      return { width, height, count, columns };
    },
    { token, near },
  );
}

/** The picture of a canvas as a number: another picture has another. @param {Locator} canvas */
export function picture(canvas) {
  return canvas.evaluate((element) => {
    const sheet = /** @type {HTMLCanvasElement} */ (element);
    const pixels = sheet.getContext("2d")?.getImageData(0, 0, sheet.width, sheet.height).data ?? new Uint8ClampedArray();
    let sum = 0;
    for (let i = 0; i < pixels.length; i++) sum = (sum * 31 + pixels[i]) | 0;
    return sum;
  });
}

// For everyone

const AXE = await readFile(path.join(root, "node_modules/axe-core/axe.min.js"), "utf8");

const RULES = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"];

/**
 * What axe finds in this state of the page.
 * @param {Page} page
 * @param {string} state
 */
export async function violations(page, state) {
  await frames(page, 3);
  if (!(await page.evaluate(() => "axe" in window))) await page.evaluate(AXE);
  return page.evaluate(async ({ RULES, state }) => {
    // Transitions of opacity would be measured half way.
    await Promise.all(document.getAnimations().map((animation) => animation.finished.catch(() => undefined)));
    const result = await /** @type {typeof window & { axe: typeof import("axe-core") }} */ (window).axe.run(document, { runOnly: RULES });
    return result.violations.flatMap(({ id, nodes }) => nodes.map(({ target, failureSummary }) => `${state}: ${id}: ${target} ${failureSummary?.split("\n")[1]?.trim()}`));
  }, { RULES, state });
}
