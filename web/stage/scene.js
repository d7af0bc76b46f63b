/**
 * The whole picture of the mechanism, back to front. What depends on the design alone is built once; a frame only places it.
 *
 * @import { Format, Highlight, Lab, Report, State } from "../types.d.ts"
 * @import { Cam } from "./cam-part.js"
 * @import { Follower, Pose } from "./follower-part.js"
 * @import { Stations } from "./stations.js"
 * @import { Kinds, Dress } from "./kinds.js"
 * @import { Pen } from "./pen.js"
 * @import { Box } from "./view.js"
 */
import { between, buildCam, drawCam, stretch } from "./cam-part.js";
import { drawRoller, drawScale, drawSpring } from "./details.js";
import { dimension, drawDimension } from "./dimensions.js";
import { buildFollower } from "./follower-part.js";
import { AT } from "./instant.js";
import { LAYERS, applies, drawAxes, drawBase, drawNormal, drawOsculating, drawPrime } from "./layers.js";
import { placeIn } from "./place.js";
import { buildStations, drawStations, stationsReach } from "./stations.js";
import { include } from "./view.js";
import { plain } from "../signs.js";

/** A jump of the cursor over more than this is taken for the passage of 360°, not for a move. */
const PASSAGE = 180;

export class Scene {
  /** @type {Report} */
  report;
  /** @type {Cam} */
  cam;
  /** @type {Follower} */
  follower;
  /** What another kind of cam, or a second one, adds. @type {Dress | null} */
  dress;
  /** @type {Stations | null} */
  #stations = null;
  /** @type {Pose} */
  #pose = { x: 0, y: 0, angle: 0, mirror: 1 };
  /** @type {{ highlight: Highlight | null, path: Path2D | null }} */
  #lit = { highlight: null, path: null };
  #turns = 0;
  #theta = 0;

  /**
   * @param {Report} report
   * @param {Lab} lab
   * @param {Scene | null} before  the scene that this one takes the place of
   * @param {Kinds | null} kinds  for what is no plain rotating cam
   */
  constructor(report, lab, before, kinds) {
    this.report = report;
    this.lab = lab;
    this.dress = kinds?.dress(report, lab) ?? null;
    this.cam = this.dress?.cam ?? buildCam(report, lab);
    this.follower = this.dress?.follower ?? buildFollower(report, lab);
    if (!before) return;
    this.#turns = before.#turns;
    this.#theta = before.#theta;
  }

  /**
   * What there is to see in a whole turn.
   * @param {Readonly<State>} state
   * @returns {Box}
   */
  box(state) {
    const box = { ...this.follower.box };
    if (shown(state, "stations", this.report) && !this.report.travels) include(box, 0, 0, stationsReach(this.report));
    for (const { reach } of this.#beside(state)) include(box, 0, 0, reach);
    return box;
  }

  /** Turn of the cam, rad; none when it travels. @param {number} theta */
  camAngle(theta) {
    return this.report.travels ? 0 : (this.report.mechanism.sense * theta * Math.PI) / 180;
  }

  /** How far the cam has travelled. @param {number} place */
  camShift(place) {
    return this.report.travels ? place : 0;
  }

  /**
   * @param {Pen} pen
   * @param {Readonly<State>} state
   * @param {Float64Array} at
   * @param {Format} format
   * @param {number} width
   * @param {number} height
   */
  draw(pen, state, at, format, width, height) {
    const { context } = pen;
    const { report, dress } = this;
    const angle = this.camAngle(state.cursor);
    const shift = this.camShift(state.cursor);
    this.follower.place(at, this.#pose);
    const frame = { state, at, angle, shift, format, pose: this.#pose, layer: (/** @type {keyof typeof LAYERS} */ name) => shown(state, name, report) };

    pen.screen();
    context.clearRect(0, 0, width, height);
    this.#drawGround(pen);
    pen.screen();
    if (shown(state, "axes", report)) drawAxes(pen, report);
    dress?.behind?.(pen, frame);
    if (!dress?.paint) this.#drawBody(pen);
    pen.world(-shift, 0, angle);
    if (dress?.paint) dress.paint(pen);
    else drawCam(pen, this.cam);
    for (const { outline, sense, colour, dash } of this.#beside(state)) {
      pen.world(-shift, 0, report.travels ? 0 : (sense * state.cursor * Math.PI) / 180);
      pen.line(colour, 1.5);
      context.setLineDash(dash.map((length) => (length * pen.weight) / pen.view.scale));
      context.stroke(outline);
    }
    context.setLineDash([]);
    this.#drawLit(pen, state, angle, shift);
    if (shown(state, "pitch", report) && this.cam.pitch) {
      pen.world(-shift, 0, angle);
      pen.line(pen.palette.pitch, 1.25, "pitch");
      context.stroke(this.cam.pitch);
    }
    if (dress?.paint) this.#drawBody(pen);
    pen.screen();
    if (shown(state, "base", report)) drawBase(pen, report, state.cursor);
    if (shown(state, "prime", report)) drawPrime(pen, report);
    if (shown(state, "stations", report)) drawStations(pen, (this.#stations ??= buildStations(report, this.lab)), angle, shift);
    this.#drawRoller(pen, state.cursor);
    dress?.front?.(pen, frame);
    pen.screen();
    if (shown(state, "osculating", report)) drawOsculating(pen, at);
    if (shown(state, "normal", report)) drawNormal(pen, report, at, `${plain("φ")} = ${format.angle(at[AT.pressureAngle])}`);
    pen.dot(/** @type {number} */ (at[AT.contactX]), /** @type {number} */ (at[AT.contactY]), 4, pen.palette.ink);
    this.#drawParameter(pen, state, at, format);
    drawScale(pen, report, format, height);
  }

  /** The cams beside whose lengths are in the same unit. @param {Readonly<State>} state */
  #beside({ beside }) {
    const { units, mechanism } = this.report;
    return mechanism.base_radius > 0 ? beside.filter(({ unit }) => unit === units.length) : [];
  }

  /** @param {Pen} pen */
  #drawGround(pen) {
    const { context, palette } = pen;
    pen.world();
    pen.line(palette.line, 0.75);
    context.stroke(this.follower.hatching);
    pen.line(palette.ink, 1);
    for (const piece of this.follower.ground) context.stroke(piece);
  }

  /** @param {Pen} pen */
  #drawBody(pen) {
    const { palette, context } = pen;
    const { x, y, angle, mirror } = this.#pose;
    pen.world(x, y, angle, mirror);
    pen.part(this.follower.body, palette.steel, palette.camEdge, 1);
    context.fillStyle = palette.paper;
    pen.line(palette.camEdge, 1);
    for (const joint of this.follower.joints) {
      context.fill(joint);
      context.stroke(joint);
    }
    if (this.follower.spring) drawSpring(pen, this.follower.spring, this.#pose.y);
  }

  /**
   * @param {Pen} pen
   * @param {number} theta
   */
  #drawRoller(pen, theta) {
    const { roller } = this.follower;
    const { rolled } = this.cam;
    if (!(roller > 0) || !rolled) return;
    const moved = theta - this.#theta;
    if (!this.report.travels && Math.abs(moved) > PASSAGE) this.#turns -= Math.sign(moved);
    this.#theta = theta;
    const spin = between(rolled, theta, this.cam.span) + this.#turns * /** @type {number} */ (rolled.at(-1));
    const along = this.report.mechanism.arm ?? 0;
    const { x, y, angle } = this.#pose;
    drawRoller(pen, x + along * Math.cos(angle), y + along * Math.sin(angle), spin, roller);
  }

  /**
   * What the pointer is on elsewhere: an angle, a stretch, a segment.
   * @param {Pen} pen
   * @param {Readonly<State>} state
   * @param {number} angle
   * @param {number} shift
   */
  #drawLit(pen, { highlight }, angle, shift) {
    if (highlight !== this.#lit.highlight) this.#lit = { highlight, path: this.#litPath(highlight) };
    const { context, palette } = pen;
    if (this.#lit.path) {
      pen.world(-shift, 0, angle);
      context.lineCap = "round";
      pen.line(palette.accent, 5);
      context.stroke(this.#lit.path);
      context.lineCap = "butt";
    }
    if (highlight?.theta === undefined) return;
    const theta = placeIn(this.report, highlight.theta);
    const [x, y] = [between(this.cam.x, theta, this.cam.span), between(this.cam.y, theta, this.cam.span)];
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    pen.screen();
    pen.dot(x * c - y * s - shift, x * s + y * c, 6, palette.accent);
  }

  /** @param {Highlight | null} highlight */
  #litPath(highlight) {
    if (highlight?.interval) return stretch(this.cam, ...highlight.interval);
    const from = highlight?.segment === undefined ? undefined : this.report.borders[highlight.segment];
    const to = highlight?.segment === undefined ? undefined : this.report.borders[highlight.segment + 1];
    return from === undefined || to === undefined ? null : stretch(this.cam, from, to);
  }

  /**
   * @param {Pen} pen
   * @param {Readonly<State>} state
   * @param {Float64Array} at
   * @param {Format} format
   */
  #drawParameter(pen, state, at, format) {
    const path = state.highlight?.parameter;
    const drawn = path && !path.startsWith("conjugate") && dimension(path, this.report, at);
    if (!drawn) return;
    const key = path.slice(path.lastIndexOf(".") + 1);
    const kept = key === "base_radius" ? state.design.cam.base_radius : state.design.follower[key];
    const value = typeof kept === "number" && key === "eccentricity" ? kept * (this.report.notation?.eccentricity ?? 1) + 0 : kept;
    const text = typeof value !== "number" ? "" : drawn.about ? format.angle(value) : format.quantity(value, { trim: true, unit: this.report.units.length });
    pen.screen();
    drawDimension(pen, drawn, text);
  }
}

/**
 * @param {Readonly<State>} state
 * @param {keyof typeof LAYERS} layer
 * @param {Report} report
 */
const shown = (state, layer, report) => (state.layers[layer] ?? LAYERS[layer]) && applies(layer, report);
