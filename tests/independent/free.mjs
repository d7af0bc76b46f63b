// Laws that give s itself from data of their segment, written a second time without a look at the core: splines by one dense system for the
// coefficients of all their pieces, formulas by power series.
import { series } from "./formula.mjs";

/** @typedef {import("./motion.mjs").State} State */
/** @typedef {import("./motion.mjs").Segment} Segment */
/** @typedef {{ at: number, order: number, value: number }} Condition */

/**
 * What lies around a segment: the height at which it starts, and the neighbours' motion at its ends where that does not depend on it.
 * `swings`: heights are degrees.
 * @typedef {{ start: number, before?: State, after?: State, alone: boolean, swings: boolean }} Around
 */

/** Points nearest to an open end of a table, from which its derivatives there are taken. */
const NEAREST = 6;

/** Halvings of the logarithm of a weight. */
const HALVINGS = 70;

/** @param {number} degrees */
const radiansOf = (degrees) => (degrees * Math.PI) / 180;

/**
 * A polynomial by its coefficients, constant term first.
 * @param {number[]} coefficients
 * @returns {(x: number) => State}
 */
export const polynomial = (coefficients) => (x) => {
  /** @type {State} */
  const state = [0, 0, 0, 0];
  coefficients.forEach((c, k) => {
    let factor = c;
    for (let order = 0; order < 4 && order <= k; order++) {
      state[order] += factor * x ** (k - order);
      factor *= k - order;
    }
  });
  return state;
};

/**
 * Derivatives with respect to x as derivatives per radian.
 * @param {(x: number) => State} state
 * @param {number} beta
 * @returns {(x: number) => State}
 */
const perRadian = (state, beta) => (x) => /** @type {State} */ (state(x).map((value, order) => value / radiansOf(beta) ** order));

/**
 * Gauss's elimination with the greatest pivot of each column, of rows brought to one size; the last entry of a row is its right-hand side.
 * @param {number[][]} given
 */
function eliminate(given) {
  const rows = given.map((row) => {
    const size = Math.max(...row.slice(0, -1).map(Math.abs));
    return row.map((value) => value / size);
  });
  const n = rows.length;
  for (let k = 0; k < n; k++) {
    let pivot = k;
    for (let i = k + 1; i < n; i++) if (Math.abs(rows[i][k]) > Math.abs(rows[pivot][k])) pivot = i;
    [rows[k], rows[pivot]] = [rows[pivot], rows[k]];
    for (let i = 0; i < n; i++) {
      const factor = i === k ? 0 : rows[i][k] / rows[k][k];
      if (factor !== 0) for (let c = k; c <= n; c++) rows[i][c] -= factor * rows[k][c];
    }
  }
  return rows.map((row, k) => row[n] / row[k]);
}

/** The derivative of that order of every power of u up to a degree. @param {number} degree @param {number} order @param {number} u */
const powers = (degree, order, u) =>
  Array.from({ length: degree + 1 }, (_, k) => {
    let factor = k < order ? 0 : u ** (k - order);
    for (let i = 0; i < order; i++) factor *= k - i;
    return factor;
  });

/**
 * Pieces of a degree between breaks in [0, 1], each in its own u ∈ [0, 1], that are to be found.
 * @param {number[]} breaks
 * @param {number} degree
 */
function unknownPieces(breaks, degree) {
  const count = breaks.length - 1;
  /** @param {number} x */
  const pieceOf = (x) => Math.min(count - 1, Math.max(0, breaks.findLastIndex((from) => from <= x)));
  /** A derivative of one piece at x as a row of the system, its right-hand side 0. @param {number} piece @param {number} x @param {number} order @returns {number[]} */
  const of = (piece, x, order) => {
    const width = breaks[piece + 1] - breaks[piece];
    const own = powers(degree, order, (x - breaks[piece]) / width).map((value) => value / width ** order);
    const row = new Array(count * (degree + 1) + 1).fill(0);
    own.forEach((value, k) => (row[piece * (degree + 1) + k] = value));
    return row;
  };
  /** @param {number[]} row @param {number} value */
  const is = (row, value) => [...row.slice(0, -1), value];
  /** @param {number[]} one @param {number[]} other @param {number} [weight] */
  const less = (one, other, weight = 1) => one.map((value, k) => value - weight * other[k]);
  /** What a derivative gains at an inner break. @param {number} k @param {number} order */
  const jump = (k, order) => less(of(k, breaks[k], order), of(k - 1, breaks[k], order));
  /** @param {number[][]} rows @returns {(x: number) => State} */
  const solve = (rows) => {
    const found = eliminate(rows);
    return (x) => {
      const piece = pieceOf(x + 1e-12);
      const width = breaks[piece + 1] - breaks[piece];
      const state = polynomial(found.slice(piece * (degree + 1), (piece + 1) * (degree + 1)))((x - breaks[piece]) / width);
      return /** @type {State} */ (state.map((value, order) => value / width ** order));
    };
  };
  return { count, pieceOf, of, is, less, jump, solve };
}

/**
 * One polynomial through a segment's conditions.
 * @param {Segment} segment
 */
function throughConditions({ beta, conditions }) {
  const list = /** @type {Condition[]} */ (conditions);
  const rows = list.map(({ at, order, value }) => [...powers(list.length - 1, order, at / beta), value * radiansOf(beta) ** order]);
  return perRadian(polynomial(eliminate(rows)), beta);
}

/**
 * Bézier's curve and its derivatives, from the differences of its ordinates.
 * @param {Segment} segment
 */
function bernstein({ beta, ordinates }) {
  /** @param {number[]} points @param {number} x @returns {number} */
  const at = (points, x) => (points.length === 1 ? points[0] : at(points.slice(1).map((next, i) => points[i] + x * (next - points[i])), x));
  const orders = [/** @type {number[]} */ (ordinates)];
  for (let order = 1; order < 4; order++) {
    const before = orders[order - 1];
    const degree = before.length - 1;
    orders.push(degree > 0 ? before.slice(1).map((next, i) => degree * (next - before[i])) : [0]);
  }
  return perRadian((x) => /** @type {State} */ (orders.map((points) => at(points, x))), beta);
}

/**
 * A spline through conditions: pieces that meet with every derivative below their degree. Knots are told, or means of as many neighbouring
 * conditions as the degree.
 * @param {Segment} segment
 */
function spline({ beta, conditions, degree = 5, knots }) {
  const list = [.../** @type {Condition[]} */ (conditions)].sort((a, b) => a.at - b.at);
  const power = Number(degree);
  const means = list.slice(1, list.length - power).map((_, i) => list.slice(i + 1, i + 1 + power).reduce((sum, { at }) => sum + at, 0) / power);
  const inner = /** @type {number[] | undefined} */ (knots) ?? means;
  const breaks = [0, ...inner.map((at) => at / beta), 1];
  const { pieceOf, of, is, jump, solve } = unknownPieces(breaks, power);
  const met = list.map(({ at, order, value }) => is(of(pieceOf(at / beta), at / beta, order), value * radiansOf(beta) ** order));
  const smooth = inner.flatMap((_, k) => Array.from({ length: power }, (_, order) => jump(k + 1, order)));
  return perRadian(solve([...met, ...smooth]), beta);
}

/**
 * Measured points: quintics that meet with four derivatives and go through the points; or, smoothed, past the inner ones. Of all curves with
 * those residuals the one with the least ∫(s‴)² has a fifth derivative that jumps at each point in proportion to its residual (Euler and Lagrange).
 * @param {Segment} segment
 * @param {Around} around
 */
function table({ beta, points, smoothing = 0 }, { before, after, alone }) {
  const list = /** @type {[number, number][]} */ (points).map(([at, s]) => /** @type {const} */ ([at / beta, s]));
  const last = list.length - 1;
  const { of, is, less, jump, solve } = unknownPieces(list.map(([x]) => x), 5);
  const turn = radiansOf(beta);
  const tolerance = Number(smoothing);
  const inner = list.slice(1, -1).map((_, k) => k + 1);

  /** The polynomial through the points nearest to an end. @param {boolean} atEnd */
  const nearest = (atEnd) => {
    const near = atEnd ? list.slice(-NEAREST) : list.slice(0, NEAREST);
    const from = near[0][0];
    const width = near[near.length - 1][0] - from;
    const state = polynomial(eliminate(near.map(([x, s]) => [...powers(near.length - 1, 0, (x - from) / width), s])))(atEnd ? 1 : 0);
    return state.map((value, order) => value / (width * turn) ** order);
  };

  /** Four rows for both ends: derivatives that are known; else those of the nearest points, or none bent when the curve is free. */
  const ends = () => {
    if (alone) return [1, 2, 3, 4].map((order) => less(of(last - 1, 1, order), of(0, 0, order)));
    return /** @type {const} */ ([[0, 0, before], [last - 1, 1, after]]).flatMap(([piece, x, known]) => {
      const state = known ?? (tolerance > 0 ? undefined : nearest(x === 1));
      return state ? [1, 2].map((order) => is(of(piece, x, order), state[order] * turn ** order)) : [3, 4].map((order) => of(piece, x, order));
    });
  };
  const held = [is(of(0, 0, 0), list[0][1]), is(of(last - 1, 1, 0), list[last][1])];
  const smooth = inner.flatMap((k) => [0, 1, 2, 3, 4].map((order) => jump(k, order)));

  if (tolerance === 0) {
    const met = inner.map((k) => is(of(k, list[k][0], 0), list[k][1]));
    return perRadian(solve([...held, ...met, ...smooth, ...ends()]), beta);
  }
  /** @param {number} weight */
  const relaxed = (weight) => solve([...held, ...smooth, ...ends(), ...inner.map((k) => is(less(jump(k, 5), of(k, list[k][0], 0), weight), -weight * list[k][1]))]);
  /** @param {(x: number) => State} curve */
  const residual = (curve) => Math.sqrt(inner.reduce((sum, k) => sum + (curve(list[k][0])[0] - list[k][1]) ** 2, 0) / inner.length);
  // Weights of the points in ∫(s‴)² + weight·Σ residual², x from 0 to 1.
  let [low, high] = [Math.log(1e-6), Math.log(1e18)];
  for (let i = 0; i < HALVINGS; i++) {
    const middle = (low + high) / 2;
    if (residual(relaxed(Math.exp(middle))) > tolerance) low = middle;
    else high = middle;
  }
  return perRadian(relaxed(Math.exp(high)), beta);
}

/**
 * The user's own expression, as a power series about x. All of its angles are radians, those of a follower that swings too.
 * @param {Segment} segment
 * @param {Around} around
 */
function expression({ beta, rise = 0, expression }, { start, swings }) {
  const unit = swings ? radiansOf(1) : 1;
  const names = { β: radiansOf(beta), L: rise * unit, s0: start * unit, π: Math.PI };
  return perRadian((x) => {
    const [c0, c1, c2, c3] = series(String(expression), x, { ...names, θ: [x * names.β, names.β] }).map((c) => c / unit);
    return [c0, c1, 2 * c2, 6 * c3];
  }, beta);
}

/** @type {Record<string, (segment: Segment, around: Around) => (x: number) => State>} */
export const ABSOLUTE = { polynomial: throughConditions, bezier: bernstein, bspline: spline, table, formula: expression };
