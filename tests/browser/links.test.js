// Links: the address always holds the design, opens what is pasted into it, and refuses what is damaged.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  LINKS, banner, becomes, en, es, eventually, field, findings, fixedPart, fragment, frames, law, level, literal, nextFragment, numberOf, openExample, openStill, program, readout, undo,
  verdict,
} from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

/** The least time between two writes of the address, and what a timer may be early, ms. */
const PAUSE = 350;
const EARLY = 5;

const GOOD = LINKS["2RO"];

/** @param {string} text @param {number} at */
const changed = (text, at) => text.slice(0, at) + (text[at] === "7" ? "8" : "7") + text.slice(at + 1);

/** Every way in which a link arrives broken. @type {Record<string, string>} */
const DAMAGED = {
  "one digit changed": GOOD.replace("S120-10", "S120-11"),
  "its first character changed": changed(GOOD, 0),
  "a character in its middle changed": changed(GOOD, Math.floor(GOOD.length / 2)),
  "its last character changed": changed(GOOD, GOOD.length - 1),
  "one character lost": GOOD.slice(0, 20) + GOOD.slice(21),
  "cut short": GOOD.slice(0, -9),
  "cut to a few characters": GOOD.slice(0, 4),
  "no checksum": GOOD.slice(0, GOOD.lastIndexOf(".")),
  "an empty checksum": GOOD.slice(0, GOOD.lastIndexOf(".") + 1),
  "of a version to come": GOOD.replace(/^1/, "2"),
  "something else altogether": "section-3_of.the-handbook",
  "percent signs and quotes": "1.%E2%82%AC%00'\"><b>x",
  "9,000 characters": `1.${"R35_7M50_10D40".repeat(643)}`.slice(0, 9000),
};

/** @param {Page} page @param {string} link */
const paste = (page, link) => page.evaluate((link) => void (location.hash = `#${link}`), link);

test("the address follows an edit, and is the design: a reload brings it back", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await field(page, "base_radius").fill("40.25");
  await law(page, 1).selectOption("cycloidal");
  await page.getByRole("textbox", { name: en("header.title") }).fill("Año 1 · ½");
  await becomes(() => page.title(), "Año 1 · ½ · LevaLab");
  const said = await verdict(page).innerText();
  const written = await eventually(
    () => fragment(page),
    (now) => assert(now.includes("40.25_7C50") && !now.includes("Example"), now),
  );
  assert.match(written, /^[\w.-]*[A-Za-z0-9]$/, "characters that chat programs cut or encode");

  await page.reload();
  await becomes(() => page.title(), "Año 1 · ½ · LevaLab");
  assert.equal(await field(page, "base_radius").inputValue(), "40.25");
  assert.equal((await program(page))[0], "cycloidal 50 10");
  assert.equal(await fragment(page), written);
  await becomes(() => verdict(page).innerText(), said);
});

test("a visit without a link finds the design as it was left", async (t) => {
  const { page, url } = await openStill(t);
  await field(page, "base_radius").fill("41");
  const link = await eventually(() => fragment(page), (now) => assert.match(now, /\.R41_7/));
  await page.goto("about:blank");
  await page.goto(url);
  await becomes(() => field(page, "base_radius").inputValue(), "41");
  await field(page, "base_radius").fill("42");
  await field(page, "base_radius").fill("41");
  await becomes(() => fragment(page), link);
});

test("during a drag the address is written no more often than every 350 ms, and at its end", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await page.evaluate(() => {
    const times = /** @type {number[]} */ ([]);
    const write = history.replaceState;
    history.replaceState = function (...given) {
      times.push(performance.now());
      return write.apply(this, given);
    };
    Object.assign(window, { writeTimes: times });
  });
  const writes = () => page.evaluate(() => /** @type {Window & { writeTimes?: number[] }} */ (window).writeTimes ?? []);
  const label = await page.locator('label[for="field-base_radius"]').boundingBox();
  assert(label);
  const [x, y] = [label.x + label.width / 2, label.y + label.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  const start = performance.now();
  let moves = 0;
  for (; performance.now() - start < 4 * PAUSE || moves < 40; moves++) {
    await page.mouse.move(x + 20 + 20 * Math.sin(moves / 5), y);
    await frames(page, 1);
  }
  const lasted = performance.now() - start;
  const during = (await writes()).length;
  await page.mouse.up();
  assert(during <= lasted / PAUSE + 1, `${during} writes in ${lasted} ms and ${moves} moves`);
  const radius = numberOf(await field(page, "base_radius").inputValue());
  await becomes(() => fragment(page), new RegExp(`\\.R${radius}_7`));
  const times = await writes();
  for (let i = 1; i < times.length; i++) {
    const gap = times[i] - times[i - 1];
    assert(gap >= PAUSE - EARLY, `two writes within ${gap} ms`);
  }
});

test("edits add nothing to the browser's history", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const length = await page.evaluate(() => history.length);
  await field(page, "base_radius").fill("50");
  const link = await nextFragment(page, LINKS["9RT"]);
  await field(page, "base_radius").fill("51");
  await nextFragment(page, link);
  assert.equal(await page.evaluate(() => history.length), length);
});

test("the copy button copies the address", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"], permissions: ["clipboard-read", "clipboard-write"] });
  // At once after an edit: the address bar may be behind, the copy may not.
  await field(page, "base_radius").fill("39");
  await page.getByRole("button", { name: en("header.share"), exact: true }).click();
  await page.getByRole("button", { name: en("header.share.done"), exact: true }).waitFor();
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  assert.match(copied, /#1\.Example_9RT\.R39_7/);
  await becomes(() => page.evaluate(() => location.href), copied);
});

test("without a clipboard the link is there to be copied by hand", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await page.evaluate(() => Object.defineProperty(navigator, "clipboard", { value: { writeText: () => Promise.reject(new Error("denied")) } }));
  await page.getByRole("button", { name: en("header.share"), exact: true }).click();
  const manual = page.getByRole("textbox", { name: en("header.share.manual") });
  await manual.waitFor();
  await becomes(() => manual.inputValue(), await page.evaluate(() => location.href));
});

for (const [how, link] of Object.entries(DAMAGED)) assert.notEqual(link, GOOD, how);

test("a damaged link pasted into the address is told, kept to be copied, and what was there stays", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const first = await verdict(page).innerText();
  await field(page, "base_radius").fill("38");
  await nextFragment(page, LINKS["9RT"]);
  await eventually(() => verdict(page).innerText(), (now) => assert.notEqual(now, first));
  const sight = async () => [await verdict(page).innerText(), await program(page), await field(page, "base_radius").inputValue(), await page.title()];
  const had = await eventually(sight, ([, , radius]) => assert.equal(radius, "38"));
  for (const [how, link] of Object.entries(DAMAGED)) {
    await paste(page, link);
    const arrived = await fragment(page);
    await becomes(() => banner(page).getByRole("textbox").inputValue().catch(() => ""), arrived);
    const told = await banner(page).innerText();
    assert(told.includes(fixedPart(en, "banner.link", "reason")), `${how}: "${told}"`);
    await becomes(sight, had);
    await banner(page).getByRole("button", { name: en("banner.close"), exact: true }).click();
    await becomes(() => banner(page).innerText(), "");
  }
  // The page is alive, and its next edit is written over the broken address.
  await field(page, "base_radius").fill("39");
  await becomes(() => fragment(page), /^1\.Example_9RT\.R39_7/);
});

test("a damaged link opened first is told, and what this browser had is offered", async (t) => {
  const { page, url } = await openStill(t);
  await openExample(page, "10EX");
  await becomes(() => fragment(page), LINKS["10EX"]);
  for (const how of ["one digit changed", "cut short", "an empty checksum", "9,000 characters"]) {
    await page.goto("about:blank");
    await page.goto(`${url}#${DAMAGED[how]}`);
    await becomes(() => banner(page).getByRole("textbox").inputValue().catch(() => ""), DAMAGED[how]);
    assert.equal(await page.title(), "Example 10EX · LevaLab", how);
    assert.equal(await fragment(page), DAMAGED[how], "the damaged link stays in the address until the first edit");
  }
  await field(page, "base_radius").fill("77");
  await becomes(() => fragment(page), /^1\.Example_10EX\.F77/);
});

test("the reason why a link is damaged is in the page's language", async (t) => {
  const { page } = await openStill(t, { fragment: DAMAGED["one digit changed"], locale: "es-ES" });
  await becomes(() => banner(page).innerText(), new RegExp(`enlace.*${literal(fixedPart(es, "banner.link", "reason"))}`));
  await page.getByRole("button", { name: "EN", exact: true }).click();
  await becomes(() => banner(page).innerText(), new RegExp(`link.*${literal(fixedPart(en, "banner.link", "reason"))}`));
});

test("a good link pasted into the address opens, and undo brings back what was there", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await field(page, "base_radius").fill("38");
  const mine = await nextFragment(page, LINKS["9RT"]);
  await paste(page, GOOD);
  await becomes(() => level(page), "acceptable");
  assert.equal(await page.title(), "Example 2RO · LevaLab");
  assert.equal(await findings(page).count(), 0);
  assert.equal(await banner(page).innerText(), "");
  await undo(page).click();
  await becomes(() => field(page, "base_radius").inputValue(), "38");
  await becomes(() => fragment(page), mine);
});

test("a good link after a damaged one takes the complaint away", async (t) => {
  const { page } = await openStill(t, { fragment: DAMAGED["cut short"] });
  assert.notEqual(await banner(page).innerText(), "");
  await paste(page, LINKS.R1);
  await becomes(() => banner(page).innerText(), "");
  await becomes(() => level(page), "unacceptable");
  assert.equal(await readout(page, "theta").textContent(), "0.0");
});

test("the back button leads back to the link before", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await paste(page, GOOD);
  await becomes(() => page.title(), "Example 2RO · LevaLab");
  await page.goBack();
  await becomes(() => page.title(), "Example 9RT · LevaLab");
});

test("a title from a link is text and nothing else", async (t) => {
  const { page } = await openStill(t);
  const title = page.getByRole("textbox", { name: en("header.title") });
  await title.fill("<img src=x onerror=alert(1)>");
  await becomes(() => page.title(), "<img src=x onerror=alert(1)> · LevaLab");
  const link = await eventually(() => fragment(page), (now) => assert(now.includes("onerror"), now));
  await page.goto("about:blank");
  await page.goBack();
  await becomes(() => fragment(page), link);
  await becomes(() => title.inputValue(), "<img src=x onerror=alert(1)>");
  assert.equal(await page.locator("img").count(), 0);
});

/** Ways in which programs pass on a link, without a character lost. @type {Record<string, string>} */
const MANGLED = {
  encoded: GOOD.replaceAll(/[._-]/g, (c) => `%${c.charCodeAt(0).toString(16).toUpperCase()}`),
  "behind a slash": `/${GOOD}`,
  "escaped for Markdown": GOOD.replaceAll("_", String.raw`\_`),
  "in angle brackets": `<${GOOD}>`,
  "with a tail": `${GOOD}&fbclid=IwAR0`,
  "at the end of a sentence": `${GOOD}).`,
  "twice in a row": GOOD + GOOD,
};

test("a link that was mangled on the way opens, and the address is the link again", async (t) => {
  const { page, url } = await openStill(t);
  for (const [how, link] of Object.entries(MANGLED)) {
    await page.goto("about:blank");
    await page.goto(`${url}#${LINKS["9RT"]}`);
    await becomes(() => page.title(), "Example 9RT · LevaLab");
    await paste(page, link);
    await becomes(() => page.title(), "Example 2RO · LevaLab");
    await becomes(() => fragment(page), GOOD);
    assert.equal(await banner(page).innerText(), "", how);
  }
});

test("a link behind a question mark opens, the address has it behind #, and the page says that the server saw it", async (t) => {
  const { page, url } = await openStill(t);
  await page.goto(`${url}?${GOOD}&utm_source=mail`);
  await becomes(() => page.title(), "Example 2RO · LevaLab");
  await becomes(() => page.evaluate(() => [location.search, location.hash]), ["", `#${GOOD}`]);
  assert.match(await banner(page).innerText(), /the design did reach the server/);
  await page.getByRole("button", { name: "ES", exact: true }).click();
  await becomes(() => banner(page).innerText(), /el diseño sí llegó al servidor/);
  await page.reload();
  await becomes(() => page.title(), "Example 2RO · LevaLab");
  assert.equal(await banner(page).innerText(), "");

  await page.goto("about:blank");
  await page.goto(`${url}?${LINKS.R1}#${GOOD}`);
  await becomes(() => page.title(), "Example 2RO · LevaLab");
  assert.equal(await banner(page).innerText(), "", "the fragment wins");
  await page.goto("about:blank");
  await page.goto(`${url}?utm_source=mail`);
  await becomes(() => page.title(), "Example 2RO · LevaLab");
  assert.equal(await banner(page).innerText(), "", "another query is none of its business");
});

test("a damaged link behind a question mark is told and kept to be copied", async (t) => {
  const { page, url } = await openStill(t);
  const link = DAMAGED["one digit changed"];
  await page.goto(`${url}?${link}`);
  await becomes(() => banner(page).getByRole("textbox").inputValue().catch(() => ""), link);
  await field(page, "base_radius").fill("41");
  await becomes(() => fragment(page), /R41_/);
  assert.equal(await page.evaluate(() => location.search), "");
});

/** A segment of a table, which a design with many digits is pasted into. */
const TABLE = "1.table.R40_10L180p0p45_.9p90_5p135_9.1p180_10L180_0_.02p0_10p45_9.08p90_5.03p135_.93p180.4C60MS";

test("a design too long for a link takes the former one out of the address at once, and says so", async (t) => {
  const { page } = await openStill(t, { fragment: TABLE });
  await field(page, "base_radius").fill("41");
  const former = await nextFragment(page, TABLE);
  const points = page.getByRole("textbox", { name: en("free.points", { number: 1 }), exact: true });
  const noise = (/** @type {number} */ k) => (k === 0 ? 0 : k === 720 ? 10 : k / 72 + (1 + Math.sin(k * k)) * 1e-3);
  const table = Array.from({ length: 721 }, (_, k) => `${k / 4} ${noise(k).toFixed(12)}`).join("\n");
  // All at once: `fill` would type 721 lines, one event each.
  await points.evaluate((area, text) => {
    if (area instanceof HTMLTextAreaElement) area.value = text;
    area.dispatchEvent(new InputEvent("input", { bubbles: true, inputType: "insertText" }));
  }, table);
  await becomes(() => page.evaluate(() => location.href.includes("#")), false);
  await becomes(() => banner(page).innerText(), new RegExp(literal(en("banner.long"))));
  assert(await page.getByRole("button", { name: en("header.share"), exact: true }).isDisabled());
  await page.reload();
  await becomes(() => field(page, "base_radius").inputValue(), "41");
  await becomes(() => points.inputValue().then((text) => text.split("\n").length), 721);
  await points.fill("0 0\n90 5.5\n180 10");
  await becomes(() => fragment(page), /\.R41_10L180p0p90_5\.5p180_10L180/);
  await becomes(() => banner(page).innerText(), "");
  assert.notEqual(await fragment(page), former);
});
