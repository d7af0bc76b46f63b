// The page in a frame of a course page, served from another site, under several sandboxes.
import assert from "node:assert/strict";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, test } from "node:test";
import { launchBrowser, launchWithoutStorage, startDist } from "./browser.js";
import { startSite } from "./site.js";
import { LINKS, becomes, cursor, en, es, eventually, field, frames, level, picture } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("playwright-core").Frame} Frame */

/** `user.js` looks into pages; a frame can be asked for the same things. @param {Frame} frame */
const inside = (frame) => /** @type {Page} */ (/** @type {unknown} */ (frame));

/** The frame in the course page, and what lies above and below it, CSS pixels. */
const FRAME = { width: 900, height: 560, above: 120, below: 3000 };

/** Complaints of the browser that a frame brings about, and which the page cannot prevent. */
const EXPECTED = /blocked by CORS policy|Failed to load resource|Permissions policy violation: The Clipboard API/;

/** @type {Promise<Awaited<ReturnType<typeof startDist>>> | undefined} */
let sharedSite;
/** @type {ReturnType<typeof launchBrowser> | undefined} */
let browser;
after(async () => {
  await (await browser)?.close();
  (await sharedSite)?.close();
});

/** Counts what is drawn on canvases, by the class of the canvas. */
function countDrawing() {
  /** @type {Record<string, number>} */
  const counts = {};
  Object.assign(globalThis, { drawing: counts });
  for (const name of /** @type {const} */ (["stroke", "fill", "fillRect", "fillText", "clearRect"])) {
    const { prototype } = CanvasRenderingContext2D;
    const draw = /** @type {(...given: unknown[]) => void} */ (prototype[name]);
    Object.assign(prototype, {
      /** @this {CanvasRenderingContext2D} @param {...unknown} given */
      [name](...given) {
        counts[this.canvas.className] = (counts[this.canvas.className] ?? 0) + 1;
        return draw.apply(this, given);
      },
    });
  }
}

/**
 * What was drawn on each kind of canvas within some time.
 * @param {Page | Frame} where
 * @param {() => Promise<unknown>} meanwhile
 */
async function drawnDuring(where, meanwhile) {
  const counts = () => where.evaluate(() => ({ .../** @type {Record<string, number>} */ (Reflect.get(globalThis, "drawing")) }));
  const before = await counts();
  await meanwhile();
  const now = await counts();
  const of = (/** @type {string} */ name) => (now[name] ?? 0) - (before[name] ?? 0);
  return { mechanism: of("stage-canvas"), diagrams: of("diagram-canvas"), cursor: of("diagram-overlay") };
}

/** @param {number} ms */
const pause = (ms) => new Promise((resume) => setTimeout(resume, ms));

/**
 * A course page with the page in a frame of it.
 * @param {import("node:test").TestContext} t
 * @param {object} [given]
 * @param {string} [given.sandbox]
 * @param {string} [given.file]
 * @param {string} [given.fragment]
 * @param {import("playwright-core").BrowserContextOptions} [given.options]
 * @param {{ width: number, height: number }} [given.size]
 * @param {boolean} [given.storage]  false: the browser keeps nothing for anybody
 * @param {boolean} [given.sameOrigin]  the course's own server has the page
 */
async function course(t, { sandbox, file = "", fragment = "", options = {}, size = FRAME, storage = true, sameOrigin = false } = {}) {
  const folder = await mkdtemp(path.join(tmpdir(), "levalab-course-"));
  const own = sameOrigin ? await startDist({ "/course/": folder }) : undefined;
  const { url } = own ?? (await (sharedSite ??= startDist()));
  const allowed = sandbox === undefined ? "" : ` sandbox="${sandbox}"`;
  const frameTag = `<iframe title="cam" src="${url}${file}${fragment && `#${fragment}`}" width="${size.width}" height="${size.height}" style="border: 0; display: block"${allowed}></iframe>`;
  const html = `<!doctype html><meta name="viewport" content="width=device-width"><title>Course</title><body style="margin: 0"><h1 style="margin: 0; height: ${FRAME.above}px">Cams</h1>${frameTag}<div style="height: ${FRAME.below}px"></div>`;
  await writeFile(path.join(folder, "index.html"), html);
  const site = own ?? (await startSite({ "/course/": folder }));
  /** @satisfies {import("playwright-core").BrowserContextOptions} */
  const usual = { viewport: { width: 1000, height: 720 }, locale: "en-GB", reducedMotion: /** @type {const} */ ("reduce"), ...options };
  const context = storage ? await (await (browser ??= launchBrowser())).newContext(usual) : await launchWithoutStorage(t, usual);
  await context.addInitScript(countDrawing);
  const page = await context.newPage();
  /** @type {string[]} */
  const complaints = [];
  page.on("pageerror", (error) => complaints.push(`uncaught: ${error.message}`));
  page.on("console", (message) => {
    if (message.type() === "error" && !EXPECTED.test(message.text())) complaints.push(`console: ${message.text()}`);
  });
  t.after(async () => {
    await context.close();
    site.close();
    await rm(folder, { recursive: true });
    assert.deepEqual(complaints, [], "the page misbehaved");
  });
  // By another name of this machine it is another site, and not only another origin.
  await page.goto(`${own ? own.origin : site.origin.replace("127.0.0.1", "localhost")}/course/`);
  const frame = await eventually(async () => page.frames()[1], (found) => assert(found?.url().startsWith(url)));
  return { page, frame: /** @type {Frame} */ (frame), url };
}

/** Waits for the first complete drawing. @param {Frame} frame */
const drawn = (frame) => frame.waitForFunction(() => performance.getEntriesByName("levalab:drawn").length > 0);

/** Puts the pointer over the middle of something in the frame. @param {Page} page @param {Frame} frame @param {string} selector */
async function pointAt(page, frame, selector) {
  const box = await frame.locator(selector).boundingBox();
  assert(box);
  const at = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  await page.mouse.move(at.x, at.y);
  return at;
}

/** How far the course page is scrolled. @param {Page} page */
const scrolled = (page) => page.evaluate(() => scrollY);

/** @param {Page} page @param {number} by */
async function wheel(page, by) {
  await page.mouse.wheel(0, by);
  // A wheel that scrolls does so a little later.
  await pause(300);
}

test("the wheel over the mechanism scrolls the course page, with Ctrl or after a click it zooms", async (t) => {
  const { page, frame } = await course(t, { size: { width: 1366, height: 700 }, options: { viewport: { width: 1400, height: 860 } } });
  await drawn(frame);
  const canvas = frame.locator(".stage-canvas");
  const hint = frame.locator("#mechanism .gesture-hint");
  const place = await canvas.boundingBox();
  await pointAt(page, frame, ".stage-canvas");
  const before = await picture(canvas);
  await wheel(page, 100);
  await eventually(() => scrolled(page), (far) => assert(far > 50, `${far} pixels`));
  assert.equal(await picture(canvas), before, "the picture has not zoomed");
  assert.equal(await hint.textContent(), en("stage.hint.wheel"));
  await becomes(() => hint.isVisible(), true);
  await page.evaluate(() => scrollTo(0, 0));
  assert.deepEqual(await canvas.boundingBox(), place, "the hint moves nothing");
  await becomes(() => hint.isVisible(), false);

  await page.keyboard.down("Control");
  await wheel(page, -100);
  await page.keyboard.up("Control");
  assert.equal(await scrolled(page), 0);
  const zoomed = await picture(canvas);
  assert.notEqual(zoomed, before);

  const at = await pointAt(page, frame, ".stage-canvas");
  await page.mouse.click(at.x + 5, place ? place.y + 20 : at.y);
  await wheel(page, -100);
  assert.equal(await scrolled(page), 0);
  assert.notEqual(await picture(canvas), zoomed, "clicked, it zooms");

  // The course page is clicked: the wheel is its own again.
  await page.mouse.click(20, 20);
  await pointAt(page, frame, ".stage-canvas");
  const left = await picture(canvas);
  await wheel(page, 100);
  await eventually(() => scrolled(page), (far) => assert(far > 50, `${far} pixels`));
  assert.equal(await picture(canvas), left);
});

test("the wheel over the diagrams scrolls the course page, with Ctrl or after a click it moves the cursor", async (t) => {
  const { page, frame } = await course(t, { size: { width: 1366, height: 700 }, options: { viewport: { width: 1400, height: 860 }, locale: "es-ES" } });
  await drawn(frame);
  await pointAt(page, frame, ".diagram-overlay");
  await wheel(page, 100);
  await eventually(() => scrolled(page), (far) => assert(far > 50, `${far} pixels`));
  assert.equal(await cursor(inside(frame)), 0);
  assert.equal(await frame.locator("#diagrams .gesture-hint").textContent(), es("diagram.hint.wheel"));
  await page.evaluate(() => scrollTo(0, 0));

  await page.keyboard.down("Control");
  await wheel(page, 100);
  await page.keyboard.up("Control");
  await becomes(() => cursor(inside(frame)), 1);
  const at = await pointAt(page, frame, ".diagram-overlay");
  await page.mouse.click(at.x, at.y);
  const clicked = await eventually(() => cursor(inside(frame)), (theta) => assert(theta > 100));
  await wheel(page, 100);
  await eventually(() => cursor(inside(frame)), (theta) => assert(theta > clicked && theta <= clicked + 1));
  assert.equal(await scrolled(page), 0);
});

test("not in a frame the wheel zooms at once", async (t) => {
  const { url } = await (sharedSite ??= startDist());
  browser ??= launchBrowser();
  const context = await (await browser).newContext({ viewport: { width: 1366, height: 768 }, reducedMotion: "reduce" });
  t.after(() => context.close());
  const page = await context.newPage();
  await page.goto(url);
  await drawn(page.mainFrame());
  const canvas = page.locator(".stage-canvas");
  const before = await picture(canvas);
  await canvas.hover();
  await page.mouse.wheel(0, -100);
  await eventually(() => picture(canvas), (now) => assert.notEqual(now, before));
  assert.equal(await page.locator(".gesture-hint").count(), 0);
});

test("a finger over the mechanism scrolls the course page, and turns the cam once the picture was tapped", async (t) => {
  const { page, frame } = await course(t, {
    size: { width: 390, height: 600 },
    options: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, reducedMotion: "no-preference" },
  });
  await drawn(frame);
  const playing = () => frame.locator("#transport button[data-state]").getAttribute("data-state");
  await becomes(playing, "playing");
  const session = await page.context().newCDPSession(page);
  /** On the cam, beside its centre, where it lies now: what arrives later may move it. */
  const onCam = async () => {
    const box = await frame.locator(".stage-canvas").boundingBox();
    assert(box);
    return { x: box.x + box.width / 2 + 24, y: box.y + box.height * 0.62 };
  };
  const swipe = async () => {
    const { x, y } = await onCam();
    const touch = (/** @type {"touchStart" | "touchMove" | "touchEnd"} */ type, /** @type {number} */ by) =>
      session.send("Input.dispatchTouchEvent", { type, touchPoints: type === "touchEnd" ? [] : [{ x, y: y - by }] });
    await touch("touchStart", 0);
    for (let by = 6; by <= 90; by += 6) {
      await touch("touchMove", by);
      await pause(16);
    }
    await touch("touchEnd", 0);
  };
  await swipe();
  // The frame is a column too, which scrolls before the course page does.
  const far = async () => (await scrolled(page)) + (await scrolled(inside(frame)));
  await eventually(far, (pixels) => assert(pixels > 40, `${pixels} pixels`));
  assert.equal(await playing(), "playing", "a finger that scrolls does not stop the cam");
  assert.equal(await frame.locator("#mechanism .gesture-hint").textContent(), en("stage.hint.finger"));

  // A tap on what still glides only stops it.
  for (let before = NaN, now = await far(); now !== before; now = await far()) {
    before = now;
    await pause(300);
  }
  for (const where of [page, frame]) await where.evaluate(() => scrollTo(0, 0));
  await becomes(far, 0);
  await pause(100);
  const { x, y } = await onCam();
  await page.touchscreen.tap(x, y);
  await becomes(() => frame.evaluate(() => document.activeElement?.className), "stage-canvas");
  await swipe();
  await becomes(playing, "paused");
  assert.equal(await far(), 0, "now the finger turns the cam");
});

// Of another origin, a frame out of view gets no frames of animation from some browsers; of the same origin it does.
for (const sameOrigin of [true, false]) {
  test(`nothing is drawn while the frame is scrolled out of view, and it is up to date when it comes back, ${sameOrigin ? "same" : "another"} origin`, async (t) => {
    const { page, frame } = await course(t, { sameOrigin, size: { width: 1366, height: 700 }, options: { viewport: { width: 1400, height: 860 }, reducedMotion: "no-preference" } });
    await drawn(frame);
    const turning = await drawnDuring(frame, () => pause(500));
    assert(turning.mechanism > 0 && turning.cursor > 0, JSON.stringify(turning));
    await page.evaluate(() => scrollTo(0, 2000));
    await pause(500);
    const place = await cursor(inside(frame));
    const away = await drawnDuring(frame, () => pause(700));
    assert.deepEqual(away, { mechanism: 0, diagrams: 0, cursor: 0 });
    assert.equal(await cursor(inside(frame)), place, "the cam stands still, and goes on from there");
    // Another design arrives meanwhile.
    await frame.evaluate((link) => void (location.hash = link), LINKS["2RO"]);
    const back = await drawnDuring(frame, async () => {
      await pause(300);
      await page.evaluate(() => scrollTo(0, 0));
      await becomes(() => level(inside(frame)), "acceptable");
      await pause(500);
    });
    assert(back.mechanism > 0 && back.diagrams > 0 && back.cursor > 0, JSON.stringify(back));
    await eventually(() => cursor(inside(frame)), (theta) => assert.notEqual(theta, place));
  });
}

test("on a phone diagrams that are scrolled away are not drawn, and show the last edit when they come back", async (t) => {
  const { url } = await (sharedSite ??= startDist());
  browser ??= launchBrowser();
  const context = await (await browser).newContext({ viewport: { width: 390, height: 844 }, locale: "en-GB", hasTouch: true, isMobile: true });
  t.after(() => context.close());
  await context.addInitScript(countDrawing);
  const page = await context.newPage();
  await page.goto(url);
  await drawn(page.mainFrame());
  await frames(page, 5);
  const curve = page.locator(".diagram-canvas").first();
  const before = await picture(curve);
  const edited = await drawnDuring(page, async () => {
    await page.getByLabel(en("segments.rise.of", { number: 1 }), { exact: true }).fill("12");
    await becomes(() => level(page), "stopped");
    await page.getByLabel(en("segments.rise.of", { number: 3 }), { exact: true }).fill("-12");
    await becomes(() => level(page), "low-speed");
    await pause(300);
  });
  assert(edited.mechanism > 0, "the mechanism stays in view, and turns");
  assert.deepEqual([edited.diagrams, edited.cursor], [0, 0]);
  assert.equal(await picture(curve), before);
  await curve.scrollIntoViewIfNeeded();
  await eventually(() => picture(curve), (now) => assert.notEqual(now, before));
});

/**
 * Opens each window of the page and closes it again with its button.
 * @param {Frame} frame
 * @param {{ single?: boolean }} [options]  in the single file, which has no other files to write
 */
async function useDialogs(frame, { single = false } = {}) {
  const button = (/** @type {string} */ key) => frame.getByRole("button", { name: en(key), exact: true });
  /** @param {string} name @param {string} close */
  const closed = async (name, close) => {
    const dialog = frame.getByRole("dialog", { name, exact: true });
    await dialog.waitFor();
    await dialog.getByRole("button", { name: close, exact: true }).last().click();
    await dialog.waitFor({ state: "hidden" });
  };
  const chosen = async (/** @type {string} */ key) => {
    await button("header.files").click();
    await frame.getByRole("menuitem", { name: en(key), exact: true }).click();
  };
  await button("header.help").click();
  await closed(en("help.title"), en("help.close"));
  await button("header.examples").click();
  await frame.locator('[data-example="R1"]').click();
  await becomes(() => level(inside(frame)), "unacceptable");
  await chosen("header.recent");
  await closed(en("recent.title"), en("recent.close"));
  await button("header.solution").click();
  await closed(en("solution.title"), en("solution.close"));
  await button("segments.auto").click();
  await closed(en("auto.title"), en("auto.close"));
  await frame.getByRole("button", { name: new RegExp(`^${en("header.compare")}`) }).click();
  await closed(en("compare.title"), en("compare.close"));
  await button("header.share").click();
  await eventually(
    async () => [await button("header.share.done").count(), await frame.getByLabel(en("header.share.manual")).isVisible()],
    ([copied, shown]) => assert(copied === 1 || shown, "neither copied nor shown"),
  );
  await frame.evaluate(() => Object.assign(globalThis, { print: () => Object.assign(globalThis, { printed: true }) }));
  await chosen("header.print");
  await frame.locator(".export-dialog[open] select").press("Enter");
  await frame.waitForFunction(() => "printed" in globalThis);
  if (single) return;
  await chosen("header.export");
  const dialog = frame.locator(".export-dialog[open]");
  await dialog.locator("#export-format").selectOption("stl");
  const saved = frame.page().waitForEvent("download");
  await dialog.locator("#export-thickness").press("Enter");
  assert.match((await saved).suggestedFilename(), /\.stl$/);
  await dialog.waitFor({ state: "hidden" });
  await chosen("header.export");
  await dialog.locator("#export-format").selectOption("csv");
  const table = frame.page().waitForEvent("download");
  await dialog.getByRole("button", { name: en("export.save"), exact: true }).click();
  assert.match((await table).suggestedFilename(), /\.csv$/);
}

for (const sandbox of [undefined, "allow-scripts allow-same-origin allow-downloads"]) {
  test(`all windows work in a frame with ${sandbox === undefined ? "no sandbox" : "a sandbox that forbids forms"}`, async (t) => {
    const { frame } = await course(t, { sandbox });
    await drawn(frame);
    await useDialogs(frame);
    await field(inside(frame), "base_radius").fill("0.3");
    await becomes(() => level(inside(frame)), "low-speed");
  });
}

for (const [locale, wording, other] of /** @type {const} */ ([
  ["en-GB", /single file works here: levalab\.html/, /un solo archivo/],
  ["es-ES", /un solo archivo sí funciona aquí: levalab\.html/, /single file/],
])) {
  test(`a frame that takes the origin away says so and leads to the single file, ${locale}`, async (t) => {
    const { page, frame, url } = await course(t, { sandbox: "allow-scripts", fragment: LINKS["2RO"], options: { locale } });
    const sentence = frame.locator("#unstarted");
    await sentence.waitFor();
    assert.match(await sentence.innerText(), wording);
    assert.doesNotMatch(await sentence.innerText(), other);
    await sentence.getByRole("link", { name: "levalab.html" }).click();
    const single = await eventually(async () => page.frames()[1], (found) => assert(found?.url().startsWith(`${url}levalab.html`)));
    assert(single);
    await drawn(single);
    assert.equal(await level(inside(single)), "acceptable", "with the same design");
    assert.equal(await single.locator("#unstarted").isVisible(), false);
  });
}

/** What the browser answers when something is to be kept. @param {Frame} frame */
const keeping = (frame) =>
  frame.evaluate(() => {
    try {
      return String(localStorage.length);
    } catch (error) {
      return String(error);
    }
  });

for (const [where, given] of /** @type {const} */ ([
  ["in the single file under a sandbox", { sandbox: "allow-scripts", file: "levalab.html" }],
  ["in a browser that blocks cookies", { storage: false }],
])) {
  test(`where nothing can be kept all windows work: ${where}`, async (t) => {
    const { frame } = await course(t, given);
    await drawn(frame);
    assert.match(await keeping(frame), /SecurityError/);
    await useDialogs(frame, { single: "file" in given });
  });
}

test("the single file is edited and explained in a frame without an origin", async (t) => {
  const { frame } = await course(t, { sandbox: "allow-scripts", file: "levalab.html", fragment: LINKS.R1 });
  await drawn(frame);
  assert.equal(await frame.evaluate(() => origin), "null");
  await field(inside(frame), "base_radius").fill("0.3");
  await becomes(() => level(inside(frame)), "low-speed");
  await frame.locator("#readouts .mark").first().click();
  await frame.getByRole("dialog").waitFor();
});
