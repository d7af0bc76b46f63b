/**
 * A requirement on the diagram: a bar with two ends, or a dot, each moved by pointer or keys.
 *
 * @import { Row } from "../stage/overlay.js"
 * @import { Part, Placed } from "./demands.js"
 */
import { h } from "../dom.js";
import { atTheta, atValue } from "../stage/overlay.js";

/** Half the tangent of a point with a velocity, pixels. */
const TANGENT = 26;

const RADIAN = 180 / Math.PI;

/** @typedef {ReturnType<typeof createHandles>} Handles */

/**
 * @param {object} acts
 * @param {(part: Part, event: PointerEvent) => void} acts.grab
 * @param {(part: Part, event: KeyboardEvent) => void} acts.key
 * @param {() => void} acts.light
 * @param {() => void} acts.rest   the hand has left it
 */
export function createHandles({ grab, key, light, rest }) {
  const whole = handle("whole");
  const from = handle("from");
  const to = handle("to");
  const tangent = h("span", { class: "auto-tangent", "aria-hidden": "true" });
  const element = h("div", { class: "auto-demand", role: "group" }, tangent, whole, from, to);

  /** @param {Part} part */
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
      tangent.hidden = v === undefined;
      if (v === undefined) return;
      // A velocity is per radian; the line is as long whatever its slope.
      const across = atTheta(row, start + 1) - left.x;
      put(tangent, left.x, left.y);
      span(tangent, across, atValue(row, s + v / RADIAN) - left.y);
      tangent.style.setProperty("--long", `${2 * TANGENT}px`);
    },

    /**
     * What a reader of the screen is told.
     * @param {string} name
     * @param {Record<Part, { name: string, now: number, text: string }>} parts
     */
    say(name, parts) {
      element.setAttribute("aria-label", name);
      for (const [part, button] of Object.entries({ whole, from, to })) {
        const { name, now, text } = parts[/** @type {Part} */ (part)];
        for (const [key, value] of [["aria-label", name], ["aria-valuenow", String(now)], ["aria-valuetext", text]]) {
          if (button.getAttribute(key ?? "") !== value) button.setAttribute(key ?? "", value ?? "");
        }
      }
    },
  };
}
