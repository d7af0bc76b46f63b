// Opens the packed page for a test, and fails the test for whatever the page does behind its back:
// an uncaught error, an error on the console, a breach of its own policy, a request to another host.
import assert from "node:assert/strict";
import { after } from "node:test";
import { drawn, launchBrowser, startDist } from "./browser.js";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("playwright-core").BrowserContextOptions} ContextOptions */

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
 * @param {{ url?: string, fragment?: string, ready?: boolean, firstVisit?: boolean, prepare?: (page: Page) => Promise<unknown>, until?: "load" | "commit" } & ContextOptions} [options]
 *   `url` instead of the packed page's; `fragment` without #; `ready: false` does not wait for the first drawing;
 *   `prepare` is done before the page is asked for, and `until` is what is waited for; `firstVisit` is that of somebody to whom the guided minute has not been offered yet
 * @returns {Promise<{ page: Page, url: string, complaints: string[] }>}
 *   `complaints` is what went wrong so far: a test that provokes an error takes it out again
 */
export async function openPage(t, { url, fragment = "", ready = true, firstVisit = false, prepare, until = "load", ...options } = {}) {
  sharedBrowser ??= launchBrowser();
  const address = url ?? (await (sharedSite ??= startDist())).url;
  const context = await (await sharedBrowser).newContext({ viewport: { width: 1366, height: 768 }, locale: "en-GB", ...options });
  if (!firstVisit) await context.addInitScript(offered);
  const page = await context.newPage();
  const complaints = watch(page, new URL(address).origin);
  await prepare?.(page);
  t.after(async () => {
    await context.close();
    assert.deepEqual(complaints, [], "the page misbehaved");
  });
  try {
    await page.goto(address + (fragment && `#${fragment}`), { waitUntil: until });
    // An uncaught error before the first drawing needs no further waiting.
    const broken = new Promise((_, reject) => page.once("pageerror", reject));
    if (ready) await Promise.race([drawn(page), broken]);
  } catch (cause) {
    throw new Error(["the page did not draw", ...complaints].join("\n"), { cause });
  }
  return { page, url: address, complaints };
}

/** What the page remembers of somebody who has been offered the guided minute; a frame without storage remembers nothing. */
function offered() {
  try {
    localStorage.setItem("levalab:tour", "true");
  } catch {
    // The page can do without, too.
  }
}

/**
 * Collects what a page does wrong from now on.
 * @param {Page} page
 * @param {string} origin the only host it may ask
 */
function watch(page, origin) {
  /** @type {string[]} */
  const complaints = [];
  /** @param {string} complaint */
  const complain = (complaint) => complaints.includes(complaint) || complaints.push(complaint);
  page.on("pageerror", (error) => complain(`uncaught: ${error.message}`));
  // Breaches of the policy and failed loads arrive here too.
  page.on("console", (message) => {
    if (message.type() === "error") complain(`console: ${message.text()}`);
  });
  page.on("request", (request) => {
    const { protocol, origin: asked } = new URL(request.url());
    if (!["data:", "blob:"].includes(protocol) && asked !== origin) complain(`request to ${request.url()}`);
  });
  return complaints;
}
