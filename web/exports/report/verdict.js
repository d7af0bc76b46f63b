/**
 * The verdict on paper.
 *
 * @import { ShellContext } from "../../types.d.ts"
 */
import { h } from "../../dom.js";
import { sentenceOf } from "../../finding-item.js";

/** Letters to a line of the verdict, and the height of one, mm. */
const LETTERS = 115;
const TEXT = 4.4;

/** Headline, findings and cures, and about how high they are, mm. @param {ShellContext} context */
export function verdict({ store, lab, t }) {
  const { verdict: both } = store.state.report;
  /** @param {number | undefined} number @param {string} text */
  const ofCam = (number, text) => (number === undefined ? text : t("verdict.cam", { number, text }));
  const headline = ofCam(both.cam, both.headline);
  const sentences = both.findings.map((finding) => ofCam(finding.cam, sentenceOf(finding, store.state)));
  const cures = lab().cures(store.state.language);
  const items = sentences.map((sentence, i) => h("li", {}, sentence, ...(cures[i] ?? []).map((cure) => h("p", { class: "cure" }, `→ ${cure.message}`))));
  const texts = [headline, ...sentences, ...cures.flat().map(({ message }) => message)];
  const lines = texts.reduce((sum, { length }) => sum + Math.ceil(length / LETTERS), 0);
  return { nodes: [h("p", { class: "headline" }, headline), h("ul", {}, ...items)], height: lines * TEXT };
}
