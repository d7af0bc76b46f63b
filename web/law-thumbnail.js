/** The acceleration of a law, a stroke high. */
import { s } from "./dom.js";

const WIDTH = 34;
const HEIGHT = 18;
const MARGIN = 2;

export function createThumbnail() {
  const curve = s("path", { class: "curve" });
  const root = s(
    "svg",
    { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: "thumbnail", "aria-hidden": "true" },
    s("path", { class: "zero", d: `M0 ${HEIGHT / 2}H${WIDTH}` }),
    curve,
  );
  let drawn = "";

  return {
    root,

    /**
     * @param {readonly number[]} acceleration  −1…1 at even steps
     * @param {boolean} falling                 a return is the rise upside down
     */
    draw(acceleration, falling) {
      const last = Math.max(1, acceleration.length - 1);
      const scale = (HEIGHT / 2 - MARGIN) * (falling ? 1 : -1);
      const points = acceleration.map((value, index) => `${((index / last) * WIDTH).toFixed(1)} ${(HEIGHT / 2 + scale * value).toFixed(1)}`);
      const d = points.length ? `M0 ${HEIGHT / 2}L${points.join("L")}L${WIDTH} ${HEIGHT / 2}` : "";
      if (d === drawn) return;
      drawn = d;
      curve.setAttribute("d", d);
    },
  };
}
