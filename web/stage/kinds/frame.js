/**
 * The rigid frame of a yoke or of a pair that slides.
 *
 * @import { Lab, Report } from "../../types.d.ts"
 * @import { Follower, Pose } from "../follower-part.js"
 * @import { Pen } from "../pen.js"
 */
import { drawDimension } from "../dimensions.js";
import { THICKNESS, around, extremes, faceHeight } from "../follower-part.js";
import { AT, newInstant, value } from "../instant.js";
import { hatch, polygon, rectangle } from "../shapes.js";
import { include } from "../view.js";

/** Free room within a frame, in its thicknesses. */
const ROOM = 0.6;

/**
 * A frame around the cam that carries an element at its top and another across the shaft.
 * @param {Report} report
 * @param {Lab} lab
 * @param {{ gap: number, radius: number, radius2?: number, reach: number }} given  `gap` between faces, or centres of rollers
 */
export function framed(report, lab, { gap, radius, radius2 = radius, reach }) {
  const { mechanism } = report;
  const { eccentricity: e, contact } = mechanism;
  const t = THICKNESS * reach;
  const flat = contact === "flat";
  const first = newInstant();
  lab.at(0, first);
  const [nx, ny] = flat ? [value(first, AT.normalX), value(first, AT.normalY)] : [0, 1];
  /** Along the face and across it. @type {(u: number, v: number) => [number, number]} */
  const place = (u, v) => [u * ny + v * nx, -u * nx + v * ny];

  /** @type {Follower["place"]} */
  const put = (at, pose) => {
    pose.x = e;
    pose.y = flat ? faceHeight(at, e) : value(at, AT.traceY);
    pose.angle = 0;
    pose.mirror = 1;
  };
  const heights = extremes(report, lab).map((at) => (flat ? faceHeight(at, e) : value(at, AT.traceY)));
  const [low, high] = [Math.min(...heights), Math.max(...heights)];
  const w = reach + Math.abs(e) + ROOM * t + (flat ? Math.abs(nx) * gap * 0.5 : 0);
  const inTop = flat ? 0 : Math.max(1.15 * radius, reach - low + ROOM * t);
  const inBottom = flat ? -gap : Math.min(-gap - 1.15 * radius2, -reach - high - ROOM * t);
  const wall = 1.1 * t;
  const ring = polygon(place(-w - wall, inTop + wall), place(w + wall, inTop + wall), place(w + wall, inBottom - wall), place(-w - wall, inBottom - wall));
  // The other way round, so that it is a hole.
  const hole = [place(-w, inTop), place(-w, inBottom), place(w, inBottom), place(w, inTop)];
  hole.forEach(([x, y], i) => (i === 0 ? ring.moveTo(x, y) : ring.lineTo(x, y)));
  ring.closePath();
  const half = 0.9 * t;
  const lugs = flat ? [] : [lug(radius, inTop + 0.5 * wall, 0), lug(radius2, inBottom - 0.5 * wall, -gap)];
  const top = inTop + wall + (flat ? Math.abs(nx) * w : 0);
  const seat = high + top + t;
  const guideTop = seat + 4.2 * t;
  const end = guideTop - low + 1.6 * t;
  const stem = rectangle(-half, inTop + 0.5 * wall, half, end);
  const inner = half + 0.12 * t;
  const outer = inner + 2.2 * t;
  const hatchingPath = new Path2D();
  const ground = [-1, 1].map((hand) => {
    const [a, b] = hand < 0 ? [e - outer, e - inner] : [e + inner, e + outer];
    hatch(hatchingPath, a, seat, b, guideTop, 0.75 * t);
    return rectangle(a, seat, b, guideTop);
  });
  const box = around({ ...mechanism, reach });
  include(box, e, high + end);
  for (const y of [low, high]) {
    for (const u of [-w - wall, w + wall]) {
      for (const v of [inTop + wall, inBottom - wall]) {
        const [x, up] = place(u, v);
        include(box, e + x, y + up);
      }
    }
  }
  const aside = w + wall + 2.2 * t;
  // Room for the dimension and its number.
  include(box, e + aside + 0.62 * reach, 0);
  /** @type {Follower} */
  const follower = { body: [ring, ...lugs, stem], joints: [], ground, hatching: hatchingPath, roller: contact === "roller" ? radius : 0, spring: null, box, place: put };
  return { follower, measure };

  /**
   * @param {number} size
   * @param {number} edge
   * @param {number} centre
   */
  function lug(size, edge, centre) {
    const side = Math.max(0.45 * size, 0.6 * t);
    return rectangle(-side, Math.min(edge, centre), side, Math.max(edge, centre));
  }

  /**
   * The dimension beside the frame, from contact to contact or centre to centre.
   * @param {Pen} pen
   * @param {Pose} pose
   * @param {number} inset  from the centres to the near sides of the rollers
   * @param {number} length
   * @param {string} symbol
   * @param {string} text
   * @param {boolean} lit
   */
  function measure(pen, pose, inset, length, symbol, text, lit) {
    /** @type {(u: number, v: number) => [number, number]} */
    const here = (u, v) => {
      const [x, y] = place(u, v);
      return [pose.x + x, pose.y + y];
    };
    const colour = lit ? pen.palette.accent : pen.palette.muted;
    pen.screen();
    pen.line(colour, 0.75);
    for (const v of [-inset, -inset - length]) pen.segment(...here(0.2 * w, v), ...here(aside + t, v));
    drawDimension(pen, { from: here(aside, -inset - length), to: here(aside, -inset), symbol }, text, colour);
  }
}
