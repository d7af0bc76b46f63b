/**
 * The instant values: what every quantity is at the cursor, in figures that do not jump about.
 *
 * @import { Context, Report, State } from "./types.d.ts"
 */
import { h, write } from "./dom.js";
import { mark } from "./help-mark.js";
import { cycleOf, decimalsOf } from "./stage/clock.js";
import { AT, instant } from "./stage/instant.js";
import { metered } from "./stage/meter.js";
import { inSight, letterOf, seesSecond, unitOfPlace } from "./stage/place.js";
import { era, plain } from "./signs.js";

const SIGNIFICANT = 5;
/** Numbers with a zero behind the point, parts of a second and derivatives by length: a figure less leaves room for their zeros. */
const SMALL = 0.1;
const SMALL_TIME = 1;
const SIGNIFICANT_SMALL = 4;
const ANGLE_DIGITS = 2;
const MOST_DIGITS = 9;
/** Width of a letter of a unit, in figures. */
const UNIT = 0.9;

/**
 * @typedef {object} Reading
 * @property {string} name           key of its strings
 * @property {string} letter
 * @property {string} timed          letter per second
 * @property {number} place
 * @property {number} placeTimed
 * @property {string} token          of its colour
 * @property {(report: Report, perSecond: boolean) => number} size  largest value of the turn
 * @property {(report: Report, perSecond: boolean) => string} unit
 */

/** @type {(key: keyof Report["summary"], timed?: keyof Report["summary"]) => Reading["size"]} */
const largest = (key, timed = key) => ({ summary }, perSecond) => {
  const range = summary[perSecond ? timed : key];
  return Math.max(Math.abs(range?.min ?? 0), Math.abs(range?.max ?? 0));
};

/** @type {(key: "s" | "v" | "a" | "j", letter: "s" | "V" | "A" | "J", place: number, timed: number) => Reading} */
const motion = (key, letter, place, timed) => ({
  name: key, letter: key, timed: letter, place, placeTimed: timed, token: key, size: largest(key, letter),
  unit: ({ units }, perSecond) => units[perSecond ? letter : key],
});

/** Place and time, motion, contact: a column each. @type {readonly (readonly Reading[])[]} */
const GROUPS = [
  [
    { name: "theta", letter: "θ", timed: "θ", place: -1, placeTimed: -1, token: "ink", size: ({ span }) => span, unit: unitOfPlace },
    { name: "t", letter: "t", timed: "t", place: AT.t, placeTimed: AT.t, token: "ink", size: ({ period }) => period, unit: () => "s" },
  ],
  [
    motion("s", "s", AT.s, AT.s),
    motion("v", "V", AT.v, AT.V),
    motion("a", "A", AT.a, AT.A),
    motion("j", "J", AT.j, AT.J),
  ],
  [
    { name: "pressure_angle", letter: "φ", timed: "φ", place: AT.pressureAngle, placeTimed: AT.pressureAngle, token: "phi", size: () => 90, unit: () => "°" },
    // A radius of curvature goes to infinity: its decimals follow the cam's size, not its own.
    { name: "rho", letter: "ρ", timed: "ρ", place: AT.rho, placeTimed: AT.rho, token: "rho", size: ({ mechanism, travels, span }) => (travels ? span : mechanism.reach), unit: ({ units }) => units.length },
    { name: "contact", letter: "q", timed: "q", place: AT.contact, placeTimed: AT.contact, token: "q", size: largest("contact"), unit: ({ units }) => units.length },
    { name: "sliding", letter: "u", timed: "u", place: AT.sliding, placeTimed: AT.slidingTimed, token: "ink", size: ({ mechanism, omega }, perSecond) => mechanism.reach * (perSecond ? omega : 1), unit: ({ units }, perSecond) => units[perSecond ? "U" : "u"] },
  ],
];

/**
 * @param {HTMLElement} root
 * @param {Context} context
 */
export function mount(root, context) {
  const { store, t, format } = context;
  const columns = GROUPS.map((group) => group.map((reading) => {
    const id = `readout-${reading.name}`;
    const letter = h("i", { class: "symbol" });
    const name = h("span", { class: "unseen" });
    const unit = h("span", { class: "readout-unit" });
    const output = h("output", { id, "aria-live": "off" });
    const label = h("label", { for: id, id: `${id}-label` }, letter, name);
    return { reading, letter, name, unit, output, label, element: h("div", { class: `readout readout-${reading.token}` }, label, mark(reading.name, label.id), output, unit), digits: 0 };
  }));
  const cells = columns.flat();
  const grid = h("div", { class: "readout-grid" }, ...columns.map((column) => h("div", {}, ...column.map(({ element }) => element))));
  root.append(grid);

  let laid = "";
  const show = metered(() => {
    const at = instant(context, seesSecond(store.state));
    const { perSecond, cursor, report } = store.state;
    for (const { reading, output, digits, element } of cells) {
      if (element.hidden) continue;
      const place = perSecond ? reading.placeTimed : reading.place;
      const text = place < 0 ? format.number(cursor, { digits: decimalsOf(store.state, cycleOf(report)) }) : format.number(at[place], { digits });
      write(output, text);
    }
  });

  store.subscribe(["report", "perSecond", "language", "second"], lay);
  store.subscribe(["cursor", "playing", "report", "perSecond", "language", "second"], show);
  if (/** @type {State["report"] | undefined} */ (store.state.report)) {
    lay();
    show();
  }

  /** Letters, units, and as many decimals as give the largest value of the turn four figures. */
  function lay() {
    const { perSecond, language } = store.state;
    const report = inSight(store.state);
    const { units, mechanism } = report;
    const next = [language, era(), perSecond, report.travels, mechanism.contact, units.s, units.length, ...cells.map(({ reading }) => `${digitsOf(reading, report, perSecond)}:${Math.floor(Math.log10(reading.size(report, perSecond) || 1))}`)].join();
    if (next === laid) return;
    laid = next;
    root.setAttribute("aria-label", t("readout.title"));
    let figures = 0;
    let measure = 0;
    for (const cell of cells) {
      const { reading } = cell;
      cell.digits = digitsOf(reading, report, perSecond);
      const place = reading.place < 0;
      write(cell.letter, place ? letterOf(report) : plain(perSecond ? reading.timed : reading.letter));
      const name = t(place && report.travels ? "readout.place" : reading.name === "sliding" && report.mechanism.contact === "roller" ? "readout.rolling" : `readout.${reading.name}`);
      write(cell.name, ` ${name}`);
      cell.element.title = name;
      const unit = reading.unit(report, perSecond);
      write(cell.unit, unit);
      const own = format.number(-reading.size(report, perSecond), { digits: cell.digits }).length;
      figures = Math.max(figures, own);
      cell.element.style.setProperty("--figures", `${own}ch`);
      measure = Math.max(measure, unit.length * UNIT);
      cell.element.hidden = reading.name === "contact" && !report.summary.contact;
    }
    grid.style.setProperty("--unit", `${measure}ch`);
    grid.style.setProperty("--cell", `calc(2.6em + ${figures + measure}ch)`);
  }
}

/**
 * Decimals of a reading.
 * @param {Reading} reading
 * @param {Report} report
 * @param {boolean} perSecond
 */
function digitsOf(reading, report, perSecond) {
  const size = reading.size(report, perSecond);
  if (!(size > 0) || reading.unit(report, perSecond) === "°") return ANGLE_DIGITS;
  const small = reading.name === "t" ? SMALL_TIME : SMALL;
  return Math.min(Math.max((report.travels || size < small ? SIGNIFICANT_SMALL : SIGNIFICANT) - 1 - Math.floor(Math.log10(size)), 0), MOST_DIGITS);
}
