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
      const sentence = fixedPart(say, failure.key, failure.gap ?? "remedy");
      await becomes(async () => (await banner(page).innerText()).includes(sentence), true);
      if (failure.key !== "start.browser") assert.match(await banner(page).innerText(), /levalab\.html/);
      assert(!/\bstart\.|\bbanner\./.test(await banner(page).innerText()), "keys in place of words");
      await banner(page).getByRole("button", { name: say("banner.close"), exact: true }).waitFor();
      forgive(complaints);
    });
  }
}

/** The sentence that index.html holds for a page whose scripts never run. @param {Page} page */
const late = (page) => page.locator("#late p:visible");

for (const [name, route] of /** @type {[string, (route: Route) => Promise<void>][]} */ ([
  ["come as plain text", async (route) => route.fulfill({ response: await route.fetch(), contentType: "text/plain" })],
  ["are a page to log in", (route) => route.fulfill({ contentType: "text/html", body: "<!doctype html><title>Log in</title>" })],
  ["are not there", (route) => route.fulfill({ status: 404, body: "" })],
])) {
  for (const [locale, words] of [["en-GB", /has not started.*levalab\.html/], ["es-ES", /no ha empezado.*levalab\.html/]]) {
    test(`scripts that ${name}: the page says so at once (${locale})`, async (t) => {
      const { page, url, complaints } = await openPage(t, { ready: false, locale: String(locale), serviceWorkers: "block" });
      await page.goto("about:blank");
      await page.route("**/main.js", route);
      await page.goto(url);
      await becomes(() => late(page).innerText(), words);
      forgive(complaints);
    });
  }
}

test("words that do not arrive: the sentence in the page has to do", async (t) => {
  const { page, url, complaints } = await openPage(t, { ready: false, serviceWorkers: "block" });
  await page.goto("about:blank");
  await page.route("**/page.en.js", (route) => route.abort());
  await page.goto(url);
  await becomes(() => late(page).innerText(), /has not started/);
  forgive(complaints);
});

test("without JavaScript the page says what it needs", async (t) => {
  const { page } = await openPage(t, { ready: false, javaScriptEnabled: false });
  await page.locator("noscript p").first().waitFor();
  assert.match(await page.locator("noscript").innerText(), /LevaLab needs JavaScript\./);
});

test("scripts that hang: the sentence comes after eight seconds, and goes when the page starts after all", async (t) => {
  const { page, url } = await openPage(t, { ready: false, serviceWorkers: "block" });
  await page.goto("about:blank");
  /** @type {() => void} */
  let release = () => {};
  const gate = new Promise((resolve) => (release = () => resolve(undefined)));
  await page.route("**/main.js", async (route) => {
    await gate;
    await route.continue();
  });
  await page.goto(url, { waitUntil: "commit" });
  await page.waitForTimeout(5000);
  assert.equal(await late(page).count(), 0, "too early");
  await late(page).waitFor({ timeout: 15_000 });
  release();
  await page.locator("#late").waitFor({ state: "detached" });
});
