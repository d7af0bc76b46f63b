/**
 * The diagram of s as a place to draw on: over the joined curve stand the requirements, which are drawn, moved and removed there.
 *
 * @import { ShellContext } from "../types.d.ts"
 * @import { Demand, Field, Kind, Part, Placed, Values } from "./demands.js"
 * @import { Grip, Handles } from "./handles.js"
 * @import { List } from "./list.js"
 */
import { h } from "../dom.js";
import { stepped } from "../hand.js";
import { heightStep } from "../number-field.js";
import { exact } from "../numbers.js";
import { factor } from "../scrub.js";
import { createBoard } from "./board.js";
import { drawn, moved, placed, turned } from "./demands.js";
import { createHand, snapped } from "./hand.js";
import { createHandles } from "./handles.js";
import { createTelling } from "./telling.js";

/** A height to begin from when nothing moves yet. */
const USUAL = 10;

/** Keys move by steps, and what lies between two of them stays there in the other direction: the finest part of a step. */
const FINEST = 0.1;

/**
 * @param {ShellContext} context
 * @param {List} list
 * @param {() => Kind} tool  what is drawn on the empty board
 * @param {(sentence: string) => void} tell  where the hand is, or what it holds
 */
export function createDrawing(context, list, tool, tell) {
  const { store, t } = context;
  const telling = createTelling(context);
  const layer = h("div", { class: "auto-layer", role: "group", tabindex: "-1" });
  const board = createBoard(context, heights, lay);
  const root = h("div", { class: "auto-plot" }, board.canvas, layer);
  const hand = createHand(layer, board.row, (held) => {
    root.classList.toggle("held", held);
    board.hold(held);
    if (!held) list.endGesture();
  });
  /** @type {Handles[]} */
  const handles = [];

  list.watch((what) => {
    if (what === "light") light();
    else lay();
  });

  const usualHeight = () => exact(Math.max(0, ...store.state.report.heights)) || USUAL;

  /** @param {number} k */
  function standing(k) {
    const demand = list.all[k];
    return demand && placed(demand);
  }

  /** Heights that the board has room for. */
  function heights() {
    const all = list.all.flatMap((demand) => {
      const place = placed(demand);
      return place ? [place.s, place.end] : [];
    });
    return Math.max(0, ...all) > 0 ? all : [...all, usualHeight()];
  }

  /** Puts the handles where the requirements are. */
  function lay() {
    const row = board.row();
    if (!row) return;
    for (const side of /** @type {const} */ (["left", "top", "width", "height"])) layer.style.setProperty(`--${side}`, `${row.area[side]}px`);
    while (handles.length > list.all.length) handles.pop()?.element.remove();
    while (handles.length < list.all.length) layer.append((handles[handles.length] = createOne(handles.length)).element);
    handles.forEach((of, k) => {
      const place = standing(k);
      of.element.hidden = !place;
      if (!place) return;
      of.draw({ ...row, x: -row.area.left, y: -row.area.top }, place);
      say(of, place, k);
    });
    light();
  }

  function light() {
    handles.forEach(({ element }, k) => element.classList.toggle("lit", k === list.lit));
  }

  /** @param {Handles} of @param {Placed} place @param {number} k */
  function say(of, place, k) {
    const name = t("auto.handle", { number: k + 1, kind: t(`auto.kind.${place.kind}`) });
    of.say(name, {
      whole: { name, now: place.from, text: telling.stand(place) },
      from: { name: t("auto.handle.from", { name }), now: place.from, text: telling.spot({ theta: place.from, s: place.s }) },
      to: { name: t("auto.handle.to", { name }), now: place.to, text: telling.spot({ theta: place.to, s: place.end }) },
      slope: { name: t("auto.handle.slope", { name }), now: place.v ?? 0, text: telling.velocity(place) },
    });
  }

  /** @param {number} k */
  function hold(k) {
    list.light(k);
    const place = standing(k);
    if (place) tell(telling.whole(place));
  }

  /** @param {number} k @param {Values} values @param {string} gesture */
  function put(k, values, gesture) {
    const texts = Object.entries(list.texts(values));
    const before = list.all[k];
    if (before && texts.some(([field, text]) => before[/** @type {Field} */ (field)] !== text)) {
      list.edit((draft) => void Object.assign(/** @type {Demand} */ (draft[k]), Object.fromEntries(texts)), gesture);
    }
    hold(k);
  }

  /** @param {number} k */
  function remove(k) {
    list.edit((draft) => void draft.splice(k, 1));
    tell("");
    const next = handles[Math.min(k, handles.length - 1)];
    if (next) next.focus("whole");
    else layer.focus();
  }

  /** @param {number} k */
  function createOne(k) {
    return createHandles({
      light: () => {
        if (!hand.busy()) hold(k);
      },
      rest: () => list.endGesture(),
      grab(part, event) {
        const place = standing(k);
        if (!place) return;
        hold(k);
        if (part === "slope") return hand.take(event, () => ({ move: ({ at, by, gesture }) => put(k, turned(place, at, by), gesture) }));
        const start = reference(place, part);
        hand.take(event, ({ at: from }) => ({
          move({ at, by, gesture }) {
            put(k, moved(place, part, { theta: start.theta + at.theta - from.theta, s: start.s + at.s - from.s }, by), gesture);
          },
        }));
      },
      key: (part, event) => press(k, part, event),
    });
  }

  /** @param {number} k @param {Grip} part @param {KeyboardEvent} event */
  function press(k, part, event) {
    const place = standing(k);
    if (!place || event.ctrlKey || event.metaKey) return;
    if (event.key === "Delete" || event.key === "Backspace") {
      event.preventDefault();
      if (part !== "slope") return remove(k);
      // A velocity that is removed is free.
      list.edit((draft) => void delete draft[k]?.v);
      return hold(k);
    }
    const [right = 0, up = 0] = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] ?? [];
    if (right === 0 && up === 0) return;
    event.preventDefault();
    event.stopPropagation();
    if (part === "slope") {
      const step = heightStep(store.state.design);
      return put(k, { v: stepped((place.v ?? 0) + (right + up) * step * factor(event), step * FINEST) }, `key:${k}.${part}`);
    }
    // The end of a dwell has only one way to go.
    const along = place.kind === "dwell" && part !== "whole" ? right + up : right;
    const step = { theta: 1, s: heightStep(store.state.design) };
    const at = reference(place, part);
    const to = { theta: at.theta + along * step.theta * factor(event), s: at.s + up * step.s * factor(event) };
    put(k, moved(place, part, to, { theta: step.theta * FINEST, s: step.s * FINEST }), `key:${k}.${part}`);
  }

  layer.addEventListener("pointerdown", (event) => {
    if (event.target !== layer) return;
    event.preventDefault();
    const k = list.all.length;
    /** @param {Kind} kind @param {Values} values @param {string} gesture */
    const create = (kind, values, gesture) => {
      list.edit((draft) => {
        draft[k] = { kind, ...list.texts(values) };
      }, gesture);
      hold(k);
    };
    hand.take(event, (pressed) => {
      const start = snapped(pressed);
      return {
        move(reach) {
          const kind = tool();
          const values = drawn(kind, start, snapped(reach));
          if (values.from !== values.to) create(kind, values, reach.gesture);
        },
        click: ({ gesture }) => create("point", { from: start.theta, s: start.s }, gesture),
        done: () => handles[k]?.focus("whole"),
      };
    });
  });
  layer.addEventListener("pointermove", (event) => {
    const row = board.row();
    if (hand.busy() || !row || event.target !== layer || event.pointerType === "touch") return;
    tell(telling.spot(snapped(hand.reach(event, row))));
  });
  layer.addEventListener("pointerleave", () => {
    if (!hand.busy()) tell("");
  });

  return {
    root,
    usualHeight,
    show: board.show,
    word() {
      layer.setAttribute("aria-label", t("auto.drawing"));
      board.word();
      lay();
    },
    /** @param {string | undefined} place  of the requirement that cannot be met */
    blame(place) {
      handles.forEach(({ element }, k) => element.classList.toggle("wrong", place === String(k)));
    },
    /** Gives back what is held, as it was; false when nothing is. */
    letGo() {
      const gesture = hand.gesture();
      if (gesture === undefined) return false;
      list.cancel(gesture);
      hand.drop();
      return true;
    },
  };
}

/**
 * The place by which a part is moved.
 * @param {Placed} place
 * @param {Part} part
 */
const reference = (place, part) => (part === "to" ? { theta: place.to, s: place.end } : { theta: place.from, s: place.s });
