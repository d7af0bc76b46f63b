/**
 * What the follower drives, on paper.
 *
 * @import { Module } from "../../engine.js"
 * @import { Design, ShellContext } from "../../types.d.ts"
 */
import { h } from "../../dom.js";
import { paperPalette } from "../../stage/palette.js";
import { letterOf, placeText, unitOfPlace } from "../../stage/place.js";
import { PLOTS, styleOf } from "../../stage/plots.js";
import { parse } from "../../stage/print.js";
import { NAME, NARROW, PIXELS, ROOM, grid } from "./paper.js";

/** Height of a diagram of an application, mm. */
const DRIVEN = 22;

/**
 * What the follower drives: its figures, its diagrams and the points to hit with their errors; and about how high they are, mm.
 * @param {ShellContext} context
 * @param {Design} design
 * @param {Module} module
 */
export function driving({ store, t, format }, design, module) {
  const { language, perSecond, report: cam } = store.state;
  const driven = design.application && module.Driven.of(design);
  const entry = driven && module.applications(design.length_unit, language).find(({ id }) => id === design.application?.kind);
  if (!entry) return null;
  const report = driven.report(language);
  const given = entry.parameters.map(({ id, ...other }) => ({ ...other, value: /** @type {number} */ (design.application?.[id] ?? other.value) }));
  const figures = [...given, ...report.figures].map(({ name, symbol, value, unit }) => `${name} ${symbol} = ${format.quantity(value, { trim: true, unit })}`);
  const palette = { ...paperPalette(), chartSize: 10, stroke: 1.3 };
  const size = { width: ROOM * PIXELS, height: DRIVEN * PIXELS, ratio: 1, labels: true };
  const plots = report.outputs.map(({ name, symbol, unit, min, max, min_at, max_at, per_cycle }, output) => {
    /** @param {number} value */
    const say = (value) => format.quantity(value, { trim: true, unit });
    const style = { ...styleOf(PLOTS.s, palette, store.state, size), curve: output === 0 ? "#006a73" : "#8a3d00", dash: output === 0 ? [] : [7, 3], per_second: perSecond };
    const range = t("report.range", { min: say(min), minAt: placeText(format, cam, min_at), max: say(max), maxAt: placeText(format, cam, max_at) });
    const delivered = per_cycle === null ? "" : `; ${t(cam.travels ? "report.journey" : "report.turn", { volume: say(per_cycle) })}`;
    return h("figure", {}, h("figcaption", {}, h("i", {}, symbol), ` ${name} (${unit}): ${range}${delivered}`), parse(driven.svg(output, style)));
  });
  const main = report.outputs[report.main];
  const head = [`${letterOf(cam)} (${unitOfPlace(cam)})`, "t (s)", ...["wanted", "found", "error"].map((key) => `${t(`report.${key}`)} (${main?.unit})`)];
  const rows = report.targets.map(({ theta, time, value, found, error }) => [format.number(Number(theta.toPrecision(7))), format.quantity(time), format.number(Number(value.toPrecision(7))), format.number(Number(found.toPrecision(6))), format.quantity(error, { trim: true })]);
  driven.free();
  const columns = Math.min(rows.length, rows.length > 6 ? 2 : 1);
  const each = Math.ceil(rows.length / columns);
  const tables = Array.from({ length: columns }, (_, k) => grid(head, rows.slice(k * each, (k + 1) * each), "targets"));
  const nodes = [h("p", {}, figures.join(" · ")), ...plots, rows.length > 0 && h("div", { class: "columns narrow" }, ...tables)].filter((node) => node !== false);
  return { title: entry.title, nodes, height: 12 + plots.length * (DRIVEN + NAME + 1) + (rows.length > 0 ? (each + 1) * NARROW + 2 : 0) };
}
