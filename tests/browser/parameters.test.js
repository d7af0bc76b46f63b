// The diagrams of the parameters say what they show of the cam at hand, and how long its face must be.
import assert from "node:assert/strict";
import { test } from "node:test";
import { LINKS, becomes, diagram, en, es, eventually, field, inkOf, numberOf, openExample, openStill } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

/** @param {Page} page @param {string} letter */
const show = (page, letter) => page.getByRole("radio", { name: new RegExp(`^${letter} `) }).check({ force: true });

/** @param {Page} page */
const said = async (page) => (await page.locator(".diagram-note").textContent()) ?? "";

test("the pressure angle is told with its extremes, their places and the limit, in both languages", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await show(page, "φ");
  await becomes(() => said(page), /from −28\.2° \(at 296\.0°\) to 24\.7° \(at 203\.8°\).*±30°/);
  await page.getByRole("button", { name: "ES", exact: true }).click();
  await becomes(() => said(page), /de −28,2° \(en 296,0°\) a 24,7° \(en 203,8°\).*±30°/);
  await page.getByRole("button", { name: es("header.examples"), exact: true }).click();
  await page.locator('[data-example="R1"]').click();
  await becomes(() => said(page), /φ llega a −31,8° en 261,7°, más allá de ±30°/);
});

test("the radius of curvature is told where it is least and what its hollows hold", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  await show(page, "ρ");
  await becomes(() => said(page), /ρ = 11\.26\smm.*47\.53\smm.*radius of 7\smm must fit/);
  await field(page, "base_radius").fill("9");
  await eventually(() => said(page), (text) => assert.match(text, /bends more tightly than the roller of 7\smm: ρ comes out as −/));
  await openExample(page, "10EX");
  await becomes(() => said(page), /the least is 40\smm/);
});

test("the contact has a diagram for flat faces only, and the face a length with a margin that is remembered", async (t) => {
  const { page } = await openStill(t, { fragment: LINKS["9RT"] });
  assert.equal(await page.getByRole("radio", { name: /^q / }).count(), 0);
  await openExample(page, "10EX");
  await show(page, "q");
  // An eccentric circle of lift 20: the contact walks from −10 to 10.
  await becomes(() => said(page), /from −10\smm \(at 270\.0°\) to 10\smm \(at 90\.0°\)/);
  await becomes(async () => (await page.locator(".face-length").textContent()) ?? "", /at least 20\smm.*10\smm.*10\smm/);
  assert((await inkOf(diagram(page, "contact"), "q")).count > 300, "no curve");
  const margin = page.getByLabel(en("parameters.margin"));
  await margin.fill("2,5");
  await margin.press("Enter");
  await becomes(async () => (await page.locator(".face-length").textContent()) ?? "", /at least 25\smm.*12\.5\smm.*12\.5\smm/);
  await margin.fill("-1");
  await margin.press("Enter");
  await becomes(() => margin.getAttribute("aria-invalid"), "true");
  await margin.press("Escape");
  await becomes(() => margin.inputValue(), "2.5");
  await page.reload();
  await becomes(async () => (await page.locator(".face-length").textContent()) ?? "", /at least 25\smm/);

  await openExample(page, "4PO");
  await eventually(async () => (await page.locator(".face-length").textContent()) ?? "", (text) => {
    const [least, near, far] = [...text.matchAll(/[\d.]+(?=\smm)/g)].map(([number]) => numberOf(number));
    // The face begins at the foot of the pivot: the part that works is its outer end.
    assert(Math.abs(least - far) < 0.02 && near > 0 && near < far, text);
  });
  // Where there is no face, the tab that is gone gives way to the first; it comes back with the face.
  await openExample(page, "9RT");
  await becomes(() => diagram(page, "s").isVisible(), true);
  await openExample(page, "10EX");
  await becomes(() => diagram(page, "contact").isVisible(), true);
});
