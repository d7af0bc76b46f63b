// The page's speed, beside its goals: `cargo xtask bench --page`. Timings swing from run to run, so nothing fails here.
import { readFile } from "node:fs/promises";
import os from "node:os";
import path from "node:path";
import { drawn, launchBrowser, root, startDist } from "./browser.js";
import { traced } from "./trace.js";

/** @typedef {import("playwright-core").Page} Page */

const SECONDS = 5;
/** A frame that the eye misses, ms. */
const LATE = 20;
/** Between the edits of a slow drag, ms: longer than the 90 for which a hand is held to be at work, so that cures and explanations run between. */
const SLOW = 140;
const EDITS = 10_000;
const MEGABIT = 1e6 / 8;

/** A slow mobile network and a cheap phone. */
const THROTTLED = { latency: 150, downloadThroughput: 1.6 * MEGABIT, uploadThroughput: 0.75 * MEGABIT, offline: false, cpu: 4 };

/** Designs whose edits take more than those of the page's first one. */
const HARDER = {
  "a conjugate pair (7CRT)": await example("7CRT"),
  "a pair of flat faces (8DA)": await example("8DA"),
  "a polynomial through twelve conditions": riseBy({
    law: "polynomial",
    conditions: [
      ...[0, 180].flatMap((at) => [0, 1, 2, 3].map((order) => ({ at, order, value: at > 0 && order === 0 ? 20 : 0 }))),
      ...[[45, 2.5], [75, 7.2], [105, 13.1], [140, 18.3]].map(([at, value]) => ({ at, order: 0, value })),
    ],
  }),
  "a table of sixty points": riseBy({ law: "table", points: Array.from({ length: 60 }, (_, i) => [(180 * i) / 59, 10 * (1 - Math.cos((Math.PI * i) / 59))]) }),
};

const site = await startDist({
  "/reference/": path.join(root, "tests/browser/reference"),
  "/pkg/": path.join(root, "web/pkg"),
  "/examples/": path.join(root, "examples"),
  "/uplot/": path.join(root, "node_modules/uplot/dist"),
});
const browser = await launchBrowser(["--enable-precise-memory-info"]);
/** @type {[what: string, found: string, goal: string][]} */
const table = [];

try {
  await measureLoading();
  await measureAnimation();
  await measureEdits();
  await measureEdits({ cpu: THROTTLED.cpu });
  for (const [of, design] of Object.entries(HARDER)) await measureEdits({ of, design });
  await measureMemory();
  await measureReference();
} finally {
  await browser.close();
  site.close();
}
console.log(`${os.cpus()[0].model}, ${os.cpus().length} cores, ${os.platform()} ${os.arch()}, Chromium ${browser.version()}, Node ${process.version}\n`);
const width = (/** @type {number} */ column) => Math.max(...table.map((row) => row[column].length));
for (const [what, found, goal] of table) console.log(`${what.padEnd(width(0))}  ${found.padStart(width(1))}  ${goal}`);

/** From the click on a link to the first complete drawing, nothing cached. */
async function measureLoading() {
  for (const [what, goal, throttle] of /** @type {const} */ ([
    ["navigation → charts drawn", "≤ 250 ms", false],
    ["navigation → charts drawn, slow 4G and CPU 4×", "≤ 1,200 ms", true],
  ])) {
    const times = [];
    for (let run = 0; run < 7; run++) {
      const { page, close } = await open(throttle ? THROTTLED : undefined);
      times.push(await page.evaluate(() => performance.getEntriesByName("levalab:drawn")[0].startTime));
      await close();
    }
    table.push([what, milliseconds(median(times)), goal]);
  }
}

/** The page as it opens: turning. */
async function measureAnimation() {
  const { page, close } = await open();
  await observe(page, "levalab:frame");
  await page.waitForTimeout(SECONDS * 1000);
  const { script, frames } = await observed(page);
  table.push(["animation frame, script, median", milliseconds(median(script)), "≤ 1 ms"]);
  table.push(["animation frame, script, p95", milliseconds(p95(script)), ""]);
  table.push([`animation frames in ${SECONDS} s`, String(script.length), `${SECONDS * 60} at 60 Hz`]);
  tellLate(frames, `of the animation in ${SECONDS} s`, "0");
  tellTrace("animation", await traced(page, () => page.waitForTimeout(SECONDS * 1000)));
  await close();
}

/**
 * The label of a number dragged to and fro.
 * @param {{ cpu?: number, of?: string, design?: object }} [options]  how many times slower; another design than the page's first, and what it is
 */
async function measureEdits({ cpu = 1, of = "", design } = {}) {
  const { page, close } = await open(undefined, (page) => page.addInitScript(remember, design));
  await pause(page);
  const devtools = await page.context().newCDPSession(page);
  await devtools.send("Emulation.setCPUThrottlingRate", { rate: cpu });
  const label = page.locator("#design .scrub").first();
  await label.scrollIntoViewIfNeeded();
  const box = await label.boundingBox();
  if (!box) throw new Error("no number with a label to drag");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 5, y);
  /** @param {number} steps  of a swing @param {number} [pause]  ms */
  async function swing(steps, pause = 0) {
    const end = performance.now() + SECONDS * 1000;
    for (let step = 0; performance.now() < end; step++) {
      await page.mouse.move(x + 60 + 50 * Math.sin(step / steps), y);
      if (pause > 0) await page.waitForTimeout(pause);
    }
  }
  await observe(page, "levalab:edit");
  await swing(20);
  const { script, frames } = await observed(page);
  const quick = await traced(page, () => swing(20));
  const slow = await traced(page, () => swing(5, SLOW));
  await page.mouse.up();
  const suffix = [of && `, ${of}`, cpu > 1 ? `, CPU ${cpu}×` : ""].join("");
  table.push([`edit → everything redrawn, script, median${suffix}`, milliseconds(median(script)), cpu > 1 ? "" : "≤ 2 ms"]);
  table.push([`edit → everything redrawn, script, p95${suffix}`, milliseconds(p95(script)), cpu > 1 ? "" : "≤ 4 ms"]);
  tellLate(frames, `in a ${SECONDS} s drag${suffix}`, cpu > 1 ? "" : "0");
  tellTrace(`drag${suffix}`, quick);
  tellTrace(`slow drag${suffix}`, slow);
  await close();
}

/**
 * @param {number[]} frames  time of each, ms
 * @param {string} where
 * @param {string} goal
 */
function tellLate(frames, where, goal) {
  table.push([`frames > ${LATE} ms of ${frames.length} ${where}`, String(frames.filter((time) => time > LATE).length), goal]);
}

/**
 * What the browser did, besides the script, for each frame in which something had changed.
 * @param {string} what
 * @param {import("./trace.js").Frame[]} frames
 */
function tellTrace(what, frames) {
  const working = frames.filter(({ layout }) => layout > 0);
  const elements = working.map((frame) => frame.elements);
  table.push([`${what}, elements restyled a frame, median and most of ${working.length}`, `${median(elements)}, ${quantile(elements, 1)}`, "≤ 60"]);
  for (const part of /** @type {const} */ (["style", "layout", "paint", "commit"])) {
    const times = working.map((frame) => frame[part]);
    table.push([`${what}, ${part} a frame, median and p95`, `${median(times).toFixed(2)}, ${milliseconds(p95(times))}`, ""]);
  }
  table.push([`${what}, longest task`, milliseconds(quantile(frames.map(({ task }) => task), 1)), "≤ 50 ms"]);
}

/** What the page remembers of an earlier visit. @param {object | undefined} design */
function remember(design) {
  if (design) localStorage.setItem("levalab:design", JSON.stringify(design));
}

/** @param {string} id */
async function example(id) {
  return JSON.parse(await readFile(path.join(root, `examples/${id}.lev.json`), "utf8"));
}

/** A cam that rises by 20 mm in half a turn. @param {object} law */
function riseBy(law) {
  return {
    format: "levalab/1", title: "", length_unit: "mm", speed: { value: 1, unit: "rad/s" },
    cam: { kind: "rotating", rotation: "counterclockwise", base_radius: 60 },
    follower: { motion: "translating", contact: "roller", roller_radius: 8, eccentricity: 0 },
    segments: [{ beta: 180, ...law }, { law: "polynomial-4-5-6-7", beta: 140, rise: -20 }, { law: "dwell", beta: 40 }],
  };
}

/** Many edits, each an undo step, then what is left after collecting the garbage. */
async function measureMemory() {
  const { page, close } = await open(undefined, watchMemories);
  await pause(page);
  const devtools = await page.context().newCDPSession(page);
  await edit(page, 2000);
  const before = await memory(page, devtools);
  await edit(page, EDITS);
  const after = await memory(page, devtools);
  const change = (/** @type {"heap" | "wasm"} */ kind) => `${((after[kind] - before[kind]) / 1e6).toFixed(2)} MB`;
  table.push([`memory after ${EDITS} edits, JavaScript (of ${(after.heap / 1e6).toFixed(1)} MB)`, change("heap"), "no growth"]);
  table.push([`memory after ${EDITS} edits, wasm (of ${(after.wasm / 1e6).toFixed(1)} MB)`, change("wasm"), "no growth"]);
  await close();
}

/** What a bare page takes for the same drawing and the analysis alone. */
async function measureReference() {
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.goto(`${site.origin}/reference/`);
  const times = await page.evaluate(async () => {
    const name = "/reference/reference.js";
    const reference = await import(name);
    return { ...(await reference.analysis()), ours: await reference.ourCharts(), uplot: await reference.uplotCharts() };
  });
  const micro = (/** @type {number} */ time) => `${(time * 1000).toFixed(1)} µs`;
  table.push(["wasm: analysis of 721 stations, verdict and report", micro(times.open), "≤ 50 µs"]);
  table.push(["wasm: a station of it", `${((times.open * 1e6) / 721).toFixed(1)} ns`, ""]);
  table.push(["wasm: the twelve columns copied out", micro(times.columns), ""]);
  table.push(["wasm: analysis ÷ 721 sines in JavaScript", (times.open / times.reference).toFixed(1), ""]);
  table.push(["four charts of 721 points, ours", milliseconds(times.ours), ""]);
  table.push(["four charts of 721 points, uPlot", milliseconds(times.uplot), "the reference"]);
  await context.close();
}

/** A fresh profile with the page drawn. @param {typeof THROTTLED} [throttle] @param {(page: Page) => Promise<unknown>} [prepare] */
async function open(throttle, prepare) {
  const context = await browser.newContext({ viewport: { width: 1366, height: 768 } });
  const page = await context.newPage();
  await prepare?.(page);
  if (throttle) {
    const { cpu, ...network } = throttle;
    const devtools = await context.newCDPSession(page);
    await devtools.send("Network.enable");
    await devtools.send("Network.emulateNetworkConditions", network);
    await devtools.send("Emulation.setCPUThrottlingRate", { rate: cpu });
  }
  await page.goto(site.url);
  await drawn(page);
  return { page, close: () => context.close() };
}

/** Stops the animation, so that edits are all that happens. @param {Page} page */
async function pause(page) {
  await page.locator("#mechanism canvas").first().focus();
  await page.keyboard.press("Space");
  await page.waitForTimeout(300);
}

/** Collects the page's own measures and the time between frames. @param {Page} page @param {string} name */
async function observe(page, name) {
  await page.evaluate((name) => {
    /** @type {{ script: number[], frames: number[] }} */
    const kept = { script: [], frames: [] };
    // Animation frames are measured only on request.
    Object.assign(window, { kept, levalabMeasure: true });
    new PerformanceObserver((list) => {
      for (const entry of list.getEntriesByName(name)) {
        const { detail } = /** @type {PerformanceMeasure} */ (entry);
        // An edit lasts until the frame that shows it; its script time is told apart.
        kept.script.push(detail?.script ?? entry.duration);
      }
    }).observe({ type: "measure" });
    let last = performance.now();
    requestAnimationFrame(function frame(now) {
      kept.frames.push(now - last);
      last = now;
      requestAnimationFrame(frame);
    });
  }, name);
}

/** @param {Page} page @returns {Promise<{ script: number[], frames: number[] }>} */
function observed(page) {
  return page.evaluate(() => /** @type {any} */ (window).kept);
}

/** Edits by keys, several a frame. @param {Page} page @param {number} count */
async function edit(page, count) {
  await page.evaluate(async (count) => {
    const input = /** @type {HTMLInputElement | null} */ (document.querySelector("#design input.number"));
    if (!input) throw new Error("no number field");
    const press = (/** @type {string} */ key) => input.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
    input.focus();
    const before = input.value;
    press("ArrowUp");
    if (input.value === before) throw new Error("the arrow keys change nothing");
    for (let done = 0; done < count; done++) {
      press("Enter");
      press(done % 2 ? "ArrowDown" : "ArrowUp");
      if (done % 10 === 9) await new Promise(requestAnimationFrame);
    }
    input.blur();
  }, count);
}

/** Keeps what memories the page's modules bring, to be measured later. @param {Page} page */
function watchMemories(page) {
  return page.addInitScript(() => {
    /** @type {Set<WebAssembly.Memory>} */
    const memories = new Set();
    Object.assign(window, { memories });
    for (const name of /** @type {const} */ (["instantiate", "instantiateStreaming"])) {
      const instantiate = /** @type {(...given: unknown[]) => Promise<any>} */ (WebAssembly[name]);
      Object.assign(WebAssembly, {
        /** @param {unknown[]} given */
        async [name](...given) {
          const made = await instantiate(...given);
          const { memory } = (made.instance ?? made).exports;
          if (memory) memories.add(memory);
          return made;
        },
      });
    }
  });
}

/** Bytes in use. @param {Page} page @param {import("playwright-core").CDPSession} devtools */
async function memory(page, devtools) {
  await devtools.send("HeapProfiler.enable");
  for (let round = 0; round < 3; round++) await devtools.send("HeapProfiler.collectGarbage");
  const { usedSize } = await devtools.send("Runtime.getHeapUsage");
  const wasm = await page.evaluate(() => [.../** @type {any} */ (window).memories].reduce((/** @type {number} */ sum, /** @type {WebAssembly.Memory} */ memory) => sum + memory.buffer.byteLength, 0));
  return { heap: usedSize, wasm: Number(wasm) };
}

/** @param {number[]} values @param {number} share */
function quantile(values, share) {
  if (values.length === 0) return Number.NaN;
  return values.toSorted((a, b) => a - b)[Math.min(values.length - 1, Math.floor(values.length * share))];
}

/** @param {number[]} values */
function median(values) {
  return quantile(values, 0.5);
}

/** @param {number[]} values */
function p95(values) {
  return quantile(values, 0.95);
}

/** @param {number} value */
function milliseconds(value) {
  return `${value.toFixed(value < 100 ? 2 : 0)} ms`;
}
