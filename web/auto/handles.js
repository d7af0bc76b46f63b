/**
 * A requirement on the diagram: a bar with two ends, or a dot with a tangent that can be turned, each moved by pointer or keys.
 *
 * @import { Row } from "../stage/overlay.js"
 * @import { Part, Placed } from "./demands.js"
 */
import { h } from "../dom.js";
import { atTheta, atValue } from "../stage/overlay.js";
import { RADIAN, TURN } from "./demands.js";

/** Half the tangent of a point, pixels. */
const TANGENT = 32;

/** Beyond any velocity. */
const FASTEST = 1e6;

/** @typedef {Part | "slope"} Grip  what a hand can take hold of */
/** @typedef {ReturnType<typeof createHandles>} Handles */

/**
 * @param {object} acts
 * @param {(part: Grip, event: PointerEvent) => void} acts.grab
 * @param {(part: Grip, event: KeyboardEvent) => void} acts.key
 * @param {() => void} acts.light
 * @param {() => void} acts.rest   the hand has left it
 */
export function createHandles({ grab, key, light, rest }) {
  const whole = handle("whole");
  const from = handle("from");
  const to = handle("to");
  const slope = handle("slope");
  for (const [button, least, most] of /** @type {const} */ ([[whole, 0, TURN], [from, 0, TURN], [to, 0, TURN], [slope, -FASTEST, FASTEST]])) {
    button.setAttribute("aria-valuemin", String(least));
    button.setAttribute("aria-valuemax", String(most));
  }
  const tangent = h("span", { class: "auto-tangent", "aria-hidden": "true" });
  const element = h("div", { class: "auto-demand", role: "group" }, tangent, whole, from, to, slope);

  /** @param {Grip} part */
  function handle(part) {
    const button = h("button", { type: "button", class: `auto-${part}`, role: "slider" });
    button.addEventListener("pointerdown", (event) => {
      if (event.button === 0) grab(part, event);
    });
    button.addEventListener("keydown", (event) => key(part, event));
    button.addEventListener("focus", light);
    button.addEventListener("pointerenter", light);
    button.addEventListener("blur", rest);
    return button;
  }

  /** @param {HTMLElement} target @param {number} x @param {number} y */
  function put(target, x, y) {
    target.style.setProperty("--x", `${x.toFixed(1)}px`);
    target.style.setProperty("--y", `${y.toFixed(1)}px`);
  }

  /** @param {HTMLElement} target @param {number} dx @param {number} dy */
  function span(target, dx, dy) {
    target.style.setProperty("--dx", dx.toFixed(1));
    target.style.setProperty("--dy", dy.toFixed(1));
  }

  return {
    element,

    /** @param {Part} part */
    focus: (part) => ({ whole, from, to })[part].focus(),

    /**
     * @param {Row} row
     * @param {Placed} place
     */
    draw(row, { kind, from: start, to: end, s, end: top, v }) {
      const [left, right] = [{ x: atTheta(row, start), y: atValue(row, s) }, { x: atTheta(row, end), y: atValue(row, top) }];
      element.dataset["kind"] = kind;
      [from.hidden, to.hidden] = [kind === "point", kind === "point"];
      put(whole, (left.x + right.x) / 2, (left.y + right.y) / 2);
      span(whole, right.x - left.x, right.y - left.y);
      put(from, left.x, left.y);
      put(to, right.x, right.y);
      [tangent.hidden, slope.hidden] = [kind !== "point", kind !== "point"];
      if (kind !== "point") return;
      // It is as long whatever the velocity, and lies level where that is free.
      const [dx, dy] = [atTheta(row, start + 1) - left.x, atValue(row, s + (v ?? 0) / RADIAN) - left.y];
      const scale = TANGENT / Math.hypot(dx, dy);
      element.toggleAttribute("data-free", v === undefined);
      put(tangent, left.x, left.y);
      span(tangent, scale * dx, scale * dy);
      tangent.style.setProperty("--long", `${2 * TANGENT}px`);
      put(slope, left.x + scale * dx, left.y + scale * dy);
    },

    /**
     * What a reader of the screen is told.
     * @param {string} name
     * @param {Record<Grip, { name: string, now: number, text: string }>} parts
     */
    say(name, parts) {
      element.setAttribute("aria-label", name);
      for (const [part, button] of Object.entries({ whole, from, to, slope })) {
        const { name, now, text } = parts[/** @type {Grip} */ (part)];
        for (const [key, value] of [["aria-label", name], ["aria-valuenow", String(now)], ["aria-valuetext", text]]) {
          if (button.getAttribute(key ?? "") !== value) button.setAttribute(key ?? "", value ?? "");
        }
      }
    },
  };
}
