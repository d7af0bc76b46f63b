// Help in place: question marks, the window behind ?, the guided minute, and the pages of theory, terms and manual.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { test } from "node:test";
import { root } from "./browser.js";
import { openPage } from "./harness.js";
import { LINKS, becomes, en, es, field, fragment, frames, nextFragment, violations } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

/** @param {Page} page */
const card = (page) => page.getByRole("dialog").and(page.locator(".card"));

/** Every mark in sight, by what it asks for. @param {Page} page */
const marks = (page) => page.locator("button[data-term]:visible").evaluateAll((all) => all.map((mark) => mark.getAttribute("data-term") ?? ""));

/** Laws and followers, as the page itself lists them. @param {Page} page */
async function entries(page) {
  const laws = await page.locator(".segment select.law").first().locator("option").evaluateAll((options) => options.map((option) => option.getAttribute("value") ?? ""));
  const followers = await page.locator('input[name="follower"]').evaluateAll((inputs) => inputs.map((input) => input.getAttribute("value") ?? ""));
  return { laws, followers };
}

test("every question mark opens its definition and gives the focus back", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["2RO"] });
  await page.locator("#mechanism summary").click();
  const terms = await marks(page);
  for (const needed of ["base_radius", "arm", "pivot_distance", "speed", "law", "beta", "rise", "theta", "t", "s", "v", "a", "j", "pressure_angle", "rho", "opening", "layer-base", "layer-pitch"]) {
    assert(terms.includes(needed), `${needed} has no question mark`);
  }
  for (const mark of await page.locator("button[data-term]:visible").all()) {
    await mark.focus();
    await page.keyboard.press("Enter");
    await card(page).waitFor();
    const term = await mark.getAttribute("data-term");
    assert.notEqual(await card(page).getByRole("heading").innerText(), "", `${term} has no name`);
    assert((await card(page).locator("p").first().innerText()).length > 30, `${term} says nothing`);
    assert.equal(await card(page).getByRole("link").count(), 1, `${term} leads nowhere`);
    await page.keyboard.press("Escape");
    await card(page).waitFor({ state: "hidden" });
    assert(await mark.evaluate((node) => node === document.activeElement), `the focus did not come back to ${term}`);
  }
});

test("marks of flat faces and of a law's own numbers are answered too, in both languages", async (t) => {
  const { page } = await openPage(t, { locale: "es-ES" });
  await page.getByRole("button", { name: es("header.examples"), exact: true }).click();
  await page.locator('[data-example="4PO"]').click();
  await page.locator('button[data-term="face_offset"]').waitFor();
  await page.locator(".segment select.law").first().selectOption("scca");
  for (const term of ["face_offset", "contact", "face", "sliding", "b", "c"]) {
    await page.locator(`button[data-term="${term}"]:visible`).first().click();
    await card(page).waitFor();
    assert.match(await card(page).getByRole("link").innerText(), /teoría/, term);
    await page.keyboard.press("Escape");
  }
});

test("a card shows the follower at hand with the magnitude lit, and its formula in MathML", async (t) => {
  const { page } = await openPage(t, { fragment: LINKS["2RO"] });
  await page.locator('button[data-term="pivot_distance"]').click();
  await card(page).waitFor();
  assert.equal(await card(page).locator("svg .lit[data-parameter='pivot_distance']").count(), 1);
  assert(((await card(page).locator("math").first().boundingBox())?.width ?? 0) > 5, "no formula is seen");
  const namespace = await card(page).locator("math").first().evaluate((node) => node.namespaceURI);
  assert.equal(namespace, "http://www.w3.org/1998/Math/MathML");
});

test("axe finds nothing in a card, in the window behind ? and in the guided minute, light and dark", async (t) => {
  /** @type {string[]} */
  const found = [];
  for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
    const { page } = await openPage(t, { colorScheme, firstVisit: true });
    await page.locator(".offer").waitFor();
    found.push(...(await violations(page, `${colorScheme}, offer`)));
    await page.locator('button[data-term="pressure_angle"]').first().click();
    await card(page).waitFor();
    found.push(...(await violations(page, `${colorScheme}, card`)));
    await page.keyboard.press("Escape");
    await page.keyboard.press("?");
    await page.getByRole("dialog", { name: en("help.title") }).waitFor();
    found.push(...(await violations(page, `${colorScheme}, help`)));
    await page.getByRole("button", { name: en("help.tour"), exact: true }).click();
    await card(page).waitFor();
    found.push(...(await violations(page, `${colorScheme}, tour`)));
  }
  assert.deepEqual(found, []);
});

test("the guided minute is offered once, goes on by keyboard, points at what is there, and leaves without a trace", async (t) => {
  const { page } = await openPage(t, { firstVisit: true });
  await page.getByRole("button", { name: en("tour.offer") }).click();
  const texts = new Set();
  for (let step = 1; step <= 6; step++) {
    await becomes(() => card(page).locator(".count").innerText(), en("tour.count", { step, steps: 6 }));
    texts.add(await card(page).locator(".telling").innerText());
    const [ring, box] = await Promise.all([page.locator(".tour-ring").boundingBox(), card(page).boundingBox()]);
    assert(ring && ring.width > 40 && ring.height > 15, `step ${step} points at nothing`);
    const { width, height } = page.viewportSize() ?? { width: 0, height: 0 };
    assert(box && box.x >= 0 && box.y >= 0 && box.x + box.width <= width && box.y + box.height <= height, `step ${step} is out of sight`);
    await page.keyboard.press("Enter");
  }
  assert.equal(texts.size, 6);
  await card(page).waitFor({ state: "detached" });
  assert.equal(await page.locator(".tour-ring, .offer").count(), 0);
  await page.reload();
  await frames(page, 30);
  assert.equal(await page.locator(".offer").count(), 0, "offered again");
  await page.getByRole("button", { name: en("header.help"), exact: true }).click();
  await page.getByRole("button", { name: en("help.tour"), exact: true }).click();
  await card(page).waitFor();
  await page.keyboard.press("Escape");
  await card(page).waitFor({ state: "detached" });
});

test("the cam can be used while the minute runs, on a phone too", async (t) => {
  const { page } = await openPage(t, { firstVisit: true, viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await page.getByRole("button", { name: en("tour.offer") }).click();
  for (let step = 1; step <= 5; step++) {
    const box = await card(page).boundingBox();
    assert(box && box.x >= 0 && box.y >= 0 && box.x + box.width <= 390 && box.y + box.height <= 844, `step ${step} is out of sight`);
    await card(page).getByRole("button", { name: en("tour.next"), exact: true }).click();
  }
  const before = await fragment(page);
  await field(page, "base_radius").fill("44");
  await nextFragment(page, before);
});

/** @param {Page} page @param {string} name */
const open = (page, name) => page.goto(page.url().replace(/(theory\/[^/]*|#.*)?$/, `theory/${name}.html`));

test("every law and every follower has its section in both languages, with a formula", async (t) => {
  const { page } = await openPage(t);
  const { laws, followers } = await entries(page);
  assert(laws.length >= 20 && followers.length >= 6);
  for (const language of ["en", "es"]) {
    await open(page, language);
    assert.equal(await page.locator("html").getAttribute("lang"), language);
    for (const id of [...laws, ...followers]) {
      const place = page.locator(`#${id}`);
      assert.equal(await place.count(), 1, `${id} has no section in ${language}`);
      assert((await place.locator("math").count()) > 0, `${id} has no formula in ${language}`);
      assert((await place.innerText()).length > 150, `${id} says little in ${language}`);
      assert.equal(await page.locator(`nav a[href="#${id}"]`).count(), 1, `${id} is not in the contents`);
    }
  }
});

test("axe finds nothing on the pages, and every link leads somewhere", async (t) => {
  /** @type {string[]} */
  const found = [];
  const { page } = await openPage(t, { colorScheme: "dark" });
  /** @type {Map<string, Set<string>>} */
  const places = new Map();
  /** @type {string[]} */
  const links = [];
  for (const name of ["en", "es", "terms-en", "terms-es", "manual-en", "manual-es", "licences-en", "licences-es"]) {
    await open(page, name);
    found.push(...(await violations(page, name)));
    places.set(name, new Set(await page.locator("[id]").evaluateAll((nodes) => nodes.map(({ id }) => id))));
    links.push(...(await page.locator("a[href]").evaluateAll((nodes) => nodes.map((node) => /** @type {HTMLAnchorElement} */ (node).href))));
  }
  assert.deepEqual(found, []);
  const lost = links.filter((link) => {
    const [address = "", place] = link.split("#");
    const name = path.basename(address, ".html");
    return name !== "index" && !(places.has(name) && (!place || places.get(name)?.has(decodeURIComponent(place))));
  });
  assert.deepEqual([...new Set(lost)], []);
});

test("the pages fit a phone and follow the theme", async (t) => {
  const { page } = await openPage(t, { viewport: { width: 390, height: 844 }, colorScheme: "dark" });
  for (const name of ["es", "terms-es", "manual-es", "licences-es"]) {
    await open(page, name);
    const { across, paper } = await page.evaluate(() => ({
      across: document.documentElement.scrollWidth - innerWidth,
      paper: getComputedStyle(document.body).backgroundColor,
    }));
    assert.equal(across, 0, `${name} is wider than the phone`);
    assert.notEqual(paper, "rgb(255, 255, 255)");
  }
});

test("the licences of everything that is built in are reached from the window behind ?, in both languages", async (t) => {
  const { page } = await openPage(t);
  const notices = await readFile(path.join(root, "LICENSE-THIRD-PARTY.txt"), "utf8");
  const works = notices.split("\n").filter((line) => line.startsWith("* ")).map((line) => line.slice(2));
  await page.keyboard.press("?");
  for (const [words, tongue, name] of /** @type {const} */ ([[en, "EN", "licences-en"], [es, "ES", "licences-es"]])) {
    const dialog = page.getByRole("dialog", { name: words("help.title") });
    const link = dialog.getByRole("link", { name: words("help.licences"), exact: true });
    const [opened] = await Promise.all([page.context().waitForEvent("page"), link.click()]);
    await opened.waitForLoadState();
    assert.match(opened.url(), new RegExp(`/${name}\\.html$`));
    assert.equal(await opened.locator("h1").innerText(), words("help.licences"));
    assert.deepEqual((await opened.locator(".works b").allInnerTexts()).sort(), [...works].sort());
    await opened.close();
    await page.keyboard.press("Escape");
    if (tongue === "EN") {
      await page.getByRole("button", { name: "ES", exact: true }).click();
      await page.keyboard.press("?");
    }
  }
});

test("the pages carry a policy of their own and no script but the one for the theme", async () => {
  for (const name of ["en", "terms-es", "manual-en", "licences-es"]) {
    const html = await readFile(path.join(root, process.env.LEVALAB_PAGE ?? "dist", `theory/${name}.html`), "utf8");
    assert.match(html, /default-src 'none'; script-src 'self'/);
    assert.equal(html.match(/<script/g)?.length, 1);
    assert.doesNotMatch(html, /\sstyle=|\son[a-z]+=/, "what the policy forbids");
  }
});
