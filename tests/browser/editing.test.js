// Editing: every number, law, segment and follower can be changed, what is wrong is told beside it, and everything can be undone.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  LINKS, actOnSegment, announced, becomes, beta, descriptions, diagram, en, es, eventually, field, frames, fragment, law, level, literal, mechanism, nextFragment, numberOf,
  openStill, picture, program, redo, rise, undo, verdict, violations,
} from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

const NINE = ["modified-sine 50 10", "dwell 40 0", "cycloidal 50 −10", "dwell 40 0", "polynomial-3-4-5 50 10", "dwell 40 0", "polynomial-4-5-6-7 50 −10", "dwell 40 0"];

/** @param {Page} page */
const programSays = (page) => page.getByRole("group", { name: en("design.program") });

/** @param {Page} page */
const figures = (page) => page.getByRole("group", { name: en("verdict.figures") }).innerText();

test("a decimal comma and a decimal point are the same number", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const radius = field(page, "base_radius");
  await radius.fill("40,5");
  await becomes(() => fragment(page), /\.R40\.5_7M/);
  const comma = await fragment(page);
  await radius.press("Tab");
  assert.equal(await radius.inputValue(), "40.5");
  await radius.fill("41");
  await nextFragment(page, comma);
  await radius.fill("40.5");
  await becomes(() => fragment(page), comma);
});

test("the cam, its diagrams and its verdict follow an edit in the next frame", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const before = await figures(page);
  const late = await page.evaluate(async () => {
    const canvases = [...document.querySelectorAll("canvas")].filter((canvas) => canvas.checkVisibility());
    const look = () =>
      canvases.map((canvas) => canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height).data.reduce((sum, channel) => (sum * 31 + channel) | 0, 0));
    const radius = document.getElementById("field-base_radius");
    const height = document.querySelector("li input[id$='-rise']");
    if (!(radius instanceof HTMLInputElement && height instanceof HTMLInputElement)) throw new Error("no fields");
    const old = look();
    await new Promise(requestAnimationFrame);
    radius.value = "37";
    radius.dispatchEvent(new Event("input", { bubbles: true }));
    height.value = "11";
    height.dispatchEvent(new Event("input", { bubbles: true }));
    const third = document.querySelectorAll("li input[id$='-rise']")[2];
    if (third instanceof HTMLInputElement) {
      third.value = "-11";
      third.dispatchEvent(new Event("input", { bubbles: true }));
    }
    // This callback runs after those that the edit asked for, before the frame is shown.
    await new Promise(requestAnimationFrame);
    const now = look();
    return canvases.filter((_, i) => now[i] === old[i]).map((canvas) => canvas.getAttribute("aria-label"));
  });
  assert.deepEqual(late, [], "not drawn anew");
  await eventually(() => figures(page), (now) => assert.notEqual(now, before));
  await becomes(() => figures(page), /s max 11\smm/);
});

test("arrows step a number, Shift by ten, Alt by a tenth; Escape gives back what it was", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const radius = field(page, "base_radius");
  await radius.focus();
  for (const [key, value] of [["ArrowUp", "36"], ["Shift+ArrowUp", "46"], ["Alt+ArrowUp", "46.1"], ["ArrowDown", "45.1"], ["Shift+ArrowDown", "35.1"]]) {
    await radius.press(key);
    assert.equal(await radius.inputValue(), value, key);
  }
  await becomes(() => fragment(page), /\.R35\.1_/);
  await radius.press("Escape");
  assert.equal(await radius.inputValue(), "35");
  await becomes(() => fragment(page), LINKS["9RT"]);
  await becomes(() => undo(page).isDisabled(), true);
});

test("dragging a label changes its number, in one step of undo", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const radius = field(page, "base_radius");
  const label = page.locator('label[for="field-base_radius"]');
  const { x, y, width, height } = (await label.boundingBox()) ?? assert.fail("no label");
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  for (let by = 4; by <= 40; by += 4) await page.mouse.move(x + width / 2 + by, y + height / 2);
  await page.mouse.up();
  assert(numberOf(await radius.inputValue()) > 38, `dragged to ${await radius.inputValue()}`);
  await undo(page).click();
  await becomes(() => radius.inputValue(), "35");
  await becomes(() => undo(page).isDisabled(), true);
});

test("a text that is no number is explained beside its field, and the last good cam stays", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const [sight, link] = [await picture(diagram(page, "s")), await fragment(page)];
  const radius = field(page, "base_radius");
  for (const [text, explanation] of /** @type {const} */ ([["", "missing"], ["1.2.3", "more than one decimal sign"], ["12x", "not a unit"], ["abc", "not a number"], ["12°", "A value in mm"], ["3e", "the exponent is missing"]])) {
    await radius.fill(text);
    assert.equal(await radius.getAttribute("aria-invalid"), "true", text);
    await eventually(() => descriptions(radius), (told) => assert(told.some((sentence) => sentence?.includes(explanation)), `"${text}" is not explained: ${told}`));
  }
  await frames(page);
  assert.equal(await picture(diagram(page, "s")), sight);
  assert.equal(await fragment(page), link);
  const dim = () => mechanism(page).evaluate((canvas) => Number(getComputedStyle(canvas).opacity));
  assert((await dim()) < 0.7, "not dimmed");
  // Seen under the field, not somewhere else.
  const [box, told] = await Promise.all([radius.boundingBox(), page.getByText("After “e” the exponent is missing, as in 1.5e3.").boundingBox()]);
  assert(box && told && told.y >= box.y && told.y - box.y < 3 * box.height, "the explanation is not beside its field");
  await radius.fill("36");
  assert.equal(await radius.getAttribute("aria-invalid"), null);
  assert.equal(await dim(), 1);
  await nextFragment(page, link);
});

test("a number is read as it is typed in a book: a calculation, a fraction, a unit of its kind", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const radius = field(page, "base_radius");
  for (const [text, value] of [["4 cm", "40"], ["1 1/4 in", "31.75"], ["2*20", "40"], ["100/4", "25"]]) {
    await radius.fill(text ?? "");
    await radius.press("Enter");
    await becomes(() => radius.inputValue(), value);
  }
  const speed = field(page, "speed");
  await speed.fill("30/pi rpm");
  await speed.press("Enter");
  await becomes(() => speed.inputValue(), "1");
});

test("a text that ends as no number leaves the design the value that it had", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const radius = field(page, "base_radius");
  await radius.focus();
  await page.keyboard.type("250 parsec");
  await becomes(() => radius.getAttribute("aria-invalid"), "true");
  await becomes(() => fragment(page), LINKS["9RT"]);
  assert.equal(await radius.inputValue(), "250 parsec");
  await becomes(() => undo(page).isDisabled(), true);
  await radius.press("Escape");
  await becomes(() => radius.inputValue(), "35");
});

test("a calculation typed after another unit was chosen is in that unit, though it is no number on the way", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await field(page, "speed-unit").selectOption("rpm");
  await page.locator(".unit-question").waitFor();
  await field(page, "speed").focus();
  await page.keyboard.type("780/2");
  await becomes(() => fragment(page), /w390m/);
  await becomes(() => field(page, "speed-unit").inputValue(), "rpm");
  await undo(page).click();
  await becomes(() => fragment(page), LINKS["9RT"]);
});

test("with an unfinished design on screen, what leaves the page says that it is the last valid cam", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const said = () => page.locator("#banner").innerText();
  for (const [unfinished, finished] of /** @type {const} */ ([["-5", "36"], ["12 parsec", "37"]])) {
    await field(page, "base_radius").fill(unfinished);
    await page.getByRole("button", { name: en("header.share"), exact: true }).click();
    await becomes(said, /^What is on screen is not a cam yet/);
    await field(page, "base_radius").fill(finished);
    await becomes(said, "");
  }
  await field(page, "base_radius").fill("0");
  await page.getByRole("button", { name: en("header.files"), exact: true }).click();
  await page.getByRole("menuitem", { name: en("header.save"), exact: true }).click();
  await becomes(said, /^What is on screen is not a cam yet/);
});

test("a number typed after another unit was chosen is in that unit, and one undo gives both back", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await field(page, "speed-unit").selectOption("rpm");
  const question = page.locator(".unit-question");
  await question.waitFor();
  const [asked, speed] = await Promise.all([question.boundingBox(), field(page, "speed").boundingBox()]);
  assert(asked && speed && asked.y - (speed.y + speed.height) < speed.height, "the question is not beside its field");
  await field(page, "speed").focus();
  await page.keyboard.type("390");
  await becomes(() => question.count(), 0);
  assert.equal(await field(page, "speed-unit").inputValue(), "rpm");
  await becomes(() => fragment(page), /390m/);
  await undo(page).click();
  await becomes(() => fragment(page), LINKS["9RT"]);
  assert.equal(await field(page, "speed-unit").inputValue(), "rad/s");
});

test("a cam that cannot be is explained beside its field and dimmed, and comes back", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const [sight, link] = [await picture(diagram(page, "s")), await fragment(page)];
  const radius = field(page, "base_radius");
  await radius.fill("-5");
  await becomes(() => level(page), "stopped");
  assert.equal(await radius.getAttribute("aria-invalid"), "true");
  const explained = async () => (await descriptions(radius)).find((text) => text !== "mm") ?? "";
  const told = await eventually(explained, (text) => assert(text.length > 10, "no explanation"));
  await eventually(() => verdict(page).innerText(), (text) => assert(text.toLowerCase().includes(told.toLowerCase()), "the verdict does not say it"));
  assert.match(await verdict(page).innerText(), /Base radius: [a-z]/);
  assert.equal(await picture(diagram(page, "s")), sight, "the last good cam is gone");
  const dim = () => mechanism(page).evaluate((canvas) => Number(getComputedStyle(canvas).opacity));
  await eventually(dim, (opacity) => assert(opacity < 0.7, "not dimmed"));
  assert.equal(await fragment(page), link, "the link holds a cam that cannot be");
  await radius.press("Escape");
  await becomes(() => level(page), "low-speed");
  await eventually(dim, (opacity) => assert.equal(opacity, 1));
});

test("a verdict on a cam that cannot be names what stands in the way", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await field(page, "base_radius").fill("-5");
  await becomes(() => level(page), "stopped");
  await becomes(() => verdict(page).innerText(), /base radius|\bR\s?b\b/i);
  await field(page, "base_radius").fill("35");
  await field(page, "roller_radius").fill("0");
  await becomes(() => level(page), "stopped");
  await becomes(() => verdict(page).innerText(), /roller radius|\bR\s?f\b/i);
});

test("another law, by its name", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await law(page, 1).selectOption("polynomial-4-5-6-7");
  await becomes(async () => (await program(page))[0], "polynomial-4-5-6-7 50 10");
  await nextFragment(page, LINKS["9RT"]);
  await law(page, 5).selectOption({ label: en("law.cycloidal") });
  await becomes(async () => (await program(page))[4], "cycloidal 50 10");
  await undo(page).click();
  await undo(page).click();
  await becomes(() => fragment(page), LINKS["9RT"]);
});

test("a law with parameters brings their fields", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await law(page, 1).selectOption("scca");
  const share = page.getByRole("textbox", { name: en("segments.parameter.of", { name: en("parameter.b"), number: 1 }) });
  await share.waitFor();
  const before = await nextFragment(page, LINKS["9RT"]);
  await share.fill("0.3");
  await nextFragment(page, before);
  await share.fill("1.5");
  await becomes(() => level(page), "stopped");
  assert.equal(await share.getAttribute("aria-invalid"), "true");
  assert.notDeepEqual(await descriptions(share), [], "what is wrong with b is not told beside it");
});

test("segments are inserted, duplicated, moved and deleted anywhere", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await becomes(() => program(page), NINE);
  await actOnSegment(page, 3, "insert-before");
  await becomes(() => program(page), [...NINE.slice(0, 2), "dwell 25 0", "cycloidal 25 −10", ...NINE.slice(3)]);
  assert.notEqual(await level(page), "stopped", "an insertion keeps a good cam good");
  await actOnSegment(page, 3, "delete");
  await becomes(() => program(page), [...NINE.slice(0, 2), "cycloidal 25 −10", ...NINE.slice(3)]);
  await undo(page).click();
  await undo(page).click();
  await becomes(() => program(page), NINE);

  await actOnSegment(page, 2, "up");
  await becomes(async () => (await program(page)).slice(0, 3), ["dwell 40 0", "modified-sine 50 10", "cycloidal 50 −10"]);
  await becomes(() => level(page), "low-speed");
  await actOnSegment(page, 1, "duplicate");
  await becomes(async () => (await program(page)).slice(0, 3), ["dwell 40 0", "dwell 40 0", "modified-sine 50 10"]);
  await becomes(async () => (await program(page)).length, 9);
});

test("a segment is dragged to its place by its number", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const grip = (/** @type {number} */ number) => programSays(page).getByRole("listitem").nth(number - 1).getByRole("button").first();
  const [from, to] = [await grip(1).boundingBox(), await grip(2).boundingBox()];
  assert(from && to);
  await page.mouse.move(from.x + from.width / 2, from.y + from.height / 2);
  await page.mouse.down();
  await page.mouse.move(to.x + to.width / 2, to.y + to.height / 2, { steps: 5 });
  await page.mouse.up();
  await becomes(async () => (await program(page)).slice(0, 2), [NINE[1], NINE[0]]);
  await undo(page).click();
  await becomes(() => program(page), NINE);
});

test("what is left of 360° is told and filled in a click", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await beta(page, 1).fill("37.5");
  await becomes(() => level(page), "stopped");
  const said = () => programSays(page).innerText();
  await becomes(said, new RegExp(literal(en("segments.left", { angle: "12.5°", whole: "360°" }))));
  await programSays(page).getByRole("button", { name: en("segments.fill"), exact: true }).click();
  await becomes(() => program(page), ["modified-sine 37.5 10", ...NINE.slice(1), "dwell 12.5 0"]);
  await becomes(said, new RegExp(literal(en("segments.closed", { whole: "360°" }))));
  await becomes(() => level(page), "low-speed");

  await beta(page, 9).fill("20");
  await becomes(said, new RegExp(literal(en("segments.over", { angle: "7.5°", whole: "360°" }))));
  await programSays(page).getByRole("button", { name: en("segments.shorten"), exact: true }).click();
  await becomes(async () => (await program(page))[8], "dwell 12.5 0");
  await becomes(() => level(page), "low-speed");
});

test("a program that ends at another height says so and is closed in a click", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await rise(page, 1).fill("10.2");
  await becomes(() => level(page), "stopped");
  await becomes(() => programSays(page).innerText(), new RegExp(literal(en("segments.height.above", { height: "0.2\u00a0mm" })).replaceAll(/\s/g, "\\s")));
  await programSays(page).getByRole("button", { name: en("segments.close"), exact: true }).click();
  await becomes(async () => (await program(page))[6], "polynomial-4-5-6-7 50 −10.2");
  await becomes(() => level(page), "low-speed");
});

test("undo and redo, by button and by key, also from within a field", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  assert(await undo(page).isDisabled());
  assert(await redo(page).isDisabled());
  const radius = field(page, "base_radius");
  await radius.fill("40");
  await radius.press("Enter");
  await radius.fill("45");
  await page.keyboard.press("Control+z");
  await becomes(() => radius.inputValue(), "40");
  await page.keyboard.press("Control+z");
  await becomes(() => radius.inputValue(), "35");
  await page.keyboard.press("Control+y");
  await becomes(() => radius.inputValue(), "40");
  await page.keyboard.press("Control+Shift+z");
  await becomes(() => radius.inputValue(), "45");
  await radius.blur();
  await undo(page).click();
  await undo(page).click();
  await becomes(() => fragment(page), LINKS["9RT"]);
  await becomes(() => undo(page).isDisabled(), true);
  await redo(page).click();
  await becomes(() => radius.inputValue(), "40");
  await law(page, 1).selectOption("cycloidal");
  await becomes(() => redo(page).isDisabled(), true);
});

test("a text that is not a number yet is undone by the browser, not by the page", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await law(page, 1).selectOption("cycloidal");
  const radius = field(page, "base_radius");
  await radius.focus();
  await page.keyboard.press("End");
  await page.keyboard.type("x");
  assert.equal(await radius.inputValue(), "35x");
  await page.keyboard.press("Control+z");
  await becomes(() => radius.inputValue(), "35");
  await becomes(async () => (await program(page))[0], "cycloidal 50 10");
});

test("every follower can be chosen, gives a cam that can be built, and undo leads back", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const radios = page.getByRole("group", { name: en("design.follower") }).getByRole("radio");
  const kinds = await radios.evaluateAll((inputs) => inputs.map((input) => /** @type {HTMLInputElement} */ (input).value));
  assert.deepEqual(kinds, ["translating-roller", "translating-knife", "translating-curved", "translating-flat", "oscillating-roller", "oscillating-flat"]);
  const pictures = new Set([await picture(mechanism(page))]);
  for (const kind of kinds.slice(1)) {
    const before = await fragment(page);
    await page.getByRole("radio", { name: en(`follower.${kind}`), exact: true }).check({ force: true });
    await nextFragment(page, before);
    assert.notEqual(await level(page), "stopped", kind);
    await frames(page);
    pictures.add(await picture(mechanism(page)));
  }
  assert.equal(pictures.size, kinds.length, "every follower looks different");
  await page.getByRole("radio", { name: en("follower.translating-roller"), exact: true }).check({ force: true });
  assert.notEqual(await level(page), "stopped");
  assert.match(await fragment(page), /^1\./);
  for (let i = 0; i < kinds.length; i++) await undo(page).click();
  await becomes(() => fragment(page), LINKS["9RT"]);
});

test("a follower and back is the same cam", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await page.getByRole("radio", { name: en("follower.translating-curved"), exact: true }).check({ force: true });
  const curved = await nextFragment(page, LINKS["9RT"]);
  await page.getByRole("radio", { name: en("follower.translating-roller"), exact: true }).check({ force: true });
  await nextFragment(page, curved);
  await becomes(() => fragment(page), LINKS["9RT"]);
});

/**
 * Chooses another unit, and answers what that is to do.
 * @param {import("playwright-core").Page} page
 * @param {string} which
 * @param {string} unit
 * @param {RegExp} answer
 */
async function changeUnit(page, which, unit, answer) {
  await field(page, which).selectOption(unit);
  await page.getByRole("button", { name: answer }).click();
}

test("another unit keeps the cam or the numbers, whichever is wanted, and is one step to undo", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await changeUnit(page, "length-unit", "in", /^Same cam: 35\smm = 1\.378\sin$/);
  const inches = await nextFragment(page, LINKS["9RT"]);
  assert.match(inches, /R1\.3779527559055118_\.2755905511811024ui/);
  assert.equal(await field(page, "base_radius").inputValue(), "1.377…");
  await becomes(() => figures(page), /0\.3937\sin/);
  await changeUnit(page, "length-unit", "mm", /^Same cam: 1\.378\sin = 35\smm$/);
  await becomes(() => fragment(page), LINKS["9RT"]);
  await undo(page).click();
  await becomes(() => fragment(page), inches);
  await undo(page).click();
  await becomes(() => fragment(page), LINKS["9RT"]);
  await changeUnit(page, "speed-unit", "rpm", /^Same speed: 1\srad\/s = 9\.549\srpm$/);
  await becomes(() => field(page, "speed").inputValue(), "9.549…");
  await changeUnit(page, "speed-unit", "rad/s", /^Same speed/);
  await becomes(() => fragment(page), LINKS["9RT"]);
});

test("a number with more figures than its field holds shows so at rest, and all of them to whoever asks", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"], locale: "es-ES" });
  const angle = page.getByLabel(es("segments.beta.of", { number: 1 }), { exact: true });
  await angle.fill("51,428571428571");
  await angle.press("Tab");
  assert.equal(await angle.inputValue(), "51,4…");
  assert.equal(await angle.getAttribute("title"), "51,428571428571°");
  await angle.focus();
  assert.equal(await angle.inputValue(), "51,428571428571");
  await angle.press("Tab");
  const other = page.getByLabel(es("segments.beta.of", { number: 2 }), { exact: true });
  await other.fill("256,32");
  await other.press("Tab");
  assert.equal(await other.inputValue(), "256,32");
  for (const field of [angle, other]) assert.equal(await field.evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth), 0, "nothing is cut by the field");
});

test("a unit that is not wanted after all changes nothing", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  const unit = field(page, "length-unit");
  for (const [to, leave] of /** @type {const} */ ([["cm", () => page.keyboard.press("Escape")], ["m", () => page.getByRole("button", { name: "Keep mm" }).click()], ["in", () => unit.selectOption("mm")]])) {
    await unit.focus();
    await unit.selectOption(to);
    await page.getByRole("group", { name: `From mm to ${to}:` }).waitFor();
    assert.match((await announced(page)) ?? "", new RegExp(`^From mm to ${to}: Same cam: 35`));
    await leave();
    await becomes(() => page.locator(".unit-question").count(), 0);
    assert.equal(await unit.inputValue(), "mm");
    assert.equal(await fragment(page), LINKS["9RT"]);
  }
  await unit.selectOption("in");
  await page.locator(".unit-question").waitFor();
  assert.deepEqual(await violations(page, "question of the unit"), []);
  // Another number has nothing to do with it; a length is one in the unit that was chosen.
  await beta(page, 1).fill("50");
  assert.equal(await page.locator(".unit-question").count(), 1);
  await field(page, "base_radius").fill("36");
  await becomes(() => page.locator(".unit-question").count(), 0);
  assert.equal(await unit.inputValue(), "in");
  await undo(page).click();
  await becomes(() => unit.inputValue(), "mm");
});

test("title, unit, speed and sense of rotation are part of the design", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await page.getByRole("textbox", { name: en("header.title") }).fill("Press feed");
  await changeUnit(page, "length-unit", "in", /^Same numbers: 35\smm → 35\sin$/);
  await changeUnit(page, "speed-unit", "rpm", /^Same numbers: 1\srad\/s → 1\srpm$/);
  await field(page, "rotation").selectOption("clockwise");
  await field(page, "speed").fill("120");
  await becomes(() => fragment(page), /^1\.Press_feed\./);
  assert.equal(await page.title(), "Press feed · LevaLab");
  await becomes(() => page.locator("#transport output").textContent(), /0\.5\ss/);
  await becomes(() => figures(page), /10\sin/);
  await becomes(() => mechanism(page).getAttribute("aria-label"), new RegExp(` ${en("stage.clockwise")}`));
  for (let i = 0; i < 5; i++) await undo(page).click();
  await becomes(() => fragment(page), LINKS["9RT"]);
});
