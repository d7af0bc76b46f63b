/**
 * Places and requirements in words, for who draws and for who does not see the drawing.
 *
 * @import { ShellContext } from "../types.d.ts"
 * @import { Placed } from "./demands.js"
 */
import { riseUnit } from "../segment-row.js";

/** @typedef {{ theta: number, s: number }} Place */

/** @param {ShellContext} context */
export function createTelling({ store, t, format }) {
  /** @param {number} value */
  const height = (value) => format.number(value, { unit: riseUnit(store.state.design) });
  /** @param {number} value */
  const angle = (value) => format.number(value, { unit: "°" });

  /** @param {Place} place */
  const spot = ({ theta, s }) => t("auto.spot", { theta: angle(theta), s: height(s) });

  /** @param {Placed} place */
  function stand({ kind, from, to, s, end, v }) {
    if (kind === "point") return `${spot({ theta: from, s })}, ${velocity({ kind, from, to, s, end, v })}`;
    const ends = { from: angle(from), to: angle(to), s: height(s) };
    return kind === "dwell" ? t("auto.told.dwell", ends) : t("auto.told.line", { ...ends, end: height(end) });
  }

  /** @param {Placed} place */
  const velocity = ({ v }) => (v === undefined ? t("auto.free") : t("auto.velocity", { v: format.number(v, { unit: store.state.report.units.v }) }));

  return {
    spot,
    velocity,
    stand,
    /** @param {Placed} place */
    whole: (place) => `${t(`auto.kind.${place.kind}`)}: ${stand(place)}`,
  };
}
