/**
 * The verdict on paper.
 *
 * @import { ShellContext } from "../../types.d.ts"
 */
import { h } from "../../dom.js";

/** Letters to a line of the verdict, and the height of one, mm. */
const LETTERS = 115;
const TEXT = 4.4;

/** Headline, findings and cures, and about how high they are, mm. @param {ShellContext} context */
export function verdict({ store, lab, t }) {
  const { verdict: first, conjugate } = store.state.report;
  const second = conjugate?.verdict;
  const headline = second ? `${first.headline} ${t("report.second")}. ${second.headline}` : first.headline;
  const findings = [...first.findings, ...(second?.findings ?? []).map((finding) => ({ ...finding, message: `${t("report.second")}. ${finding.message}` }))];
  const cures = lab().cures(store.state.language);
  const items = findings.map(({ message }, i) => h("li", {}, message, ...(cures[i] ?? []).map((cure) => h("p", { class: "cure" }, `→ ${cure.message}`))));
  const texts = [headline, ...findings.map(({ message }) => message), ...cures.flat().map(({ message }) => message)];
  const lines = texts.reduce((sum, { length }) => sum + Math.ceil(length / LETTERS), 0);
  return { nodes: [h("p", { class: "headline" }, headline), h("ul", {}, ...items)], height: lines * TEXT };
}
