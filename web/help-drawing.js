/**
 * The drawing beside the geometry fields: the follower with its magnitudes dimensioned. The one that is being edited lights up, and a click
 * on a dimension goes to its field.
 *
 * @import { Symbols } from "./help-drawing-parts.js"
 * @import { FollowerEntry, KindId } from "./types.d.ts"
 */
import { s } from "./dom.js";
import { DRAWINGS, anyFollower } from "./follower-dimensions.js";
import { kindDrawing } from "./kind-drawings.js";
import { sign } from "./signs.js";

const WIDTH = 168;
const HEIGHT = 166;

/** Empty room above the followers that swing. */
const ROOM = 44;

/**
 * @param {object} options
 * @param {(parameter: string) => void} options.pick
 * @param {(parameter: string | null) => void} options.point
 */
export function createHelpDrawing({ pick, point }) {
  const root = s("svg", { class: "help-drawing", role: "img" });

  /** @param {Event} event */
  const parameterAt = (event) =>
    event.target instanceof Element ? (event.target.closest("[data-parameter]")?.getAttribute("data-parameter") ?? null) : null;

  root.addEventListener("click", (event) => {
    const parameter = parameterAt(event);
    if (parameter) pick(parameter);
  });
  root.addEventListener("pointerover", (event) => point(parameterAt(event)));
  root.addEventListener("pointerleave", () => point(null));

  return {
    root,

    /**
     * @param {FollowerEntry} entry
     * @param {string} name  text alternative
     * @param {KindId} kind
     */
    show(entry, name, kind) {
      /** @type {Symbols} */
      const symbols = { base_radius: "R_b", breadth: "d_c", length: "ℓ" };
      for (const parameter of entry.parameters) symbols[parameter.key] = parameter.symbol;
      for (const [key, ours] of Object.entries(symbols)) if (key !== "arm") symbols[key] = sign(ours);
      const plain = () => (DRAWINGS[entry.id] ?? anyFollower)(symbols);
      const top = entry.motion === "oscillating" ? ROOM : 0;
      root.setAttribute("viewBox", `0 ${top} ${WIDTH} ${HEIGHT - top}`);
      root.setAttribute("aria-label", name);
      if (kind === "rotating" || kind === "grooved") return root.replaceChildren(...plain());
      root.replaceChildren(...(kindDrawing(kind, entry.id, symbols) ?? plain()));
    },

    /** @param {string | null} parameter */
    light(parameter) {
      for (const group of root.querySelectorAll("[data-parameter]")) {
        group.classList.toggle("lit", group.getAttribute("data-parameter") === parameter);
      }
    },
  };
}
