/**
 * The page's only state, its undo history and the one animation frame in which everything is redrawn.
 *
 * @import { Design, DesignError, Keeper, State, Store, ViewState, Wiring } from "./types.d.ts"
 */

/** Undo steps that are kept: a whole lesson, in some hundred kilobytes. */
const HISTORY = 400;

/** Measures kept in the browser's performance timeline before it is emptied, so that memory does not grow. */
const MEASURES = 1000;

/** Name of the measure that covers an edit, from its beginning to the end of the frame that shows it. */
export const EDIT_MEASURE = "levalab:edit";

/** What is said of an edit before the page is put together. @type {DesignError} */
const UNWIRED = { path: "", message: "" };

/** @returns {ViewState} */
function initialView() {
  return {
    cursor: 0,
    playing: false,
    rate: 0.25,
    perSecond: false,
    tab: "svaj",
    second: false,
    layers: { base: true, prime: true, pitch: true, axes: true, normal: true, osculating: false, stations: false },
    language: "en",
    theme: "system",
    projector: false,
    projectorSpeed: false,
    projectorValues: false,
    highlight: null,
    margins: {},
    beside: [],
  };
}

/**
 * @typedef {object} Entry
 * @property {string} label
 * @property {Design} design
 * @property {string | undefined} gesture
 * @property {number} origin
 */

/** @returns {Store & Keeper} */
export function createStore() {
  /** @type {Wiring | null} */
  let wiring = null;
  /** @type {State} */
  const state = Object.assign(/** @type {State} */ ({ error: null, stale: false }), initialView());
  /** @type {Design | null} */
  let good = null;
  /** @type {{ keys: string[], fn: (state: Readonly<State>, changed: ReadonlySet<string>) => void }[]} */
  const listeners = [];
  /** @type {Entry[]} */
  const past = [];
  /** @type {Entry[]} */
  const future = [];
  /** Counts the designs that were opened: which of them the current one grew from. */
  let origin = 0;
  let origins = 0;
  /** Two sets in turn, so that a frame of the animation allocates nothing here. */
  let changed = new Set();
  let spare = new Set();
  let scheduled = false;
  let editStart = 0;
  let editScript = 0;
  let measures = 0;

  function scheduleDraw() {
    if (scheduled) return;
    scheduled = true;
    (wiring?.frame ?? requestAnimationFrame)(draw);
  }

  function draw() {
    scheduled = false;
    const now = changed;
    changed = spare;
    spare = now;
    const frameStart = performance.now();
    for (const { keys, fn } of listeners) {
      if (!meets(keys, now)) continue;
      try {
        fn(state, now);
      } catch (error) {
        if (!wiring?.failed) throw error;
        wiring.failed(error);
      }
    }
    now.clear();
    if (editStart > 0) measureEdit(frameStart);
  }

  /** @param {number} frameStart */
  function measureEdit(frameStart) {
    const end = performance.now();
    if (++measures % MEASURES === 0) performance.clearMeasures(EDIT_MEASURE);
    performance.measure(EDIT_MEASURE, { start: editStart, end, detail: { script: editScript + end - frameStart } });
    editStart = 0;
    editScript = 0;
  }

  /**
   * Makes `design` the current one, good or not. The last good report stays when it is not.
   * @param {Design} design
   */
  function adopt(design) {
    const start = performance.now();
    if (editStart === 0) editStart = start;
    // A motion that is ready-made has no segments to tell.
    design.segments ??= [];
    state.design = design;
    changed.add("design");
    const opened = wiring ? wiring.analyse(design) : undefined;
    if (opened?.outline) state.outline = opened.outline;
    if (opened?.report) {
      state.report = opened.report;
      good = design;
      changed.add("report");
    }
    const error = opened?.error ?? null;
    if (error !== state.error) {
      state.error = error;
      changed.add("error");
    }
    if (state.stale !== (error !== null)) {
      state.stale = error !== null;
      changed.add("stale");
    }
    editScript += performance.now() - start;
    scheduleDraw();
  }

  /**
   * @param {string} label
   * @param {string} [gesture]
   */
  function remember(label, gesture) {
    future.length = 0;
    const last = past.at(-1);
    if (gesture !== undefined && last?.gesture === gesture) return;
    past.push({ label, design: state.design, gesture, origin });
    if (past.length > HISTORY) past.shift();
  }

  /**
   * @param {Entry[]} from
   * @param {Entry[]} to
   */
  function travel(from, to) {
    const entry = from.pop();
    if (!entry) return;
    to.push({ label: entry.label, design: state.design, gesture: undefined, origin });
    origin = entry.origin;
    adopt(entry.design);
  }

  return {
    get state() {
      return state;
    },

    connect(next) {
      wiring = next;
    },

    start(design) {
      adopt(design);
      editStart = 0;
      editScript = 0;
      return state.error === null;
    },

    reanalyse(design = state.design) {
      adopt(design);
    },

    touch(key) {
      changed.add(key);
      scheduleDraw();
    },

    subscribe(keys, fn) {
      const listener = { keys: /** @type {string[]} */ (keys), fn };
      listeners.push(listener);
      return () => void listeners.splice(listeners.indexOf(listener), 1);
    },

    set(patch) {
      for (const key of /** @type {(keyof ViewState)[]} */ (Object.keys(patch))) {
        if (Object.is(state[key], patch[key])) continue;
        Object.assign(state, { [key]: patch[key] });
        changed.add(key);
      }
      if (changed.size > 0) scheduleDraw();
    },

    edit(label, edits, { gesture, told = false } = {}) {
      const start = performance.now();
      const { design, error } = wiring?.apply(state.design, edits) ?? { error: UNWIRED };
      if (!design) {
        if (!told) wiring?.refused?.(error, state.design, edits);
        return error;
      }
      remember(label, gesture);
      if (editStart === 0) editStart = start;
      editScript += performance.now() - start;
      adopt(design);
      return null;
    },

    cancel(gesture) {
      const last = past.at(-1);
      if (!last || last.gesture !== gesture) return;
      past.pop();
      adopt(last.design);
    },

    endGesture() {
      const last = past.at(-1);
      if (last) last.gesture = undefined;
    },

    replace(design, label) {
      remember(label);
      origin = ++origins;
      adopt(design);
    },

    undo: () => travel(past, future),
    redo: () => travel(future, past),
    canUndo: () => past.length > 0,
    canRedo: () => future.length > 0,
    lastGood: () => good ?? state.design,
    origin: () => origin,
    undoLabel: () => past.at(-1)?.label ?? "",
    redoLabel: () => future.at(-1)?.label ?? "",

    drawNow: draw,
  };
}

/**
 * @param {string[]} keys
 * @param {Set<string>} set
 */
function meets(keys, set) {
  for (const key of keys) if (set.has(key)) return true;
  return false;
}

export const store = createStore();
