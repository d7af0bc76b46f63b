// For everyone: axe finds nothing in any state, everything has a name, and what is drawn is also said.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  LINKS, announced, baseRadiusCure, becomes, beta, diagram, en, es, eventually, field, findings, frames, inkOf, level, mechanism, openExample, openStill, unfoldFindings, violations,
} from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

/** A polynomial through nine conditions. */
const CONDITIONS = "1.Example_R6.R2_1uiw12.566op_30_.75p0p56.88_110.27p123.84_79.35p198.72_106.71p256.32N256.32s0v0a0s56.88_1.177s123.84_.847s198.72_1.139s256.32v256.32a256.32D103.68.0WiuYM";

test("axe finds nothing on the page as it opens, with findings, with an error, after a damaged link", async (t) => {
  /** @type {string[]} */
  const found = [];
  const { page } = await openStill(t);
  found.push(...(await violations(page, "start")));
  await openExample(page, "R1");
  await becomes(() => baseRadiusCure(page).count(), 1);
  found.push(...(await violations(page, "not acceptable")));
  await field(page, "base_radius").fill("-5");
  await becomes(() => level(page), "stopped");
  await beta(page, 1).fill("1.2.3");
  found.push(...(await violations(page, "error")));
  await page.evaluate(() => void (location.hash = "#1.damaged.abc"));
  await page.getByRole("alert").getByRole("textbox").waitFor();
  found.push(...(await violations(page, "damaged link")));
  assert.deepEqual(found, []);
});

test("axe finds nothing in the menus, the help, the tabs and the layers", async (t) => {
  /** @type {string[]} */
  const found = [];
  const { page } = await openStill(t);
  await page.getByRole("button", { name: en("segments.actions", { number: 3 }), exact: true }).click();
  found.push(...(await violations(page, "menu of a segment")));
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: en("header.files"), exact: true }).click();
  found.push(...(await violations(page, "menu of files")));
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: en("header.help"), exact: true }).click();
  found.push(...(await violations(page, "help")));
  await page.keyboard.press("Escape");
  await page.locator("#mechanism summary").click();
  await page.getByRole("radio", { name: /ρ/ }).check({ force: true });
  found.push(...(await violations(page, "layers and ρ")));
  assert.deepEqual(found, []);
});

test("axe finds nothing in the dark, in Spanish, right or wrong", async (t) => {
  /** @type {string[]} */
  const found = [];
  const { page } = await openStill(t, { colorScheme: "dark", locale: "es-ES", fragment: LINKS.R1 });
  await becomes(() => baseRadiusCure(page).count(), 1);
  found.push(...(await violations(page, "dark")));
  await field(page, "base_radius").fill("x");
  await beta(page, 1, es).fill("400");
  await becomes(() => level(page), "stopped");
  found.push(...(await violations(page, "dark, wrong")));
  await page.getByRole("button", { name: es("header.help"), exact: true }).click();
  found.push(...(await violations(page, "dark, help")));
  assert.deepEqual(found, []);
});

test("axe finds nothing on a phone and on a projector", async (t) => {
  /** @type {string[]} */
  const found = [];
  const phone = await openStill(t, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, fragment: LINKS.R1 });
  found.push(...(await violations(phone.page, "phone")));
  await unfoldFindings(phone.page);
  await becomes(() => baseRadiusCure(phone.page).count(), 1);
  found.push(...(await violations(phone.page, "phone, findings")));
  await phone.page.setViewportSize({ width: 1920, height: 1080 });
  await phone.page.keyboard.press("p");
  found.push(...(await violations(phone.page, "projector")));
  assert.deepEqual(found, []);
});

test("axe finds nothing in the table of conditions and in Auto, and no target is small", async (t) => {
  /** @type {string[]} */
  const found = [];
  /** @param {Page} page @param {string} selector */
  const small = (page, selector) =>
    page.locator(selector).evaluateAll((all) =>
      all.filter((one) => one.checkVisibility()).map((one) => ({ one, rect: one.getBoundingClientRect() })).filter(({ rect }) => rect.width < 23.9 || rect.height < 23.9 || rect.right > innerWidth)
        .map(({ one, rect: { width, height } }) => `${one.getAttribute("aria-label") ?? one.textContent}: ${width}×${height}`));
  const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, colorScheme: /** @type {const} */ ("dark"), locale: "es-ES" };
  for (const { say, ...options } of [{ say: en }, { ...phone, say: es }]) {
    const { page } = await openStill(t, { fragment: CONDITIONS, ...options });
    await page.locator(".conditions").waitFor();
    found.push(...(await violations(page, "conditions")), ...(await small(page, ".conditions :is(button, input)")));
    await page.getByRole("button", { name: say("segments.auto"), exact: true }).click();
    await page.locator("#auto li").first().waitFor();
    found.push(...(await violations(page, "auto")), ...(await small(page, "#auto :is(button, select, input[type=text])")));
    // Every kind of requirement on the diagram, and none.
    for (const kind of ["line", "point"]) {
      await page.locator(`#auto [name="auto-tool"][value="${kind}"]`).check({ force: true });
      await page.getByRole("button", { name: say("auto.add"), exact: true }).click();
    }
    await page.locator("#auto [data-kind=point] .auto-whole").focus();
    found.push(...(await violations(page, "auto, drawn")), ...(await small(page, "#auto :is(button, select, input[type=text])")));
    await page.getByRole("button", { name: say("auto.none"), exact: true }).click();
    found.push(...(await violations(page, "auto, empty")));
  }
  assert.deepEqual(found, []);
});

test("every control and every canvas has a name", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.R1 });
  await becomes(() => baseRadiusCure(page).count(), 1);
  await page.locator("#mechanism summary").click();
  const devtools = await page.context().newCDPSession(page);
  const { nodes } = await devtools.send("Accessibility.getFullAXTree");
  const named = /^(button|textbox|searchbox|spinbutton|slider|combobox|listbox|radio|checkbox|link|menuitem|tab|image|img|canvas|dialog|group|region|list)$/i;
  const nameless = nodes
    .filter(({ ignored, role, name }) => !ignored && named.test(role?.value ?? "") && !name?.value?.trim())
    .map(({ role, properties }) => `${role?.value} ${JSON.stringify(properties?.map((property) => property.name))}`);
  assert.deepEqual(nameless.filter((found) => !/^(list|group|region) /.test(found)), []);
  assert(nodes.filter(({ role }) => role?.value === "combobox").length >= 5, "the tree has no controls");
  const canvases = await page.locator("canvas").evaluateAll((all) => all.filter((canvas) => canvas.checkVisibility()).map((canvas) => canvas.getAttribute("aria-label") ?? ""));
  assert(canvases.length >= 6);
  for (const name of canvases) assert(name.length > 10, `a canvas is called "${name}"`);
  assert.equal(new Set(canvases).size, canvases.length, "two canvases have the same name");
});

test("what the diagrams show is said in numbers, with their units and places", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const said = async (/** @type {import("./user.js").Diagram} */ name) => (await diagram(page, name).getAttribute("aria-label")) ?? "";
  await becomes(() => said("s"), /from 0\smm to 10\smm/);
  await becomes(() => said("v"), /from −[\d.]+\smm\/rad to [\d.]+\smm\/rad; least at [\d.]+°, greatest at [\d.]+°/);
  await becomes(() => said("a"), /mm\/rad²/);
  await becomes(() => said("j"), /mm\/rad³/);
  await page.getByRole("radio", { name: /φ/ }).check({ force: true });
  await becomes(() => said("pressure_angle"), /from −28\.18° to 24\.68°/);
  await page.getByRole("radio", { name: /SVAJ/ }).check({ force: true });
  await page.getByRole("radio", { name: new RegExp(en("diagram.per.second")) }).check({ force: true });
  await field(page, "speed").fill("2");
  await eventually(() => said("v"), (text) => assert.match(text, /mm\/s\b/));
  await becomes(() => mechanism(page).getAttribute("aria-label"), /translating roller.*35\smm.*45\smm/);
  await openExample(page, "2RO");
  await becomes(async () => (await mechanism(page).getAttribute("aria-label")) ?? "", /oscillating roller.*40\smm/);
});

test("a curvature that goes to infinity is said with the numbers that there are", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.R1 });
  await page.getByRole("radio", { name: /ρ/ }).check({ force: true });
  const said = (await diagram(page, "rho").getAttribute("aria-label")) ?? "";
  assert.doesNotMatch(said, /from ∞ to ∞/);
  assert.match(said, /\d\sm\b/, "no radius is told");
});

test("a changed verdict is announced once the hands are still", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.R1 });
  await becomes(() => baseRadiusCure(page).count(), 1);
  await baseRadiusCure(page).first().click();
  await becomes(() => announced(page), /^Not for high speeds/);
});

test("landmarks and headings lead through the page", async (t) => {
  const { page } = await openStill(t);
  assert.equal(await page.getByRole("banner").count(), 1);
  assert.equal(await page.getByRole("main").count(), 1);
  assert.equal(await page.getByRole("heading", { level: 1 }).count(), 1);
  for (const name of [en("app.design"), en("stage.title"), en("transport.title"), en("diagram.title"), en("readout.title"), en("app.verdict")]) {
    assert.equal(await page.getByRole("region", { name, exact: true }).count(), 1, name);
  }
});

test("no quantity is known by its colour alone: every curve has its own dash", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const gaps = [];
  for (const [name, colour] of /** @type {const} */ ([["s", "s"], ["v", "v"], ["a", "a"], ["j", "j"]])) {
    const { columns } = await inkOf(diagram(page, name), colour);
    const first = columns.findIndex(Boolean);
    const last = columns.findLastIndex(Boolean);
    gaps.push(columns.slice(first, last).filter((column) => !column).length);
  }
  const [full, ...dashed] = gaps;
  for (const count of dashed) assert(count > full + 10, `dashes are missing: ${gaps}`);
});

test("red, amber and green come with a shape and a word", async (t) => {
  const { page } = await openStill(t);
  const shapes = new Set();
  const words = new Set();
  for (const id of ["R1", "9RT", "2RO"]) {
    await openExample(page, id);
    await frames(page, 3);
    shapes.add(await page.locator("#verdict svg path").first().getAttribute("d"));
    words.add((await page.locator("#verdict strong").innerText()).split(/[:.]/)[0]);
  }
  await becomes(() => findings(page).count(), 0);
  assert.equal(shapes.size, 3);
  assert.equal(words.size, 3);
});

test("axe finds nothing in the comparison and in what the diagrams say", async (t) => {
  /** @type {string[]} */
  const found = [];
  for (const options of [{}, { colorScheme: /** @type {const} */ ("dark"), viewport: { width: 390, height: 844 } }]) {
    const { page } = await openStill(t, { fragment: LINKS["10EX"], ...options });
    await page.getByRole("radio", { name: /^q / }).check({ force: true });
    await page.getByLabel(en("parameters.margin")).waitFor();
    found.push(...(await violations(page, "face")));
    await page.locator("#pin").click();
    await page.locator("#legend li").waitFor();
    await openExample(page, "9RT");
    found.push(...(await violations(page, "legend")));
    await page.getByRole("button", { name: new RegExp(`^${en("header.compare")}`) }).click();
    await page.getByRole("table", { name: en("compare.table") }).waitFor();
    found.push(...(await violations(page, "slate")));
    await page.getByRole("radio", { name: en("compare.view.laws") }).check({ force: true });
    await page.getByRole("table", { name: en("compare.laws.table") }).waitFor();
    found.push(...(await violations(page, "tournament")));
  }
  assert.deepEqual(found, []);
});
