// A real browser with the packed page in it.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { mkdir, mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { chromium } from "playwright-core";
import { startSite } from "./site.js";

/** @typedef {import("playwright-core").Page} Page */

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

/** For the first drawing, ms: a loaded machine is no failure, a page that never draws should not hold up the others. */
const PATIENCE = 15_000;

/** Where Chromium's relatives live when LEVALAB_BROWSER does not say. */
const PLACES = [
  "/usr/bin/chromium",
  "/usr/bin/chromium-browser",
  "/usr/bin/google-chrome",
  "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
  "C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe",
  "C:\\Program Files (x86)\\Microsoft\\Edge\\Application\\msedge.exe",
];

/** @param {string[]} [flags] further flags @param {string} [downloadsPath] */
export function launchBrowser(flags = [], downloadsPath) {
  return chromium.launch({ executablePath: program(), args: [...FLAGS, ...flags], downloadsPath });
}

/**
 * A browser whose user has blocked cookies, and with them storage, locks and workers of every page.
 * @param {import("node:test").TestContext} t  after which it closes
 * @param {import("playwright-core").BrowserContextOptions} options
 */
export async function launchWithoutStorage(t, options) {
  const profile = await mkdtemp(path.join(tmpdir(), "levalab-profile-"));
  await mkdir(path.join(profile, "Default"));
  const blocked = 2;
  const preferences = { profile: { default_content_setting_values: { cookies: blocked } } };
  await writeFile(path.join(profile, "Default", "Preferences"), JSON.stringify(preferences));
  const context = await chromium.launchPersistentContext(profile, { executablePath: program(), args: FLAGS, ...options });
  t.after(async () => {
    await context.close();
    await rm(profile, { recursive: true, force: true });
  });
  return context;
}

/** The browser's program. */
function program() {
  const found = process.env.LEVALAB_BROWSER ?? PLACES.find((place) => existsSync(place));
  assert(found, "no browser found: name its program in LEVALAB_BROWSER");
  return found;
}

/**
 * Serves `dist/`, or the folder in LEVALAB_PAGE (the checkout, say, while styles are tried), below a deep path.
 * @param {Record<string, string>} [mounts] further folders
 */
export async function startDist(mounts = {}) {
  const dist = path.resolve(root, process.env.LEVALAB_PAGE ?? "dist");
  assert(existsSync(path.join(dist, "index.html")), `${dist} holds no page: run \`cargo xtask dist\``);
  const site = await startSite({ [PREFIX]: dist, ...mounts });
  return { ...site, url: site.origin + PREFIX };
}

/** Waits for the first complete drawing. @param {Page} page */
export async function drawn(page) {
  await page.waitForFunction(() => performance.getEntriesByName("levalab:drawn").length > 0, undefined, { timeout: PATIENCE });
}
