/**
 * The requirements as one state of table and drawing: what each changes the other shows, and every change can be taken back.
 *
 * @import { Language } from "../types.d.ts"
 * @import { Demand, Field, Values } from "./demands.js"
 */
import { exact, fieldText, parseNumber } from "../numbers.js";

/** Steps that are remembered. */
const MOST = 200;

/** @typedef {ReturnType<typeof createList>} List */

/** @param {() => Language} language */
export function createList(language) {
  /** @type {Demand[]} */
  let all = [];
  /** @type {Demand[][]} */
  let past = [];
  /** @type {Demand[][]} */
  let future = [];
  let gesture = "";
  let lit = -1;
  /** @type {((what: "demands" | "light") => void)[]} */
  const watchers = [];
  const tell = (/** @type {"demands" | "light"} */ what) => watchers.forEach((watcher) => watcher(what));

  /** @param {Values} values @returns {Partial<Record<Field, string>>} */
  const texts = (values) => Object.fromEntries(Object.entries(values).map(([field, value]) => [field, fieldText(exact(value), language())]));

  /** @param {Demand[] | undefined} to @param {Demand[][]} kept */
  function travel(to, kept) {
    if (!to) return;
    kept.push(all);
    all = to;
    gesture = "";
    lit = Math.min(lit, all.length - 1);
    tell("demands");
  }

  return {
    get all() {
      return all;
    },
    /** The one that is lit in table and drawing, or −1. */
    get lit() {
      return lit;
    },
    get canUndo() {
      return past.length > 0;
    },
    get canRedo() {
      return future.length > 0;
    },
    texts,

    /** Begins anew. @param {Demand[]} demands */
    begin(demands) {
      [all, past, future, gesture, lit] = [demands, [], [], "", -1];
      tell("demands");
    },

    /**
     * Changes the list; changes of one gesture are taken back at once.
     * @param {(draft: Demand[]) => void} change
     * @param {string} [of]
     */
    edit(change, of = "") {
      const before = all;
      all = structuredClone(before);
      change(all);
      if (of === "" || of !== gesture) {
        past = [...past.slice(1 - MOST), before];
        future = [];
      }
      gesture = of;
      lit = Math.min(lit, all.length - 1);
      tell("demands");
    },

    /** The next change is a step of its own. */
    endGesture() {
      gesture = "";
    },

    /** Takes back a gesture that is under way, as if it had never begun. @param {string} of */
    cancel(of) {
      const before = of === gesture ? past.pop() : undefined;
      if (!before) return;
      [all, gesture] = [before, ""];
      tell("demands");
    },
    undo: () => travel(past.pop(), future),
    redo: () => travel(future.pop(), past),

    /** @param {number} place */
    light(place) {
      if (lit === place) return;
      lit = place;
      tell("light");
    },

    /** Numbers as the language writes them. */
    speak() {
      for (const demand of all) {
        for (const field of /** @type {const} */ (["from", "to", "s", "end", "v"])) {
          const { value } = parseNumber(demand[field] ?? "", "°");
          if (value !== undefined) demand[field] = fieldText(value, language());
        }
      }
      tell("demands");
    },

    /** @param {(what: "demands" | "light") => void} watcher */
    watch(watcher) {
      watchers.push(watcher);
    },
  };
}
