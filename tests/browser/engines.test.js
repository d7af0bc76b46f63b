// The main job in every engine, from a server and from one file on disk: open, edit, verdict, link and back, language, files.
import assert from "node:assert/strict";
import { copyFile, mkdtemp, readFile, readdir, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, suite, test } from "node:test";
import { pathToFileURL } from "node:url";
import { drawn, root, startDist } from "./browser.js";
import { ENGINES } from "./engines.js";
import { LINKS, banner, becomes, diagram, en, es, eventually, field, findings, fragment, inkOf, level, mechanism, openExample, picture, readout, undo, verdict } from "./user.js";

/** @typedef {import("playwright-core").Browser} Browser */
/** @typedef {import("playwright-core").BrowserContext} BrowserContext */
/** @typedef {import("playwright-core").Page} Page */

const TEN = await readFile(path.join(root, "examples/10EX.lev.json"), "utf8");
const SINGLE = path.join(root, "dist/levalab.html");

/** Where the page comes from. @type {Record<string, () => Promise<{ url: string, close: () => unknown }>>} */
const SOURCES = {
  "a server": startDist,
  // Alone in its folder, under a name of its own, as somebody keeps it.
  "one file on disk": async () => {
    const folder = await mkdtemp(path.join(tmpdir(), "levalab "));
    const file = path.join(folder, "my cams.html");
    await copyFile(SINGLE, file);
    return { url: pathToFileURL(file).href, close: () => rm(folder, { recursive: true }) };
  },
};

/** The page that a click opens beside this one. @param {Page} page @param {() => Promise<void>} click */
async function beside(page, click) {
  const [opened] = await Promise.all([page.context().waitForEvent("page"), click()]);
  return opened;
}

/** Firefox reports a formula that is laid out before the rest of it has arrived over the network; `wholeFormulas` looks at the finished page. */
const HALF_ARRIVED = /^Incorrect number of children for <\w+\/> tag\.$/;

/** Fails when a formula of a page that has arrived lacks a part. @param {Page} page */
async function wholeFormulas(page) {
  await page.waitForLoadState();
  const broken = await page.locator("math :is(msub, msup, mfrac, munder, mover, msubsup, munderover)").evaluateAll((elements) =>
    elements.filter((element) => element.childElementCount !== (/^m(subsup|underover)$/.test(element.localName) ? 3 : 2)).map(({ localName, textContent }) => `${localName} ${textContent}`),
  );
  assert.deepEqual(broken, [], "formulas without a part");
}

/** How far below the upper edge of the window it stands. @param {import("playwright-core").Locator} place */
const top = (place) => place.evaluate((node) => node.getBoundingClientRect().top);

for (const [engine, launch] of Object.entries(ENGINES)) {
  suite(engine, () => {
    /** @type {Browser} */
    let browser;
    /** Where its downloads go. */
    let downloads = "";
    before(async () => {
      downloads = await mkdtemp(path.join(tmpdir(), "levalab-saved-"));
      browser = await launch(downloads);
    });
    after(async () => {
      await browser?.close();
      await rm(downloads, { recursive: true });
    });

    /** The design of the file that was saved last. */
    async function saved() {
      const files = (await readdir(downloads, { recursive: true, withFileTypes: true })).filter((entry) => entry.isFile());
      const designs = await Promise.all(files.map(async (file) => JSON.parse(await readFile(path.join(file.parentPath, file.name), "utf8"))));
      return designs.map(({ title, cam }) => `${title}: ${cam.base_radius}`);
    }

    for (const [source, start] of Object.entries(SOURCES)) {
      /** The page in a fresh profile, and what goes wrong in it. @param {import("node:test").TestContext} t @param {string} [hash] */
      async function open(t, hash = "") {
        const { url, close } = await start();
        const context = await browser.newContext({ reducedMotion: "reduce", viewport: { width: 1366, height: 768 }, locale: "en-GB" });
        /** @type {string[]} */
        const complaints = [];
        // What is opened beside the page is watched as well.
        context.on("page", (page) => {
          page.on("pageerror", ({ message }) => HALF_ARRIVED.test(message) || complaints.push(message));
          page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
          page.on("request", (request) => {
            if (!new RegExp(`^(data:|blob:|${url.startsWith("file:") ? url : new URL(url).origin})`).test(request.url())) complaints.push(`request to ${request.url()}`);
          });
        });
        const page = await context.newPage();
        t.after(async () => {
          await context.close();
          await close();
          assert.deepEqual(complaints, [], "the page misbehaved");
        });
        await page.goto(url + hash);
        await drawn(page);
        return { page, context, url };
      }

      test(`${engine}, from ${source}: an edit changes cam, diagrams, verdict and link; the link gives it back; undo takes it back`, async (t) => {
        const { page, context, url } = await open(t, `#${LINKS.R1}`);
        assert.equal(await level(page), "unacceptable");
        const before = { s: await picture(diagram(page, "s")), cam: await picture(mechanism(page)), text: await verdict(page).innerText() };
        await field(page, "base_radius").fill("0.5");
        await becomes(() => level(page), "low-speed");
        const link = await eventually(() => fragment(page), (now) => assert.match(now, /\.R\.5_/));
        await eventually(() => picture(mechanism(page)), (now) => assert.notEqual(now, before.cam));
        assert((await inkOf(diagram(page, "s"), "s", 60)).count > 200, "s is not drawn");
        const other = await context.newPage();
        await other.goto(`${url}#${link}`);
        await drawn(other);
        assert.equal(await field(other, "base_radius").inputValue(), "0.5");
        assert.equal(await level(other), "low-speed");
        await undo(page).click();
        await becomes(() => verdict(page).innerText(), before.text);
        await becomes(() => fragment(page), LINKS.R1);
      });

      test(`${engine}, from ${source}: examples, cursor, both languages, a cure by a click`, async (t) => {
        const { page } = await open(t);
        await openExample(page, "R1");
        await becomes(() => level(page), "unacceptable");
        // Typed as by hand: filled in by a script, a field of Firefox does not tell that it has changed.
        await page.locator("#transport-angle").click();
        await page.keyboard.press("Control+A");
        await page.keyboard.type("251.18");
        await page.keyboard.press("Enter");
        await becomes(() => readout(page, "v").textContent(), "−0.18831");
        await page.getByRole("button", { name: "ES", exact: true }).click();
        await becomes(() => verdict(page).innerText(), /^Inaceptable/m);
        assert.equal(await page.locator("html").getAttribute("lang"), "es");
        await becomes(() => readout(page, "v").textContent(), "−0,18831");
        await page.getByRole("button", { name: "EN", exact: true }).click();
        const count = await findings(page).count();
        await findings(page).getByRole("button", { name: /R\s?b ≥/ }).first().click();
        await becomes(() => findings(page).count(), count - 1);
      });

      test(`${engine}, from ${source}: files open and are saved, recent designs are listed, a wrong link is told`, async (t) => {
        const { page, url } = await open(t, "#1.Wrong.R35");
        await becomes(() => banner(page).innerText(), /./);
        const menu = page.getByRole("button", { name: en("header.files"), exact: true });
        await page.locator('input[type="file"]').setInputFiles({ name: "cam.lev.json", mimeType: "application/json", buffer: Buffer.from(TEN) });
        await becomes(() => fragment(page), LINKS["10EX"]);
        await field(page, "base_radius").fill("31");
        await eventually(() => fragment(page), (now) => assert.match(now, /\.F31H/));
        await menu.click();
        await page.getByRole("menuitem", { name: en("header.save"), exact: true }).click();
        await eventually(saved, (designs) => assert(designs.includes("Example 10EX: 31"), `saved: ${designs}`));
        await eventually(() => page.evaluate(() => Object.keys(localStorage).filter((key) => key.startsWith("levalab:recent:")).length), (kept) => assert.equal(kept, 1));
        await menu.click();
        await page.getByRole("menuitem", { name: en("header.recent"), exact: true }).click();
        const dialog = page.getByRole("dialog", { name: en("recent.title") });
        await becomes(() => dialog.getByRole("listitem").locator("strong").allTextContents(), ["Example 10EX"]);
        // Without a link the tab finds what it had.
        await page.goto("about:blank");
        await page.goto(url);
        await drawn(page);
        assert.equal(await field(page, "base_radius").inputValue(), "31");
      });

      test(`${engine}, from ${source}: a question mark answers with drawing and formula, and its page opens at the place`, async (t) => {
        const { page } = await open(t, `#${LINKS["2RO"]}`);
        const mark = page.locator('button[data-term="pivot_distance"]');
        await mark.click();
        const card = page.getByRole("dialog").and(page.locator(".card"));
        await card.waitFor();
        assert.equal(await card.locator("svg .lit[data-parameter='pivot_distance']").count(), 1);
        assert(((await card.locator("math").first().boundingBox())?.width ?? 0) > 5, "no formula is seen");
        const theory = await beside(page, () => card.getByRole("link").click());
        const place = theory.getByRole("heading", { name: "Oscillating roller follower", exact: true });
        await eventually(() => top(place), (y) => assert(y >= 0 && y < 200, `the place is at ${y}`));
        for (const shown of [page, theory]) await wholeFormulas(shown);
        await theory.close();
        await page.keyboard.press("Escape");
        await card.waitFor({ state: "hidden" });
        assert(await mark.evaluate((node) => node === document.activeElement), "the focus did not come back");
      });

      test(`${engine}, from ${source}: manual, theory and terms open beside the cam, lead to each other in both languages, and back`, async (t) => {
        const { page, url } = await open(t);
        await page.getByRole("button", { name: en("header.help"), exact: true }).click();
        const help = page.getByRole("dialog", { name: en("help.title") });
        for (const name of [en("help.manual"), en("help.theory"), en("help.terms")]) {
          const opened = await beside(page, () => help.getByRole("link", { name, exact: true }).click());
          await becomes(() => opened.getByRole("heading", { level: 1 }).innerText(), name);
          await opened.close();
        }
        const reading = await beside(page, () => help.getByRole("link", { name: en("help.theory"), exact: true }).click());
        const contents = reading.getByRole("navigation", { name: "Contents" });
        await contents.getByRole("link", { name: "Cycloidal", exact: true }).click();
        const law = reading.locator("section").filter({ has: reading.getByRole("heading", { name: "Cycloidal", exact: true }) }).last();
        await eventually(() => top(law), (y) => assert(y >= 0 && y < 200, `the law is at ${y}`));
        assert((await law.locator("math").count()) > 0, "it has no formula");
        await wholeFormulas(reading);
        await reading.getByRole("link", { name: "Español" }).click();
        await becomes(() => reading.locator("html").getAttribute("lang"), "es");
        await reading.getByRole("link", { name: es("help.terms"), exact: true }).click();
        await becomes(() => reading.getByRole("heading", { level: 1 }).innerText(), es("help.terms"));
        await reading.reload();
        await becomes(() => reading.getByRole("heading", { level: 1 }).innerText(), es("help.terms"));
        // From a server, going back is the browser's own doing; within one file it is ours.
        if (url.startsWith("file:")) {
          await reading.evaluate(() => history.back());
          await becomes(() => reading.getByRole("heading", { level: 1 }).innerText(), es("help.theory"));
        }
        await reading.getByRole("link", { name: "Volver a la leva" }).click();
        await drawn(reading);
        assert((await inkOf(diagram(reading, "s"), "s", 60)).count > 200, "the cam is not back");
      });
    }

    test(`${engine}: the second visit works with the server gone`, async (t) => {
      const site = await startDist();
      const context = await browser.newContext({ reducedMotion: "reduce", locale: "en-GB" });
      t.after(() => context.close());
      const page = await context.newPage();
      await page.goto(site.url);
      await drawn(page);
      await page.evaluate(async () => void (await navigator.serviceWorker.ready));
      site.close();
      await page.goto("about:blank");
      await page.goto(`${site.url}#${LINKS["2RO"]}`);
      await drawn(page);
      assert.equal(await level(page), "acceptable");
    });
  });
}

test("the single file names every script and style by its hash, and nothing else may run", async () => {
  const page = await readFile(SINGLE, "utf8");
  const [, policy = ""] = /http-equiv="Content-Security-Policy" content="([^"]+)"/.exec(page) ?? [];
  assert.match(policy, /default-src 'none'; script-src( 'sha256-[\w+/]+=*')+ 'wasm-unsafe-eval'; style-src( 'sha256-[\w+/]+=*'){2};/);
  // From a server its worker comes from beside it.
  assert(!/unsafe-inline|'self'|https?:/.test(policy.replace("worker-src 'self';", "")), policy);
  assert.match(policy, /require-trusted-types-for 'script'; trusted-types levalab-own levalab-worker$/);
  assert(!/<(script|link)[^>]+(src|href)="(?!data:)/.test(page), "it loads something");
});
