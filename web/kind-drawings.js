/**
 * Help drawings of the kinds of cam that are not plain plates, and of a second cam; loaded when one is met.
 *
 * @import { Follower, KindId, TieKey } from "./types.d.ts"
 * @import { Symbols } from "./help-drawing-parts.js"
 * @import { Point } from "./sketch.js"
 */
import { s } from "./dom.js";
import { cam, dimension } from "./help-drawing-parts.js";
import { arcArrow, arrow, circle, letter, path, polar, stroke } from "./sketch.js";

const CENTRE = { x: 74, y: 88 };

/**
 * @param {KindId} kind
 * @param {string} follower
 * @param {Symbols} symbols
 * @returns {SVGElement[] | null}
 */
export function kindDrawing(kind, follower, symbols) {
  if (kind === "constant-breadth") return yoke(follower === "translating-roller", symbols);
  if (kind === "translating") return wedge(follower, symbols);
  return null;
}

/**
 * @param {boolean} rollers
 * @param {Symbols} symbols
 */
function yoke(rollers, symbols) {
  const [base, lift, r] = [36, 14, 11];
  const top = CENTRE.y - base;
  const bottom = CENTRE.y + base + lift;
  const [left, right] = [14, 122];
  const gap = rollers ? 2 * r : 0;
  const frame = `M${left - 5} ${top - gap - 6}H${right + 5}V${bottom + gap + 6}H${left - 5}zM${left} ${top - gap}V${bottom + gap}H${right}V${top - gap}z`;
  const x = right + 18;
  return [
    stroke("part", `${frame}M${CENTRE.x - 4} ${top - gap - 6}V10H${CENTRE.x + 4}V${top - gap - 6}z`),
    ...cam(CENTRE, base, 270),
    ...(rollers ? [circle("part", { x: CENTRE.x, y: top - r }, r), circle("part", { x: CENTRE.x, y: bottom + r }, r)] : []),
    dimension(
      symbols,
      "breadth",
      [stroke("dim-line", `M${CENTRE.x + 6} ${top}H${x + 4}M${CENTRE.x + 6} ${bottom}H${x + 4}`), ...arrow({ x, y: top }, { x, y: bottom }, true)],
      { x: x + 5, y: (top + bottom) / 2 },
      "start",
    ),
    dimension(symbols, "base_radius", arrow(CENTRE, polar(CENTRE, base, 155)), { x: CENTRE.x - 20, y: CENTRE.y + 6 }),
    ...(rollers ? [dimension(symbols, "roller_radius", arrow({ x: CENTRE.x, y: top - r }, polar({ x: CENTRE.x, y: top - r }, r, 20)), { x: CENTRE.x + r + 3, y: top - r }, "start")] : []),
  ];
}

/**
 * @param {string} follower
 * @param {Symbols} symbols
 */
function wedge(follower, symbols) {
  const [left, right, low, high, floor] = [10, 158, 104, 84, 128];
  const x = 84;
  const r = follower === "translating-roller" ? 12 : 0;
  const y = 94 - r * 1.02;
  const body = `M${left} ${low}H46C70 ${low} 98 ${high} 122 ${high}H${right}V${floor}H${left}z`;
  const parts = [stroke("cam", body), stroke("base-circle", `M${left - 4} ${low}H${right + 4}`), stroke("ground", `M4 ${floor}H164M12 ${floor}l-5 6M30 ${floor}l-5 6M48 ${floor}l-5 6M66 ${floor}l-5 6M84 ${floor}l-5 6M102 ${floor}l-5 6M120 ${floor}l-5 6M138 ${floor}l-5 6M156 ${floor}l-5 6`)];
  const stem = stroke("part", `M${x - 4} ${r ? y : y - 12}V24h8V${r ? y : y - 12}z`);
  const tip = follower === "translating-knife" ? stroke("part", `M${x} ${y}l-4 -12h8z`) : follower === "translating-curved" ? stroke("part", `M${x - 20} ${y - 12}A26 26 0 0 0 ${x + 20} ${y - 12}z`) : circle("part", { x, y }, r);
  const guide = stroke("ground", `M${x - 5} 34v18M${x + 5} 34v18M${x - 5} 36l-5 5M${x - 5} 43l-5 5M${x + 5} 36l5 5M${x + 5} 43l5 5`);
  const line = 146;
  const dims = [
    dimension(symbols, "length", [stroke("dim-line", `M${left} ${floor + 6}V${line + 4}M${right} ${floor + 6}V${line + 4}`), ...arrow({ x: left, y: line }, { x: right, y: line }, true)], { x, y: line - 4 }),
  ];
  if (r) dims.push(dimension(symbols, "roller_radius", arrow({ x, y }, polar({ x, y }, r, 160)), { x: x - r - 4, y }, "end"));
  if (follower === "translating-curved") dims.push(dimension(symbols, "face_radius", arrow({ x, y: y - 24 }, { x: x + 12, y: y - 3 }), { x: x + 14, y: y - 20 }, "start"));
  return [...parts, stem, tip, guide, ...dims];
}

/**
 * The second element of a pair with what ties it to the first.
 * @param {Readonly<Follower>} follower
 * @param {TieKey} tie
 */
export function pairDrawing(follower, tie) {
  const swings = follower.motion === "oscillating";
  const root = s("svg", { class: "help-drawing", role: "img", viewBox: "0 0 168 122" });
  root.append(...(swings ? arms(follower.contact === "flat", tie) : bars(follower.contact === "flat")));
  return root;
}

/** @param {boolean} flat */
function bars(flat) {
  const centre = { x: 70, y: 61 };
  const [one, two] = [24, 20];
  const r = flat ? 0 : 9;
  const [top, bottom] = [centre.y - one - r, centre.y + two + 14 + r];
  const touch = (/** @type {number} */ y, /** @type {number} */ out) => (flat ? stroke("part", `M24 ${y}H116V${y + 5 * out}H24z`) : circle("part", { x: centre.x, y }, r));
  const x = 132;
  return [
    stroke("second", lobeAt(centre, two + 14, 270)),
    ...cam(centre, one, 90),
    touch(top, -1),
    touch(bottom, 1),
    s("g", { class: "dimension lit-always" }, stroke("dim-line", `M${centre.x} ${top}H${x + 4}M${centre.x} ${bottom}H${x + 4}`), ...arrow({ x, y: top }, { x, y: bottom }, true), letter("D", { x: x + 5, y: 64 }, "start")),
  ];
}

/**
 * @param {boolean} flat
 * @param {TieKey} tie
 */
function arms(flat, tie) {
  const centre = { x: 48, y: 62 };
  const pivot = { x: 140, y: 62 };
  const ends = [148, 212].map((direction) => polar(pivot, flat ? 112 : 96, direction));
  const [one, two] = /** @type {[Point, Point]} */ (ends);
  return [
    stroke("second", lobeAt(centre, 30, 215)),
    ...cam(centre, 27, 200),
    stroke("bar", path(one, pivot, two)),
    ...(flat ? [] : [circle("part", one, 10), circle("part", two, 10)]),
    circle("pin", pivot, 3),
    tie === "angle"
      ? s("g", { class: "dimension" }, ...arcArrow(pivot, 34, 148, 180), ...arcArrow(pivot, 34, 212, 180), letter("Γ", { x: 98, y: 66 }, "end"))
      : s("g", { class: "dimension" }, ...arrow(centre, polar(centre, 28, 300)), letter("R_b2", { x: 66, y: 108 }, "start")),
  ];
}

/**
 * @param {Point} centre
 * @param {number} r
 * @param {number} about  degrees
 */
function lobeAt(centre, r, about) {
  const points = [];
  for (let angle = 0; angle < 360; angle += 6) points.push(polar(centre, r + 5 * Math.cos(((angle - about) * Math.PI) / 180), angle));
  return path(...points) + "z";
}
