/**
 * A finding: its sentence, its places, and the changes that cure it. It is rewritten in place, since during a drag it
 * changes with every frame.
 *
 * @import { Cure, Finding, ShellContext, State } from "./types.d.ts"
 */
import { h, write } from "./dom.js";
import { placeIn, placeText } from "./stage/place.js";

/**
 * What a finding says, with derivatives as the diagrams have them.
 * @param {Finding} finding
 * @param {Pick<State, "perSecond">} state
 */
export const sentenceOf = ({ message, message_by_time }, { perSecond }) => (perSecond ? message_by_time ?? message : message);

/**
 * @param {ShellContext} context
 * @param {() => void} cured  where the focus goes when the cure has taken its button away
 */
export function createFindingItem({ store, t, format }, cured) {
  /** @type {Finding | null} */
  let what = null;
  /** @type {Cure[]} */
  let remedies = [];
  const sentence = h("button", { type: "button", class: "finding-text" });
  const places = h("span", { class: "places" });
  const cures = h("span", { class: "cures" });
  const counsel = h("span", { class: "counsel" });
  const root = h("li", { class: "finding pending" }, sentence, places, cures, counsel);

  sentence.addEventListener("click", () => what && see(what.theta));
  root.addEventListener("pointerenter", () => store.set({ highlight: highlight() }));
  root.addEventListener("pointerleave", () => store.set({ highlight: null }));
  root.addEventListener("focusin", () => store.set({ highlight: highlight() }));
  root.addEventListener("focusout", () => store.set({ highlight: null }));

  /** @returns {import("./types.d.ts").Highlight | null} */
  function highlight() {
    if (!what) return null;
    return what.interval ? { theta: what.theta, interval: what.interval } : { theta: what.theta };
  }

  /** @param {number} theta */
  function see(theta) {
    const cursor = placeIn(store.state.report, theta);
    store.set({ cursor, playing: false, highlight: { theta }, ...(what?.cam ? { second: what.cam === 2 } : {}) });
  }

  /**
   * As many buttons as there are texts, each with its text.
   * @param {HTMLElement} parent
   * @param {string} kind
   * @param {string[]} texts
   * @param {(index: number) => void} act
   */
  function fillButtons(parent, kind, texts, act) {
    while (parent.childElementCount > texts.length) parent.lastElementChild?.remove();
    while (parent.childElementCount < texts.length) {
      const index = parent.childElementCount;
      const button = h("button", { type: "button", class: kind });
      button.addEventListener("click", () => act(index));
      parent.append(button);
    }
    texts.forEach((text, index) => {
      const button = parent.children[index];
      if (button) write(button, text);
    });
  }

  /** @param {number} index */
  function cure(index) {
    const edits = remedies[index]?.edits;
    if (!edits) return;
    store.edit(t("edit.cure"), edits);
    cured();
  }

  return {
    root,

    /** @param {Finding} finding */
    update(finding) {
      const next = { ...finding, message: sentenceOf(finding, store.state) };
      // The message is in the language and the units of the page, so that a change of either is a change.
      const same = what?.message === next.message && what.cam === next.cam && what.severity === next.severity && what.theta === next.theta && what.places.join() === next.places.join();
      what = next;
      if (same) return;
      write(sentence, next.cam === undefined ? next.message : t("verdict.cam", { number: next.cam, text: next.message }));
      root.classList.toggle("tolerated", next.severity === "acceptable");
      sentence.title = t("verdict.see", { angle: placeText(format, store.state.report, next.theta) });
      const several = next.places.length > 1 ? next.places : [];
      fillButtons(places, "place", several.map(degrees), (index) => see(what?.places[index] ?? 0));
    },

    /**
     * The cures of the cam in sight; null while they are not known yet: then those of the cam before wait, disabled.
     * @param {Cure[] | null} next
     */
    prescribe(next) {
      if (next) {
        // An advice has no edits: it is read, not applied.
        const advice = next.filter(({ edits }) => edits.length === 0);
        remedies = next.filter(({ edits }) => edits.length > 0);
        root.classList.remove("pending");
        fillButtons(cures, "cure", remedies.map(({ message }) => message), cure);
        write(counsel, advice.map(({ message }) => message).join(" "));
      }
      const waiting = next === null;
      for (const button of cures.children) {
        if (button instanceof HTMLButtonElement && button.disabled !== waiting) button.disabled = waiting;
      }
    },
  };

  /** @param {number} theta */
  function degrees(theta) {
    return store.state.report.travels ? placeText(format, store.state.report, theta) : format.number(Math.round(theta * 10) / 10, { unit: "°" });
  }
}

/** @typedef {ReturnType<typeof createFindingItem>} FindingItem */
