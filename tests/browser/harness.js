// Opens the packed page in a real browser, and fails a test for whatever the page does behind its back:
// an uncaught error, an error on the console, a breach of its own policy, a request to another host.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import path from "node:path";
import { after } from "node:test";
import { chromium } from "playwright-core";
import { startSite } from "./site.js";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("playwright-core").BrowserContextOptions} ContextOptions */

export const root = path.resolve(import.meta.dirname, "../..");

/** Deep on purpose: every address in the page has to be relative. */
const PREFIX = "/some/where/levalab/";

/** For closed networks, no GPU and no display. */
const FLAGS = [
  "--headless",
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** Where Chromium's relatives live when LEVALAB_BROWSER does not say. */
const PLACES = [
  "/usr/bin/chromium",
  "/usr/bin/chromium-browser",
  "/usr/bin/google-chrome",
  "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
  "C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe",
  "C:\\Program Files (x86)\\Microsoft\\Edge\\Application\\msedge.exe",
];

/** @param {string[]} [flags] further flags */
export function launchBrowser(flags = []) {
  const executablePath = process.env.LEVALAB_BROWSER ?? PLACES.find((place) => existsSync(place));
  assert(executablePath, "no browser found: name its program in LEVALAB_BROWSER");
  return chromium.launch({ executablePath, args: [...FLAGS, ...flags] });
}

/** Serves `dist/` below a deep path. @param {Record<string, string>} [mounts] further folders */
export async function startDist(mounts = {}) {
  const dist = path.join(root, "dist");
  assert(existsSync(path.join(dist, "index.html")), "dist/ is missing: run `cargo xtask dist`");
  const site = await startSite({ [PREFIX]: dist, ...mounts });
  return { ...site, url: site.origin + PREFIX };
}

/** @type {Promise<Awaited<ReturnType<typeof startDist>>> | undefined} */
let sharedSite;
/** @type {ReturnType<typeof launchBrowser> | undefined} */
let sharedBrowser;

after(async () => {
  await (await sharedBrowser)?.close();
  (await sharedSite)?.close();
});

/**
 * A fresh browser profile with the page in it, drawn. It closes with the test, which fails if the page misbehaved.
 * @param {import("node:test").TestContext} t
 * @param {{ url?: string, fragment?: string, ready?: boolean } & ContextOptions} [options]
 *   `url` instead of the packed page's; `fragment` without #; `ready: false` does not wait for the first drawing
 * @returns {Promise<{ page: Page, url: string, complaints: string[] }>}
 *   `complaints` is what went wrong so far: a test that provokes an error takes it out again
 */
export async function openPage(t, { url, fragment = "", ready = true, ...options } = {}) {
  sharedBrowser ??= launchBrowser();
  const address = url ?? (await (sharedSite ??= startDist())).url;
  const context = await (await sharedBrowser).newContext({ viewport: { width: 1366, height: 768 }, locale: "en-GB", ...options });
  const page = await context.newPage();
  const complaints = watch(page, new URL(address).origin);
  t.after(async () => {
    await context.close();
    assert.deepEqual(complaints, [], "the page misbehaved");
  });
  await page.goto(address + (fragment && `#${fragment}`));
  if (ready) await drawn(page);
  return { page, url: address, complaints };
}

/** Waits for the first complete drawing. @param {Page} page */
export async function drawn(page) {
  await page.waitForFunction(() => performance.getEntriesByName("levalab:drawn").length > 0);
}

/**
 * Collects what a page does wrong from now on.
 * @param {Page} page
 * @param {string} origin the only host it may ask
 */
function watch(page, origin) {
  /** @type {string[]} */
  const complaints = [];
  page.on("pageerror", (error) => complaints.push(`uncaught: ${error.message}`));
  // Breaches of the policy and failed loads arrive here too.
  page.on("console", (message) => {
    if (message.type() === "error") complaints.push(`console: ${message.text()}`);
  });
  page.on("request", (request) => {
    const { protocol, origin: asked } = new URL(request.url());
    if (!["data:", "blob:"].includes(protocol) && asked !== origin) complaints.push(`request to ${request.url()}`);
  });
  return complaints;
}
