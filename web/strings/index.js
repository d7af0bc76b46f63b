/**
 * The page's words, one file a language, loaded when that language is wanted; `stage.*.js` hold those of the mechanism, diagrams and readouts.
 * Names of laws, followers and kinds of cam come from the catalogue (`pkg/names.*.js`).
 *
 * @import { Language, Translate } from "../types.d.ts"
 */
import { say } from "../signs.js";

/** A sentence, or its forms by number: `{ one: "{count} joint", other: "{count} joints" }`. */
/** @typedef {string | { one: string, other: string }} Phrase */

/** @type {Record<Language, Record<string, Phrase>>} */
const LANGUAGES = { en: {}, es: {} };

/** What every visit needs. @type {Record<Language, () => Promise<Record<string, Record<string, Phrase>>>>} */
const PAGE = { en: () => import("./page.en.js"), es: () => import("./page.es.js") };

/** Loads the words of a language, before it is first spoken. @param {Language} language */
export async function learn(language) {
  Object.assign(LANGUAGES[language], ...Object.values(await PAGE[language]()));
}

/** @param {Language} language */
export const learned = (language) => Object.keys(LANGUAGES[language]).length > 0;

/**
 * The words of a part of the page that is loaded when it is first asked for.
 * @param {Record<Language, Record<string, Phrase>>} more
 */
export function addStrings(more) {
  Object.assign(LANGUAGES.en, more.en);
  Object.assign(LANGUAGES.es, more.es);
}

/** @type {Record<Language, Intl.PluralRules>} */
const PLURAL = { en: new Intl.PluralRules("en"), es: new Intl.PluralRules("es") };

/**
 * @param {() => Language} language
 * @returns {Translate}
 */
export function createTranslate(language) {
  return (key, values = {}) => {
    const phrase = LANGUAGES[language()][key];
    if (phrase === undefined) return key;
    const text = say(typeof phrase === "string" ? phrase : phrase[form(language(), values["count"])]);
    return text.replaceAll(/\{(\w+)\}/g, (_, name) => String(values[name] ?? ""));
  };
}

/**
 * @param {Language} language
 * @param {string | number | undefined} count
 * @returns {"one" | "other"}
 */
function form(language, count) {
  return PLURAL[language].select(Number(count ?? 0)) === "one" ? "one" : "other";
}

/**
 * What follows the browser at first.
 * @param {readonly string[]} preferred
 * @returns {Language}
 */
export function firstLanguage(preferred) {
  for (const tag of preferred) {
    if (/^es\b/i.test(tag)) return "es";
    if (/^en\b/i.test(tag)) return "en";
  }
  return "en";
}
