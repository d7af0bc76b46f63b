// Room: the whole job without scrolling on a laptop, one column on a phone, nothing cut off, the verdict always in sight.
import assert from "node:assert/strict";
import { test } from "node:test";
import { LINKS, baseRadiusCure, becomes, en, field, frames, level, openStill, unfoldFindings, verdict } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

/** Two rollers on one cam, whose jumps of acceleration are tolerated. */
const BREADTH = "1.Example_5ACRT.R40_10b100h.3UpiUn";

const LAPTOP = { width: 1366, height: 768 };
const SCREEN = { width: 1920, height: 1080 };
const PHONE = { width: 390, height: 844 };

/** @param {Page} page */
const overflow = (page) =>
  page.evaluate(() => {
    const { scrollWidth, scrollHeight } = document.scrollingElement ?? document.documentElement;
    return { across: Math.max(0, Math.max(scrollWidth, document.body.scrollWidth) - innerWidth), down: Math.max(0, scrollHeight - innerHeight) };
  });

/**
 * What can be used or read but lies outside the window, and outside of anything that could be scrolled.
 * @param {Page} page
 * @param {boolean} tall  whether the page itself may be scrolled
 */
const outside = (page, tall) =>
  page.evaluate((tall) => {
    const name = (/** @type {Element} */ node) => `${node.tagName.toLowerCase()} ${node.id || node.getAttribute("aria-label") || node.textContent?.trim().slice(0, 30)}`;
    const scrolled = (/** @type {Element} */ node) => {
      for (let parent = node.parentElement; parent && parent !== document.body; parent = parent.parentElement) {
        if (/auto|scroll/.test(getComputedStyle(parent).overflowY) && parent.scrollHeight > parent.clientHeight) return true;
      }
      return false;
    };
    return [...document.querySelectorAll("button, input, select, canvas, output, h1, .headline, figcaption")]
      .filter((node) => node.checkVisibility({ visibilityProperty: true }) && !node.closest(".unseen, dialog, [popover], details:not([open])") && !node.classList.contains("unseen"))
      .filter((node) => {
        const { left, right, top, bottom } = node.getBoundingClientRect();
        if (left < -1 || right > innerWidth + 1) return true;
        return !tall && !scrolled(node) && (top < -1 || bottom > innerHeight + 1);
      })
      .map(name);
  }, tall);

/** Buttons, labels and captions whose own text does not fit into them; those with a sign instead are left out. @param {Page} page */
const cutOff = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll("button, label, legend, figcaption, output, .headline, .unit, summary, #verdict p")]
      .filter((node) => node.checkVisibility() && !node.classList.contains("unseen") && !node.querySelector(".unseen") && getComputedStyle(node, "::before").content === "none")
      .filter((node) => node.clientWidth > 0 && node.scrollWidth > node.clientWidth + 1 && getComputedStyle(node).overflowX !== "visible")
      .map((node) => node.textContent?.trim() || node.getAttribute("aria-label")),
  );

/** Lines that a text takes. @param {import("playwright-core").Locator} text */
const lines = (text) => text.evaluate((node) => Math.round(node.getBoundingClientRect().height / parseFloat(getComputedStyle(node).lineHeight)));

test("on a laptop the judgement keeps to one line, in both languages, with and without a cam", async (t) => {
  for (const [locale, fragment] of [["es-ES", LINKS["9RT"]], ["en-GB", LINKS["2RO"]]]) {
    const { page } = await openStill(t, { locale, viewport: LAPTOP, fragment });
    assert.equal(await lines(verdict(page).locator(".saying")), 1, `${locale}, acceptable or not`);
    await field(page, "base_radius").fill("-5");
    await becomes(() => level(page), "stopped");
    assert.equal(await lines(verdict(page).locator(".saying")), 1, `${locale}, stopped`);
  }
  // The longest of all, beside the most figures.
  for (const locale of ["es-ES", "en-GB"]) {
    const { page } = await openStill(t, { locale, viewport: LAPTOP, fragment: BREADTH });
    await becomes(() => level(page), "acceptable");
    assert.equal(await lines(verdict(page).locator(".saying")), 1, `${locale}, constant breadth`);
  }
});

/** Sections that lie over one another. @param {Page} page */
const overlapping = (page) =>
  page.evaluate(() => {
    const parts = [...document.querySelectorAll("#header, main > section")].filter((node) => node.checkVisibility());
    return parts.flatMap((one, i) =>
      parts.slice(i + 1).flatMap((other) => {
        const [a, b] = [one.getBoundingClientRect(), other.getBoundingClientRect()];
        const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
        const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
        return across > 1 && down > 1 ? [`${one.id} and ${other.id}`] : [];
      }),
    );
  });

/** Whether the light and its sentence are in the window. @param {Page} page */
const verdictInSight = (page) =>
  page.evaluate(() => {
    const line = document.querySelector("#verdict p")?.getBoundingClientRect();
    const middle = line && document.elementFromPoint(line.left + Math.min(30, line.width / 2), line.top + line.height / 2);
    return Boolean(line && line.top >= 0 && line.bottom <= innerHeight && line.height > 8 && middle?.closest("#verdict"));
  });

for (const [viewport, locale, theme] of /** @type {const} */ ([
  [LAPTOP, "en-GB", "light"],
  [LAPTOP, "es-ES", "dark"],
  [SCREEN, "es-ES", "light"],
])) {
  test(`${viewport.width} × ${viewport.height}, ${locale}: everything is in sight without scrolling`, async (t) => {
    const { page } = await openStill(t, { viewport, locale, colorScheme: theme });
    const hidden = await page.locator("#design").evaluate(({ scrollHeight, clientHeight }) => scrollHeight - clientHeight);
    assert(hidden <= 0, `${hidden} pixels of the design panel are hidden`);
    for (const link of ["", LINKS.R1, LINKS["2RO"]]) {
      await page.evaluate((link) => void (link && (location.hash = link)), link);
      if (link === LINKS.R1) await becomes(() => baseRadiusCure(page).count(), 1);
      await frames(page);
      assert.deepEqual(await overflow(page), { across: 0, down: 0 }, link);
      assert.deepEqual(await outside(page, false), [], link);
      assert.deepEqual(await cutOff(page), [], link);
      assert.deepEqual(await overlapping(page), [], link);
      assert(await verdictInSight(page), link);
    }
  });
}

test("the header keeps all its buttons in sight at every width, at the first visit and later", async (t) => {
  for (const [firstVisit, locale] of /** @type {const} */ ([[true, "es-ES"], [false, "es-ES"], [true, "en-GB"]])) {
    const { page } = await openStill(t, { firstVisit, locale });
    if (firstVisit) await page.locator("#header .offer").waitFor();
    for (const width of [1366, 1181, 1180, 1024, 921, 920, 834, 768, 721, 720, 390, 360]) {
      await page.setViewportSize({ width, height: 800 });
      await frames(page);
      const right = await page.locator("#header").evaluate((header) => Math.max(...[...header.querySelectorAll("button")].map((button) => button.getBoundingClientRect().right)));
      assert(right <= width, `${right} of ${width}, ${locale}`);
    }
  }
});

test("the place of the cursor under the diagrams covers none of the labels of their axis", async (t) => {
  const { page } = await openStill(t, { viewport: LAPTOP });
  for (const key of ["Home", "PageUp", "End"]) {
    await page.locator(".diagram-overlay").press(key);
    await frames(page);
    const inked = await page.locator(".diagram-overlay").evaluate((overlay) => {
      if (!(overlay instanceof HTMLCanvasElement)) throw new Error("no overlay");
      const last = [...document.querySelectorAll(".diagram-canvas")].filter((canvas) => canvas.checkVisibility()).at(-1);
      const [top, bottom] = [overlay.getBoundingClientRect().top, last?.getBoundingClientRect().bottom ?? 0];
      const ratio = overlay.height / overlay.clientHeight;
      // Nothing in the line of the labels, something below it.
      const ink = (/** @type {number} */ from, /** @type {number} */ to) =>
        overlay.getContext("2d")?.getImageData(0, Math.round((from - top) * ratio), overlay.width, Math.round((to - from) * ratio)).data.filter((_, i) => i % 4 === 3).some((alpha) => alpha > 0);
      return [ink(bottom - 18, bottom - 6), ink(bottom, bottom + 8)];
    });
    assert.deepEqual(inked, [false, true], key);
  }
});

test("on a laptop the mechanism and each diagram have room, and are sharp at two pixels for one", async (t) => {
  const { page } = await openStill(t, { viewport: LAPTOP, deviceScaleFactor: 2 });
  const canvases = await page.evaluate(() =>
    [...document.querySelectorAll("canvas")].filter((canvas) => canvas.checkVisibility()).map(({ width, clientWidth, clientHeight }) => ({ width, clientWidth, clientHeight })),
  );
  assert(canvases.length >= 6, "canvases are missing");
  for (const { width, clientWidth, clientHeight } of canvases) {
    assert(clientWidth >= 300 && clientHeight >= 60, `a canvas of ${clientWidth} × ${clientHeight}`);
    assert(Math.abs(width / clientWidth - 2) < 0.02, `${width / clientWidth} pixels for one`);
  }
});

test("on a laptop a wrong number and its explanation fit too", async (t) => {
  const { page } = await openStill(t, { viewport: LAPTOP, locale: "es-ES" });
  await field(page, "base_radius").fill("-5");
  await field(page, "roller_radius").fill("1.2.3");
  await becomes(() => level(page), "stopped");
  assert.deepEqual(await overflow(page), { across: 0, down: 0 });
  assert.deepEqual(await outside(page, false), []);
  assert(await verdictInSight(page));
});

for (const locale of ["en-GB", "es-ES"]) {
  test(`phone, ${locale}: one column, the mechanism and the verdict stay while the page scrolls`, async (t) => {
    const { page } = await openStill(t, { viewport: PHONE, locale, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
    for (const link of ["", LINKS.R1]) {
      await page.evaluate((link) => void (link && (location.hash = link)), link);
      if (link) await becomes(() => level(page), "unacceptable");
      await frames(page);
      assert.equal((await overflow(page)).across, 0, link);
      assert((await overflow(page)).down > 200, "it does not scroll");
      assert.deepEqual(await outside(page, true), [], link);
      assert.deepEqual(await cutOff(page), [], link);
      for (const share of [0, 0.4, 1]) {
        await page.evaluate((share) => scrollTo(0, share * document.documentElement.scrollHeight), share);
        await frames(page);
        const box = await page.locator("#mechanism canvas").boundingBox();
        assert(box && box.y >= -1 && box.y + box.height < 0.75 * PHONE.height, `the mechanism is at ${box?.y} at ${share} of the page`);
        assert(await verdictInSight(page), `the verdict is out of sight at ${share} of the page`);
      }
      await page.evaluate(() => scrollTo(0, 0));
    }
    await unfoldFindings(page);
    await becomes(() => baseRadiusCure(page).count(), 1);
    assert.equal((await overflow(page)).across, 0, "findings");
    assert.deepEqual(await outside(page, true), [], "findings");
    assert.deepEqual(await cutOff(page), [], "findings");
  });
}

for (const [size, theme] of /** @type {const} */ ([
  [{ width: 700, height: 450 }, "light"],
  [{ width: 844, height: 390 }, "dark"],
  [{ width: 1100, height: 450 }, "light"],
])) {
  test(`a low frame or a phone on its side, ${size.width} × ${size.height}: nothing lies over anything else`, async (t) => {
    for (const locale of ["en-GB", "es-ES"]) {
      const { page } = await openStill(t, { viewport: size, locale, colorScheme: theme });
      for (const link of ["", LINKS.R1, LINKS["2RO"], LINKS["10EX"], BREADTH]) {
        await page.evaluate((link) => void (link && (location.hash = link)), link);
        await frames(page, 4);
        assert.equal((await overflow(page)).across, 0, link);
        assert.deepEqual(await outside(page, true), [], link);
        // The verdict is meant to stay in sight over what scrolls under it.
        assert.deepEqual((await overlapping(page)).filter((pair) => !pair.includes("verdict")), [], link);
        assert(await verdictInSight(page), link);
        const lost = await page.evaluate(() =>
          [["#mechanism .stage-bar", "#mechanism"], ["#mechanism canvas", "#mechanism"], [".diagram-plots", "#diagrams"], ["#verdict", "body"]].filter(([part, whole]) => {
            const [inner, outer] = [document.querySelector(part ?? "")?.getBoundingClientRect(), document.querySelector(whole ?? "")?.getBoundingClientRect()];
            return !inner || !outer || inner.height < 20 || inner.top < outer.top - 1 || inner.bottom > outer.bottom + 1;
          }),
        );
        assert.deepEqual(lost, [], link);
        if (size.width > 1080) continue;
        // Picture and what moves it are in the window together.
        const [canvas, play] = [await page.locator("#mechanism canvas").boundingBox(), await page.locator("#transport .transport-play").boundingBox()];
        const verdictTop = await verdict(page).evaluate((node) => node.getBoundingClientRect().top);
        assert(canvas && canvas.height >= 150 && canvas.y >= 0, `the picture is ${canvas?.height} high`);
        assert(play && play.y + play.height <= verdictTop + 1, "the transport is under the verdict");
      }
    }
  });
}

test("on a phone every control is large enough for a finger", async (t) => {
  const { page } = await openStill(t, { viewport: PHONE, hasTouch: true, isMobile: true });
  const small = await page.evaluate(() =>
    [...document.querySelectorAll("button, input:not(.unseen), select, summary")]
      .filter((node) => node.checkVisibility() && !node.classList.contains("unseen"))
      .map((node) => ({ name: node.id || node.getAttribute("aria-label") || node.textContent, height: node.getBoundingClientRect().height, width: node.getBoundingClientRect().width }))
      .filter(({ height, width }) => height < 24 || width < 24)
      .map(({ name, height, width }) => `${name}: ${width.toFixed(0)} × ${height.toFixed(0)}`),
  );
  assert.deepEqual(small, []);
});

test("the projector view hides the design, keeps mechanism, diagrams and verdict, and enlarges the type", async (t) => {
  const { page } = await openStill(t, { viewport: SCREEN, fragment: LINKS.R1 });
  const size = () => verdict(page).evaluate((node) => parseFloat(getComputedStyle(node).fontSize));
  const before = await size();
  await page.keyboard.press("p");
  await page.getByRole("group", { name: en("design.program") }).waitFor({ state: "hidden" });
  assert((await size()) >= 1.4 * before);
  await frames(page, 3);
  assert.deepEqual(await overflow(page), { across: 0, down: 0 });
  assert.deepEqual(await outside(page, false), []);
  assert.deepEqual(await overlapping(page), []);
  assert(await verdictInSight(page));
  await page.keyboard.press("p");
  await page.getByRole("group", { name: en("design.program") }).waitFor();
});
