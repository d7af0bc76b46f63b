// The columns of `levalab analyze` computed a second time: one set of textbook formulas for each follower, written out in
// components. Run `node cam.mjs FILE [SAMPLES]` to print them.
import { readFileSync } from "node:fs";
import process from "node:process";
import { motion } from "./motion.mjs";

const { PI, sin, cos, sqrt, hypot, atan2 } = Math;
const RADIANS = PI / 180;

/**
 * @typedef {{ motion: string, contact: string, [parameter: string]: number | string }} Follower
 * @typedef {{ kind: string, rotation?: string, base_radius: number, length?: number, breadth?: number, generator?: string, sides?: number }} Cam
 * @typedef {{ cam: Cam, follower: Follower, segments?: import("./motion.mjs").Segment[], [other: string]: unknown }} Design
 */

/**
 * What is known of one contact in the fixed frame, follower on top. `contact` is there for flat faces, `rhoPitch`, `pitchX`
 * and `pitchY` for the others.
 * @typedef {{ phi: number, rho: number, x: number, y: number, rhoPitch?: number, pitchX?: number, pitchY?: number, contact?: number }} Touch
 */

/**
 * A disc that slides on an axis at eccentricity e: S = s₀ + s, h² = S² + (v − σe)², ρp = h³/(S² + (v − σe)(2v − σe) − aS).
 * @param {number} radius
 * @returns {(follower: Follower, base: number, sense: number, state: number[]) => Touch}
 */
const slidingDisc = (radius) => (follower, base, sense, [s, v, a]) => {
  const e = Number(follower.eccentricity ?? 0);
  const height = sqrt((base + radius) ** 2 - e ** 2) + s;
  const across = v - sense * e;
  const h = hypot(height, across);
  const rhoPitch = h ** 3 / (height ** 2 + across * (across + v) - a * height);
  return {
    phi: atan2(across, height),
    rho: rhoPitch - radius,
    rhoPitch,
    // The roller is touched a radius below its centre, leaning by φ against the sense of rotation.
    x: e + (sense * radius * across) / h,
    y: height - (radius * height) / h,
    pitchX: e,
    pitchY: height,
  };
};

/** @type {Record<string, (follower: Follower, base: number, sense: number, state: number[]) => Touch>} */
const FOLLOWERS = {
  "translating-roller": (follower, ...rest) => slidingDisc(Number(follower.roller_radius))(follower, ...rest),
  "translating-curved": (follower, ...rest) => slidingDisc(Number(follower.face_radius))(follower, ...rest),
  "translating-knife": slidingDisc(0),

  // Envelope of a face leaning by γ: support p = Rb + s·cos γ, and the contact −σv·cos γ along the face from its foot.
  "translating-flat": (follower, base, sense, [s, v, a]) => {
    const lean = Number(follower.face_angle ?? 0) * RADIANS;
    const p = base + s * cos(lean);
    const q = -sense * v * cos(lean);
    const x = -p * sin(lean) - q * cos(lean);
    return { phi: lean, rho: base + (s + a) * cos(lean), x, y: p * cos(lean) - q * sin(lean), contact: x };
  },

  // k = 1 + σv: |P′|² = m² + k²A² − 2mkA·cos ξ, tan φ = (kA − m·cos ξ)/(m·sin ξ).
  "oscillating-roller": (follower, base, sense, [s, v, a]) => {
    const [m, arm, radius] = [follower.pivot_distance, follower.arm, follower.roller_radius].map(Number);
    const xi = Math.acos((m ** 2 + arm ** 2 - (base + radius) ** 2) / (2 * m * arm)) + s;
    const k = 1 + sense * v;
    const [u, w] = [m - arm * k * cos(xi), arm * k * sin(xi)];
    const [du, dw] = [-arm * (sense * a * cos(xi) - k * v * sin(xi)), arm * (sense * a * sin(xi) + k * v * cos(xi))];
    const speed = hypot(u, w);
    // The normal (u, w) turns in the fixed frame by its own change, in the cam's frame by −σ more.
    const rhoPitch = speed / (1 - (sense * (u * dw - w * du)) / speed ** 2);
    const [pitchX, pitchY] = [m - arm * cos(xi), arm * sin(xi)];
    return turned(Number(follower.pivot_angle ?? 0) * RADIANS, {
      phi: atan2(k * arm - m * cos(xi), m * sin(xi)),
      rho: rhoPitch - radius,
      rhoPitch,
      x: pitchX - (radius * u) / speed,
      y: pitchY - (radius * w) / speed,
      pitchX,
      pitchY,
    });
  },

  // α = π/2 − ξ − σθ, p = f + m·sin ξ, q = dp/dα = −m·v·cos ξ/(v + σ), ρ = p + dq/dα.
  "oscillating-flat": (follower, base, sense, [s, v, a]) => {
    const [m, offset] = [follower.pivot_distance, follower.face_offset ?? 0].map(Number);
    const xi = Math.asin((base - offset) / m) + s;
    const lead = v + sense;
    const p = offset + m * sin(xi);
    const q = (-m * v * cos(xi)) / lead;
    const dq = (-m * ((a * cos(xi) - v * v * sin(xi)) * lead - v * cos(xi) * a)) / lead ** 2;
    const contact = m * cos(xi) + q;
    return turned(Number(follower.pivot_angle ?? 0) * RADIANS, {
      phi: atan2(offset, contact),
      rho: p - dq / lead,
      x: p * sin(xi) - q * cos(xi),
      y: p * cos(xi) + q * sin(xi),
      contact,
    });
  },
};

/**
 * The points of a touch turned about the cam's centre, counter-clockwise.
 * @param {number} angle
 * @param {Touch} touch
 * @returns {Touch}
 */
function turned(angle, touch) {
  const [c, n] = [cos(angle), sin(angle)];
  const result = { ...touch, x: touch.x * c - touch.y * n, y: touch.x * n + touch.y * c };
  if (touch.pitchX !== undefined && touch.pitchY !== undefined) {
    result.pitchX = touch.pitchX * c - touch.pitchY * n;
    result.pitchY = touch.pitchX * n + touch.pitchY * c;
  }
  return result;
}

/**
 * Every column of a design at `samples` equal steps, angles in degrees.
 * @param {Design} design
 * @param {number} samples
 * @returns {Record<string, number[]>}
 */
export function columns(design, samples) {
  const { cam, follower } = design;
  if (cam.kind === "translating") return travelled(design, samples);
  const segments = program(design);
  const sense = cam.rotation === "clockwise" ? -1 : 1;
  const unit = follower.motion === "oscillating" ? RADIANS : 1;
  const touch = FOLLOWERS[`${follower.motion}-${follower.contact}`];
  const at = motion(segments, follower.motion === "oscillating");
  /** @type {Record<string, number[]>} */
  const table = {};
  for (let row = 0; row <= samples; row++) {
    const theta = (360 * row) / samples;
    const state = at(theta);
    const fixed = touch(follower, cam.base_radius, sense, state.map((value) => value * unit));
    const { x, y, pitchX, pitchY } = turned(-sense * (theta % 360) * RADIANS, fixed);
    const [s, v, a, j] = state;
    const { rho, rhoPitch: rho_pitch, contact } = fixed;
    // The outer wall of a groove lies as far beyond the centre of the roller as the inner one lies before it.
    const grooved = cam.kind === "grooved" && pitchX !== undefined && pitchY !== undefined;
    const outer = grooved ? { outer_x: 2 * pitchX - x, outer_y: 2 * pitchY - y } : {};
    const ofTheCam = { rho, rho_pitch, x, y, pitch_x: pitchX, pitch_y: pitchY, contact, ...outer };
    const values = { theta, s, v, a, j, pressure_angle: fixed.phi / RADIANS, ...ofTheCam };
    for (const [name, value] of Object.entries(values)) {
      if (value !== undefined) (table[name] ??= []).push(value);
    }
  }
  return table;
}

/**
 * The segments of a design over a whole turn; those of a ready-made motion of constant breadth spelled out.
 * @param {Design} design
 * @returns {import("./motion.mjs").Segment[]}
 */
function program({ cam, segments = [] }) {
  const { kind, generator, breadth = 0, base_radius, sides = 3 } = cam;
  if (kind !== "constant-breadth") return segments;
  const rise = breadth - 2 * base_radius;
  if (generator === "harmonic") {
    const dwell = { law: "dwell", beta: 60 };
    return [1, -1].flatMap((sign) => [{ law: "simple-harmonic", beta: 120, rise: sign * rise }, dwell]);
  }
  if (generator === "circular-arc") {
    return Array.from({ length: 2 * sides }, (_, k) => ({ law: "circular-arc", beta: 180 / sides, rise: k % 2 === 0 ? rise : -rise }));
  }
  const image = segments.map((segment) => ({ ...segment, rise: -(segment.rise ?? 0) }));
  return [...segments, ...image];
}

/** Degrees: so little before its end a travel is at its end, where a turn would be at its beginning. */
const BEFORE_THE_END = 1e-9;

/**
 * A cam that travels, with a disc of radius Rf on the y axis: P = x + i(Rf + s), tan φ = s′, ρp = −(1 + s′²)^(3/2)/s″.
 * @param {Design} design
 * @param {number} samples
 * @returns {Record<string, number[]>}
 */
function travelled({ cam, follower, segments = [] }, samples) {
  const length = cam.length ?? 0;
  const radius = Number(follower.roller_radius ?? follower.face_radius ?? 0);
  // The same motion over a turn, whose derivatives are then taken along the travel.
  const at = motion(segments.map((segment) => ({ ...segment, beta: (segment.beta * 360) / length })));
  /** @type {Record<string, number[]>} */
  const table = {};
  for (let row = 0; row <= samples; row++) {
    const theta = (length * row) / samples;
    const state = at(Math.min((360 * row) / samples, 360 - BEFORE_THE_END));
    const [s, v, a, j] = state.map((value, order) => value * ((2 * PI) / length) ** order);
    const h = hypot(1, v);
    const rho_pitch = -(h ** 3) / a;
    const [pitch_x, pitch_y] = [theta, radius + s];
    const [x, y] = [pitch_x + (radius * v) / h, pitch_y - radius / h];
    const values = { theta, s, v, a, j, pressure_angle: Math.atan(v) / RADIANS, rho: rho_pitch - radius, rho_pitch, x, y, pitch_x, pitch_y };
    for (const [name, value] of Object.entries(values)) (table[name] ??= []).push(value);
  }
  return table;
}

if (process.argv[1] === import.meta.filename) {
  const [file, samples = "720"] = process.argv.slice(2);
  process.stdout.write(`${JSON.stringify(columns(JSON.parse(readFileSync(file, "utf8")), Number(samples)))}\n`);
}
