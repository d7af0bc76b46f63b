/**
 * Another follower for the same cam: what can be kept is kept, the rest gets proportions that work.
 *
 * @import { Design, Follower, FollowerEntry, Parameter, ShellContext } from "./types.d.ts"
 */
import { clean } from "./clean.js";
import { scaleHeights, setEnd, statedEnd } from "./free-data.js";
import { heightAt } from "./program.js";

/** An oscillating follower that swings more than this is out of the ordinary. */
const LARGEST_SWING = 30;

/** Arm and pivot distance as shares of the prime circle, as in the classic programs (80 to 50). */
const ARM = 1.6;

/** The radii that mean the same on a roller and on a curved face. */
/** @type {Record<string, string>} */
const TWINS = { roller_radius: "face_radius", face_radius: "roller_radius" };

/**
 * @param {Design} draft
 * @param {FollowerEntry} entry
 */
export function changeFollower(draft, entry) {
  const old = draft.follower;
  /** @type {Follower} */
  const next = { motion: entry.motion, contact: entry.contact };
  for (const parameter of entry.parameters) {
    const value = kept(old, parameter.key) ?? proportion(parameter, draft.cam.base_radius ?? (draft.cam.length ?? 1) / 5, next);
    if (value !== null) next[parameter.key] = value;
  }
  draft.follower = next;
  // What an application is driven by is a length.
  if (next.motion === "oscillating") delete draft.application;
  if (old.motion !== next.motion) convertRises(draft, next.motion === "oscillating" ? lever(next) : 1 / lever(old));
}

/**
 * Another follower needs another tie to its second cam: one that works, or else the second cam goes.
 * @param {Design} draft
 * @param {ShellContext["room"]} room
 */
export function keepPair(draft, room) {
  if (!draft.conjugate) return;
  const key = draft.follower.motion === "translating" ? "distance" : "angle";
  const found = room(draft, key);
  if (found) draft.conjugate = { [key]: found.value };
  else delete draft.conjugate;
}

/**
 * @param {Follower} old
 * @param {string} key
 */
function kept(old, key) {
  const value = old[key] ?? old[TWINS[key] ?? ""];
  return typeof value === "number" ? value : null;
}

/**
 * @param {Parameter} parameter
 * @param {number} base  base radius
 * @param {Follower} next  the parameters found so far
 * @returns {number | null}
 */
function proportion({ key, quantity, default: usual }, base, next) {
  if (usual !== null || quantity !== "length") return usual;
  const prime = base + Number(next["roller_radius"] ?? 0);
  if (key === "roller_radius") return nice(0.2 * base);
  if (key === "face_radius") return nice(0.5 * base);
  if (key === "arm") return nice(ARM * prime);
  if (key === "pivot_distance") return nice(next.contact === "flat" ? 2 * base : ARM * prime);
  return 0;
}

/** @param {Follower} follower */
function lever(follower) {
  return (Number(follower["arm"] ?? follower["pivot_distance"]) * Math.PI) / 180;
}

/**
 * Heights turned into angles at the lever's end, or back, in round figures.
 * @param {Design} draft
 * @param {number} divisor  length a degree
 */
function convertRises(draft, divisor) {
  const heights = [...draft.segments.map((_, index) => heightAt(draft, index)), heightAt(draft)].map((height) => height / divisor);
  const top = Math.max(...heights.map(Math.abs));
  const shrink = draft.follower.motion === "oscillating" && top > LARGEST_SWING ? LARGEST_SWING / top : 1;
  const unit = 10 ** (Math.floor(Math.log10(top * shrink || 1)) - 1);
  const rounded = heights.map((height) => Math.round((height * shrink) / unit) * unit);
  draft.segments.forEach((segment, index) => {
    if (segment.rise) segment.rise = clean((rounded[index + 1] ?? 0) - (rounded[index] ?? 0));
    scaleHeights(segment, shrink / divisor);
    if (statedEnd(segment) !== undefined) setEnd(segment, clean(rounded[index + 1] ?? 0));
  });
}

/**
 * The nearest of 1, 1.5, 2, 2.5 … 10 times a power of ten.
 * @param {number} value
 */
function nice(value) {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  return clean((Math.round((value / power) * 2) / 2) * power);
}
