// What the browser does for each frame, by its own trace: elements restyled, and the time of style, layout, paint, commit and tasks.

/** @typedef {import("playwright-core").Page} Page */

/**
 * @typedef {object} Frame  the work of the page's main thread from one commit to the next
 * @property {number} at        when it was committed, ms
 * @property {number} elements  whose style was recalculated
 * @property {number} style     ms of the thread, as the next three
 * @property {number} layout
 * @property {number} paint
 * @property {number} commit
 * @property {number} task      ms of the longest task, script and all, as it was lived through
 */

/**
 * @typedef {object} Event  of a trace; times in µs
 * @property {string} name
 * @property {number} pid
 * @property {number} tid
 * @property {number} ts
 * @property {number} [dur]
 * @property {number} [tdur]  of the thread alone, whatever else the machine does
 * @property {{ elementCount?: number }} [args]
 */

const CATEGORIES = ["devtools.timeline", "disabled-by-default-devtools.timeline"];

const TASK = "RunTask";
/** Which part of a frame each event counts as. @type {Readonly<Record<string, "style" | "layout" | "paint" | "commit">>} */
const PARTS = { UpdateLayoutTree: "style", Layout: "layout", PrePaint: "paint", Paint: "paint", Layerize: "paint", Commit: "commit" };

/**
 * The frames that the page made while `work` was done.
 * @param {Page} page
 * @param {() => Promise<unknown>} work
 * @returns {Promise<Frame[]>}
 */
export async function traced(page, work) {
  const browser = page.context().browser();
  if (!browser) throw new Error("the page belongs to no browser");
  await browser.startTracing(page, { categories: CATEGORIES });
  try {
    await work();
  } catch (error) {
    // A trace has to end before another can begin.
    await browser.stopTracing();
    throw error;
  }
  const trace = await browser.stopTracing();
  return framesOf(JSON.parse(trace.toString()).traceEvents);
}

/** @param {Event[]} events  of the whole browser */
function framesOf(events) {
  const own = events.filter(({ name }) => name in PARTS || name === TASK);
  const thread = busiest(own.filter(({ name }) => name === "Commit"));
  /** @type {Frame[]} */
  const frames = [];
  let frame = blank();
  for (const event of own.filter((event) => threadOf(event) === thread).sort((a, b) => a.ts - b.ts)) {
    const { name, ts, dur = 0, tdur, args } = event;
    if (name === TASK) {
      frame.task = Math.max(frame.task, dur / 1000);
      continue;
    }
    frame[PARTS[name]] += (tdur ?? dur) / 1000;
    frame.elements += args?.elementCount ?? 0;
    if (name !== "Commit") continue;
    frame.at = (ts + dur) / 1000;
    frames.push(frame);
    frame = blank();
  }
  // The first had begun before the trace did.
  return frames.slice(1);
}

/** @returns {Frame} */
const blank = () => ({ at: 0, elements: 0, style: 0, layout: 0, paint: 0, commit: 0, task: 0 });

/** @param {Event} event */
const threadOf = ({ pid, tid }) => `${pid} ${tid}`;

/** The thread of most events: that of the only page which moves. @param {Event[]} events */
function busiest(events) {
  /** @type {Map<string, number>} */
  const counts = new Map();
  for (const event of events) counts.set(threadOf(event), (counts.get(threadOf(event)) ?? 0) + 1);
  return [...counts].sort((a, b) => b[1] - a[1])[0]?.[0];
}
