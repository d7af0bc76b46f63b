// The browsers that the main job is done in: Chromium, and Firefox as its makers ship it.
//
// Firefox is driven by playwright-core over WebDriver BiDi, which needs neither a patched build nor a second program, so that the
// same helpers serve both.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { firefox } from "playwright-core";
import { launchBrowser } from "./browser.js";

/** Where Firefox lives when LEVALAB_FIREFOX does not say. */
const PLACES = [
  "/usr/bin/firefox",
  "/usr/bin/firefox-esr",
  "/Applications/Firefox.app/Contents/MacOS/firefox",
  "C:\\Program Files\\Mozilla Firefox\\firefox.exe",
];

/** Each is started with the folder that downloads go to. @type {Record<string, (downloads: string) => Promise<import("playwright-core").Browser>>} */
export const ENGINES = { Chromium: (downloads) => launchBrowser([], downloads), Firefox: launchFirefox };

/** @param {string} downloadsPath */
async function launchFirefox(downloadsPath) {
  const executablePath = process.env.LEVALAB_FIREFOX ?? PLACES.find((place) => existsSync(place));
  assert(executablePath, "no Firefox found: name its program in LEVALAB_FIREFOX");
  // Reduced motion, so that the cam stands still.
  const browser = await firefox.launch({ channel: "moz-firefox", executablePath, downloadsPath, firefoxUserPrefs: { "ui.prefersReducedMotion": 1 } });
  forgiveOldFirefox(browser);
  return browser;
}

/**
 * playwright-core asks for the colour scheme by a command that the long-term release of Firefox does not know yet. Nothing here
 * depends on it.
 * @param {any} browser
 */
function forgiveOldFirefox(browser) {
  const sessions = Object.getPrototypeOf(browser._connection.toImpl(browser)._browserSession);
  const send = sessions.send;
  sessions.send = async function (/** @type {string} */ method, /** @type {unknown} */ parameters) {
    try {
      return await send.call(this, method, parameters);
    } catch (error) {
      if (method === "emulation.setMediaFeaturesOverride" && /unknown command/.test(String(error))) return {};
      throw error;
    }
  };
}
