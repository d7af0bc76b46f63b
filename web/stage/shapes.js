/** Outlines that the follower and its frame are made of, in lengths of their own frame. */

/**
 * @param {number} x0
 * @param {number} y0
 * @param {number} x1
 * @param {number} y1
 */
export function rectangle(x0, y0, x1, y1) {
  const path = new Path2D();
  path.rect(x0, y0, x1 - x0, y1 - y0);
  return path;
}

/** @param {...[number, number]} points */
export function polygon(...points) {
  const path = new Path2D();
  for (const [x, y] of points) path.lineTo(x, y);
  path.closePath();
  return path;
}

/**
 * @param {number} x
 * @param {number} y
 * @param {number} radius
 */
export function disc(x, y, radius) {
  const path = new Path2D();
  path.arc(x, y, radius, 0, 2 * Math.PI);
  return path;
}

/**
 * A bar with round ends of two radii, from the origin along the first axis.
 * @param {number} length
 * @param {number} start  radius at the origin
 * @param {number} end
 */
export function bar(length, start, end) {
  const side = Math.acos(Math.min(Math.max((start - end) / length, -1), 1));
  const path = new Path2D();
  path.arc(0, 0, start, side, 2 * Math.PI - side);
  path.arc(length, 0, end, -side, side);
  path.closePath();
  return path;
}

/**
 * Hatching at 45° inside a rectangle.
 * @param {Path2D} path
 * @param {number} x0
 * @param {number} y0
 * @param {number} x1
 * @param {number} y1
 * @param {number} step
 */
export function hatch(path, x0, y0, x1, y1, step) {
  for (let c = x0 - y1 + step / 2; c < x1 - y0; c += step) {
    const from = Math.max(x0, c + y0);
    const to = Math.min(x1, c + y1);
    path.moveTo(from, from - c);
    path.lineTo(to, to - c);
  }
}

/**
 * A mushroom's head about the centre of its arc: the arc below, a flat back above.
 * @param {number} radius
 * @param {number} half  half of the arc, rad
 * @param {number} thickness  of its rim
 */
export function mushroom(radius, half, thickness) {
  const path = new Path2D();
  const x = radius * Math.sin(half);
  const y = -radius * Math.cos(half);
  path.arc(0, 0, radius, -Math.PI / 2 - half, -Math.PI / 2 + half);
  path.lineTo(x, y + thickness);
  path.lineTo(-x, y + thickness);
  path.closePath();
  return path;
}
