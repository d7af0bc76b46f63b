/**
 * The designs that were worked on lately, one entry in the browser for each, so that tabs never write over each other.
 *
 * @import { Design, Read, ShellContext } from "./types.d.ts"
 */
import { forget, keep, kept, recall } from "./memory.js";
import { isShelved } from "./shelf.js";

const BEGINNING = "recent:";

/** Designs that are kept: some fifty kilobytes of the five million characters that a browser gives. */
const MOST = 16;

/** Milliseconds between two writings. */
const PAUSE = 1000;

/** @typedef {{ name: string, saved: number, design: Design }} Recent */
/** @typedef {(design: unknown) => Read} Check */

/**
 * Newest first. What cannot be read, whoever wrote it, is taken away.
 * @param {Check} check
 * @returns {Recent[]}
 */
export function recentDesigns(check) {
  const found = kept(BEGINNING).flatMap((name) => {
    const entry = /** @type {{ saved?: unknown, design?: unknown } | null} */ (recall(name));
    const saved = entry?.saved;
    const { design } = check(entry?.design ?? null);
    if (design && typeof saved === "number" && Math.abs(saved) < 8.64e15) return [{ name, saved, design }];
    forget(name);
    return [];
  });
  return found.sort((a, b) => b.saved - a.saved);
}

/** The entries that open tabs are at work on. @returns {Promise<Set<string>>} */
export async function inOtherTabs() {
  // A frame without an origin has locks and refuses to tell of them; it has no entries either.
  const { held = [] } = (await navigator.locks?.query().catch(() => undefined)) ?? {};
  return new Set(held.flatMap(({ name = "" }) => (own.has(name) ? [] : [name])));
}

/** Locks of this tab, held for as long as it lives. @type {Set<string>} */
const own = new Set();

/**
 * Makes an entry this tab's; false when it is another's.
 * @param {string} name
 * @returns {Promise<boolean>}
 */
function claim(name) {
  if (own.has(name)) return Promise.resolve(true);
  if (!navigator.locks) return Promise.resolve(false);
  return new Promise((resolve) => {
    const hold = (/** @type {Lock | null} */ lock) => {
      resolve(lock !== null);
      if (!lock) return undefined;
      own.add(name);
      return new Promise(() => {});
    };
    navigator.locks.request(name, { ifAvailable: true }, hold).catch(() => resolve(false));
  });
}

/**
 * Keeps what is worked on in this tab: each design that was opened goes on in an entry of its own.
 * @param {ShellContext} context
 * @param {Check} check
 */
export function keepRecent({ store }, check) {
  /** The entry of each opened design. @type {Map<number, string>} */
  const entries = new Map();
  let timer = 0;
  let written = "";

  async function write() {
    clearTimeout(timer);
    timer = 0;
    const [design, origin] = [store.lastGood(), store.origin()];
    const text = JSON.stringify(design);
    if (text === written || isShelved(text)) return;
    const name = entries.get(origin) ?? (await entryFor(text));
    if (name === "") return;
    entries.set(origin, name);
    written = text;
    keep(name, { saved: Date.now(), design });
  }

  /**
   * The entry that holds the very same design already, unless another tab is at work on it: then none is needed. Else a new one.
   * @param {string} text
   */
  async function entryFor(text) {
    const all = recentDesigns(check);
    const same = all.find(({ design }) => JSON.stringify(design) === text || JSON.stringify(check(JSON.parse(text)).design) === JSON.stringify(design));
    if (same) return (await claim(same.name)) ? same.name : "";
    for (const { name } of all.slice(MOST - 1)) forget(name);
    const name = `${BEGINNING}${Date.now().toString(36)}${Math.random().toString(36).slice(2, 8)}`;
    await claim(name);
    own.add(name);
    return name;
  }

  store.subscribe(["report"], () => {
    timer ||= window.setTimeout(write, PAUSE);
  });
  addEventListener("pagehide", () => {
    if (timer) void write();
  });
  void write();
}
