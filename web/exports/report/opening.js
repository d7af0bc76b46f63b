/**
 * What the report opens with: the numbers of the design and its program.
 *
 * @import { Design, ShellContext } from "../../types.d.ts"
 */
import { h } from "../../dom.js";
import { plain } from "../../signs.js";
import { NARROW, grid, section } from "./paper.js";

/** Height of a line of the tables, mm. */
const LINE = 5.2;
/** Segments that have room beside the design, and in one column below it. */
const BESIDE = 20;
const LONGEST = 23;
/**
 * Design and program side by side; a long program below, in as many columns as it takes to stay on the page. And about how high they are, mm.
 * @param {ShellContext} context
 * @param {Design} design
 */
export function opening(context, design) {
  const { t } = context;
  const numbers = magnitudes(context, design);
  const count = segmentsOf(context, design).length;
  if (count <= BESIDE) {
    const nodes = [h("div", { class: "two" }, section(t("report.design"), table(numbers)), section(t("report.program"), program(context, design, 0, count)))];
    return { nodes, height: Math.max(numbers.length, count + 1) * LINE + 8 };
  }
  const half = Math.ceil(numbers.length / 2);
  const columns = Math.ceil(count / LONGEST);
  const each = Math.ceil(count / columns);
  const parts = Array.from({ length: columns }, (_, k) => program(context, design, k * each, Math.min(count, (k + 1) * each)));
  const nodes = [
    section(t("report.design"), h("div", { class: "columns" }, table(numbers.slice(0, half)), table(numbers.slice(half)))),
    section(t("report.program"), h("div", { class: "columns narrow" }, ...parts)),
  ];
  return { nodes, height: half * LINE + (each + 1) * NARROW + 20 };
}

/** The design's own numbers: name, value with its unit. @param {ShellContext} context @param {Design} design @returns {[string, string][]} */
function magnitudes({ t, format, catalogue, store }, design) {
  const unit = design.length_unit;
  const { mechanism, pressure_angle_limit, omega } = store.state.report;
  const entry = catalogue.followers.find(({ motion, contact }) => motion === design.follower.motion && contact === design.follower.contact);
  const rows = (entry?.parameters ?? []).flatMap(({ key, symbol, quantity, default: usual }) => {
    const value = design.follower[key] ?? usual;
    if (typeof value !== "number") return [];
    return [/** @type {[string, string]} */ ([`${t(`parameter.${key}`)} ${key === "arm" ? symbol : plain(symbol)}`, format.number(key === "eccentricity" ? value * (store.state.report.notation?.eccentricity ?? 1) + 0 : value, { unit: quantity === "length" ? unit : "°" })])];
  });
  const speed = `${format.number(design.speed.value)} ${design.speed.unit}${design.speed.unit === "rad/s" || store.state.report.travels ? "" : ` = ${format.quantity(omega, { trim: true })} rad/s`}`;
  const { cam } = design;
  const lengths = /** @type {const} */ (["base_radius", "breadth", "length"]).filter((key) => cam[key]);
  const pair = Object.entries(design.conjugate ?? {});
  return [
    ...(cam.kind === "rotating" ? [] : [/** @type {[string, string]} */ ([t("report.kind"), t(`kind.${cam.kind}`)])]),
    [t("report.follower"), t(`follower.${design.follower.motion}-${design.follower.contact}`)],
    ...lengths.map((key) => /** @type {[string, string]} */ ([key === "base_radius" ? `${t("parameter.base_radius")} ${plain("R_b")}` : t(`report.${key}`), format.number(cam[key], { unit })])),
    ...(mechanism.prime_radius === null || mechanism.roller_radius === 0 || !lengths.includes("base_radius") ? [] : [/** @type {[string, string]} */ ([`${t("report.prime_radius")} ${plain("R_p")}`, format.number(mechanism.prime_radius, { unit })])]),
    ...rows,
    ...pair.map(([key, value]) => /** @type {[string, string]} */ ([t(`pair.${key}`), format.number(value, { unit: key === "angle" ? "°" : unit })])),
    [t("parameter.speed"), speed],
    ...(cam.rotation ? [/** @type {[string, string]} */ ([t("report.rotation"), t(`report.rotation.${cam.rotation}`)])] : []),
    [`${plain("φ")} ${t("report.limit")}`, format.number(pressure_angle_limit, { unit: "°" })],
  ];
}

/** @param {[string, string][]} rows */
function table(rows) {
  return h("table", {}, h("tbody", {}, ...rows.map(([name, value]) => h("tr", {}, h("th", { scope: "row" }, name), h("td", {}, value)))));
}

/** The segments of the design, or those of a motion that is ready-made. @param {ShellContext} context @param {Design} design */
const segmentsOf = ({ store }, design) => store.state.report.program ?? design.segments ?? [];

/** Segments from one to another. @param {ShellContext} context @param {Design} design @param {number} from @param {number} to */
function program(context, design, from, to) {
  const { t, format, store } = context;
  const { borders, units } = store.state.report;
  const place = "length" in design.cam ? design.length_unit : "°";
  const head = ["", t("report.law"), t("report.from"), "β", `L (${units.s})`];
  const rows = segmentsOf(context, design).slice(from, to).map(({ law, beta, rise }, i) => [
    String(from + i + 1),
    t(`law.${law}`),
    format.number(borders[from + i], { unit: place }),
    format.number(beta, { unit: place }),
    rise === undefined ? "" : format.number(rise),
  ]);
  return grid(head, rows, "program");
}
