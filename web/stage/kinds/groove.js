/**
 * A groove in the face of a disc, and the roller in it.
 *
 * @import { Lab, Report } from "../../types.d.ts"
 * @import { Dress } from "../kinds.js"
 * @import { Box } from "../view.js"
 */
import { along, buildCam } from "../cam-part.js";
import { THICKNESS, buildFollower } from "../follower-part.js";
import { value } from "../instant.js";
import { include } from "../view.js";

/** @param {Report} report */
export const suits = (report) => report.kind === "grooved";

/**
 * @param {Report} report
 * @param {Lab} lab
 * @returns {Dress}
 */
export function dress(report, lab) {
  const plain = buildCam(report, lab);
  const [x, y] = [lab.column("outer_x"), lab.column("outer_y")];
  let far = 0;
  for (let i = 0; i < x.length; i++) far = Math.max(far, Math.hypot(value(x, i), value(y, i)));
  const radius = 1.08 * far;
  const disc = new Path2D();
  disc.arc(0, 0, radius, 0, 2 * Math.PI);
  const outer = along(new Path2D(), x, y, 0, x.length - 1);
  outer.closePath();
  const both = new Path2D(outer);
  both.addPath(plain.profile);
  /** @type {Box} */
  const box = { left: -radius, right: radius, bottom: -radius, top: radius };
  const follower = buildFollower(report, lab, { box, clear: radius + THICKNESS * report.mechanism.reach, free: true });
  for (const [a, b] of [[-radius, -radius], [radius, radius]]) include(follower.box, a, b);
  return {
    cam: { ...plain, profile: disc },
    follower,
    paint(pen) {
      const { context, palette } = pen;
      context.lineJoin = "round";
      context.fillStyle = palette.cam;
      context.fill(disc);
      context.fillStyle = palette.steel;
      context.globalAlpha = 0.75;
      context.fill(both, "evenodd");
      context.globalAlpha = 1;
      pen.line(palette.camEdge, 1.2);
      context.stroke(disc);
      pen.line(palette.camEdge, 1.65);
      context.stroke(plain.profile);
      context.stroke(outer);
      pen.line(palette.camEdge, 0.75);
      context.stroke(plain.hub);
      context.fillStyle = palette.paper;
      context.fill(plain.bore);
      context.stroke(plain.bore);
      context.stroke(plain.mark);
    },
  };
}
