/**
 * A cam of constant breadth or diameter between the two sides of a yoke.
 *
 * @import { Lab, Report } from "../../types.d.ts"
 * @import { Dress } from "../kinds.js"
 */
import { between, buildCam } from "../cam-part.js";
import { drawRoller } from "../details.js";
import { AT, newInstant, value } from "../instant.js";
import { drawNormal } from "../layers.js";
import { plain } from "../../signs.js";
import { framed } from "./frame.js";

/** @param {Report} report */
export const suits = (report) => report.kind === "constant-breadth";

/**
 * @param {Report} report
 * @param {Lab} lab
 * @returns {Dress}
 */
export function dress(report, lab) {
  const { mechanism, summary } = report;
  const breadth = summary.breadth?.max ?? 0;
  const radius = mechanism.contact === "roller" ? mechanism.roller_radius : 0;
  const cam = buildCam(report, lab);
  const frame = framed(report, lab, { gap: breadth + 2 * radius, radius, reach: mechanism.reach });
  const far = newInstant();
  return {
    cam,
    follower: frame.follower,
    front(pen, { state, pose, format, layer }) {
      // What touches on the far side is what touched on this side half a turn before, seen from behind.
      lab.at(state.cursor + 180, far);
      for (let place = AT.contactX; place <= AT.centreY; place++) far[place] = -value(far, place);
      if (radius > 0 && cam.rolled) drawRoller(pen, value(far, AT.traceX), value(far, AT.traceY), between(cam.rolled, (state.cursor + 180) % 360), radius);
      pen.screen();
      if (layer("normal")) drawNormal(pen, report, far, `${plain("φ")} = ${format.angle(far[AT.pressureAngle])}`);
      pen.dot(value(far, AT.contactX), value(far, AT.contactY), 4, pen.palette.ink);
      frame.measure(pen, pose, radius, breadth, "d_c", format.number(Number(breadth.toPrecision(9)), { unit: report.units.length }), state.highlight?.parameter === "breadth");
    },
  };
}
