/**
 * How cams that are no plain rotating plate are drawn, and second cams: a file each.
 *
 * @import { Format, Lab, Report, State } from "../types.d.ts"
 * @import { Cam } from "./cam-part.js"
 * @import { Follower, Pose } from "./follower-part.js"
 * @import { Layer } from "./layers.js"
 * @import { Pen } from "./pen.js"
 */
import * as groove from "./kinds/groove.js";
import * as pair from "./kinds/pair.js";
import * as wedge from "./kinds/wedge.js";
import * as yoke from "./kinds/yoke.js";

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

/**
 * The first that suits a report dresses it.
 * @type {{ suits: (report: Report) => boolean, dress: (report: Report, lab: Lab) => Dress }[]}
 */
const KINDS = [wedge, groove, pair, yoke];

/**
 * @param {Report} report
 * @param {Lab} lab
 */
export const dress = (report, lab) => KINDS.find((kind) => kind.suits(report))?.dress(report, lab) ?? null;
