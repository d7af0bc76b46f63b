// What the browser keeps between visits is data that anybody may have written: an old version, another page of the same host, an attacker.
// Whatever stands there, the page draws, says nothing on the console, and works.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { test } from "node:test";
import { root } from "./browser.js";
import { banner, becomes, cursor, diagram, en, eventually, field, fragment, inkOf, level, openStill, setCursor } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */
/** Texts by the name that they are kept under, without the prefix of the page. @typedef {Record<string, string>} Kept */

const GOOD = JSON.parse(await readFile(path.join(root, "examples/10EX.lev.json"), "utf8"));

/** Lists within each other. @param {number} depth */
const lists = (depth) => "[".repeat(depth) + "]".repeat(depth);
/** Objects within each other. @param {number} depth @param {string} [key] */
const objects = (depth, key = "a") => `{"${key}":`.repeat(depth) + "1" + "}".repeat(depth);
/** The good design with one field in another's place. @param {string} key @param {string} text */
const designWith = (key, text) => `{${JSON.stringify(key)}:${text},${JSON.stringify({ ...GOOD, [key]: undefined }).slice(1)}`;

const HUGE = JSON.stringify("x".repeat(500_000));
/** What has no text and no number: to ask for one throws. */
const NO_PRIMITIVE = '{"toString":1,"valueOf":2}';

/** No part of a view as the page keeps it. @type {Record<string, string>} */
const VIEWS = {
  "the name of a method": '{"constructor":1,"toString":"x","hasOwnProperty":true,"valueOf":{}}',
  "a prototype": '{"__proto__":{"polluted":true},"layers":{"__proto__":{"polluted":true},"constructor":true},"margins":{"__proto__":{"polluted":true}}}',
  "a prototype that is a number": '{"__proto__":1,"layers":{"__proto__":true},"margins":{"__proto__":3}}',
  "lists for objects": '{"layers":[true,[],null],"margins":[1,-1,[]],"language":["es"],"theme":["dark"],"tab":["rho"],"perSecond":[true]}',
  "objects for words": `{"language":${NO_PRIMITIVE},"theme":${NO_PRIMITIVE},"tab":${NO_PRIMITIVE},"perSecond":${NO_PRIMITIVE}}`,
  "objects for numbers": `{"margins":{"mm":${NO_PRIMITIVE},"in":null},"layers":{"base":${NO_PRIMITIVE}}}`,
  "lists 5,000 deep": ["language", "theme", "tab", "layers", "margins"].map((key, i) => `${i ? "," : "{"}"${key}":${lists(5000)}`).join("") + "}",
  "objects 5,000 deep": `{"margins":{"mm":${objects(5000)}},"layers":${objects(5000)}}`,
  "nothing but depth": lists(1_000_000),
  "huge words": `{"language":${HUGE},"theme":${HUGE},"tab":${HUGE},"margins":{${HUGE}:1}}`,
  "a list": "[1,2,3]",
  "a number": "7",
  "a word": '"dark"',
  "nothing": "null",
  "no JSON": "{\u0000",
};

/** No design. @type {Record<string, string>} */
const DESIGNS = {
  "a prototype": '{"__proto__":{"format":"levalab/1","polluted":true}}',
  "a good design with a prototype": designWith("__proto__", '{"polluted":true}'),
  "a good design with the name of a method": designWith("constructor", '{"prototype":{"polluted":true}}'),
  "a prototype as the cam": designWith("cam", '{"__proto__":{"kind":"disc"}}'),
  "a prototype as a segment": designWith("segments", '[{"__proto__":{"law":"cycloidal"}}]'),
  "lists 5,000 deep": lists(5000),
  "objects 5,000 deep": objects(5000),
  "objects 5,000 deep by a known name": objects(5000, "cam"),
  "segments 5,000 deep": designWith("segments", lists(5000)),
  "a follower 5,000 deep": designWith("follower", objects(5000, "kind")),
  "nothing but depth": lists(1_000_000),
  "a huge title": designWith("title", HUGE),
  "a hundred thousand segments": designWith("segments", `[${Array(100_000).fill(JSON.stringify(GOOD.segments[0])).join(",")}]`),
  "a list for the whole": "[1,2,3]",
  "a list for the cam": designWith("cam", "[1]"),
  "an object for the segments": designWith("segments", '{"0":{},"length":1}'),
  "objects for words": designWith("format", NO_PRIMITIVE),
  "another version": designWith("format", '"levalab/9"'),
  "a word": '"text"',
  "a number": "1e999",
  "nothing": "null",
};

/**
 * The page as it opens with those texts in its store.
 * @param {import("node:test").TestContext} t
 * @param {{ local?: Kept, session?: Kept }} kept
 */
async function openWith(t, { local = {}, session = {} }) {
  /** @param {Page} page */
  const prepare = (page) =>
    page.addInitScript(
      ({ local, session }) => {
        if (location.protocol === "about:") return;
        for (const [name, text] of Object.entries({ tour: "true", ...local })) localStorage.setItem(`levalab:${name}`, text);
        for (const [name, text] of Object.entries(session)) sessionStorage.setItem(`levalab:${name}`, text);
      },
      { local, session },
    );
  const { page } = await openStill(t, { prepare });
  return page;
}

/** Nothing has reached what every object inherits. @param {Page} page */
async function isUnpolluted(page) {
  const [polluted, names] = await page.evaluate(() => ["polluted" in {}, Object.keys(Object.prototype)]);
  assert.deepEqual([polluted, names], [false, []]);
}

/** An edit goes all the way through. @param {Page} page @param {RegExp} radius  in the link, of 36 */
async function works(page, radius) {
  await field(page, "base_radius").fill("36");
  await becomes(() => fragment(page), radius);
  await setCursor(page, "20");
  assert.equal(await cursor(page), 20);
  assert((await inkOf(diagram(page, "s"), "s", 60)).count > 200, "s is not drawn");
}

/** The page stands there with its own example, in its own language, and works. @param {Page} page */
async function opensUsual(page) {
  await becomes(() => field(page, "base_radius").inputValue(), "35");
  await becomes(() => level(page), "low-speed");
  assert.equal(await page.locator("html").getAttribute("lang"), "en");
  await works(page, /\.R36_7/);
  await isUnpolluted(page);
}

for (const [name, view] of Object.entries(VIEWS)) {
  test(`a kept view of another shape is passed over: ${name}`, async (t) => {
    const page = await openWith(t, { local: { view, design: JSON.stringify(GOOD) } });
    await becomes(() => field(page, "base_radius").inputValue(), "30");
    assert.equal(await page.locator("html").getAttribute("lang"), "en");
    await works(page, /\.F36H/);
    await isUnpolluted(page);
  });
}

for (const [name, design] of Object.entries(DESIGNS)) {
  test(`a kept design that is none is passed over: ${name}`, async (t) => {
    await opensUsual(await openWith(t, { local: { design }, session: { design: `{"design":${design},"fragment":""}` } }));
  });
}

test("what is right in a kept view counts, whatever stands beside it", async (t) => {
  const view = `{"__proto__":1,"language":"es","theme":"dark","constructor":[],"layers":{"toString":true,"pitch":false},"margins":{"mm":2,"in":"x"}}`;
  const page = await openWith(t, { local: { view } });
  assert.equal(await page.locator("html").getAttribute("lang"), "es");
  assert.equal(await page.locator("html").getAttribute("data-theme"), "dark");
  // What is kept from now on is the page's own again.
  await page.getByRole("button", { name: "EN", exact: true }).click();
  const kept = await eventually(
    () => page.evaluate(() => JSON.parse(localStorage.getItem("levalab:view") ?? "{}")),
    (view) => assert.equal(view.language, "en"),
  );
  assert.deepEqual(Object.keys(kept).sort(), ["language", "layers", "margins", "perSecond", "projectorSpeed", "projectorValues", "tab", "theme"]);
  assert.equal(kept.layers.pitch, false);
  assert.equal(kept.layers.base, true);
  assert(!Object.hasOwn(kept.layers, "toString"), "a layer that is none");
  assert.deepEqual(kept.margins, { mm: 2 });
});

test("the good design of the tab opens beside a bad one of all tabs", async (t) => {
  const session = { design: JSON.stringify({ design: GOOD, fragment: "" }) };
  const page = await openWith(t, { local: { design: lists(5000), view: '{"constructor":1}' }, session });
  await becomes(() => field(page, "base_radius").inputValue(), "30");
});

test("recent designs of any shape leave the good one in the list", async (t) => {
  const saved = 1.7e12;
  /** @type {Kept} */
  const recent = { "recent:good": JSON.stringify({ saved, design: GOOD }) };
  for (const [i, design] of Object.values(DESIGNS).filter((text) => text.length < 100_000).entries()) recent[`recent:bad${i}`] = `{"saved":${saved},"design":${design}}`;
  for (const [i, when] of [NO_PRIMITIVE, lists(5000), '"1e12"', "null", "[1]", "true"].entries()) recent[`recent:when${i}`] = `{"saved":${when},"design":${JSON.stringify(GOOD)}}`;
  Object.assign(recent, { "recent:": "{}", "recent:__proto__": '{"__proto__":{"polluted":true}}', "recent:deep": lists(1_000_000) });
  const page = await openWith(t, { local: recent });
  await page.getByRole("button", { name: en("header.files"), exact: true }).click();
  await page.getByRole("menuitem", { name: en("header.recent"), exact: true }).click();
  const items = page.getByRole("dialog", { name: en("recent.title") }).getByRole("listitem");
  await becomes(() => items.locator("strong").allTextContents(), [GOOD.title]);
  const names = await page.evaluate(() => Object.keys(localStorage).filter((key) => key.startsWith("levalab:recent:")));
  assert.deepEqual(names, ["levalab:recent:good"]);
  await isUnpolluted(page);
});

for (const [name, slate] of Object.entries({
  "pins of any shape": `[null,7,"x",[],${lists(5000)},{"design":${objects(5000)}},{"name":${NO_PRIMITIVE},"shown":${lists(5000)},"design":${JSON.stringify(GOOD)}},{"name":${HUGE},"design":{}}]`,
  "an object": '{"__proto__":{"polluted":true},"length":3}',
  "depth": lists(100_000),
})) {
  test(`kept pins of another shape are passed over: ${name}`, async (t) => {
    const page = await openWith(t, { local: { slate, tour: lists(5000) } });
    await page.getByRole("button", { name: en("header.compare"), exact: true }).click();
    await page.getByRole("dialog").first().waitFor();
    await page.keyboard.press("Escape");
    await opensUsual(page);
  });
}

test("a file nested 5,000 deep is refused with a sentence", async (t) => {
  const { page } = await openStill(t);
  for (const text of [lists(5000), objects(5000), designWith("segments", lists(5000)), designWith("__proto__", "{}")]) {
    await page.locator('input[type="file"]').setInputFiles({ name: "cam.lev.json", mimeType: "application/json", buffer: Buffer.from(text) });
    await eventually(() => banner(page).innerText(), (told) => assert(told.length > 20, "nothing is said"));
    await banner(page).getByRole("button", { name: en("banner.close"), exact: true }).click();
  }
  await opensUsual(page);
});
