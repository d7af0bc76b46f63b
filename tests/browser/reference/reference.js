// Runs inside a bare page: what one analysis costs in wasm, and what four charts cost, drawn by us and by uPlot.
import init, { Lab } from "/pkg/levalab_wasm.js";
import uPlot from "/uplot/uPlot.esm.js";

const SAMPLES = 720;
const WIDTH = 420;
const HEIGHT = 120;
const DIAGRAMS = /** @type {const} */ (["s", "v", "a", "j"]);
const COLUMNS = /** @type {const} */ (["theta", "s", "v", "a", "j", "pressure_angle", "rho", "rho_pitch", "x", "y", "pitch_x", "pitch_y"]);

await init();
const lab = new Lab();
const design = await (await fetch("/examples/9RT.lev.json")).json();

/**
 * Milliseconds a run, median of many rounds; a round is long enough for the browser's coarse clock.
 * @param {number} runs
 * @param {(run: number) => unknown} work
 */
async function time(runs, work) {
  const rounds = [];
  for (let round = 0; round < 31; round++) {
    const start = performance.now();
    for (let run = 0; run < runs; run++) await work(run);
    rounds.push((performance.now() - start) / runs);
  }
  return rounds.sort((a, b) => a - b)[15];
}

/** The same number of sines, added up, in JavaScript: how fast this machine is today. */
function sines() {
  let sum = 0;
  for (let station = 0; station <= SAMPLES; station++) sum += Math.sin(station * 0.01);
  return sum;
}

/** A change with every call, as a slider makes it. @param {number} run */
function changed(run) {
  const copy = structuredClone(design);
  copy.cam.base_radius += (run % 10) / 10;
  return copy;
}

export async function analysis() {
  const designs = Array.from({ length: 10 }, (_, run) => changed(run));
  const open = await time(50, (run) => lab.open(designs[run % 10], SAMPLES, "en"));
  const columns = await time(50, () => COLUMNS.map((name) => lab.column(name)));
  const reference = await time(200, sines);
  return { open, columns, reference };
}

export async function ourCharts() {
  const canvases = DIAGRAMS.map(() => document.body.appendChild(document.createElement("canvas")));
  const style = {
    width: WIDTH,
    height: HEIGHT,
    pixel_ratio: 2,
    font: "sans-serif",
    font_size: 11,
    ink: "#222222",
    muted: "#666666",
    grid: "#dddddd",
    background: "#ffffff",
    curve: "#0072b2",
    limit: "#cc0000",
    mark: "#888888",
    dash: [],
    stroke: 1.5,
    per_second: false,
    x_labels: true,
    decimal_comma: false,
  };
  lab.open(design, SAMPLES, "en");
  return time(10, () => DIAGRAMS.forEach((diagram, row) => lab.draw(canvases[row], diagram, style)));
}

export async function uplotCharts() {
  lab.open(design, SAMPLES, "en");
  const theta = lab.column("theta");
  const charts = DIAGRAMS.map((name) => {
    const options = { width: WIDTH, height: HEIGHT, legend: { show: false }, scales: { x: { time: false } }, series: [{}, { stroke: "#0072b2", width: 1.5 }] };
    return { chart: new uPlot(options, [theta, lab.column(name)], document.body), values: lab.column(name) };
  });
  return time(10, async (run) => {
    for (const { chart, values } of charts) {
      values[0] += run * 1e-9;
      chart.setData([theta, values]);
    }
    // uPlot draws in a microtask.
    await Promise.resolve();
  });
}
