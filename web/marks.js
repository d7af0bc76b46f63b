/**
 * The places that a diagram of s shows of the data of free laws, as the engine finds them: once a design.
 *
 * @import { ShellContext } from "./types.d.ts"
 */

/**
 * @typedef {object} Mark
 * @property {"point" | "ordinate" | "knot"} kind
 * @property {number} segment
 * @property {number} item      its place in the data of the segment
 * @property {number} at        from the segment's start
 * @property {number} theta
 * @property {number} height
 * @property {number} residual  how much higher the curve lies there
 */

const KINDS = /** @type {const} */ (["point", "ordinate", "knot"]);
/** Numbers of a mark. */
const WIDTH = 7;

/** The report for which they were found, and they. @type {{ report: unknown, marks: Mark[] } | null} */
let known = null;

/**
 * The marks of the design on screen.
 * @param {ShellContext} context
 */
export function marksOf({ store, module }) {
  const { report } = store.state;
  if (known?.report !== report) known = { report, marks: ask() };
  return known.marks;

  function ask() {
    const design = store.lastGood();
    const numbers = module().data_marks(design);
    return Array.from({ length: numbers.length / WIDTH }, (_, i) => {
      const [kind = 0, segment = 0, item = 0, at = 0, theta = 0, height = 0, residual = 0] = numbers.subarray(i * WIDTH);
      return { kind: KINDS[kind] ?? "point", segment, item, at, theta, height, residual };
    });
  }
}
