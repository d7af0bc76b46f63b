// The picture that is in the packed page: it is that of the living page, gives way to it without a jump, and is never another's.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { drawn, root } from "./browser.js";
import { openPage } from "./harness.js";
import { LINKS, en, es, eventually, fragment, frames } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("playwright-core").BrowserContextOptions} ContextOptions */

const SIZES = /** @type {[number, number][]} */ ([[1366, 768], [1920, 1080], [1024, 768], [390, 844]]);

/** What the page may shift when it comes to life, and what its HTML may weigh, gzip. */
const SHIFT = 0.02;
const HTML_WEIGHT = 13_000;

/** Cams that a course page links to. */
const OTHERS = {
  R1: LINKS.R1,
  "8DA": "1.Example_8DA.F100kd225Hd180_25Hd180-25.054lzz",
  GROOVE: "1.Grooved_cam.R45_8gS110_16D70S110-16D70.2tdy94",
  R6: "1.Example_R6.R2_1uiw12.566op_30_.75p0p56.88_110.27p123.84_79.35p198.72_106.71p256.32N256.32s0v0a0s56.88_1.177s123.84_.847s198.72_1.139s256.32v256.32a256.32D103.68.0WiuYM",
};

/** Keeps the page from coming to life until it is let. */
function gate() {
  /** @type {() => void} */
  let open = () => {};
  const opened = new Promise((resolve) => (open = () => resolve(undefined)));
  /** @param {Page} page */
  const hold = (page) => page.route(/\.(wasm|js)$/, async (route) => {
    if (!route.request().url().endsWith("early.js")) await opened;
    await route.continue();
  });
  return { open, hold };
}

/**
 * The page before and after it came to life: `look` is asked both times.
 * @template Sight
 * @param {import("node:test").TestContext} t
 * @param {(page: Page) => Promise<Sight>} look
 * @param {ContextOptions & { fragment?: string }} [options]
 */
async function bothTimes(t, look, options) {
  const { open, hold } = gate();
  const { page } = await openPage(t, { reducedMotion: "reduce", ready: false, prepare: hold, until: "commit", ...options });
  await page.locator("#verdict").waitFor();
  await frames(page, 2);
  const before = await look(page);
  open();
  await drawn(page);
  await frames(page, 3);
  return { page, before, after: await look(page) };
}

/** Where the parts of the page lie. @param {Page} page */
const places = (page) => page.evaluate(() => {
  const parts = ["#header", "#header .end", "#design", "#design .segments-head", "#mechanism", ".stage-frame", "#transport", ".transport-scrub", "#diagrams", ".diagram-plots", ".diagram-s", ".diagram-j", "#readouts", "#verdict", ".headline"];
  return parts.map((part) => {
    const { x = NaN, y = NaN, width = NaN, height = NaN } = document.querySelector(part)?.getBoundingClientRect() ?? {};
    return `${part} ${[x, y, width, height].map((value) => Math.round(10 * value) / 10).join(" ")}`;
  });
});

/** Pictures of mechanism and diagrams, as data addresses. @param {Page} page */
async function pictures(page) {
  await page.locator(".diagram-plots").scrollIntoViewIfNeeded();
  const taken = [];
  for (const part of [".stage-frame", ".diagram-plots"]) taken.push(`data:image/png;base64,${(await page.locator(part).screenshot()).toString("base64")}`);
  await page.evaluate(() => scrollTo(0, 0));
  return taken;
}

/**
 * How much of the ink of one picture has ink within a pixel of it in the other, and the other way round.
 * @param {Page} page
 * @param {string} one
 * @param {string} other
 */
const overlap = (page, one, other) => page.evaluate(async (addresses) => {
  const inks = await Promise.all(addresses.map(async (address) => {
    const image = Object.assign(new Image(), { src: address });
    await image.decode();
    const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
    context.drawImage(image, 0, 0);
    const { data, width, height } = context.getImageData(0, 0, image.width, image.height);
    const at = (/** @type {number} */ pixel) => (data[4 * pixel] ?? 0) + (data[4 * pixel + 1] ?? 0) + (data[4 * pixel + 2] ?? 0);
    return { width, height, ink: Array.from({ length: width * height }, (_, pixel) => Math.abs(at(pixel) - at(0)) > 150) };
  }));
  /** @param {number} from @param {number} to */
  const met = (from, to) => {
    const { width, ink } = /** @type {typeof inks[0]} */ (inks[from]);
    const near = /** @type {typeof inks[0]} */ (inks[to]).ink;
    let [all, found] = [0, 0];
    ink.forEach((inked, pixel) => {
      if (!inked) return;
      all++;
      if ([-1, 0, 1].some((dy) => [-1, 0, 1].some((dx) => near[pixel + dy * width + dx]))) found++;
    });
    return found / all;
  };
  return { there: met(0, 1), back: met(1, 0) };
}, [one, other]);

for (const [width, height] of SIZES) {
  for (const [locale, colorScheme] of /** @type {const} */ ([["en-GB", "light"], ["es-ES", "dark"]])) {
    test(`cam, curves and frame of the first picture lie where the living page draws them (${width}×${height}, ${locale}, ${colorScheme})`, async (t) => {
      const screen = { viewport: { width, height }, locale, colorScheme };
      const { page, before, after } = await bothTimes(t, async (page) => ({ places: await places(page), pictures: await pictures(page) }), screen);
      assert.deepEqual(before.places, after.places);
      for (const [at, part] of ["mechanism", "diagrams"].entries()) {
        const { there, back } = await overlap(page, before.pictures[at] ?? "", after.pictures[at] ?? "");
        assert(there > 0.97, `${part}: ${there} of the first picture is in the living one`);
        // The scale of the mechanism and the angle at its normal come with the living page; on a phone it lies over the diagrams.
        assert(back > 0.8, `${part}: ${back} of the living picture was in the first`);
      }
    });
  }

  test(`nothing shifts when the page comes to life and offers its guided minute (${width}×${height})`, async (t) => {
    const { page } = await openPage(t, { viewport: { width, height }, reducedMotion: "reduce", firstVisit: true, prepare: (page) => page.addInitScript(noteShifts) });
    await page.locator(".offer").waitFor();
    await frames(page, 10);
    const shifts = await page.evaluate(() => /** @type {{ shifts: number[] }} */ (/** @type {unknown} */ (window)).shifts);
    assert(shifts.reduce((sum, shift) => sum + shift, 0) <= SHIFT, `${shifts}`);
  });
}

/** Notes every layout shift. */
function noteShifts() {
  /** @type {number[]} */
  const shifts = [];
  Object.assign(window, { shifts });
  new PerformanceObserver((list) => {
    for (const entry of list.getEntries()) shifts.push(/** @type {PerformanceEntry & { value: number }} */ (entry).value);
  }).observe({ type: "layout-shift", buffered: true });
}

test("the first paint takes the HTML, the style sheet and one small script", async (t) => {
  const { open, hold } = gate();
  const { page } = await openPage(t, { ready: false, prepare: hold, until: "commit" });
  await eventually(() => page.evaluate(() => performance.getEntriesByName("first-contentful-paint").length), (paints) => assert.equal(paints, 1));
  assert.equal(await page.locator(".poster-cam").isVisible(), true);
  open();
  await drawn(page);
});

test("the module is asked for above the style sheet, and the HTML stays light", async (t) => {
  const { url } = await openPage(t);
  const html = await (await fetch(url)).text();
  const hints = [...html.matchAll(/<link rel="(?:modulepreload|preload)" href="([^"]*)"/g)];
  assert.deepEqual(hints.map(([, file = ""]) => path.basename(file)).sort(), ["levalab_wasm.js", "levalab_wasm_bg.wasm"]);
  for (const { index } of hints) assert(index < html.indexOf('rel="stylesheet"'));
  const weight = gzipSync(html, { level: 9 }).length;
  assert(weight < HTML_WEIGHT, `${weight} bytes`);
  assert(!/ style=|<style/.test(html), "the policy forbids styles in the HTML");
});

for (const [locale, language, say] of /** @type {const} */ ([["en-GB", "en", en], ["es-ES", "es", es]])) {
  test(`before it lives, the picture is read as a sentence and a judgement in the page's language, without controls; then it is gone (${language})`, async (t) => {
    const { page, before, after } = await bothTimes(t, heard, { locale });
    assert.equal(await page.evaluate(() => document.documentElement.lang), language);
    assert(before.text.some((text) => text.includes(language === "en" ? "drawn to scale" : "a escala")), before.text.join("|"));
    assert(before.text.some((text) => text.includes(language === "en" ? "Not for high speeds" : "No apta para altas velocidades")), before.text.join("|"));
    assert(!before.text.some((text) => text.includes(language === "en" ? "No apta" : "Not for")), "the other language is heard");
    assert.deepEqual(before.controls, []);
    assert(after.controls.includes(say("header.examples")), after.controls.join("|"));
    const left = await page.evaluate(() => document.querySelectorAll('[data-poster], .in-en, .in-es, [class*="poster"], [data-other]').length);
    assert.equal(left, 0);
    assert.equal(await page.evaluate(() => [...document.querySelectorAll("[id]")].map(({ id }) => id).filter((id, at, all) => all.indexOf(id) !== at).length), 0);
  });
}

/** What a reader of the screen finds. @param {Page} page */
async function heard(page) {
  const devtools = await page.context().newCDPSession(page);
  const { nodes } = await devtools.send("Accessibility.getFullAXTree");
  const of = (/** @type {(role: string) => boolean} */ wanted) => nodes.filter(({ ignored, role }) => !ignored && wanted(String(role?.value))).map(({ name }) => String(name?.value));
  return { text: of((role) => role === "StaticText"), controls: of((role) => ["button", "textbox", "combobox", "slider", "radio", "checkbox"].includes(role)) };
}

test("a page that arrives in two halves shows its sections when all of them are there", async (t) => {
  const { url } = await openPage(t);
  const html = await (await fetch(url)).text();
  const { page } = await openPage(t, { ready: false, until: "commit", prepare: (page) => halves(page, url, html) });
  await page.locator("#diagrams").waitFor({ state: "attached" });
  assert.equal(await page.locator("h1").isVisible(), true);
  assert.equal(await page.locator(".poster-cam").isVisible(), false);
  await page.evaluate(() => document.body.append(Object.assign(document.createElement("div"), { id: "announcer" })));
  assert.equal(await page.locator(".poster-cam").isVisible(), true);
});

/**
 * Serves the page without what comes after its diagrams.
 * @param {Page} page
 * @param {string} url
 * @param {string} html
 */
async function halves(page, url, html) {
  const half = html.slice(0, html.indexOf('<section id="readouts"')).replace(/<script type="module"[^>]*><\/script>/, "");
  await page.route(url, (route) => route.fulfill({ contentType: "text/html", body: half }));
}

test("without JavaScript the picture stays", async (t) => {
  const { page } = await openPage(t, { javaScriptEnabled: false, ready: false });
  assert.equal(await page.locator(".poster-cam").isVisible(), true);
  assert.equal(await page.locator(".headline").isVisible(), true);
  assert.equal(await page.locator(".in-es").first().isVisible(), false);
});

/** Notes in every frame, before it is painted, what is seen of the first picture, and every title. */
function watchFrames() {
  /** @type {{ frames: number, seen: Set<string>, titles: Set<string> }} */
  const watched = { frames: 0, seen: new Set(), titles: new Set() };
  Object.assign(window, { watched });
  const shown = (/** @type {Element} */ element) => element.checkVisibility({ visibilityProperty: true });
  requestAnimationFrame(function look() {
    if (document.body) watched.frames++;
    for (const part of [".poster-cam", ".poster-plot > svg", ".diagram figcaption[data-poster]", "#design > [data-poster] input", "#transport > [data-poster] .transport-ticks", "#readouts > [data-poster] output", "#verdict > [data-poster] .saying"]) {
      for (const element of document.querySelectorAll(part)) if (shown(element)) watched.seen.add(part);
    }
    for (const title of document.querySelectorAll("#header .title")) if (title instanceof HTMLInputElement && shown(title)) watched.titles.add(title.value);
    requestAnimationFrame(look);
  });
}

/** @param {Page} page */
const watched = (page) => page.evaluate(() => {
  const { frames, seen, titles } = /** @type {{ watched: { frames: number, seen: Set<string>, titles: Set<string> } }} */ (/** @type {unknown} */ (window)).watched;
  return { frames, seen: [...seen], titles: [...titles] };
});

/**
 * Opens the page slowly, with every frame watched; gives what was seen.
 * @param {import("node:test").TestContext} t
 * @param {{ fragment?: string, kept?: Record<string, unknown>, ours?: Record<string, unknown> } & ContextOptions} [options]
 *   what the browser and this tab have kept
 */
async function watchOpening(t, { fragment = "", kept = {}, ours = {}, ...options } = {}) {
  const { open, hold } = gate();
  const { page } = await openPage(t, {
    fragment, ready: false, until: "commit", ...options,
    async prepare(page) {
      await hold(page);
      await page.addInitScript(watchFrames);
      await page.addInitScript(([kept, ours]) => {
        for (const [name, value] of Object.entries(kept)) localStorage.setItem(`levalab:${name}`, JSON.stringify(value));
        for (const [name, value] of Object.entries(ours)) sessionStorage.setItem(`levalab:${name}`, JSON.stringify(value));
      }, /** @type {const} */ ([kept, ours]));
    },
  });
  await page.locator("#verdict").waitFor({ state: "attached" });
  await frames(page, 5);
  const waiting = await page.evaluate(() => ({
    other: document.documentElement.hasAttribute("data-other"),
    axes: [...document.querySelectorAll(".poster-plot")].filter((plot) => getComputedStyle(plot, "::before").borderInlineStartStyle === "solid" && plot.getBoundingClientRect().height > 40).length,
    name: document.querySelector("h1")?.checkVisibility({ visibilityProperty: true }),
  }));
  open();
  await drawn(page);
  await frames(page, 5);
  return { page, waiting, ...(await watched(page)) };
}

const R1 = JSON.parse(await readFile(path.join(root, "examples/R1.lev.json"), "utf8"));
const NOTHING = /** @type {string[]} */ ([]);

/** @type {[why: string, options: Parameters<typeof watchOpening>[1]][]} */
const ELSEWHERE = [
  ...Object.entries(OTHERS).map(([id, link]) => /** @type {[string, { fragment: string }]} */ ([`a link to ${id}`, { fragment: link }])),
  ["a damaged link", { fragment: "1.Nothing.R" }],
  ["a design that was kept", { kept: { design: R1 } }],
  ["a design that this tab kept", { ours: { design: { design: R1, fragment: "" } } }],
  ["a design that this tab kept under the address of the first", { fragment: LINKS["9RT"], ours: { design: { design: R1, fragment: LINKS["9RT"] } } }],
  ["another tab of the diagrams", { kept: { view: { tab: "rho" } } }],
  ["derivatives by time", { kept: { view: { perSecond: true } } }],
  ["other layers", { kept: { view: { layers: { base: false, prime: true, pitch: true, axes: true, normal: true, osculating: true, stations: false } } } }],
];

for (const [why, options] of ELSEWHERE) {
  test(`of the first design no frame is seen on the way to ${why}`, async (t) => {
    const { waiting, seen, titles, frames } = await watchOpening(t, options);
    assert.deepEqual(seen, NOTHING);
    assert(frames > 5, `${frames} frames`);
    // The frame of the page stands there, with empty axes.
    assert.deepEqual(waiting, { other: true, axes: 4, name: true });
    assert.equal(titles.length, 1, titles.join("|"));
  });
}

test("the first picture is seen by somebody who comes back to the first design, whatever the language", async (t) => {
  // The worker would answer for the scripts that are held.
  const { page } = await openPage(t, { locale: "es-ES", serviceWorkers: "block" });
  await eventually(() => fragment(page), (link) => assert.match(link, /^1\.Ejemplo_9RT\./));
  const { open, hold } = gate();
  await hold(page);
  for (const again of ["the same address", "the bare one"]) {
    if (again === "the bare one") await page.evaluate(() => history.replaceState(null, "", location.pathname));
    await page.reload({ waitUntil: "commit" });
    await page.locator(".poster-cam").waitFor();
    assert.equal(await page.locator(".title:visible").inputValue(), "Ejemplo 9RT", again);
  }
  open();
  await drawn(page);
});

test("the cam begins to turn from the pose of the first picture", async (t) => {
  const { page } = await openPage(t, { prepare: (page) => page.addInitScript(noteCursors) });
  await eventually(() => page.evaluate(() => /** @type {{ angles: string[] }} */ (/** @type {unknown} */ (window)).angles.length), (count) => assert(count > 3));
  const [first = "", second = ""] = await page.evaluate(() => /** @type {{ angles: string[] }} */ (/** @type {unknown} */ (window)).angles);
  assert.equal(Number.parseFloat(first), 0);
  assert(Number.parseFloat(second) < 45, `${first}, ${second}`);
});

/** Notes each angle that the living page shows. */
function noteCursors() {
  /** @type {string[]} */
  const angles = [];
  Object.assign(window, { angles });
  requestAnimationFrame(function look() {
    const shown = document.querySelector("#readout-theta")?.textContent;
    if (shown && angles.at(-1) !== shown) angles.push(shown);
    requestAnimationFrame(look);
  });
}
