/** Small drawings of the followers, by id; an id that is newer than these gets a plain cam with a box on it. */
import { s } from "./dom.js";

const CAM = "M20 40c-6.6 0-11-4-11-9 0-6 5-12 11-12s11 6 11 12c0 5-4.4 9-11 9z";

/** @type {Record<string, () => SVGElement[]>} */
export const DRAWINGS = {
  "translating-roller": () => [cam(), s("circle", { cx: 20, cy: 14, r: 5, class: "part" }), line("M20 14V1"), guide()],
  "translating-knife": () => [cam(), s("path", { d: "M20 19l-3.4-7V1h6.8v11z", class: "part" }), guide()],
  "translating-curved": () => [cam(), s("path", { d: "M11 13q9 12 18 0z", class: "part" }), line("M20 13V1"), guide()],
  "translating-flat": () => [cam(), s("path", { d: "M9 16h22v3H9z", class: "part" }), line("M20 16V1"), guide()],
  "oscillating-roller": () => [
    s("path", { d: "M15 40c-6 0-10-4-10-8.500 0-5.500 4.500-11 10-11s10 5.500 10 11c0 4.500-4 8.500-10 8.500z", class: "cam" }),
    line("M15 15.500L35 20"),
    s("circle", { cx: 15, cy: 15.5, r: 5, class: "part" }),
    ...ground(35, 20),
  ],
  "oscillating-flat": () => [
    s("path", { d: "M14 40c-6 0-10-4-10-8.500 0-5.500 4.500-11 10-11s10 5.500 10 11c0 4.500-4 8.500-10 8.500z", class: "cam" }),
    s("path", { d: "M2 18.200L35 22.600V19.600L2 15.200z", class: "part" }),
    ...ground(35, 21),
  ],
};

/** @param {string} id */
export function followerDrawing(id) {
  const parts = DRAWINGS[id] ?? (() => [cam(), s("path", { d: "M14 9h12v10H14z", class: "part" }), line("M20 9V1")]);
  return s("svg", { viewBox: "0 0 40 42", "aria-hidden": "true", class: "follower-drawing" }, ...parts());
}

function cam() {
  return s("path", { d: CAM, class: "cam" });
}

/** @param {string} d */
function line(d) {
  return s("path", { d, class: "stem" });
}

function guide() {
  return line("M14.500 4v5M25.500 4v5");
}

/**
 * A pivot on the ground.
 * @param {number} x
 * @param {number} y
 */
function ground(x, y) {
  return [
    s("path", { d: `M${x} ${y}l-4 8h8z`, class: "part" }),
    s("circle", { cx: x, cy: y, r: 2.4, class: "part" }),
    line(`M${x - 5} ${y + 8}h10`),
  ];
}
