/**
 * A pair of conjugate cams on one shaft: the second one behind the first, with its own follower or at the far end of a frame.
 *
 * @import { Lab, Report } from "../../types.d.ts"
 * @import { Follower } from "../follower-part.js"
 * @import { Dress } from "../kinds.js"
 * @import { Pen } from "../pen.js"
 */
import { between, buildCam } from "../cam-part.js";
import { drawRoller } from "../details.js";
import { drawDimension } from "../dimensions.js";
import { buildFollower } from "../follower-part.js";
import { AT, newInstant, value } from "../instant.js";
import { drawNormal } from "../layers.js";
import { hatch } from "../shapes.js";
import { include } from "../view.js";
import { plain } from "../../signs.js";
import { framed } from "./frame.js";

/** Lines of the second cam's hatching across it. */
const HATCHES = 44;

/** @param {Report} report */
export const suits = (report) => report.conjugate !== null;

/**
 * @param {Report} report
 * @param {Lab} lab
 * @returns {Dress}
 */
export function dress(report, lab) {
  const { mechanism } = report;
  const other = /** @type {Report} */ (report.conjugate);
  const cam = buildCam(other, lab, true);
  const lines = hatching(Math.max(other.mechanism.reach, 1e-9));
  const at2 = newInstant();
  const theirs = { x: 0, y: 0, angle: 0, mirror: 1 };
  const swings = mechanism.pivot !== null;
  /** @type {Lab} */
  const secondLab = { ...lab, column: (name) => lab.column(name, true), at: (theta, out) => lab.at(theta, out, true), limits: (border) => lab.limits(border) };
  const radii = [mechanism, other.mechanism].map((each) => (mechanism.contact === "flat" ? 0 : each.roller_radius));
  const [radius = 0, radius2 = 0] = radii;
  const first = swings ? buildFollower(report, lab) : null;
  const second = swings ? buildFollower(other, secondLab) : null;
  const gap = swings ? 0 : distance(report, lab);
  const frame = swings ? null : framed(report, lab, { gap, radius, radius2, reach: Math.max(mechanism.reach, other.mechanism.reach) });
  if (first && second) {
    include(first.box, second.box.left, second.box.bottom);
    include(first.box, second.box.right, second.box.top);
  }
  const follower = frame?.follower ?? /** @type {Follower} */ (first);
  include(follower.box, 0, 0, other.mechanism.reach);

  /** @param {Pen} pen @param {number} angle */
  function drawSecond(pen, angle) {
    const { context, palette } = pen;
    pen.world(0, 0, angle);
    context.lineJoin = "round";
    context.fillStyle = palette.panel;
    context.fill(cam.profile);
    context.save();
    context.clip(cam.profile);
    pen.line(palette.camEdge, 0.75);
    context.globalAlpha = 0.55;
    context.stroke(lines);
    context.restore();
    pen.line(palette.camEdge, 1.65);
    context.stroke(cam.profile);
  }

  return {
    follower,
    behind(pen, { state, angle }) {
      lab.at(state.cursor, at2, true);
      drawSecond(pen, angle);
      if (!second) return;
      second.place(at2, theirs);
      pen.world(theirs.x, theirs.y, theirs.angle, theirs.mirror);
      pen.part(second.body, pen.palette.steel, pen.palette.camEdge, 1);
    },
    front(pen, { state, at, angle, pose, format, layer }) {
      const { context, palette } = pen;
      // The outline goes on where the first cam hides it.
      pen.world(0, 0, angle);
      pen.line(palette.camEdge, 1, "axis");
      context.stroke(cam.profile);
      if (layer("pitch") && cam.pitch) {
        pen.line(palette.pitch, 1.25, "pitch");
        context.stroke(cam.pitch);
      }
      pen.screen();
      if (layer("base")) {
        pen.line(palette.base, 1.25, "base");
        pen.circle(0, 0, other.mechanism.base_radius);
      }
      if (cam.rolled) drawRoller(pen, value(at2, AT.traceX), value(at2, AT.traceY), between(cam.rolled, state.cursor), radius2);
      pen.screen();
      if (layer("normal")) drawNormal(pen, other, at2, `${plain("φ")} = ${format.angle(at2[AT.pressureAngle])}`);
      pen.dot(value(at2, AT.contactX), value(at2, AT.contactY), 4, palette.ink);
      const lit = state.highlight?.parameter?.startsWith("conjugate") ?? false;
      if (frame) frame.measure(pen, pose, 0, gap, "D", format.number(Number(gap.toPrecision(9)), { unit: report.units.length }), lit);
      else if (lit && mechanism.pivot && report.pair_angle !== null) swingAngle(pen, mechanism.pivot, at, format.number(Number(report.pair_angle.toPrecision(6)), { unit: "°" }));
    },
  };

  /**
   * @param {Pen} pen
   * @param {[number, number]} pivot
   * @param {Float64Array} at
   * @param {string} text
   */
  function swingAngle(pen, pivot, at, text) {
    const size = 0.5 * Math.hypot(...pivot);
    /** @type {(instant: Float64Array, follower: Follower | null) => [number, number]} */
    const along = (instant, part) => {
      const pose = { x: 0, y: 0, angle: 0, mirror: 1 };
      part?.place(instant, pose);
      return [pivot[0] + size * Math.cos(pose.angle), pivot[1] + size * Math.sin(pose.angle)];
    };
    pen.screen();
    drawDimension(pen, { from: along(at2, second), to: along(at, first), about: pivot, symbol: "Γ" }, text);
  }
}

/**
 * Distance between the elements of a pair that slides: faces, or centres of the rollers.
 * @param {Report} report
 * @param {Lab} lab
 */
function distance(report, lab) {
  const [one, two] = [newInstant(), newInstant()];
  lab.at(0, one);
  lab.at(0, two, true);
  if (report.mechanism.contact !== "flat") return value(one, AT.traceY) - value(two, AT.traceY);
  const [nx, ny] = [value(one, AT.normalX), value(one, AT.normalY)];
  return (value(one, AT.contactX) - value(two, AT.contactX)) * nx + (value(one, AT.contactY) - value(two, AT.contactY)) * ny;
}

/** Lines at 45° over a square about the origin. @param {number} reach */
function hatching(reach) {
  const path = new Path2D();
  hatch(path, -reach, -reach, reach, reach, (4 * reach) / HATCHES);
  return path;
}
