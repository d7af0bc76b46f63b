// How much of the page the browser has to look at again for a frame: held by counts out of its own trace, never by times.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage } from "./harness.js";
import { traced } from "./trace.js";
import { en, eventually, frames } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("playwright-core").Locator} Locator */

/** Elements whose style may be recalculated for one frame. The page has some 1,400. */
const MOST_RESTYLED = 60;
/** Frames of the animation that are looked at, and moves of a drag, each shown before the next. */
const ANIMATED = 60;
const MOVES = 40;
/** Pixels of a move: a step of the number. */
const STEP = 4;

const LINKS = {
  "a translating roller": "1.Example_9RT.R35_7M50_10D40C50-10D40Q50_10D40S50-10D40.3Qwl0W",
  "an oscillating roller": "1.Example_2RO.A40_10_80_80S120_10D120S120-10.0MVlhp",
  "a flat face": "1.Example_10EX.F30H180_20H180-20.1IbBNh",
  "a yoke": "1.harmonic_flat.F40b100h.4ThtCJ",
  "a pair of cams": "1.7CRT.R170_10kd380_10S36_20S36-20S36_20S36-20S36_20S36-20S36_20S36-20S36_20S36-20.11DfvS",
  "a wedge": "1.Wedge.R0_8w50t150C60_20D30C60-12.197YKJ",
  "a groove": "1.Groove.R50_8gC120_20D60C120-20D60.2v56q6",
};

/** A follower that drives a force. */
const DRIVING = "1.Example_R6.R2_1uiw12.566op_30_.75p0p56.88_110.27p123.84_79.35p198.72_106.71p256.32N256.32s0v0a0s56.88_1.177s123.84_.847s198.72_1.139s256.32v256.32a256.32D103.68.0WiuYM";

for (const [name, fragment] of Object.entries(LINKS)) {
  test(`${name}: a frame of the animation restyles few elements`, async (t) => {
    const { page } = await openPage(t, { fragment });
    await settled(page);
    const before = await readout(page).textContent();
    const made = await traced(page, () => frames(page, ANIMATED));
    assert.notEqual(await readout(page).textContent(), before, "the readouts stand still");
    assertFew(made, ANIMATED / 2);
  });

  test(`${name}: a frame of a drag restyles few elements`, async (t) => {
    const { page } = await openPage(t, { fragment, reducedMotion: "reduce" });
    await settled(page);
    const label = page.locator("#design .scrub").first();
    const input = page.locator(`#${await label.getAttribute("for")}`);
    const before = await input.inputValue();
    const drop = await take(page, label);
    const made = await traced(page, async () => {
      for (let move = 1; move <= MOVES; move++) {
        await drop.moveTo(STEP * (move <= MOVES / 2 ? move : MOVES - move));
        await frames(page, 1);
      }
      await drop.moveTo(3 * STEP);
      await frames(page, 2);
    });
    await drop.leave();
    assert.notEqual(await input.inputValue(), before, "the number did not change");
    assertFew(made, MOVES / 2);
  });
}

for (const [where, opener] of /** @type {const} */ ([["mechanism and diagrams", null], ["the application", "design.application"], ["the board to draw on", "segments.auto"]])) {
  test(`${where}: on a screen of another pixel ratio everything is drawn for that screen`, async (t) => {
    const { page } = await openPage(t, { fragment: opener === "design.application" ? DRIVING : LINKS["a translating roller"], reducedMotion: "reduce" });
    if (opener) await page.getByRole("button", { name: en(opener), exact: true }).click();
    const devtools = await page.context().newCDPSession(page);
    for (const [turn, deviceScaleFactor] of [1, 2, 1.5, 1].entries()) {
      // Size and place of the window stay.
      await devtools.send("Emulation.setDeviceMetricsOverride", { width: 1366, height: 768, deviceScaleFactor, mobile: false });
      // A ratio that is only emulated has Chromium look at the media queries again no sooner than another feature changes: one that means
      // nothing to the page.
      await page.emulateMedia({ contrast: turn % 2 ? "more" : "no-preference" });
      await eventually(() => canvases(page), (seen) => {
        assert(seen.length >= (opener ? 7 : 6), `only ${seen.length} canvases are in sight`);
        for (const { name, ratio, drawn } of seen) {
          assert(Math.abs(ratio - deviceScaleFactor) < 0.01, `${name} has ${ratio} pixels for a CSS pixel instead of ${deviceScaleFactor}`);
          assert(drawn, `${name} is blank`);
        }
      });
    }
  });
}

/**
 * The canvases in sight: their pixels for a CSS pixel, and whether anything is drawn on them.
 * @param {Page} page
 */
function canvases(page) {
  return page.locator("canvas:visible").evaluateAll((elements) =>
    elements.map((element) => {
      const canvas = /** @type {HTMLCanvasElement} */ (element);
      const pixels = canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height).data ?? new Uint8ClampedArray();
      return { name: canvas.className || canvas.ariaLabel, ratio: canvas.width / canvas.getBoundingClientRect().width, drawn: pixels.some((value) => value > 0) };
    }),
  );
}

/** @param {Page} page */
const readout = (page) => page.locator("#readout-theta");

/** Waits until all is there that comes by itself after the first drawing. @param {Page} page */
async function settled(page) {
  await page.waitForLoadState("networkidle");
  await eventually(() => page.locator(".finding.pending").count(), (count) => assert.equal(count, 0));
  await frames(page, 4);
}

/**
 * Takes a label by the middle, and lets it begin to move.
 * @param {Page} page
 * @param {Locator} label
 */
async function take(page, label) {
  await label.scrollIntoViewIfNeeded();
  const box = await label.boundingBox();
  assert(box, "the label is not in sight");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + STEP, y);
  await frames(page, 2);
  return {
    /** @param {number} by */
    moveTo: (by) => page.mouse.move(x + STEP + by, y),
    leave: () => page.mouse.up(),
  };
}

/**
 * @param {import("./trace.js").Frame[]} made
 * @param {number} fewest  frames that prove anything
 */
function assertFew(made, fewest) {
  assert(made.length >= fewest, `only ${made.length} frames were traced`);
  const counts = made.map(({ elements }) => elements);
  const worst = Math.max(...counts);
  const over = counts.filter((count) => count > MOST_RESTYLED).length;
  assert(worst <= MOST_RESTYLED, `${over} of ${counts.length} frames restyle more than ${MOST_RESTYLED} elements, one of them ${worst}`);
}
