// Random designs, and how far the `levalab` command and the formulas of cam.mjs are apart on them.
import { spawnSync } from "node:child_process";
import { columns } from "./cam.mjs";
import { FREE_LAWS, MATCHED_LAWS } from "./motion.mjs";

/** Agreement, as a part of the scale of each column. */
const AGREEMENT = 1e-6;

/** Followers, with a geometry each that can rest on its base circle; `u` is a random number in [0, 1). */
export const FOLLOWERS = {
  /** @param {() => number} u */
  "translating-roller": (u) => ({ base_radius: 30 + 40 * u(), roller_radius: 2 + 20 * u(), eccentricity: maybe(u, 25) }),
  /** @param {() => number} u */
  "translating-knife": (u) => ({ base_radius: 30 + 40 * u(), eccentricity: maybe(u, 25) }),
  /** @param {() => number} u */
  "translating-curved": (u) => ({ base_radius: 30 + 40 * u(), face_radius: 20 + 80 * u(), eccentricity: maybe(u, 25) }),
  /** @param {() => number} u */
  "translating-flat": (u) => ({ base_radius: 20 + 80 * u(), face_angle: maybe(u, 25) }),
  /** @param {() => number} u */
  "oscillating-roller": (u) => ({
    base_radius: 30 + 10 * u(),
    roller_radius: 2 + 10 * u(),
    arm: 60 + 20 * u(),
    pivot_distance: 75 + 10 * u(),
    pivot_angle: maybe(u, 180),
  }),
  /** @param {() => number} u */
  "oscillating-flat": (u) => ({
    base_radius: 20 + 40 * u(),
    face_offset: maybe(u, 15),
    pivot_distance: 80 + 60 * u(),
    pivot_angle: maybe(u, 180),
  }),
};

/** Zero one time in four, else between −size and size. @param {() => number} u @param {number} size */
function maybe(u, size) {
  return u() < 0.25 ? 0 : size * (2 * u() - 1);
}

/**
 * Random numbers in [0, 1), the same for the same seed (mulberry32).
 * @param {number} seed
 */
export function random(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/**
 * Conditions that lead from a height to another, with some derivatives at the ends and a point between them at times.
 * @param {() => number} u
 * @param {number} beta
 * @param {number} start
 * @param {number} end
 */
function conditions(u, beta, start, end) {
  const list = [{ at: 0, order: 0, value: start }, { at: beta, order: 0, value: end }];
  for (const at of [0, beta]) {
    // Every order up to one, which always has a solution.
    const orders = Math.floor(4 * u());
    for (let order = 1; order <= orders; order++) list.push({ at, order, value: u() < 0.5 ? 0 : 20 * (2 * u() - 1) });
  }
  if (u() < 0.5) list.push({ at: beta * (0.2 + 0.6 * u()), order: 0, value: 15 * u() });
  return list;
}

/** Inner places of a segment, apart from each other. @param {() => number} u @param {number} beta @param {number} count */
const places = (u, beta, count) => Array.from({ length: count }, (_, k) => (beta * (k + 1 + 0.6 * (u() - 0.5))) / (count + 1));

/**
 * More conditions than the degree of a spline; at times with its knots, near the means of conditions that it would take.
 * @param {() => number} u
 * @param {number} beta
 * @param {number} start
 * @param {number} end
 */
function spline(u, beta, start, end) {
  const degree = 4 + Math.floor(5 * u());
  const ends = conditions(u, beta, start, end).filter(({ at }) => at === 0 || at === beta);
  const inner = Math.max(0, degree + 1 - ends.length) + Math.floor(5 * u());
  const list = [...ends, ...places(u, beta, inner).map((at) => ({ at, order: 0, value: 15 * u() }))].sort((a, b) => a.at - b.at || a.order - b.order);
  const means = list.slice(1, list.length - degree).map((_, i) => list.slice(i + 1, i + 1 + degree).reduce((sum, { at }) => sum + at, 0) / degree);
  const told = means.map((at, i) => at + 0.2 * (u() - 0.5) * ((means[i + 1] ?? beta) - at));
  return { conditions: list, degree, ...(u() < 0.4 && told.length > 0 && { knots: told }) };
}

/**
 * Measured points, half of them to be smoothed.
 * @param {() => number} u
 * @param {number} beta
 * @param {number} start
 * @param {number} end
 */
function table(u, beta, start, end) {
  const inner = places(u, beta, 2 + Math.floor(8 * u())).map((at) => [at, 15 * u()]);
  return { points: [[0, start], ...inner, [beta, end]], ...(u() < 0.5 && { smoothing: 0.001 + 0.02 * u() }) };
}

/** Formulas that lead from s₀ to s₀ + L, with a number of their own. @type {((a: string) => string)[]} */
const FORMULAS = [
  (a) => `s0 + L(x - sin(2π x)/(2π)) + ${a} sin(π x)^4`,
  (a) => `s0 + L x^3 (10 - 15x + 6x^2) - ${a}x^2*(1 - x)^2`,
  (a) => `s0 + L/2 (1 - cos(π x)) * exp(${a} x (1 - x))`,
  (a) => `s0 + L (exp(${a}x) - 1)/(exp(${a}) - 1)`,
  (a) => `s0 + L (sqrt(1 + ${a}x) - 1)/(sqrt(1 + ${a}) - 1)`,
  (a) => `s0 + L ln(1 + ${a}x)/ln(1 + ${a}) + atan(θ (β - θ))`,
  (a) => `s0 + L ((1 + θ/β)^(1 + x) - 1)/3 - ${a}x(1 - x)^3`,
];

/**
 * What a law takes besides β and L.
 * @param {() => number} u
 * @param {string} law
 * @param {number} beta
 */
function parameters(u, law, beta) {
  const b = u();
  const c = (1 - b) * u();
  const crossover = 0.1 + 0.8 * u();
  if (law === "scca") return { b, c };
  if (law === "skewed-scca") return { b, c, crossover };
  if (law === "asymmetric-3-4-5") return { crossover };
  return law === "parabolic-blend" ? { beta1: b * beta, beta3: c * beta } : {};
}

/**
 * A cycle of two to seven segments; half of them begin on whole degrees, where rows lie on joints.
 * @param {() => number} u
 * @param {number} lift
 */
function segments(u, lift) {
  // A table of the whole turn joins itself.
  if (u() < 0.1) return [{ law: "table", beta: 360, ...table(u, 360, 0, 0) }];
  const n = 2 + Math.floor(6 * u());
  const grid = u() < 0.5 ? 1 : 1000;
  const laws = [...FREE_LAWS, ...MATCHED_LAWS];
  /** @type {import("./motion.mjs").Segment[]} */
  const list = [];
  let [angle, height] = [0, 0];
  for (let k = 0; k < n; k++) {
    const last = k === n - 1;
    const beta = last ? 360 - angle : Math.round(((360 - angle) / (n - k)) * (0.6 + 0.7 * u()) * grid) / grid;
    let law = laws[Math.floor(laws.length * u())];
    const beside = list.some(({ law }, i) => MATCHED_LAWS.includes(law) && (i === k - 1 || (last && i === 0)));
    if ((MATCHED_LAWS.includes(law) && beside) || (law === "dwell" && last && height !== 0)) law = "cycloidal";
    const target = last ? 0 : law === "dwell" ? height : Math.round(lift * u() * 1000) / 1000;
    const own = parameters(u, law, beta);
    if (law === "bspline") list.push({ law, beta, ...spline(u, beta, height, target) });
    else if (law === "table") list.push({ law, beta, ...table(u, beta, height, target) });
    else if (law === "formula") list.push({ law, beta, rise: target - height, expression: FORMULAS[Math.floor(FORMULAS.length * u())]((0.1 + 2 * u()).toFixed(3)) });
    else if (law === "bezier") list.push({ law, beta, ordinates: [height, ...Array.from({ length: Math.floor(6 * u()) }, () => 15 * u()), target] });
    else if (law === "polynomial") list.push({ law, beta, conditions: conditions(u, beta, height, target) });
    else list.push({ law, beta, rise: target - height, ...own });
    [angle, height] = [angle + beta, target];
  }
  return list;
}

/**
 * @param {keyof typeof FOLLOWERS} kind
 * @param {"counterclockwise" | "clockwise"} rotation
 * @param {number} seed
 * @returns {import("./cam.mjs").Design}
 */
export function randomDesign(kind, rotation, seed) {
  const u = random(seed);
  const [motion, contact] = kind.split("-");
  /** @type {{ base_radius: number, [parameter: string]: number }} */
  const { base_radius, ...parameters } = FOLLOWERS[kind](u);
  return {
    // The newest version that is published holds what every earlier one held.
    format: "levalab/2",
    title: `Random ${kind} ${seed}`,
    length_unit: "mm",
    speed: { value: 1, unit: "rad/s" },
    cam: { kind: "rotating", rotation, base_radius },
    follower: { motion, contact, ...parameters },
    segments: segments(u, motion === "oscillating" ? 20 : 15),
  };
}

/**
 * The columns of the command under test; null where a value is not finite.
 * @param {string} binary
 * @param {object} design
 * @param {number} samples
 * @returns {Record<string, (number | null)[]>}
 */
export function analyze(binary, design, samples) {
  const options = { input: JSON.stringify(design), encoding: /** @type {const} */ ("utf8"), maxBuffer: 1e8 };
  const { status, stdout, stderr, error } = spawnSync(binary, ["analyze", "-", "--samples", String(samples), "--json"], options);
  if (error || status !== 0) throw new Error(`${binary}: ${error ?? stderr}`);
  return JSON.parse(stdout).columns;
}

/**
 * What differs between the command and the formulas: nothing, or one line a column.
 * @param {string} binary
 * @param {import("./cam.mjs").Design} design
 * @param {number} samples
 */
export function disagreements(binary, design, samples) {
  const [found, expected] = [analyze(binary, design, samples), columns(design, samples)];
  const lines = [];
  const [names, wanted] = [found, expected].map((table) => Object.keys(table).sort().join(" "));
  if (names !== wanted) lines.push(`columns ${names}, expected ${wanted}`);
  // One scale for what shares an axis; a curve that is all but flat is not measured by its own rounding.
  const size = Math.max(...expected.x.map(Math.abs), ...expected.y.map(Math.abs));
  for (const [name, values] of Object.entries(expected)) {
    const inPlane = ["x", "y", "pitch_x", "pitch_y", "outer_x", "outer_y", "contact"].includes(name);
    const scale = inPlane ? size : Math.max(...values.map(Math.abs));
    const same = name.startsWith("rho") ? sameRadius(size) : name === "pressure_angle" ? sameAngle(design.follower) : sameValue(scale);
    const row = values.findIndex((value, i) => !same(found[name]?.[i], value));
    if (row >= 0) lines.push(`${name} is ${found[name]?.[row]} at row ${row}, expected ${values[row]}`);
  }
  return lines;
}

/** @typedef {(found: number | null | undefined, value: number) => boolean} Comparison */

/** @param {number} scale @returns {Comparison} */
function sameValue(scale) {
  return (found, value) => typeof found === "number" && Math.abs(found - value) <= AGREEMENT * scale;
}

/**
 * Degrees. The sign of φ is fixed for a disc that slides, which is steep in its rise; for the others only its size is.
 * @param {{ motion: string, contact: string }} follower
 * @returns {Comparison}
 */
function sameAngle({ motion, contact }) {
  const signed = motion === "translating" && contact !== "flat";
  const same = sameValue(1);
  return (found, value) => (signed ? same(found, value) : typeof found === "number" && same(Math.abs(found), Math.abs(value)));
}

/**
 * A radius of curvature has no scale of its own: where it runs to infinity, from either side, curvatures are compared.
 * @param {number} size
 * @returns {Comparison}
 */
function sameRadius(size) {
  return (found, value) => {
    if (found === undefined) return false;
    const radius = found ?? Infinity;
    const near = Math.abs(radius - value) <= AGREEMENT * Math.max(size, Math.abs(value));
    return near || Math.abs(1 / radius - 1 / value) <= AGREEMENT / size;
  };
}
