// A page that cannot start says why, in its own language, and names the way that is left.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage } from "./harness.js";
import { banner, becomes, en, es, fixedPart } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("playwright-core").Route} Route */

/** What the console says of the provoked failure. @param {string[]} complaints */
function forgive(complaints) {
  complaints.length = 0;
}

/** @type {{ name: string, key: string, gap?: string, break: (page: Page) => Promise<unknown> }[]} */
const FAILURES = [
  { name: "no WebAssembly", key: "start.browser", break: (page) => page.addInitScript(() => void Reflect.deleteProperty(globalThis, "WebAssembly")) },
  {
    name: "a policy that forbids WebAssembly",
    key: "start.policy",
    break: (page) => page.route(/\/levalab\/$/, async (route) => {
      const response = await route.fetch();
      await route.fulfill({ response, body: (await response.text()).replace(" 'wasm-unsafe-eval'", "") });
    }),
  },
  { name: "the module is not there", key: "start.network", gap: "reason", break: (page) => page.route("**/*.wasm", (route) => route.fulfill({ status: 404, body: "" })) },
  { name: "the module's connection breaks", key: "start.network", gap: "reason", break: (page) => page.route("**/*.wasm", (route) => route.abort()) },
  { name: "the module ends in the middle", key: "start.damaged", gap: "reason", break: (page) => page.route("**/*.wasm", halved) },
  { name: "a page instead of the module", key: "start.damaged", gap: "reason", break: (page) => page.route("**/*.wasm", (route) => route.fulfill({ contentType: "text/html", body: "<!doctype html><title>Log in</title>" })) },
];

/** @param {Route} route */
async function halved(route) {
  const response = await route.fetch();
  const body = await response.body();
  await route.fulfill({ status: 200, contentType: "application/wasm", body: body.subarray(0, body.length / 2) });
}

for (const [locale, say] of /** @type {const} */ ([["en-GB", en], ["es-ES", es]])) {
  for (const failure of FAILURES) {
    test(`${failure.name}: the page says so (${locale})`, async (t) => {
      const { page, url, complaints } = await openPage(t, { ready: false, locale, serviceWorkers: "block" });
      await page.goto("about:blank");
      await failure.break(page);
      await page.goto(url);
      const sentence = failure.gap ? fixedPart(say, failure.key, failure.gap) : say(failure.key);
      await becomes(async () => (await banner(page).innerText()).includes(sentence), true);
      assert(!/\bstart\.|\bbanner\./.test(await banner(page).innerText()), "keys in place of words");
      await banner(page).getByRole("button", { name: say("banner.close"), exact: true }).waitFor();
      forgive(complaints);
    });
  }
}
