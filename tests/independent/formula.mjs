// Expressions as power series: what is read is added, multiplied and put into functions term by term, up to the third.

/** A power series about a place: value, and coefficients of the first three powers. @typedef {number[]} Series */

const TERMS = [0, 1, 2, 3];

/** @param {number} value @returns {Series} */
const constant = (value) => [value, 0, 0, 0];

/** Σ of products whose indices add up to n. @param {Series} a @param {Series} b @param {number} n @param {number} [from] */
const cauchy = (a, b, n, from = 0) => TERMS.slice(from, n + 1).reduce((sum, k) => sum + a[k] * b[n - k], 0);

/** @param {Series} a @param {Series} b @returns {Series} */
const times = (a, b) => TERMS.map((n) => cauchy(a, b, n));

/** q·b = a, term by term. @param {Series} a @param {Series} b @returns {Series} */
function divided(a, b) {
  /** @type {Series} */
  const q = [];
  for (const n of TERMS) q.push((a[n] - cauchy(b, [...q, 0, 0, 0, 0], n, 1)) / b[0]);
  return q;
}

/** The series of f(a) from f at its first term and f′(a) as a series: n·fₙ = Σ k·aₖ·f′ₙ₋ₖ. @param {Series} a @param {number} first @param {(soFar: Series) => Series} slope @returns {Series} */
function composed(a, first, slope) {
  const f = [first];
  for (const n of TERMS.slice(1)) {
    const d = slope([...f, 0, 0, 0, 0]);
    f.push(TERMS.slice(1, n + 1).reduce((sum, k) => sum + k * a[k] * d[n - k], 0) / n);
  }
  return f;
}

/** sin and cos hang on each other. @param {Series} a */
function waves(a) {
  const [sin, cos] = [[Math.sin(a[0])], [Math.cos(a[0])]];
  for (const n of TERMS.slice(1)) {
    const of = (/** @type {Series} */ other) => TERMS.slice(1, n + 1).reduce((sum, k) => sum + k * a[k] * other[n - k], 0) / n;
    const [s, c] = [of(cos), -of(sin)];
    sin.push(s);
    cos.push(c);
  }
  return { sin, cos };
}

/** @type {Record<string, (a: Series) => Series>} */
const FUNCTIONS = {
  sin: (a) => waves(a).sin,
  cos: (a) => waves(a).cos,
  exp: (a) => composed(a, Math.exp(a[0]), (soFar) => soFar),
  ln: (a) => composed(a, Math.log(a[0]), () => divided(constant(1), a)),
  atan: (a) => composed(a, Math.atan(a[0]), () => divided(constant(1), times(a, a).map((value, n) => value + (n === 0 ? 1 : 0)))),
  sqrt: (a) => composed(a, Math.sqrt(a[0]), (soFar) => divided(constant(0.5), soFar)),
};

/**
 * The series of an expression of x about a place.
 * @param {string} text
 * @param {number} place
 * @param {Record<string, number | number[]>} names
 * @returns {Series}
 */
export function series(text, place, names) {
  const tokens = text.match(/\d+\.?\d*|s0|[a-z]{2,}|[-+*/^()]|\S/g) ?? [];
  let next = 0;
  const accept = (/** @type {string} */ token) => tokens[next] === token && ++next > 0;

  /** @returns {Series} */
  function sum() {
    let total = product();
    for (;;) {
      if (accept("+")) total = product().map((value, n) => total[n] + value);
      else if (accept("-")) total = product().map((value, n) => total[n] - value);
      else return total;
    }
  }

  /** @returns {Series} */
  function product() {
    let total = signed();
    for (;;) {
      if (accept("*")) total = times(total, signed());
      else if (accept("/")) total = divided(total, signed());
      else if (next < tokens.length && !"+-)".includes(tokens[next])) total = times(total, power());
      else return total;
    }
  }

  /** @returns {Series} */
  const signed = () => (accept("-") ? signed().map((value) => -value) : power());

  /** @returns {Series} */
  function power() {
    const base = atom();
    if (!accept("^")) return base;
    const exponent = signed();
    // A whole power is a product; any other goes by the logarithm.
    if (Number.isInteger(exponent[0]) && exponent[0] >= 0 && exponent.slice(1).every((value) => value === 0)) {
      return Array.from({ length: exponent[0] }).reduce((/** @type {Series} */ all) => times(all, base), constant(1));
    }
    return FUNCTIONS.exp(times(exponent, FUNCTIONS.ln(base)));
  }

  /** @returns {Series} */
  function atom() {
    const token = tokens[next++];
    if (token === "(") {
      const inner = sum();
      if (!accept(")")) throw new Error(`no ) in ${text}`);
      return inner;
    }
    if (token in FUNCTIONS) return FUNCTIONS[token](atom());
    if (token === "x") return [place, 1, 0, 0];
    const known = names[token];
    if (Array.isArray(known)) return TERMS.map((n) => known[n] ?? 0);
    const value = known ?? Number(token);
    if (Number.isNaN(value)) throw new Error(`${token} in ${text}`);
    return constant(value);
  }

  const found = sum();
  if (next < tokens.length) throw new Error(`${tokens[next]} in ${text}`);
  return found;
}
