/**
 * Each follower at rest on its cam, with its magnitudes dimensioned.
 *
 * @import { Symbols } from "./help-drawing-parts.js"
 * @import { Point } from "./sketch.js"
 */
import { baseRadius, cam, dimension } from "./help-drawing-parts.js";
import { arcArrow, arrow, circle, path, polar, stroke } from "./sketch.js";

/** @typedef {(symbols: Symbols) => SVGElement[]} Drawing */

/** Base radius, eccentricity and centre of the translating drawings. */
const BASE = 40;
const ECCENTRICITY = 18;
const CENTRE = { x: 62, y: 112 };
const AXIS = CENTRE.x + ECCENTRICITY;

/** Centre, pivot distance and pivot angle of the oscillating ones. */
const HUB = { x: 50, y: 108 };
const PIVOT_DISTANCE = 88;
const PIVOT_ANGLE = 10;
const PIVOT = polar(HUB, PIVOT_DISTANCE, PIVOT_ANGLE);

/** @type {Record<string, Drawing>} */
export const DRAWINGS = {
  "translating-roller": translatingRoller,
  "translating-knife": translatingKnife,
  "translating-curved": translatingCurved,
  "translating-flat": translatingFlat,
  "oscillating-roller": oscillatingRoller,
  "oscillating-flat": oscillatingFlat,
};

/** @param {number} x */
function guide(x) {
  return stroke("ground", `M${x - 5} 20v16M${x + 5} 20v16M${x - 5} 21l-5 5M${x - 5} 27l-5 5M${x + 5} 21l5 5M${x + 5} 27l5 5`);
}

/** @param {Symbols} symbols */
function eccentricity(symbols) {
  const y = 9;
  const extension = stroke("centre-line", `M${CENTRE.x} ${CENTRE.y}V${y - 5}`);
  return dimension(symbols, "eccentricity", [extension, ...arrow({ x: CENTRE.x, y }, { x: AXIS, y }, true)], { x: CENTRE.x - 4, y: y + 4 }, "end");
}

/** @param {number} bottom */
function axisAndStem(bottom) {
  return [stroke("part", `M${AXIS - 4} ${bottom}V14h8V${bottom}z`), stroke("centre-line", `M${AXIS} ${bottom + 22}V2`), guide(AXIS)];
}

/** @type {Drawing} */
function translatingRoller(symbols) {
  const r = 14;
  const roller = { x: AXIS, y: CENTRE.y - Math.sqrt((BASE + r) ** 2 - ECCENTRICITY ** 2) };
  return [
    ...cam(CENTRE, BASE, 225),
    ...axisAndStem(roller.y),
    circle("part", roller, r),
    circle("dot", roller, 1.5),
    eccentricity(symbols),
    baseRadius(symbols, CENTRE, BASE, 155),
    dimension(symbols, "roller_radius", arrow(roller, polar(roller, r, 10)), { x: roller.x + r + 4, y: roller.y + 2 }, "start"),
  ];
}

/** @type {Drawing} */
function translatingKnife(symbols) {
  const y = CENTRE.y - Math.sqrt(BASE ** 2 - ECCENTRICITY ** 2);
  return [
    ...cam(CENTRE, BASE, 225),
    stroke("part", `M${AXIS} ${y}l-5 -12V14h10V${y - 12}z`),
    stroke("centre-line", `M${AXIS} ${y + 18}V2`),
    guide(AXIS),
    eccentricity(symbols),
    baseRadius(symbols, CENTRE, BASE, 155),
  ];
}

/** @type {Drawing} */
function translatingCurved(symbols) {
  const r = 36;
  const centre = { x: AXIS, y: CENTRE.y - Math.sqrt((BASE + r) ** 2 - ECCENTRICITY ** 2) };
  const left = polar(centre, r, 270 - 42);
  const right = polar(centre, r, 270 + 42);
  return [
    ...cam(CENTRE, BASE, 225),
    ...axisAndStem(left.y),
    stroke("part", `${path(left)}A${r} ${r} 0 0 0 ${right.x} ${right.y}z`),
    circle("dot", centre, 1.5),
    eccentricity(symbols),
    baseRadius(symbols, CENTRE, BASE, 155),
    dimension(symbols, "face_radius", arrow(centre, polar(centre, r, -66)), { x: centre.x + 16, y: centre.y + 14 }, "start"),
  ];
}

/** @type {Drawing} */
function translatingFlat(symbols) {
  const tilt = 12;
  const centre = { x: 76, y: 112 };
  const contact = polar(centre, BASE, 90 + tilt);
  const [left, right] = [polar(contact, -44, tilt), polar(contact, 52, tilt)];
  const top = (/** @type {Point} */ point) => ({ x: point.x, y: point.y - 7 });
  const corner = polar(contact, 8, tilt);
  return [
    ...cam(centre, BASE, 235),
    stroke("part", `M${centre.x - 4} ${contact.y}V14h8V${contact.y - 4}z`),
    stroke("part", path(left, right, top(right), top(left)) + "z"),
    stroke("centre-line", `M${centre.x} ${centre.y}V2`),
    guide(centre.x),
    dimension(
      symbols,
      "face_angle",
      [stroke("dim-line", path(corner, { x: corner.x + 52, y: corner.y })), ...arcArrow(corner, 40, 0, tilt)],
      { x: corner.x + 46, y: corner.y - 12 },
      "start",
    ),
    baseRadius(symbols, centre, BASE, 155),
  ];
}

/**
 * Pivot with its ground, distance and angle.
 * @param {Symbols} symbols
 */
function pivot(symbols) {
  const y = 156;
  const { x } = PIVOT;
  return [
    stroke("ground", `M${x} ${PIVOT.y}l-7 14h14zM${x - 10} ${PIVOT.y + 14}h20m-17 0l-4 5m10 -5l-4 5m10 -5l-4 5`),
    dimension(
      symbols,
      "pivot_distance",
      [stroke("dim-line", `M${HUB.x} ${HUB.y + 8}V${y + 4}M${x} ${PIVOT.y + 24}V${y + 4}`), ...arrow({ x: HUB.x, y }, { x, y }, true)],
      { x: (HUB.x + x) / 2 + 12, y: y - 4 },
    ),
    dimension(
      symbols,
      "pivot_angle",
      [stroke("dim-line", path(HUB, { x: HUB.x + 74, y: HUB.y }, HUB, polar(HUB, PIVOT_DISTANCE, PIVOT_ANGLE))), ...arcArrow(HUB, 62, 0, PIVOT_ANGLE)],
      { x: HUB.x + 64, y: HUB.y + 12 },
    ),
    circle("pin", PIVOT, 3),
  ];
}

/** @type {Drawing} */
function oscillatingRoller(symbols) {
  const base = 34;
  const r = 11;
  const arm = 80;
  const swing = Math.acos((PIVOT_DISTANCE ** 2 + arm ** 2 - (base + r) ** 2) / (2 * PIVOT_DISTANCE * arm));
  const direction = 180 + PIVOT_ANGLE - (swing * 180) / Math.PI;
  const roller = polar(PIVOT, arm, direction);
  const off = (/** @type {Point} */ point) => polar(point, 17, direction - 90);
  const middle = polar(polar(PIVOT, arm / 2, direction), 22, direction - 90);
  return [
    ...cam(HUB, base, 215),
    stroke("bar", path(PIVOT, roller)),
    circle("part", roller, r),
    circle("dot", roller, 1.5),
    ...pivot(symbols),
    dimension(
      symbols,
      "arm",
      [stroke("dim-line", path(roller, polar(roller, 20, direction - 90)) + path(PIVOT, polar(PIVOT, 20, direction - 90))), ...arrow(off(roller), off(PIVOT), true)],
      middle,
    ),
    baseRadius(symbols, HUB, base, 165),
    dimension(symbols, "roller_radius", arrow(roller, polar(roller, r, 140)), { x: roller.x - r - 3, y: roller.y - 5 }, "end"),
  ];
}

/** @type {Drawing} */
function oscillatingFlat(symbols) {
  const base = 36;
  const offset = 15;
  const slope = PIVOT_ANGLE - (Math.asin((base - offset) / PIVOT_DISTANCE) * 180) / Math.PI;
  const foot = polar(PIVOT, offset, slope + 90);
  const far = polar(foot, -118, slope);
  const up = (/** @type {Point} */ point) => polar(point, 6, slope + 90);
  return [
    ...cam(HUB, base, 225),
    stroke("part", path(far, foot, up(foot), up(far)) + "z"),
    stroke("bar", path(PIVOT, foot)),
    ...pivot(symbols),
    dimension(
      symbols,
      "face_offset",
      arrow(polar(PIVOT, 12, slope), polar(foot, 12, slope), true),
      { x: foot.x + 17, y: foot.y + 12 },
      "start",
    ),
    baseRadius(symbols, HUB, base, 155),
  ];
}

/** @type {Drawing} */
export function anyFollower(symbols) {
  return [...cam(CENTRE, BASE, 225), ...axisAndStem(CENTRE.y - BASE), baseRadius(symbols, CENTRE, BASE, 155)];
}
