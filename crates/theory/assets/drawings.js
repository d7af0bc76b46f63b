// Drawings of the theory: cam and follower with their magnitudes, diagrams, the inversion, what undercuts a cam. Everything is
// laid out from a real profile: what touches in the drawing touches by computation.
import { s } from "../../../web/dom.js";
import { arcArrow, arrow, circle, letter, path, polar, stroke } from "../../../web/sketch.js";

/** @typedef {import("../../../web/sketch.js").Point} Point */

/**
 * @param {number} width
 * @param {number} height
 * @param {...SVGElement} parts
 */
const sheet = (width, height, ...parts) =>
  s("svg", { class: "help-drawing", viewBox: `0 0 ${width} ${height}`, "aria-hidden": "true", "data-wide": width > 220 ? "" : undefined }, ...parts);

/**
 * A magnitude, which can be lit.
 * @param {string} key
 * @param {...SVGElement} parts
 */
const part = (key, ...parts) => s("g", { "data-parameter": key, class: "dimension" }, ...parts);

const CENTRE = { x: 120, y: 150 };
const BASE = 46;
const LIFT = 40;
const ROLLER = 15;
/** Direction of the nose of the cam, degrees. */
const NOSE = 34;
const STEP = 3;

/** Radius of the profile in a direction. @param {number} degrees */
function reach(degrees) {
  const off = Math.abs(((degrees - NOSE + 540) % 360) - 180);
  return BASE + (off < 100 ? (LIFT * (1 + Math.cos((off * Math.PI) / 100))) / 2 : 0);
}

/** Point of the profile. @param {number} degrees @param {Point} [centre] */
const profileAt = (degrees, centre = CENTRE) => polar(centre, reach(degrees), degrees);

/** Directions of a whole turn. */
const TURN = Array.from({ length: 360 / STEP }, (_, i) => i * STEP);

const cam = () => stroke("cam", path(...TURN.map((at) => profileAt(at))) + "z");

/** Outward normal of the profile. @param {number} degrees @returns {Point} */
function normalAt(degrees) {
  const [before, after] = [profileAt(degrees - 0.5), profileAt(degrees + 0.5)];
  const [dx, dy] = [after.x - before.x, after.y - before.y];
  const size = Math.hypot(dx, dy);
  return { x: -dy / size, y: dx / size };
}

/** @param {Point} from @param {Point} along @param {number} by */
const off = (from, along, by) => ({ x: from.x + along.x * by, y: from.y + along.y * by });

/** The point of the parallel curve. @param {number} degrees @param {number} by */
const parallel = (degrees, by) => off(profileAt(degrees), normalAt(degrees), by);

/** The direction in which the parallel curve crosses the axis above the centre. */
function touching() {
  let [low, high] = [40, 140];
  for (let i = 0; i < 60; i++) {
    const middle = (low + high) / 2;
    if (parallel(middle, ROLLER).x > CENTRE.x) low = middle;
    else high = middle;
  }
  return low;
}

/** Radius of curvature of the profile, from three points. @param {number} degrees */
function radiusAt(degrees) {
  const [a, b, c] = [-3, 0, 3].map((by) => profileAt(degrees + by));
  if (!a || !b || !c) return 0;
  const side = (/** @type {Point} */ p, /** @type {Point} */ q) => Math.hypot(p.x - q.x, p.y - q.y);
  const twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return (side(a, b) * side(b, c) * side(c, a)) / (2 * Math.abs(twice));
}

const stem = (/** @type {Point} */ roller) => stroke("part", `M${roller.x - 5} ${roller.y}V10h10V${roller.y}z`);
const guide = () => stroke("ground", `M${CENTRE.x - 6} 18v20M${CENTRE.x + 6} 18v20M${CENTRE.x - 6} 19l-6 6M${CENTRE.x - 6} 27l-6 6M${CENTRE.x + 6} 19l6 6M${CENTRE.x + 6} 27l6 6`);

/** Cam, follower and all that can be read on them. */
function mechanism() {
  const at = touching();
  const contact = profileAt(at);
  const normal = normalAt(at);
  const roller = off(contact, normal, ROLLER);
  const rest = { x: CENTRE.x, y: CENTRE.y - BASE - ROLLER };
  const radius = radiusAt(at);
  const middle = off(contact, normal, -radius);
  const lean = (Math.atan2(-normal.y, normal.x) * 180) / Math.PI;
  const tip = off(roller, normal, 52);
  const label = polar(roller, 58, (90 + lean) / 2);
  const aside = CENTRE.x - 34;
  return sheet(
    250, 236,
    part("axes", stroke("centre-line", `M14 ${CENTRE.y}H226M${CENTRE.x} 4V232`)),
    cam(),
    part("base", circle("base-circle", CENTRE, BASE), ...arrow(CENTRE, polar(CENTRE, BASE, 208)), letter("R_b", off(polar(CENTRE, BASE * 0.6, 208), { x: 0, y: -1 }, 4))),
    part("prime", circle("prime-circle", CENTRE, BASE + ROLLER), ...arrow(CENTRE, polar(CENTRE, BASE + ROLLER, 246)), letter("R_p", polar(CENTRE, BASE + ROLLER + 11, 246))),
    part("pitch", stroke("pitch-curve", path(...TURN.map((degrees) => parallel(degrees, ROLLER))) + "z"), letter("P", off(parallel(6, ROLLER), normalAt(6), 9))),
    circle("hub", CENTRE, 5),
    stem(roller), circle("part", roller, ROLLER), circle("dot", roller, 1.6), guide(),
    part("theta", stroke("dim-line", path(CENTRE, polar(CENTRE, 36, 300), CENTRE, polar(CENTRE, 36, 352))), ...arcArrow(CENTRE, 30, 300, 350), letter("θ", polar(CENTRE, 41, 327))),
    part("s", stroke("dim-line", path({ x: aside - 5, y: roller.y }, { x: roller.x, y: roller.y }) + path({ x: aside - 5, y: rest.y }, rest)), ...arrow({ x: aside, y: rest.y }, { x: aside, y: roller.y }, true), letter("s", { x: aside - 8, y: (rest.y + roller.y) / 2 + 4 }, "end")),
    part("rho", circle("rho-circle", middle, radius), stroke("rho-line", path(middle, contact)), circle("rho-dot", middle, 2), letter("ρ", off(off(contact, normal, -radius * 0.55), { x: 1, y: 0 }, 9))),
    part("pressure_angle", stroke("phi-line", path(off(contact, normal, -22), tip) + path(roller, { x: roller.x, y: roller.y - 52 })), ...arcArrow(roller, 44, 90, lean), letter("φ", label)),
    circle("dot", contact, 2.2),
  );
}

/** The push of the cam and its two parts. */
function pressureAngle() {
  const at = touching();
  const contact = profileAt(at);
  const normal = normalAt(at);
  const roller = off(contact, normal, ROLLER);
  const push = 62;
  const tip = off(roller, normal, push);
  const lean = (Math.atan2(-normal.y, normal.x) * 180) / Math.PI;
  return sheet(
    250, 236,
    stroke("centre-line", `M14 ${CENTRE.y}H226M${CENTRE.x} 4V232`),
    cam(), circle("base-circle", CENTRE, BASE), circle("hub", CENTRE, 5),
    stroke("thin-bar", path(roller, { x: roller.x, y: 8 })), circle("part", roller, ROLLER),
    stroke("phi-line", path(off(contact, normal, -26), roller)),
    part("N", ...arrow(roller, tip), letter("N", off(tip, { x: -1, y: -0.2 }, 9))),
    part("cos", ...arrow(roller, { x: roller.x, y: tip.y })),
    part("sin", ...arrow(roller, { x: tip.x, y: roller.y })),
    stroke("thin", path({ x: roller.x, y: tip.y }, tip, { x: tip.x, y: roller.y })),
    part("pressure_angle", ...arcArrow(roller, 30, 90, lean), letter("φ", polar(roller, 39, (90 + lean) / 2))),
    circle("dot", contact, 2.2),
  );
}

/** @param {string} text @param {Point} at @param {string} anchor */
const formula = (text, at, anchor) => s("text", { x: at.x, y: at.y, "text-anchor": anchor, class: "dim-text" }, text);

/** A flat face: where it touches, how far that walks, which way it slides. */
function flat() {
  const heights = TURN.map((degrees) => profileAt(degrees));
  const contact = heights.reduce((top, point) => (point.y < top.y ? point : top));
  const { y } = contact;
  const low = CENTRE.y + BASE + 26;
  return sheet(
    250, 246,
    stroke("centre-line", `M14 ${CENTRE.y}H226M${CENTRE.x} 4V236`),
    cam(), circle("base-circle", CENTRE, BASE), circle("hub", CENTRE, 5),
    stroke("part", `M${CENTRE.x - 5} ${y - 8}V10h10V${y - 8}z`),
    stroke("part", `M${CENTRE.x - 62} ${y}h124v-8h-124z`), guide(),
    part("contact", stroke("dim-line", `M${contact.x} ${y}V${y - 32}M${CENTRE.x + 5} ${y - 27}H${CENTRE.x}`), ...arrow({ x: CENTRE.x, y: y - 27 }, { x: contact.x, y: y - 27 }), letter("q", { x: (CENTRE.x + contact.x) / 2 + 4, y: y - 33 })),
    part("face", stroke("dim-line", `M${CENTRE.x - 62} ${y + 4}V${low + 6}M${CENTRE.x + 62} ${y + 4}V${low + 6}`), ...arrow({ x: CENTRE.x - 62, y: low }, { x: CENTRE.x + 62, y: low }, true)),
    part("sliding", ...arrow({ x: contact.x + 4, y: y + 7 }, { x: contact.x + 36, y: y + 7 }), letter("u", { x: contact.x + 44, y: y + 11 })),
    part("rest", circle("dot", contact, 2.4)),
  );
}

/** s, v, a and j of a cycloidal rise between dwells, with β and L. */
function motion() {
  const [left, start, end, right] = [26, 74, 186, 234];
  const tau = 2 * Math.PI;
  /** @type {[string, number, number, (x: number) => number][]} */
  const curves = [
    ["s", 84, 52, (x) => x - Math.sin(tau * x) / tau],
    ["v", 132, 32, (x) => (1 - Math.cos(tau * x)) / 2],
    ["a", 176, 17, (x) => Math.sin(tau * x)],
    ["j", 222, 17, (x) => Math.cos(tau * x)],
  ];
  const drawn = curves.map(([name, zero, height, of]) => {
    const rise = Array.from({ length: 61 }, (_, i) => ({ x: start + ((end - start) * i) / 60, y: zero - height * of(i / 60) }));
    const ends = name === "s" ? zero - height : zero;
    const line = path({ x: left, y: zero }, { x: start, y: zero }, ...rise, { x: end, y: ends }, { x: right, y: ends });
    return part(name, stroke("thin", `M${left} ${zero}H${right}`), stroke(`curve-${name}`, line), letter(name, { x: left - 9, y: zero + 3 }));
  });
  const y = 16;
  return sheet(
    250, 246,
    ...drawn,
    part("beta", stroke("dim-line", `M${start} ${y - 5}V84M${end} ${y - 5}V32`), ...arrow({ x: start, y }, { x: end, y }, true), letter("β", { x: (start + end) / 2, y: y - 4 })),
    part("rise", stroke("dim-line", `M${end} 84H${right + 4}`), ...arrow({ x: right - 12, y: 84 }, { x: right - 12, y: 32 }, true), letter("L", { x: right - 4, y: 62 }, "start")),
    letter("θ", { x: right + 9, y: 88 }),
  );
}

/** The acceleration of the SCCA family with its shares. */
function scca() {
  const [left, width, zero, height] = [20, 210, 84, 52];
  const [b, c] = [0.3, 0.3];
  const d = 1 - b - c;
  const at = (/** @type {number} */ x) => {
    if (x > 0.5) return -of(1 - x);
    return of(x);
  };
  const of = (/** @type {number} */ x) => (x < b / 2 ? Math.sin((Math.PI * x) / b) : x < (1 - d) / 2 ? 1 : Math.cos((Math.PI * (x - (1 - d) / 2)) / d));
  const points = Array.from({ length: 121 }, (_, i) => ({ x: left + (width * i) / 120, y: zero - height * at(i / 120) }));
  const y = 154;
  const place = (/** @type {number} */ x) => left + width * x;
  const bounds = [0, b / 2, (b + c) / 2, 1 - (b + c) / 2, 1 - b / 2, 1].map(place);
  const names = ["b", "c", "d", "c", "b"];
  const spans = names.map((name, i) => {
    const [from, to] = [bounds[i] ?? 0, bounds[i + 1] ?? 0];
    const text = name === "d" ? "d" : `${name}/2`;
    return part(name, ...arrow({ x: from, y }, { x: to, y }, true), formula(text, { x: (from + to) / 2, y: y + 15 }, "middle"));
  });
  return sheet(
    250, 178,
    stroke("thin", `M${left} ${zero}H${left + width}` + bounds.map((x) => `M${x} 26V${y + 4}`).join("")),
    stroke("curve-a", path(...points)), letter("a", { x: left - 10, y: zero + 4 }), ...spans,
  );
}

/** The follower in its positions around a cam that stands still. */
function inversion() {
  const centre = { x: 120, y: 122 };
  const shift = { x: 0, y: centre.y - CENTRE.y };
  const moved = (/** @type {Point} */ point) => off(point, shift, 1);
  const parts = [];
  for (let degrees = 0; degrees < 360; degrees += 30) {
    const ray = polar(centre, 1, degrees);
    const along = { x: ray.x - centre.x, y: ray.y - centre.y };
    // The roller that touches the profile and whose centre lies in this direction.
    let [best, miss] = [moved(parallel(degrees, ROLLER)), Infinity];
    for (let near = degrees - 40; near < degrees + 40; near += 0.25) {
      const point = moved(parallel(near, ROLLER));
      const aside = Math.abs((point.x - centre.x) * along.y - (point.y - centre.y) * along.x);
      if (aside < miss) [best, miss] = [point, aside];
    }
    const far = polar(centre, 112, degrees);
    parts.push(stroke("thin", path(centre, far)), stroke(degrees === 90 ? "bar" : "thin-bar", path(best, far)), circle(degrees === 90 ? "part" : "ghost", best, ROLLER), circle("dot", best, 1.3));
  }
  return sheet(
    250, 240,
    stroke("cam", path(...TURN.map((at) => moved(profileAt(at)))) + "z"),
    circle("prime-circle", centre, BASE + ROLLER),
    stroke("pitch-curve", path(...TURN.map((at) => moved(parallel(at, ROLLER)))) + "z"),
    ...parts, circle("hub", centre, 5), ...arcArrow(centre, 24, 60, 150), letter("θ", polar(centre, 33, 118)),
  );
}

/** The curve parallel to a pitch curve: sound, with a cusp, undercut. */
function radius() {
  const rf = 26;
  const panels = [0.5, 1, 1.75].map((share, i) => {
    const bend = share / (2 * rf);
    const middle = { x: 42 + i * 84, y: 44 };
    const half = 36;
    const pitch = [];
    const inner = [];
    for (let x = -half; x <= half; x += 0.75) {
      const slope = 2 * bend * x;
      const size = Math.hypot(1, slope);
      pitch.push({ x: middle.x + x, y: middle.y + bend * x * x });
      inner.push({ x: middle.x + x - (rf * slope) / size, y: middle.y + bend * x * x + rf / size });
    }
    const cut = share > 1;
    return [
      stroke("pitch-curve", path(...pitch)), stroke(cut ? "curve-bad" : "profile", path(...inner)),
      circle("ghost", middle, rf), circle("dot", middle, 1.5), ...arrow(middle, polar(middle, rf, 120)),
      formula(share < 1 ? "ρₚ > R" : share > 1 ? "ρₚ < R" : "ρₚ = R", { x: middle.x - 4, y: 138 }, "middle"),
      s("text", { x: middle.x + 18, y: 141, class: "dim-text" }, s("tspan", { class: "index" }, "f")),
    ];
  });
  return sheet(252, 146, ...panels.flat());
}

/** A cam of arcs about the vertices of a triangle, between the two faces of its yoke. */
function breadth() {
  const centre = { x: 124, y: 116 };
  const [inner, rounding, turned] = [52, 14, 12];
  const vertices = [90, 210, 330].map((at) => polar(centre, inner, at + turned));
  const side = inner * Math.sqrt(3);
  // Opposite each vertex an arc about it; round each vertex a small one.
  const outline = vertices.flatMap((vertex, i) => {
    const towards = 270 + turned + 120 * i;
    const arc = (/** @type {Point} */ about, /** @type {number} */ r, /** @type {number} */ middle) => Array.from({ length: 16 }, (_, k) => polar(about, r, middle - 30 + 4 * k));
    return [...arc(vertex, side + rounding, towards), ...arc(/** @type {Point} */ (vertices[(i + 2) % 3]), rounding, towards + 60)];
  });
  const heights = outline.map(({ y }) => y);
  const [top, bottom] = [Math.min(...heights), Math.max(...heights)];
  const far = 214;
  const face = (/** @type {number} */ y, /** @type {number} */ thick) => stroke("part", `M36 ${y}h176v${thick}h-176z`);
  return sheet(
    250, 236,
    stroke("cam", path(...outline) + "z"), stroke("part", `M${centre.x - 4} ${top - 7}V8h8V${top - 7}z`), face(top, -7), face(bottom, 7),
    part("sides", stroke("thin-bar", path(...vertices) + "z"), ...vertices.map((vertex) => circle("dot", vertex, 2))),
    circle("hub", centre, 5),
    part("breadth", stroke("dim-line", `M${far} ${top}h16M${far} ${bottom}h16`), ...arrow({ x: far + 10, y: top }, { x: far + 10, y: bottom }, true), letter("d_c", { x: far + 15, y: (top + bottom) / 2 + 4 }, "start")),
  );
}

/** @type {Record<string, () => SVGElement>} */
export const DRAWINGS = { mechanism, "pressure-angle": pressureAngle, flat, motion, scca, inversion, radius, breadth };
