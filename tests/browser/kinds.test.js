// Every kind of cam and pairs of cams, as they are chosen, edited, drawn and taken back.
import assert from "node:assert/strict";
import { test } from "node:test";
import { becomes, en, eventually, field, fragment, frames, level, literal, mechanism, numberOf, openExample, openStill, picture, program, readout, findings, undo, unfoldFindings, verdict, violations } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

const LINKS = {
  breadth: "1.harmonic_flat.F40b100h.4ThtCJ",
  arcs: "1.circular-0jarc_flat.F49.2b100a7.28VFsX",
  mirror: "1.mirror_flat.F40b100mC120_20D60.20TJmK",
  roller: "1.7CRT.R170_10kd380_10S36_20S36-20S36_20S36-20S36_20S36-20S36_20S36-20S36_20S36-20.11DfvS",
  flat: "1.8DA.F100kd225Hd180_25Hd180-25.2vQwwj",
  arms: "1.OR_pair.A50_10_80_100ka86S110_9D40C140-9D70.40eCk6",
  wedge: "1.Wedge.R0_8w50t150C60_20D30C60-12.197YKJ",
  groove: "1.Groove.R50_8gC120_20D60C120-20D60.2v56q6",
  impossible: "1.11RO.A40_10_80_80D90S90_25S45-10S45_10S90-25.08CBcN",
};

/** @param {Page} page */
const kind = (page) => page.locator("#field-kind");
/** @param {Page} page */
const addSecond = (page) => page.getByRole("button", { name: en("pair.add") });
/** @param {Page} page */
const removeSecond = (page) => page.getByRole("button", { name: en("pair.remove") });

/**
 * Moves the cursor to a share of what it runs through.
 * @param {Page} page
 * @param {number} share
 */
async function moveTo(page, share) {
  await page.locator("#transport-scrub").evaluate((scrub, part) => {
    if (!(scrub instanceof HTMLInputElement)) throw new Error("no scrubber");
    scrub.value = String(Number(scrub.max) * part);
    scrub.dispatchEvent(new Event("input"));
  }, share);
  await frames(page);
}

for (const [name, link] of Object.entries(LINKS)) {
  test(`${name}: it opens by its link, moves, and leaves as the same link`, async (t) => {
    const { page } = await openStill(t, { fragment: link });
    await eventually(() => mechanism(page).getAttribute("aria-label"), (said) => assert.ok(said));
    assert.equal(await fragment(page), link);
    assert.notEqual(await level(page), "stopped");
    await moveTo(page, 0.1);
    await eventually(() => picture(mechanism(page)), (seen) => assert.notEqual(seen, 0));
    const before = await picture(mechanism(page));
    await moveTo(page, 0.3);
    await eventually(() => picture(mechanism(page)), (after) => assert.notEqual(after, before, "nothing moved"));
    assert.deepEqual(await violations(page, name), []);
  });
}

test("a cam of constant breadth: its rule, its motion that follows, its breadth throughout", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.breadth });
  const rule = page.locator(".breadth .rule");
  await becomes(() => rule.textContent(), /100 − 2·40 = 20\s?mm/);
  await becomes(() => page.locator(".ready li").count().then(String), "4");
  await becomes(() => verdict(page).locator(".figures").textContent(), new RegExp(literal(en("verdict.figure.breadth", { value: "100\u00a0mm" }))));
  await becomes(() => verdict(page).locator(".tolerated").count().then(String), "1");
  await field(page, "breadth").fill("104");
  await becomes(() => rule.textContent(), /104 − 2·40 = 24\s?mm/);
  await becomes(() => page.locator(".ready li").first().textContent(), /24\s?mm/);
  await field(page, "breadth").fill("70");
  await becomes(() => page.locator("#field-breadth-error").textContent(), /80/);
  await undo(page).click();
  await page.locator("#field-generator").selectOption("circular-arc");
  await page.locator("#field-sides").selectOption("5");
  await becomes(() => level(page), "acceptable");
  await page.locator("#field-generator").selectOption("mirror");
  await becomes(() => page.locator(".closing .sum").textContent(), en("segments.closed", { whole: "180°" }));
  await becomes(() => level(page), "acceptable");
});

test("every kind can be reached from every other, is a good cam, and undo gives the old one back", async (t) => {
  const { page } = await openStill(t);
  const kinds = ["grooved", "constant-breadth", "translating", "rotating", "constant-breadth", "grooved", "translating", "constant-breadth", "rotating"];
  const links = [await fragment(page)];
  for (const next of kinds) {
    await kind(page).selectOption(next);
    await eventually(() => fragment(page), (link) => assert.notEqual(link, links.at(-1)));
    assert.notEqual(await level(page), "stopped", next);
    links.push(await fragment(page));
  }
  for (const link of links.slice(0, -1).toReversed()) {
    await undo(page).click();
    await becomes(() => fragment(page), link);
  }
});

test("a second cam comes and goes with a click, is judged, and keeps the first", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.roller });
  const with2 = await fragment(page);
  await becomes(() => field(page, "pair-distance").inputValue(), "380");
  await removeSecond(page).click();
  await eventually(() => fragment(page), (link) => assert.doesNotMatch(link, /kd380/));
  const alone = await program(page);
  await addSecond(page).click();
  await becomes(() => field(page, "pair-distance").inputValue(), "380");
  assert.deepEqual(await program(page), alone);
  await undo(page).click();
  await undo(page).click();
  await becomes(() => fragment(page), with2);
  await moveTo(page, 0.02);
  const first = numberOf(await readout(page, "s").textContent());
  await page.getByRole("radio", { name: en("diagram.cam.second") }).check({ force: true });
  await becomes(async () => (numberOf(await readout(page, "s").textContent()) + first).toFixed(2), "20.00");
});

test("a pair too close says so and gives what works; where none is possible the page says why", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.roller });
  await field(page, "pair-distance").fill("150");
  await becomes(() => level(page), "stopped");
  await becomes(() => page.locator("#field-pair-distance-error").textContent(), /\d/);
  const advice = page.locator(".pair .cure");
  await becomes(() => advice.textContent(), /380/);
  await advice.click();
  await becomes(() => level(page), "acceptable");
  await page.goto(`${page.url().split("#")[0]}#${LINKS.impossible}`);
  await eventually(() => fragment(page), (link) => assert.equal(link, LINKS.impossible));
  await addSecond(page).click();
  await becomes(() => page.locator(".pair > .error").textContent(), /the nearest to one is 100\.5°.*The pressure angle reaches 51\.5° at 135°.*would cut 11\.81\smm deep/);
  assert.equal(await fragment(page), LINKS.impossible);
});

test("a cure of the second cam is applied with a click, and undo takes it back", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.roller });
  await field(page, "pair-distance").fill("250");
  await becomes(() => level(page), "unacceptable");
  const before = await fragment(page);
  await unfoldFindings(page);
  const ofSecond = findings(page).filter({ hasText: en("verdict.cam", { number: 2, text: "" }).trim() });
  const cure = ofSecond.locator("button.cure").first();
  await cure.waitFor();
  const told = await findings(page).allTextContents();
  await cure.click();
  await eventually(() => findings(page).allTextContents(), (now) => assert.notDeepEqual(now, told, "nothing changed"));
  await eventually(() => fragment(page), (link) => assert.notEqual(link, before));
  await undo(page).click();
  await becomes(() => findings(page).allTextContents(), told);
});

test("a wedge opened while the cursor stands at its start tells its place as a length", async (t) => {
  const { page } = await openStill(t);
  await openExample(page, "WEDGE");
  await becomes(() => page.getByRole("textbox", { name: en("transport.place") }).inputValue(), /mm$/);
});

test("the cursor of a wedge is a length that ends where the wedge does, and the clock turns it round", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS.wedge });
  const place = page.getByRole("textbox", { name: en("transport.place") });
  await place.fill("149");
  await place.press("Enter");
  await place.blur();
  await becomes(() => readout(page, "theta").textContent(), /^149/);
  await page.locator("#transport-scrub").focus();
  for (let i = 0; i < 3; i++) await page.keyboard.press("ArrowRight");
  await becomes(() => readout(page, "theta").textContent(), /^150/);
  await page.getByRole("button", { name: en("transport.play") }).click();
  await eventually(() => readout(page, "theta").textContent(), (text) => assert.ok(numberOf(text) < 149, "it stays at the end"));
  await becomes(() => page.locator(".closing .sum").textContent(), en("segments.complete", { whole: "150\u00a0mm" }));
});
