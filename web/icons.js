/** The few signs that go without words because everyone reads them. */
import { s } from "./dom.js";

const PATHS = {
  undo: "M7 4L3 8l4 4M3 8h9a5 5 0 0 1 0 10H8",
  redo: "M13 4l4 4l-4 4M17 8H8a5 5 0 0 0 0 10h4",
  light: "M10 6.500a3.500 3.500 0 1 0 0 7a3.500 3.500 0 1 0 0-7zM10 1v2.500M10 16.500V19M1 10h2.500M16.500 10H19M3.600 3.600l1.800 1.800M14.600 14.600l1.800 1.800M16.400 3.600l-1.800 1.800M5.400 14.600l-1.800 1.800",
  dark: "M16.500 12.500A7.500 7.500 0 0 1 7.500 3.500A7.500 7.500 0 1 0 16.500 12.500z",
  system: "M10 2.500a7.500 7.500 0 1 0 0 15a7.500 7.500 0 1 0 0-15zM10 2.500v15M10 6l5.500-1M10 10h7.500M10 14l5.500 1",
  unfold: "M5 12.500l5-5l5 5",
  projector: "M2 3h16M3.500 3v10h13V3M10 13v2.500M6 18l4-2.500l4 2.500",
};

/** @param {keyof typeof PATHS} name */
export function icon(name) {
  return s("svg", { viewBox: "0 0 20 20", class: "icon", "aria-hidden": "true" }, s("path", { d: PATHS[name] }));
}
