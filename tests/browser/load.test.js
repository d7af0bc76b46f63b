// The packed page opens anywhere, and keeps to itself.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage } from "./harness.js";

/** @typedef {import("playwright-core").Page} Page */

test("the page draws under any path, within its policy, asking no other host", async (t) => {
  const { page } = await openPage(t);
  assert.match(await page.title(), /LevaLab$/);
});

test("the policy allows nothing but the page's own files", async (t) => {
  const { page } = await openPage(t);
  const policy = await page.locator('meta[http-equiv="Content-Security-Policy"]').getAttribute("content");
  const rules = new Set(policy?.split(";").map((rule) => rule.trim()));
  for (const rule of ["default-src 'none'", "script-src 'self' 'wasm-unsafe-eval'", "connect-src 'self'", "base-uri 'none'", "form-action 'none'", "require-trusted-types-for 'script'", "trusted-types levalab-own levalab-worker"]) {
    assert(rules.has(rule), rule);
  }
});

/** What the browser says to somebody of that name who would vouch for scripts and markup. @param {Page} page @param {string} name */
const vouch = (page, name) =>
  page.evaluate((name) => {
    try {
      /** @type {typeof window & { trustedTypes: { createPolicy(name: string, rules: object): object } }} */ (window).trustedTypes.createPolicy(name, {});
      return "allowed";
    } catch (error) {
      return /** @type {Error} */ (error).name;
    }
  }, name);

/** A refusal is told on the console. @param {string[]} complaints */
function forgiveRefusals(complaints) {
  for (let i = complaints.length; i-- > 0; ) if (/Trusted ?Type/.test(complaints[i])) complaints.splice(i, 1);
}

test("no other name can vouch for a script or for markup, in the page and in its pages of theory", async (t) => {
  const { page, url, complaints } = await openPage(t);
  for (const name of ["default", "another", "levalab"]) assert.equal(await vouch(page, name), "TypeError", name);
  const help = await page.locator('link[rel="help"]').getAttribute("href");
  for (const file of ["en.html", "terms-es.html", "manual-en.html"]) {
    await page.goto(new URL(file, new URL(help ?? "", url)).href);
    for (const name of ["default", "levalab-own", "levalab-worker"]) assert.equal(await vouch(page, name), "TypeError", `${file}: ${name}`);
    assert.match((await page.locator('meta[http-equiv="Content-Security-Policy"]').getAttribute("content")) ?? "", /require-trusted-types-for 'script'; trusted-types 'none'$/);
  }
  forgiveRefusals(complaints);
});

test("the module arrives once, asked for before the script that uses it runs", async (t) => {
  const { page } = await openPage(t);
  const loads = await page.evaluate(() =>
    performance.getEntriesByType("resource").map(({ name, startTime }) => ({ name, startTime })),
  );
  const modules = loads.filter(({ name }) => name.endsWith(".wasm"));
  const script = loads.find(({ name }) => name.endsWith("main.js"));
  assert.equal(modules.length, 1);
  assert(script && modules[0].startTime < script.startTime + 50, "the hint in index.html was not used");
});

for (const [locale, language] of [["en-GB", "en"], ["es-ES", "es"]]) {
  test(`the main screen takes four scripts, the words of one language among them (${locale})`, async (t) => {
    const { page } = await openPage(t, { locale });
    const scripts = await page.evaluate(() => {
      const [{ startTime: drawn }] = performance.getEntriesByName("levalab:drawn");
      const loads = performance.getEntriesByType("resource").filter(({ name, startTime }) => name.endsWith(".js") && startTime < drawn);
      return loads.map(({ name }) => name.split("/").at(-1)).sort();
    });
    assert.deepEqual(scripts, ["early.js", "levalab_wasm.js", "main.js", `page.${language}.js`]);
  });
}
