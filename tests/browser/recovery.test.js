// What must not take the page down: a failing calculation, a browser that stores nothing, a store full of nonsense.
import assert from "node:assert/strict";
import { test } from "node:test";
import { drawn } from "./browser.js";
import {
  LINKS, banner, becomes, diagram, en, eventually, field, fragment, frames, inkOf, level, mechanism, openStill, picture, program, setCursor, undo, verdict,
} from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

/** What the page's module is asked for. @typedef {"open" | "at" | "draw" | "step_cures" | "column"} Call */

/**
 * Makes the next call of the running module jump to nowhere, so that it stops with a real trap.
 * @param {Page} page
 * @param {Call} call
 * @param {number} [times]
 */
async function breakNext(page, call, times = 1) {
  await page.evaluate(
    async ({ call, times }) => {
      const glue = performance.getEntriesByType("resource").map(({ name }) => name).findLast((name) => name.includes("levalab_wasm.js")) ?? "";
      const { Lab } = await import(glue);
      const sound = Lab.prototype[call];
      let left = times;
      Lab.prototype[call] = function (/** @type {unknown[]} */ ...given) {
        if (left-- <= 0) return sound.apply(this, given);
        this.__wbg_ptr = 0x7ffffff0;
        return sound.apply(this, given);
      };
    },
    { call, times },
  );
}

/** The trap itself may be told on the console; nothing else. @param {string[]} complaints */
function forgiveTrap(complaints) {
  const trap = /memory access out of bounds|RuntimeError|unreachable/;
  for (let i = complaints.length; i-- > 0; ) if (trap.test(complaints[i])) complaints.splice(i, 1);
}

/** Closes the banner once it tells of the trap, so that everything has its size again. @param {Page} page @param {string[]} complaints */
async function acknowledge(page, complaints) {
  await becomes(() => banner(page).innerText(), new RegExp(en("banner.panic").slice(0, 30)));
  await banner(page).getByRole("button", { name: en("banner.close"), exact: true }).click();
  await frames(page);
  forgiveTrap(complaints);
}

for (const call of /** @type {const} */ (["open", "draw", "at", "step_cures"])) {
  test(`after a trap in "${call}" the page says so, keeps the cam and goes on`, async (t) => {
    const { page, complaints } = await openStill(t, { fragment: LINKS["9RT"] });
    await setCursor(page, "20");
    const sight = async () => ({ program: await program(page), diagram: await picture(diagram(page, "s")), mechanism: await picture(mechanism(page)) });
    const had = await sight();
    await breakNext(page, call);
    await field(page, "base_radius").fill("36");
    await acknowledge(page, complaints);
    const { columns } = await inkOf(diagram(page, "s"), "s", 60);
    assert(columns.filter(Boolean).length > 0.7 * columns.length, "no cam in sight");

    // As the banner advises, then on.
    await undo(page).click();
    await becomes(sight, had);
    await becomes(() => level(page), "low-speed");
    await field(page, "base_radius").fill("37");
    await becomes(() => fragment(page), /\.R37_7/);
    await eventually(() => picture(mechanism(page)), (now) => assert.notEqual(now, had.mechanism));
    await becomes(() => verdict(page).innerText(), /^Not for high speeds/m);
  });
}

test("a calculation that fails again and again is said to, and the design stays in the address", async (t) => {
  const { page, complaints } = await openStill(t, { fragment: LINKS["9RT"] });
  for (const radius of ["36", "37", "38"]) {
    await breakNext(page, "open");
    await field(page, "base_radius").fill(radius);
    await acknowledge(page, complaints);
  }
  await breakNext(page, "open");
  await field(page, "base_radius").fill("39");
  await becomes(() => banner(page).innerText(), new RegExp(en("banner.broken").slice(0, 30)));
  assert.match(await fragment(page), /^1\.Example_9RT\.R3\d_7/);
  await page.getByRole("button", { name: en("transport.forth") }).click();
  await frames(page);
  // After a pause it is tried again, without loading the page.
  await eventually(() => banner(page).innerText(), (told) => assert.match(told, new RegExp(en("banner.panic").slice(0, 30))));
  await field(page, "base_radius").fill("41");
  await becomes(() => fragment(page), /\.R41_7/);
  await becomes(() => level(page), "low-speed");
  forgiveTrap(complaints);
});

test("when not even a fresh start works, it is said", async (t) => {
  const { page, complaints } = await openStill(t, { fragment: LINKS["9RT"] });
  await page.evaluate(() => {
    const instantiate = () => Promise.reject(new RangeError("Out of memory: Cannot allocate Wasm memory for new instance"));
    Object.assign(WebAssembly, { instantiate });
  });
  await breakNext(page, "open");
  await field(page, "base_radius").fill("36");
  await eventually(() => banner(page).innerText(), (told) => assert(told.length > 20, "nothing is said"));
  forgiveTrap(complaints);
  for (let i = complaints.length; i-- > 0; ) if (/Out of memory/.test(complaints[i])) complaints.splice(i, 1);
});

test("with storage forbidden the page works", async (t) => {
  const { page } = await openStill(t);
  await page.addInitScript(() => {
    Object.defineProperty(window, "localStorage", {
      get() {
        throw new DOMException("The operation is insecure.", "SecurityError");
      },
    });
  });
  await page.reload();
  await drawn(page);
  await worksAndShares(page);
});

test("with storage full the page works", async (t) => {
  const { page } = await openStill(t);
  await page.addInitScript(() => {
    Storage.prototype.setItem = () => {
      throw new DOMException("exceeded the quota", "QuotaExceededError");
    };
  });
  await page.reload();
  await drawn(page);
  await worksAndShares(page);
});

test("with nonsense in storage the page opens with its example", async (t) => {
  const { page } = await openStill(t);
  for (const nonsense of ["{", '"text"', '{"format":"levalab/1"}', '{"format":"levalab/9","segments":7}', '{"layers":3,"tab":"?","theme":{},"language":"xx","perSecond":"yes"}']) {
    await page.evaluate((nonsense) => {
      for (const name of [...Object.keys(localStorage), "levalab:design", "levalab:view"]) localStorage.setItem(name, nonsense);
    }, nonsense);
    await page.reload();
    await drawn(page);
    await becomes(() => field(page, "base_radius").inputValue(), "35");
    await becomes(() => level(page), "low-speed");
    assert.equal(await page.locator("html").getAttribute("lang"), "en", nonsense);
  }
});

/** @param {Page} page */
async function worksAndShares(page) {
  await becomes(() => level(page), "low-speed");
  await field(page, "base_radius").fill("44");
  await becomes(() => fragment(page), /\.R44_7/);
  await page.getByRole("button", { name: "ES", exact: true }).click();
  await becomes(() => page.locator("html").getAttribute("lang"), "es");
  await page.reload();
  await becomes(() => field(page, "base_radius").inputValue(), "44");
}
