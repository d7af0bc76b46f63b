/**
 * What is drawn on canvases, each in a sentence for those who cannot see it.
 *
 * @import { Context, ShellContext } from "../types.d.ts"
 * @import { Plot } from "./plots.js"
 */
import { plain } from "../signs.js";
import { inSight, placeText } from "./place.js";
import { rangeOf, unitOf } from "./plots.js";

/**
 * @param {ShellContext} context
 * @param {Plot} plot
 */
export function diagramInWords({ store, t, format }, plot) {
  const { perSecond } = store.state;
  const report = inSight(store.state);
  const word = t(`diagram.name.${plot.diagram}`);
  const name = word.charAt(0).toLocaleUpperCase() + word.slice(1);
  const letter = plain(perSecond ? plot.perSecond : plot.letter);
  const unit = unitOf(plot, report, perSecond);
  const range = rangeOf(plot, report, perSecond);
  if (!range) return t("diagram.alternative.none", { name, letter });
  // Where the profile turns hollow, ρ goes through infinity: what counts is where it is sharpest.
  if (plot.diagram === "rho" && report.least_convex && (range.min === null || range.max === null)) {
    const { value, at } = report.least_convex;
    return t("diagram.alternative.rho", { name, letter, value: format.quantity(value, { trim: true, unit }), at: placeText(format, report, at) });
  }
  /** @param {number | null} value */
  const say = (value) => (value === null ? "∞" : format.quantity(value, { trim: true, unit }));
  return t("diagram.alternative", {
    name, letter, min: say(range.min), max: say(range.max), minAt: placeText(format, report, range.min_at), maxAt: placeText(format, report, range.max_at),
  });
}

/** @param {Context} context */
export function mechanismInWords({ store, t, format }) {
  const { mechanism, units, kind, span, conjugate, summary } = store.state.report;
  const length = (/** @type {number} */ value) => format.quantity(value, { trim: true, unit: units.length });
  const alone = t(kind === "rotating" ? "stage.alternative" : `stage.alternative.${kind}`, {
    length: length(span),
    breadth: length(summary.breadth?.max ?? 0),
    follower: t(`follower.noun.${mechanism.motion}-${mechanism.contact}`),
    base: length(mechanism.base_radius),
    reach: length(mechanism.reach),
    sense: t(mechanism.sense > 0 ? "stage.counterclockwise" : "stage.clockwise"),
  });
  return conjugate ? `${alone} ${t("stage.alternative.pair", { base: length(conjugate.mechanism.base_radius) })}` : alone;
}
