// Other screens than the laptop's: the projector of a classroom, forced colours, and the verdict wherever it must not cut off a cure.
import assert from "node:assert/strict";
import { test } from "node:test";
import { drawn } from "./browser.js";
import { LINKS, becomes, cursorField, en, es, eventually, frames, openStill, picture, setCursor, unfoldFindings, violations } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

const PROJECTOR = { width: 1024, height: 768 };
const LAPTOP = { width: 1366, height: 768 };
const SCREEN = { width: 1920, height: 1080 };

/** @param {Page} page */
const inProjectorView = (page) => page.locator("html").evaluate((root) => root.hasAttribute("data-projector"));

/** @param {Page} page @param {import("./user.js").Words} [say] */
const toggles = (page, say = en) => ({
  speed: page.locator("#header").getByRole("button", { name: say("projector.speed"), exact: true }),
  values: page.locator("#header").getByRole("button", { name: say("projector.values"), exact: true }),
});

/** The projector view with all that it can show. @param {Page} page */
async function project(page) {
  await page.keyboard.press("p");
  await becomes(() => inProjectorView(page), true);
  for (const [key, shown] of [["s", "#transport-wheel"], ["v", "#readout-theta"]]) {
    if (!(await page.locator(shown).isVisible())) await page.keyboard.press(key);
    await page.locator(shown).waitFor();
  }
  await frames(page, 3);
}

/** Controls and figures that lie outside the window, in whole or in part. @param {Page} page */
const outside = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll("button, input, canvas, output, h1, .headline, .readout")]
      .filter((node) => node.checkVisibility() && !node.closest(".unseen, dialog, [popover], details:not([open])"))
      .filter((node) => {
        const { left, right, top, bottom } = node.getBoundingClientRect();
        return left < -1 || top < -1 || right > innerWidth + 1 || bottom > innerHeight + 1;
      })
      .map((node) => node.id || node.getAttribute("aria-label") || node.textContent),
  );

for (const viewport of [PROJECTOR, LAPTOP, SCREEN]) {
  test(`${viewport.width} × ${viewport.height}: the projector view keeps every control in sight, with speed and values`, async (t) => {
    for (const [locale, say] of /** @type {const} */ ([["en-GB", en], ["es-ES", es]])) {
      const { page } = await openStill(t, { viewport, locale, fragment: LINKS["9RT"] });
      await project(page);
      const end = page.locator("#header .end");
      for (const name of ["ES", "EN", say("header.projector"), say("header.help"), say("projector.speed"), say("projector.values")]) {
        const box = await end.getByRole("button", { name, exact: true }).boundingBox();
        assert(box && box.x >= 0 && box.x + box.width <= viewport.width && box.y >= 0, `${name} is out of sight`);
      }
      assert.equal(await end.getByRole("button").count(), 7, "a button of the header is missing");
      for (const tab of ["svaj", "pressure_angle", "rho"]) {
        await page.locator(`[name="diagram-tab"][value="${tab}"]`).check({ force: true });
        await frames(page, 3);
        assert.deepEqual(await outside(page), [], `${locale}, ${tab}`);
      }
      for (const name of ["s", "v", "a", "j"]) assert.equal(await page.locator(`#readout-${name}`).isVisible(), false, `${name} is no value of the diagram of ρ`);
    }
  });
}

test("Escape leaves the projector view, after whatever else is open or has been typed", async (t) => {
  const { page } = await openStill(t);
  await page.keyboard.press("p");
  await becomes(() => inProjectorView(page), true);
  await page.keyboard.press("Escape");
  await becomes(() => inProjectorView(page), false);

  await page.keyboard.press("p");
  const closings = /** @type {const} */ ([
    ["the help", () => page.keyboard.press("?"), () => page.locator("#help").isVisible()],
    ["the layers", () => page.locator("#mechanism summary").click(), () => page.locator(".stage-layers-list").isVisible()],
    ["a term", () => page.locator("#verdict .figures .mark").first().click(), () => page.locator(".card").isVisible()],
    ["a typed angle", () => cursorField(page).fill("77"), async () => (await cursorField(page).inputValue()) === "77"],
  ]);
  for (const [what, open, isOpen] of closings) {
    await open();
    await becomes(isOpen, true);
    await page.keyboard.press("Escape");
    await becomes(isOpen, false);
    assert(await inProjectorView(page), `Escape was for ${what}`);
  }
  await page.keyboard.press("Escape");
  await becomes(() => inProjectorView(page), false);
});

test("the large values are those of the chosen diagrams, and none of them moves while the cam turns", async (t) => {
  const { page } = await openStill(t, { viewport: PROJECTOR, fragment: LINKS["9RT"] });
  const small = await page.locator("#readout-s").evaluate((node) => parseFloat(getComputedStyle(node).fontSize));
  await project(page);
  const shown = () =>
    page.locator(".readout").evaluateAll((all) => all.filter((one) => one.checkVisibility()).map((one) => one.querySelector("output")?.id.replace("readout-", "")));
  assert.deepEqual(await shown(), ["theta", "s", "v", "a", "j"]);
  assert((await page.locator("#readout-s").evaluate((node) => parseFloat(getComputedStyle(node).fontSize))) >= 1.6 * small);

  /** Edges of the letters, figures and units. */
  const edges = () =>
    page.locator(".readout :is(label, output, .readout-unit)").evaluateAll((all) =>
      all.filter((one) => one.checkVisibility()).map((one) => {
        const { left, right } = one.getBoundingClientRect();
        return [Math.round(left), Math.round(right)];
      }));
  await setCursor(page, "0");
  const still = await edges();
  const texts = new Set();
  for (const theta of ["17", "47", "123.4", "211", "285", "307", "359.9"]) {
    await setCursor(page, theta);
    texts.add(await page.locator("#readout-a").textContent());
    assert.deepEqual(await edges(), still, `at ${theta}`);
  }
  assert(texts.size > 4, "the values stand still");
  for (const [tab, values] of /** @type {const} */ ([["pressure_angle", ["theta", "pressure_angle"]], ["rho", ["theta", "rho"]]])) {
    await page.locator(`[name="diagram-tab"][value="${tab}"]`).check({ force: true });
    await becomes(shown, [...values]);
  }
});

test("what the projector view shows is chosen by buttons and keys that exist in it only, and remembered", async (t) => {
  const { page } = await openStill(t, { locale: "es-ES" });
  const { speed, values } = toggles(page, es);
  assert.equal(await speed.count(), 0, "the button is there outside the projector view");
  await page.keyboard.press("v");
  await page.keyboard.press("p");
  await speed.waitFor();
  assert.equal(await values.getAttribute("aria-pressed"), "false", "the key works outside the projector view");
  await speed.click();
  await page.locator("#transport-wheel").waitFor();
  await page.keyboard.press("v");
  await page.locator("#readout-s").waitFor();
  await becomes(() => values.getAttribute("aria-pressed"), "true");
  await page.reload();
  await drawn(page);
  await page.keyboard.press("p");
  await becomes(() => inProjectorView(page), true);
  await page.locator("#transport-wheel").waitFor();
  await page.locator("#readout-s").waitFor();
  await page.keyboard.press("s");
  await page.locator("#transport-wheel").waitFor({ state: "hidden" });
  await page.locator("#header").getByRole("button", { name: es("header.help"), exact: true }).click();
  const keys = page.locator("#help .keys");
  for (const name of ["help.projector", "help.projector.shown"]) await keys.getByText(es(name), { exact: true }).waitFor();
});

/** Designs with many findings and long cures: translating and oscillating followers, a pair, a wedge. */
const HARD = [
  "1.Example_R1.R.1_.01umw1sP90_.1V90_.1P135-.2D45.116d5V",
  "1.Example_4PO.O20_0_80P40_3P40_6P40_3D60P120-12D60.26JfnP",
  "1.Example_12PO.O21.599999999999998_0_80T60_10T60-10T60_10T60-10T60_10T60-10.1vZQbI",
  "1.Example_7CRT.R85_10kd380P36_20P36-20P36_20P36-20P36_20P36-20P36_20P36-20P36_20P36-20.2sBf7P",
  "1.Wedge.R0_8w50t160D20P75_54D20P35-18D10.4AqMQn",
];

/**
 * Findings and cures that are cut off, out of reach, or not in sight though they are of the first finding.
 * @param {Page} page
 * @param {number} first  how many cures of the first finding have to be in sight
 */
const cutOff = (page, first) =>
  page.evaluate((first) => {
    const view = document.querySelector("#verdict .findings");
    const verdict = document.querySelector("#verdict");
    if (!view || !verdict || !view.checkVisibility()) return [];
    const box = view.getBoundingClientRect();
    const longer = view.scrollHeight > view.clientHeight + 1;
    /** @type {string[]} */
    const wrong = [];
    if (box.bottom > innerHeight + 1) wrong.push("the list ends below the window");
    if (longer && (!/auto|scroll/.test(getComputedStyle(view).overflowY) || getComputedStyle(view).borderBlockEndStyle === "none")) wrong.push("nothing says that there is more");
    if (longer && verdict.querySelector(".unfold")?.checkVisibility() !== true) wrong.push("it cannot be unfolded");
    let ofFirst = 0;
    const isFirst = (/** @type {number} */ index, /** @type {Element} */ button) => index === 0 && (!button.classList.contains("cure") || ++ofFirst <= first);
    for (const [index, item] of [...view.querySelectorAll("li")].entries()) {
      for (const button of item.querySelectorAll("button")) {
        const { left, right, top, bottom } = button.getBoundingClientRect();
        const say = (/** @type {string} */ what) => wrong.push(`${index}, ${button.textContent}: ${what}`);
        if (left < box.left - 1 || right > box.left + view.clientWidth + 1) say("wider than the list");
        if (button.scrollWidth > button.clientWidth + 1 || button.scrollHeight > button.clientHeight + 1) say("longer than its button");
        if (bottom - box.top + view.scrollTop > view.scrollHeight + 1) say("cannot be scrolled to");
        if (top < box.bottom - 1 && bottom > box.bottom + 1) say("cut off by the edge of the list");
        if (isFirst(index, button) && bottom > box.bottom + 1) say("out of sight, though of the first finding");
      }
    }
    return wrong;
  }, first);

/** Until the cures of the cam in sight are there. @param {Page} page */
const cured = (page) => becomes(() => page.locator("#verdict :is(.finding.pending, .cure:disabled)").count(), 0);

for (const [locale, say] of /** @type {const} */ ([["en-GB", en], ["es-ES", es]])) {
  test(`${locale}: the verdict cuts off no finding and no cure, of any example, on any screen`, { timeout: 300_000 }, async (t) => {
    const { page } = await openStill(t, { locale });
    await page.getByRole("button", { name: say("header.examples"), exact: true }).click();
    await page.locator("[data-example]").first().waitFor();
    const ids = await page.locator("[data-example]").evaluateAll((all) => all.map((one) => /** @type {HTMLElement} */ (one).dataset["example"] ?? ""));
    assert(ids.length > 15, "examples are missing");
    await page.keyboard.press("Escape");
    let cures = 0;
    for (const design of [...ids, ...HARD]) {
      if (design.includes(".")) await page.evaluate((link) => void (location.hash = link), design);
      else {
        await page.getByRole("button", { name: say("header.examples"), exact: true }).click();
        await page.locator(`[data-example="${design}"]`).click();
      }
      await frames(page);
      await cured(page);
      cures += await page.locator("#verdict .cure").count();
      for (const viewport of [LAPTOP, PROJECTOR, SCREEN]) {
        await page.setViewportSize(viewport);
        if (viewport === PROJECTOR) await unfoldFindings(page);
        await frames(page, 3);
        assert.deepEqual(await cutOff(page, design.includes(".") ? 1 : Infinity), [], `${design} at ${viewport.width} × ${viewport.height}`);
        // Folded again for the next one.
        if (viewport === PROJECTOR) await page.locator('#verdict button[aria-expanded="true"]').evaluateAll((all) => all.forEach((one) => /** @type {HTMLElement} */ (one).click()));
      }
      await page.setViewportSize(LAPTOP);
    }
    assert(cures > 20, `${cures} cures are no test`);
  });
}

// Forced colours

/** Contrast of two colours as the page computes them. @param {string} one @param {string} other */
function contrast(one, other) {
  const [a, b] = [one, other].map((colour) => {
    const [red = 0, green = 0, blue = 0] = (colour.match(/[\d.]+/g) ?? []).map((channel) => Number(channel) / 255).map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue + 0.05;
  });
  return Math.max(a, b) / Math.min(a, b);
}

/** @param {import("playwright-core").Locator} element @param {string} property */
const style = (element, property) => element.evaluate((node, property) => getComputedStyle(node).getPropertyValue(property), property);

/** @param {Page} page @param {string} colour  of the system @returns {Promise<string>} */
const systemColour = (page, colour) =>
  page.evaluate((colour) => {
    const probe = document.createElement("i");
    probe.style.color = colour;
    document.body.append(probe);
    const { color } = getComputedStyle(probe);
    probe.remove();
    return color;
  }, colour);

for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
  const forced = { forcedColors: /** @type {const} */ ("active"), colorScheme, fragment: LINKS.R1 };

  test(`forced colours, ${colorScheme}: what is chosen looks different from what is not`, async (t) => {
    const { page } = await openStill(t, forced);
    await page.locator(".transport-reverse").click();
    const pairs = {
      language: ['#header [lang="en"]', '#header [lang="es"]'],
      follower: [".follower:has(:checked)", ".follower:not(:has(:checked))"],
      diagrams: [".diagram-choice label:has(:checked)", ".diagram-choice label:not(:has(:checked))"],
      "sense of the animation": [".transport-reverse", ".transport-step"],
    };
    for (const [what, [chosen, other]] of Object.entries(pairs)) {
      const [one, two] = [page.locator(chosen).first(), page.locator(other).first()];
      const [ground, plain] = [await style(one, "background-color"), await style(two, "background-color")];
      assert(contrast(ground, plain) >= 3 || /, 0\)$/.test(plain), `${what}: ${ground} beside ${plain}`);
      assert.equal(await style(one, "forced-color-adjust"), "none", `${what}: the browser lays a plate under its text`);
      assert.equal(ground, await systemColour(page, "Highlight"), what);
      assert.equal(await style(one, "color"), await systemColour(page, "HighlightText"), what);
    }
    const segment = page.locator(".segment").nth(1);
    assert.equal(await style(segment, "outline-style"), "none");
    await segment.hover();
    assert.equal(await style(segment, "outline-style"), "solid", "the segment that is pointed at");
    await page.locator("#transport-scrub").focus();
    await page.keyboard.press("Shift+Tab");
    assert.equal(await page.evaluate(() => (document.activeElement ? parseFloat(getComputedStyle(document.activeElement).outlineWidth) : 0)), 3, "the ring of the focus");
  });

  test(`forced colours, ${colorScheme}: verdict, curves and mechanism are drawn in colours of the system`, async (t) => {
    const { page } = await openStill(t, forced);
    const [paper, ink] = [await systemColour(page, "Canvas"), await systemColour(page, "CanvasText")];
    assert.equal(await style(page.locator("#verdict .light .shape"), "fill"), ink);
    assert.equal(await style(page.locator("#verdict .light .mark"), "stroke"), paper);
    await frames(page, 3);
    // What is drawn reaches across: a cam over a fourth of its sheet, a curve over its diagram but for the values beside it and the gaps of its dashes.
    for (const [canvas, least] of /** @type {const} */ ([["#mechanism canvas", 0.25], [".diagram-s canvas", 0.8], [".diagram-j canvas", 0.5]])) {
      const { inked, strange } = await page.locator(canvas).evaluate((node, ink) => {
        const sheet = /** @type {HTMLCanvasElement} */ (node);
        const pixels = sheet.getContext("2d")?.getImageData(0, 0, sheet.width, sheet.height).data ?? new Uint8ClampedArray();
        const wanted = (ink.match(/\d+/g) ?? []).map(Number);
        const columns = new Set();
        let strange = 0;
        for (let i = 0; i < pixels.length; i += 4) {
          if (pixels[i + 3] < 200) continue;
          const [red, green, blue] = pixels.slice(i, i + 3);
          if (Math.abs(red - (wanted[0] ?? 0)) < 64) columns.add((i / 4) % sheet.width);
          // Ink, paper and their mixtures are grey in both themes of the browser.
          if (Math.max(red, green, blue) - Math.min(red, green, blue) > 12) strange++;
        }
        return { inked: columns.size / sheet.width, strange };
      }, ink);
      assert(inked >= least, `${canvas}: ${(100 * inked).toFixed(0)} % of its columns hold the colour of text`);
      assert.equal(strange, 0, `${canvas}: colours of the page's own`);
    }
    assert.deepEqual(await violations(page, `forced colours, ${colorScheme}`), []);
  });
}

test("colours that are forced, or let go, while the page is open are drawn at once", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const before = await picture(page.locator(".diagram-s canvas"));
  await page.emulateMedia({ forcedColors: "active" });
  await eventually(() => picture(page.locator(".diagram-s canvas")), (now) => assert.notEqual(now, before));
  await page.emulateMedia({ forcedColors: "none" });
  await becomes(() => picture(page.locator(".diagram-s canvas")), before);
});

test("every name of a law and of a kind of cam fits into its list, in both languages", async (t) => {
  for (const locale of ["en-GB", "es-ES"]) {
    const { page } = await openStill(t, { locale });
    for (const viewport of [PROJECTOR, LAPTOP]) {
      await page.setViewportSize(viewport);
      await frames(page);
      const long = await page.locator("select.law, #field-kind").evaluateAll((lists) => {
        const measure = document.createElement("canvas").getContext("2d");
        return lists.flatMap((list) => {
          const { fontWeight, fontSize, fontFamily, paddingInlineStart, paddingInlineEnd } = getComputedStyle(list);
          if (measure) measure.font = `${fontWeight} ${fontSize} ${fontFamily}`;
          const room = list.clientWidth - parseFloat(paddingInlineStart) - parseFloat(paddingInlineEnd);
          return [.../** @type {HTMLSelectElement} */ (list).options].map(({ text }) => text).filter((text) => (measure?.measureText(text).width ?? Infinity) > room + 0.5);
        });
      });
      assert.deepEqual([...new Set(long)], [], `${locale}, ${viewport.width}`);
    }
  }
});
