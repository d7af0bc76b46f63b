// The main screen is complete when it moves; what comes later arrives on a busy machine too, or says that it did not.
import assert from "node:assert/strict";
import { test } from "node:test";
import { CATALOGUE } from "../../web/pkg/catalogue.js";
import { openPage } from "./harness.js";
import { LINKS, becomes, en, es, eventually, field, frames, fragment, law, level, undo, verdict } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

/** Requests that fail for want of the network are what these tests are about. @param {string[]} complaints */
function forgiveLoads(complaints) {
  for (let i = complaints.length; i-- > 0; ) if (/ERR_FAILED|ERR_INTERNET_DISCONNECTED|404/.test(complaints[i])) complaints.splice(i, 1);
}

/** A browser without a free moment, as on a slow machine while the cam turns. */
function neverIdle() {
  Object.assign(window, {
    requestIdleCallback: (/** @type {() => void} */ work, /** @type {{ timeout?: number }} */ { timeout } = {}) => (timeout === undefined ? 0 : setTimeout(work, timeout)),
  });
}

/**
 * The page turning, and from then on without the network; nothing more is asked of it by an edit.
 * @param {import("node:test").TestContext} t
 * @param {Parameters<typeof openPage>[1]} [options]
 */
async function openThenCut(t, options) {
  const { page, complaints } = await openPage(t, { ...options, serviceWorkers: "block" });
  /** @type {string[]} */
  const asked = [];
  await page.context().route("**", (route) => {
    asked.push(route.request().url());
    return route.abort();
  });
  return { page, complaints, asked };
}

/** A design is on screen, not the refusal of one. @param {Page} page @param {string} after */
async function stands(page, after) {
  await frames(page);
  await eventually(() => level(page), (now) => assert.notEqual(now, "stopped", after));
}

/** First edits, each made on the page as it opened. @type {[name: string, edit: (page: Page) => Promise<unknown>][]} */
const FIRST_EDITS = [
  ...CATALOGUE.laws.map(({ id }) => /** @type {[string, (page: Page) => Promise<unknown>]} */ ([`law ${id}`, (page) => law(page, 1).selectOption(id)])),
  ...CATALOGUE.followers.map(({ id }) => /** @type {[string, (page: Page) => Promise<unknown>]} */ ([`follower ${id}`, (page) => page.locator(`input[name="follower"][value="${id}"]`).check({ force: true })])),
  ...CATALOGUE.kinds.map(({ id }) => /** @type {[string, (page: Page) => Promise<unknown>]} */ ([`kind ${id}`, (page) => page.locator("#field-kind").selectOption(id)])),
  ...Object.entries({ base_radius: "30", roller_radius: "9", eccentricity: "1", speed: "60" }).map(
    ([key, value]) => /** @type {[string, (page: Page) => Promise<unknown>]} */ ([`${key} ${value}`, (page) => field(page, key).fill(value)]),
  ),
  ["a second cam", (page) => page.getByRole("button", { name: en("pair.add"), exact: true }).click()],
  ["a segment more", (page) => page.getByRole("button", { name: en("segments.add"), exact: true }).click()],
  ["another unit", async (page) => {
    await page.locator("#field-length-unit, #field-length_unit").first().selectOption("in");
    await page.locator(".unit-question button").first().click();
  }],
];

test("with the network cut, first edits over every law, follower, kind and field work and ask for nothing", async (t) => {
  assert(FIRST_EDITS.length >= 30, `${FIRST_EDITS.length} edits`);
  const { page, asked, complaints } = await openThenCut(t, { fragment: LINKS["9RT"] });
  const before = await fragment(page);
  for (const [name, edit] of FIRST_EDITS) {
    await edit(page);
    // A free law without data, or a segment without a rise, is told to be unfinished: that is an answer too.
    await frames(page);
    await eventually(() => verdict(page).innerText(), (text) => assert(text.trim().length > 20, name));
    assert(!(await verdict(page).innerText()).includes(en("banner.panic").slice(0, 30)), name);
    for (let step = 0; step < 8 && (await undo(page).isEnabled()); step++) {
      await undo(page).click();
      await frames(page);
    }
    await becomes(() => fragment(page), before);
    await stands(page, name);
  }
  // The parts that the first seconds ask for by themselves may still be on their way; an edit asks for none.
  assert.deepEqual(asked.filter((url) => /wasm/.test(url) && !/export|workshop/.test(url)), []);
  forgiveLoads(complaints);
});

test("each byte of a first visit is loaded once", async (t) => {
  const { page } = await openPage(t);
  await page.waitForLoadState("networkidle");
  // The browser asks for its icon by itself, as often as it likes.
  const loads = await page.evaluate(() => performance.getEntriesByType("resource").map(({ name }) => name).filter((name) => !name.endsWith("icon.svg")));
  const twice = loads.filter((name, i) => loads.indexOf(name) !== i);
  assert.deepEqual(twice, []);
  assert.equal(loads.filter((name) => name.endsWith(".wasm")).length, 1, "one module serves the main screen");
});

/** Buttons of the header and the panel that ask for a part. @type {[name: string, press: (page: Page, say: typeof en) => Promise<unknown>][]} */
const PARTS = [
  ["examples", (page, say) => page.getByRole("button", { name: say("header.examples"), exact: true }).click()],
  ["solution", (page, say) => page.getByRole("button", { name: say("header.solution"), exact: true }).click()],
  ["comparison", (page, say) => page.getByRole("button", { name: say("header.compare"), exact: true }).click()],
  ["pin", (page) => page.locator("#pin").click()],
  ["help", (page) => page.locator("#help-button").click()],
  ["question mark", (page) => page.locator("button.mark").first().click()],
  ["application", (page) => page.locator("#application-button").click()],
  ["auto", (page, say) => page.getByRole("button", { name: say("segments.auto"), exact: true }).click()],
  ...["recent", "export", "print", "notation"].map((item) => /** @type {[string, (page: Page, say: typeof en) => Promise<unknown>]} */ ([
    item,
    async (page, say) => {
      await page.getByRole("button", { name: say("header.files"), exact: true }).click();
      await page.getByRole("menuitem", { name: say(`header.${item}`), exact: true }).click();
    },
  ])),
];

for (const [locale, say] of /** @type {const} */ ([["en-GB", en], ["es-ES", es]])) {
  test(`a part that cannot come says so beside its button, with a way to reload (${locale})`, async (t) => {
    const { page, complaints } = await openThenCut(t, { locale });
    const missing = page.locator(".missing-part");
    for (const [name, press] of PARTS) {
      await press(page, say);
      await missing.waitFor();
      assert((await missing.innerText()).includes(say("demand.missing")), name);
      assert(await missing.getByRole("button", { name: say("demand.reload"), exact: true }).isVisible(), name);
      await page.keyboard.press("Escape");
      await missing.waitFor({ state: "hidden" });
    }
    forgiveLoads(complaints);
  });
}

test("the reload that is offered loads the page again, with its design", async (t) => {
  const { page, complaints } = await openPage(t, { fragment: LINKS.R1 });
  await page.route("**/part-*.js", (route) => route.abort());
  await page.getByRole("button", { name: en("header.examples"), exact: true }).click();
  const reload = page.locator(".missing-part").getByRole("button", { name: en("demand.reload"), exact: true });
  await reload.waitFor();
  await page.unroute("**/part-*.js");
  await Promise.all([page.waitForEvent("load"), reload.click()]);
  await becomes(() => page.title(), /R1/);
  forgiveLoads(complaints);
});

test("a browser that is never idle still keeps recent designs, learns the other language and takes dropped files", async (t) => {
  const { page } = await openPage(t, { ready: false });
  await page.addInitScript(neverIdle);
  await page.reload();
  await field(page, "base_radius").fill("44");
  await becomes(() => fragment(page), /\.R44_7/);
  await eventually(() => page.evaluate(() => Object.keys(localStorage).filter((key) => key.startsWith("levalab:recent:")).length), (count) => assert.equal(count, 1));
  const loaded = () => page.evaluate(() => performance.getEntriesByType("resource").map(({ name }) => name.split("/").at(-1) ?? "").filter((name) => name.startsWith("page.")));
  await eventually(loaded, (names) => assert.equal(names.length, 2, names.join()));
  const design = JSON.stringify({ ...JSON.parse(await page.evaluate(() => localStorage.getItem("levalab:design") ?? "")), title: "Dropped" });
  await page.evaluate((design) => {
    const data = new DataTransfer();
    data.items.add(new File([design], "dropped.lev.json", { type: "application/json" }));
    dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  }, design);
  await becomes(() => page.title(), /^Dropped/);
});
