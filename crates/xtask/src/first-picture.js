// Draws with a watched module what a first visit shows, and prints the numbers of the stretches of code that this entered:
// `node first-picture.js GLUE WATCHED`, both with their whole path.
import { readFile } from "node:fs/promises";
import { pathToFileURL } from "node:url";

const [, , glue, watched] = process.argv;

/** A canvas on which everything can be drawn and nothing is seen. */
class Surface {}
class Canvas {
  width = 1000;
  height = 300;
  getContext() {
    return surface;
  }
}
const surface = new Proxy(new Surface(), { get: (target, key) => (typeof key === "symbol" ? Reflect.get(target, key) : () => undefined), set: () => true });
Object.assign(globalThis, { HTMLCanvasElement: Canvas, CanvasRenderingContext2D: Surface });

const { initSync, Lab, open_link, read_design } = await import(pathToFileURL(glue).href);
const exports = initSync({ module: await readFile(watched) });

/** Cams that a course page links to, besides the one that the page opens with. */
const OTHERS = ["1RT", "3PT", "2RO", "4PO", "12PO"];
const SAMPLES = 720;
/** Without dashes, and with. */
const DASHES = [[], [9, 3], [4, 2.5]];
const DIAGRAMS = ["s", "v", "a", "j", "pressure_angle", "rho"];
/** From a phone to a projector: curves are thinned to the width they are drawn at, which takes other turns at each. */
const SIZES = Array.from({ length: 60 }, (_, step) => [280 + 17 * step, 80 + ((step * 97) % 560)]);
const STYLE = {
  font: 'system-ui, "Segoe UI", sans-serif', font_size: 11, stroke: 1.5,
  ink: "#111111", muted: "#888888", grid: "#cccccc", background: "#ffffff", curve: "#0066cc", limit: "#cc0000", mark: "#ff9900",
};

for (const id of ["9RT", ...OTHERS]) {
  const design = JSON.parse(await readFile(new URL(`../../../examples/${id}.lev.json`, import.meta.url), "utf8"));
  for (const language of ["en", "es"]) {
    const lab = new Lab();
    // As it came, then as it is after a first edit.
    for (const factor of [1, 1.03]) {
      const cam = { ...design.cam, base_radius: Math.round(design.cam.base_radius * factor) };
      const { report } = lab.open({ ...design, cam }, SAMPLES, language);
      for (const diagram of DIAGRAMS) {
        const applies = lab.column(diagram).length > 0;
        for (const [step, [width, height]] of applies ? SIZES.entries() : []) {
          const own = { width, height, dash: DASHES[step % 3], pixel_ratio: 2 + (step % 2), x_labels: height > 100, per_second: width > 600, decimal_comma: language === "es" };
          lab.draw(new Canvas(), diagram, { ...STYLE, ...own });
        }
      }
      for (const column of ["x", "y", "pitch_x", "pitch_y"]) lab.column(column);
      for (let theta = 0; theta < 360; theta += 7.5) lab.at(theta, new Float64Array(32));
      open_link(report.link, language);
    }
    lab.free();
    read_design(design, language);
  }
}

const entered = [];
for (let number = 0; `entered${number}` in exports; number++) if (exports[`entered${number}`].value === 1) entered.push(number);
console.log(JSON.stringify(entered));
