import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { CATALOGUE } from "../pkg/catalogue.js";
import { createTranslate, firstLanguage, learn } from "./index.js";

/** @typedef {Record<string, import("./index.js").Phrase>} Words */

/** All the words of a language: `en.js` and every `<part>.en.js`. @param {string} language @returns {Promise<Words>} */
async function wordsOf(language) {
  const names = readdirSync(import.meta.dirname).filter((name) => (name === `${language}.js` || name.endsWith(`.${language}.js`)) && name !== `page.${language}.js`);
  const parts = await Promise.all(names.map((name) => import(`./${name}`)));
  return Object.assign({}, ...parts.flatMap((part) => Object.values(part)));
}

const english = await wordsOf("en");
const spanish = await wordsOf("es");
const web = fileURLToPath(new URL("..", import.meta.url));

/** Every script of the page but the strings themselves and the tests, as one text. */
const source = readdirSync(web, { recursive: true, encoding: "utf8" })
  .filter((name) => name.endsWith(".js") && !/^(pkg|strings)\b|\.test\.js$/.test(name))
  .map((name) => readFileSync(join(web, name), "utf8"))
  .join("\n");

/** Keys that are put together, `law.${id}`: their beginnings. */
const prefixes = [...source.matchAll(/`([a-z]+(?:[.-][a-z-]+)*[.-])\$\{/g)].map(([, prefix]) => prefix ?? "");

/** @param {string} key */
const isUsed = (key) => source.includes(`"${key}"`) || prefixes.some((prefix) => key.startsWith(prefix));

/** @param {string | { one: string, other: string }} phrase */
const forms = (phrase) => (typeof phrase === "string" ? [phrase] : [phrase.one, phrase.other]);

/** @param {string} text */
const names = (text) => [...new Set([...text.matchAll(/\{(\w+)\}/g)].map(([, name]) => name))].sort();

test("both languages have the same keys", () => {
  assert.deepEqual(Object.keys(spanish).sort(), Object.keys(english).sort());
});

test("every sentence takes the same values in both languages", () => {
  for (const [key, phrase] of Object.entries(english)) {
    const other = /** @type {Record<string, string | { one: string, other: string }>} */ (spanish)[key] ?? "";
    const values = (/** @type {typeof phrase} */ sentence) => [...new Set(forms(sentence).flatMap(names))].sort();
    assert.deepEqual(values(other), values(phrase), key);
    assert.equal(typeof other, typeof phrase, `${key}: plural in one language only`);
  }
});

test("no sentence is empty, and none carries spaces at its ends", () => {
  for (const [key, phrase] of [...Object.entries(english), ...Object.entries(spanish)]) {
    for (const text of forms(phrase)) assert.ok(text !== "" && text.trim() === text, key);
  }
});

test("no key is unused", () => {
  assert.deepEqual(Object.keys(english).filter((key) => !isUsed(key)), []);
});

test("no key is asked for that is missing", () => {
  const asked = [...source.matchAll(/(?:\bt|\.text|\.attribute|\bfix|banner\.show)\((?:[^()"]|\([^()]*\))*?"([a-z]+\.[\w.-]+)"/g)].map(([, key]) => key ?? "");
  assert.ok(asked.length > 50, "the search finds the calls");
  assert.deepEqual(asked.filter((key) => !(key in english)), []);
});

test("plurals agree in number", async () => {
  await learn("es");
  const t = createTranslate(() => "es");
  assert.equal(t("verdict.all", { count: 1 }), "1 observación");
  assert.equal(t("verdict.all", { count: 4 }), "4 observaciones");
});

test("every law, follower and kind of cam has its name from the catalogue, and every parameter its words, in every language", async () => {
  for (const language of /** @type {const} */ (["en", "es"])) {
    await learn(language);
    const t = createTranslate(() => language);
    const { laws, followers, kinds } = CATALOGUE;
    const keys = [
      ...laws.flatMap(({ id, group }) => [`law.${id}`, `group.${group}`]),
      ...followers.flatMap(({ id }) => [`follower.${id}`, `follower.noun.${id}`]),
      ...kinds.map(({ id }) => `kind.${id}`),
    ];
    const parameters = [...laws, ...followers].flatMap((entry) => entry.parameters.map(({ key }) => key));
    keys.push(...parameters.flatMap((key) => [`parameter.${key}`, `parameter.${key}.hint`]));
    assert.deepEqual(keys.filter((key) => t(key) === key), [], language);
    const names = keys.filter((key) => !key.startsWith("parameter."));
    assert.deepEqual(names.filter((key) => key in english || key in spanish), [], "none is written a second time");
  }
});

test("the language follows the browser at first", () => {
  assert.equal(firstLanguage(["es-MX", "en"]), "es");
  assert.equal(firstLanguage(["fr", "es"]), "es");
  assert.equal(firstLanguage(["de-AT"]), "en");
});
