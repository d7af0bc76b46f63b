// Motion laws and programs from the formulas of textbooks, written a second time without a look at the core.
// A state is [y, y′, y″, y‴]; laws are functions of x ∈ [0, 1), values on an inner joint being limits from the right.
import { ABSOLUTE, polynomial } from "./free.mjs";

/** @typedef {[number, number, number, number]} State */
/** @typedef {{ law: string, beta: number, rise?: number, [parameter: string]: unknown }} Segment */

const { PI, sin, cos } = Math;
const TAU = 2 * PI;

/** A place this close to a joint (parts of a segment) is on it. */
const ON_A_JOINT = 1e-9;

/**
 * y(x) = 1 − y(1 − x): the second half of a law that is its own reverse.
 * @param {(x: number) => State} half
 * @param {number} x
 * @returns {State}
 */
const antisymmetric = (half, x) => {
  if (x < 0.5 - ON_A_JOINT) return half(x);
  const [y, v, a, j] = half(1 - x);
  return [1 - y, v, -a, j];
};

/**
 * Norton's SCCA family, first half: sine over b/2, constant over c/2, cosine over the half of d.
 * @param {number} x
 * @param {number} b
 * @param {number} c
 * @returns {State}
 */
function sineConstantCosine(x, b, c) {
  const d = 1 - b - c;
  const peak = (4 * PI ** 2) / ((PI ** 2 - 8) * (b ** 2 - d ** 2) - TAU * (PI - 2) * b + PI ** 2);
  /** @type {State} */
  let state;
  if (b > 0 && x < b / 2) {
    const angle = (PI * x) / b;
    state = [(b / PI) * x - (b / PI) ** 2 * sin(angle), (b / PI) * (1 - cos(angle)), sin(angle), (PI / b) * cos(angle)];
  } else if (x <= (1 - d) / 2) {
    const line = b * (1 / PI - 1 / 2);
    state = [x ** 2 / 2 + line * x + b ** 2 * (1 / 8 - 1 / PI ** 2), x + line, 1, 0];
  } else {
    const [angle, line] = [(PI / d) * (x - (1 - d) / 2), b / PI + c / 2];
    const constant = (d / PI) ** 2 + b ** 2 * (1 / 8 - 1 / PI ** 2) - (1 - d) ** 2 / 8;
    state = [line * x + constant - (d / PI) ** 2 * cos(angle), line + (d / PI) * sin(angle), cos(angle), (-PI / d) * sin(angle)];
  }
  return /** @type {State} */ (state.map((value) => peak * value));
}

/**
 * A law that is its own reverse, its halves stretched so that they meet at `crossover` with the same velocity.
 * @param {(x: number) => State} half
 * @param {number} crossover
 * @param {number} x
 * @returns {State}
 */
const skewed = (half, crossover, x) => {
  const first = x < crossover - ON_A_JOINT;
  const twice = 2 * (first ? crossover : 1 - crossover);
  const [y, v, a, j] = half((first ? x : 1 - x) / twice);
  return first ? [twice * y, v, a / twice, j / twice ** 2] : [1 - twice * y, v, -a / twice, j / twice ** 2];
};

/** @type {Record<string, (x: number, segment: Segment) => State>} */
const LAWS = {
  dwell: () => [0, 0, 0, 0],
  "constant-velocity": (x) => [x, 1, 0, 0],
  parabolic: (x) => antisymmetric((u) => [2 * u * u, 4 * u, 4, 0], x),
  "parabolic-blend": (x, { beta, beta1, beta3 }) => {
    const [first, last] = [Number(beta1) / beta, Number(beta3) / beta];
    const speed = 1 / (first / 2 + (1 - first - last) + last / 2);
    if (x < first - ON_A_JOINT) return [(speed * x * x) / (2 * first), (speed * x) / first, speed / first, 0];
    if (x < 1 - last - ON_A_JOINT) return [speed * (x - first / 2), speed, 0, 0];
    return [1 - (speed * (1 - x) ** 2) / (2 * last), (speed * (1 - x)) / last, -speed / last, 0];
  },
  "cubic-1": (x) => antisymmetric((u) => [4 * u ** 3, 12 * u * u, 24 * u, 24], x),
  "cubic-2": polynomial([0, 0, 3, -2]),
  "simple-harmonic": (x) => [(1 - cos(PI * x)) / 2, (PI / 2) * sin(PI * x), (PI ** 2 / 2) * cos(PI * x), (-(PI ** 3) / 2) * sin(PI * x)],
  "double-harmonic": (x, { rise = 0 }) => {
    /** @param {number} u @returns {State} */
    const rising = (u) => [
      (1 - cos(PI * u) - (1 - cos(TAU * u)) / 4) / 2,
      (PI / 2) * (sin(PI * u) - sin(TAU * u) / 2),
      (PI ** 2 / 2) * (cos(PI * u) - cos(TAU * u)),
      (PI ** 3 / 2) * (2 * sin(TAU * u) - sin(PI * u)),
    ];
    if (rise >= 0) return rising(x);
    const [y, v, a, j] = rising(1 - x);
    return [1 - y, v, -a, j];
  },
  cycloidal: (x) => [x - sin(TAU * x) / TAU, 1 - cos(TAU * x), TAU * sin(TAU * x), TAU ** 2 * cos(TAU * x)],
  "freudenstein-1-3-5": (x) => {
    // With the coefficients 1, 1/54 and 1/1250 the velocity is zero at both ends for this share alone.
    const share = 1 / (1 + 3 / 54 + 5 / 1250);
    /** @param {(angle: number) => number} wave @param {number} order */
    const harmonics = (wave, order) => wave(TAU * x) + (3 ** order * wave(3 * TAU * x)) / 54 + (5 ** order * wave(5 * TAU * x)) / 1250;
    return [x - (share / TAU) * harmonics(sin, 0), 1 - share * harmonics(cos, 1), share * TAU * harmonics(sin, 2), share * TAU ** 2 * harmonics(cos, 3)];
  },
  "polynomial-3-4-5": polynomial([0, 0, 0, 10, -15, 6]),
  "polynomial-4-5-6-7": polynomial([0, 0, 0, 0, 35, -84, 70, -20]),
  "modified-trapezoidal": (x) => antisymmetric((u) => sineConstantCosine(u, 1 / 4, 1 / 2), x),
  "modified-sine": (x) => antisymmetric((u) => sineConstantCosine(u, 1 / 4, 0), x),
  scca: (x, { b, c }) => antisymmetric((u) => sineConstantCosine(u, Number(b), Number(c)), x),
  "skewed-scca": (x, { b, c, crossover }) => skewed((u) => sineConstantCosine(u, Number(b), Number(c)), Number(crossover), x),
  "asymmetric-3-4-5": (x, { crossover }) => skewed(polynomial([0, 0, 0, 10, -15, 6]), Number(crossover), x),
  "half-harmonic-start": (x) => {
    const [half, angle] = [PI / 2, (PI / 2) * x];
    return [1 - cos(angle), half * sin(angle), half ** 2 * cos(angle), -(half ** 3) * sin(angle)];
  },
  "half-harmonic-end": (x) => {
    const [half, angle] = [PI / 2, (PI / 2) * x];
    return [sin(angle), half * cos(angle), -(half ** 2) * sin(angle), -(half ** 3) * cos(angle)];
  },
  "half-cycloidal-start": (x) => [x - sin(PI * x) / PI, 1 - cos(PI * x), PI * sin(PI * x), PI ** 2 * cos(PI * x)],
  "half-cycloidal-end": (x) => [x + sin(PI * x) / PI, 1 + cos(PI * x), -PI * sin(PI * x), -(PI ** 2) * cos(PI * x)],
};

/** Laws that take their end conditions from their neighbours, with Hermite's closed forms of their coefficients. */
const MATCHED = {
  /** @param {State} start @param {State} end */
  "polynomial-5": ([y0, v0, a0], [y1, v1, a1]) => {
    const d = y1 - y0;
    return [
      y0, v0, a0 / 2,
      10 * d - 6 * v0 - 4 * v1 - (3 * a0 - a1) / 2,
      -15 * d + 8 * v0 + 7 * v1 + (3 * a0 - 2 * a1) / 2,
      6 * d - 3 * (v0 + v1) - (a0 - a1) / 2,
    ];
  },
  /** @param {State} start @param {State} end */
  "polynomial-7": ([y0, v0, a0, j0], [y1, v1, a1, j1]) => {
    const d = y1 - y0;
    return [
      y0, v0, a0 / 2, j0 / 6,
      35 * d - 20 * v0 - 15 * v1 - 5 * a0 + (5 / 2) * a1 - (2 / 3) * j0 - j1 / 6,
      -84 * d + 45 * v0 + 39 * v1 + 10 * a0 - 7 * a1 + j0 + j1 / 2,
      70 * d - 36 * v0 - 34 * v1 - (15 / 2) * a0 + (13 / 2) * a1 - (2 / 3) * j0 - j1 / 2,
      -20 * d + 10 * v0 + 10 * v1 + 2 * a0 - 2 * a1 + j0 / 6 + j1 / 6,
    ];
  },
};

/** The support of a circle under a flat face, for cams made of arcs alone. @type {typeof LAWS} */
const ARCS = {
  "circular-arc": (x, { beta }) => {
    const angle = (beta * PI) / 180;
    const height = 1 / (2 * (1 - cos(angle / 2)));
    const half = (/** @type {number} */ u) => /** @type {State} */ ([height * (1 - cos(angle * u)), height * angle * sin(angle * u), height * angle ** 2 * cos(angle * u), -height * angle ** 3 * sin(angle * u)]);
    return antisymmetric(half, x);
  },
};

export const FREE_LAWS = [...Object.keys(LAWS), ...Object.keys(ABSOLUTE)];
export const MATCHED_LAWS = Object.keys(MATCHED);

/** @param {Segment} segment @returns {segment is Segment & { law: keyof typeof MATCHED }} */
const isMatched = (segment) => segment.law in MATCHED;

/**
 * Displacement and derivatives per radian at any θ in degrees, limits from the right on joints.
 * @param {Segment[]} segments
 * @param {boolean} [swings]  heights are degrees
 * @returns {(theta: number) => State}
 */
export function motion(segments, swings = false) {
  const starts = [0];
  const heights = [0];
  /** @type {(((x: number) => State) | undefined)[]} */
  const absolute = [];
  const n = segments.length;
  /** The derivatives per radian of a law of its own at x. @param {number} k @param {number} x @returns {State} */
  const unit = (k, x) => {
    const { law, beta, rise = 0 } = segments[k];
    const radians = (beta * PI) / 180;
    return /** @type {State} */ ((LAWS[law] ?? ARCS[law])(x, segments[k]).map((value, order) => (rise * value) / radians ** order));
  };
  /** Motion at an end of a neighbour, where it depends on nothing else. @param {number} k @param {number} x */
  const edge = (k, x) => (segments[k].law in LAWS ? unit(k, x) : undefined);
  for (const [k, segment] of segments.entries()) {
    const { beta, rise = 0, law } = segment;
    const around = { start: heights[k], before: edge((k + n - 1) % n, 1), after: edge((k + 1) % n, 0), alone: n === 1, swings };
    absolute.push(ABSOLUTE[law]?.(segment, around));
    starts.push(starts[k] + beta);
    heights.push(absolute[k]?.(1)[0] ?? heights[k] + rise);
  }
  /** @param {number} k @param {number} x @returns {State} */
  const free = (k, x) => absolute[k]?.(x) ?? /** @type {State} */ (unit(k, x).map((value, order) => (order === 0 ? heights[k] : 0) + value));
  /** @param {number} k @param {number} x @returns {State} */
  const matched = (k, x) => {
    const segment = segments[k];
    if (!isMatched(segment)) return free(k, x);
    const radians = (segment.beta * PI) / 180;
    /** @param {State} state @param {number} height @returns {State} */
    const inX = ([, v, a, j], height) => [height, v * radians, a * radians ** 2, j * radians ** 3];
    // Limits from the left: the end of a law, not the start of what follows.
    const before = inX(free((k + n - 1) % n, 1), heights[k]);
    const after = inX(free((k + 1) % n, 0), heights[k + 1]);
    const state = polynomial(MATCHED[segment.law](before, after))(x);
    return /** @type {State} */ (state.map((value, order) => value / radians ** order));
  };
  return (theta) => {
    const turned = ((theta % 360) + 360) % 360;
    let k = segments.length - 1;
    while (k > 0 && turned < starts[k] - ON_A_JOINT * segments[k].beta) k--;
    return matched(k, Math.max(0, (turned - starts[k]) / segments[k].beta));
  };
}
