/**
 * How cams that are no plain rotating plate are drawn, and second cams: yoke, pair, wedge, groove. Loaded when one is met.
 *
 * @import { Format, Lab, Report, State } from "../types.d.ts"
 * @import { Cam } from "./cam-part.js"
 * @import { Follower, Pose } from "./follower-part.js"
 * @import { Layer } from "./layers.js"
 * @import { Pen } from "./pen.js"
 * @import { Box } from "./view.js"
 */
import { along, between, buildCam } from "./cam-part.js";
import { drawRoller } from "./details.js";
import { drawDimension } from "./dimensions.js";
import { THICKNESS, around, buildFollower, extremes, faceHeight } from "./follower-part.js";
import { AT, newInstant } from "./instant.js";
import { drawNormal } from "./layers.js";
import { hatch, polygon, rectangle } from "./shapes.js";
import { include } from "./view.js";
import { plain } from "../signs.js";

/**
 * @typedef {object} Frame  what is drawn in one frame
 * @property {Readonly<State>} state
 * @property {Float64Array} at
 * @property {number} angle
 * @property {number} shift
 * @property {Format} format
 * @property {Pose} pose
 * @property {(layer: Layer) => boolean} layer
 */

/** @typedef {(pen: Pen, frame: Frame) => void} Draw */

/**
 * @typedef {object} Dress  parts in place of the plain ones, and what is drawn besides, back to front
 * @property {Cam} [cam]
 * @property {Follower} [follower]
 * @property {Draw} [behind]  before the follower's body
 * @property {(pen: Pen) => void} [paint]  the cam itself, in its own frame; the body then goes over it
 * @property {Draw} [front]   over everything but normal and readings
 */

/** @typedef {{ dress: (report: Report, lab: Lab) => Dress | null }} Kinds */

/** Share of a wedge's length that its follower is drawn for, when it is low. */
const WEDGE_SIZE = 0.3;
/** Depth of a wedge below its base line, as a share of its length. */
const WEDGE_DEPTH = 0.1;
/** Lines of the second cam's hatching across it. */
const HATCHES = 44;
/** Free room within a frame, in its thicknesses. */
const ROOM = 0.6;

/**
 * @param {Report} report
 * @param {Lab} lab
 * @returns {Dress | null}
 */
export function dress(report, lab) {
  if (report.travels) return wedge(report, lab);
  if (report.kind === "grooved") return groove(report, lab);
  if (report.conjugate) return pair(report, lab, report.conjugate);
  return report.kind === "constant-breadth" ? yoke(report, lab) : null;
}

/**
 * @param {Float64Array} at
 * @param {number} place
 */
const value = (at, place) => /** @type {number} */ (at[place]);

/**
 * @param {Report} report
 * @param {Lab} lab
 * @returns {Dress}
 */
function wedge(report, lab) {
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

/**
 * @param {Report} report
 * @param {Lab} lab
 * @returns {Dress}
 */
function groove(report, lab) {
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

/**
 * @param {Report} report
 * @param {Lab} lab
 * @returns {Dress}
 */
function yoke(report, lab) {
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

/**
 * @param {Report} report
 * @param {Lab} lab
 * @param {Report} other
 * @returns {Dress}
 */
function pair(report, lab, other) {
  const { mechanism } = report;
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

/**
 * A frame around the cam that carries an element at its top and another across the shaft.
 * @param {Report} report
 * @param {Lab} lab
 * @param {{ gap: number, radius: number, radius2?: number, reach: number }} given  `gap` between faces, or centres of rollers
 */
function framed(report, lab, { gap, radius, radius2 = radius, reach }) {
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

/** Lines at 45° over a square about the origin. @param {number} reach */
function hatching(reach) {
  const path = new Path2D();
  hatch(path, -reach, -reach, reach, reach, (4 * reach) / HATCHES);
  return path;
}
