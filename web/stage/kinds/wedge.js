/**
 * A wedge that travels to and fro between two stops on its bed.
 *
 * @import { Lab, Report } from "../../types.d.ts"
 * @import { Dress } from "../kinds.js"
 * @import { Box } from "../view.js"
 */
import { along, buildCam } from "../cam-part.js";
import { drawDimension } from "../dimensions.js";
import { THICKNESS, buildFollower } from "../follower-part.js";
import { hatch, polygon, rectangle } from "../shapes.js";

/** Share of a wedge's length that its follower is drawn for, when it is low. */
const WEDGE_SIZE = 0.3;
/** Depth of a wedge below its base line, as a share of its length. */
const WEDGE_DEPTH = 0.1;

/** @param {Report} report */
export const suits = (report) => report.travels;

/**
 * @param {Report} report
 * @param {Lab} lab
 * @returns {Dress}
 */
export function dress(report, lab) {
  const { span: length, mechanism } = report;
  const reach = Math.max(mechanism.reach, WEDGE_SIZE * length);
  const floor = -WEDGE_DEPTH * length;
  const t = THICKNESS * reach;
  const plain = buildCam(report, lab);
  const profile = along(new Path2D(), plain.x, plain.y, 0, plain.x.length - 1);
  profile.lineTo(length, floor);
  profile.lineTo(0, floor);
  profile.closePath();
  const none = new Path2D();
  /** @type {Box} */
  const box = { left: -length - 2 * t, right: length + 2 * t, bottom: floor - 2.2 * t, top: 0 };
  const follower = buildFollower({ ...report, mechanism: { ...mechanism, reach } }, lab, { box });
  const bed = polygon([-length - 2 * t, floor], [length + 2 * t, floor]);
  hatch(follower.hatching, -length - 2 * t, floor - 1.3 * t, length + 2 * t, floor, 0.9 * t);
  // Stops where the wedge turns round.
  const stops = [rectangle(-length - 1.2 * t, floor, -length, 0.35 * floor), rectangle(length, floor, length + 1.2 * t, 0.35 * floor)];
  follower.ground.push(bed, ...stops);
  return {
    cam: { ...plain, profile, hub: none, bore: none, mark: none },
    follower,
    front(pen, { state, shift, format }) {
      if (state.highlight?.parameter !== "length") return;
      const y = 0.5 * floor;
      pen.screen();
      drawDimension(pen, { from: [-shift, y], to: [length - shift, y], symbol: "ℓ" }, format.quantity(length, { trim: true, unit: report.units.length }));
    },
  };
}
