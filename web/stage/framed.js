/**
 * Whose a gesture is while another page, of a course say, shows this one in a frame. As on the maps that pages show, wheel and finger scroll
 * that page until the picture has been clicked or tapped; with Ctrl held the wheel is the picture's at once.
 */
import { h } from "../dom.js";

/** Milliseconds that a hint stays after the gesture that it is about. */
const HINT = 1500;

/** True when another page shows this one in a frame. */
export const isFramed = () => window.top !== window.self;

/**
 * @param {HTMLElement} picture  that takes the focus when it is clicked; a hint lies over it, in its parent
 * @param {() => { wheel: string, finger?: string }} words  how the picture is used from here on
 */
export function sharedGestures(picture, words) {
  const framed = isFramed();
  const hint = h("p", { class: "gesture-hint", "aria-hidden": "true" });
  let timer = 0;
  picture.toggleAttribute("data-framed", framed);

  /** True while keys would reach the picture: it was clicked, tapped or reached by Tab, and the page around has not been clicked since. */
  const chosen = () => document.hasFocus() && document.activeElement === picture;

  /** @param {string} sentence */
  function tell(sentence) {
    hint.textContent = sentence;
    if (!hint.isConnected) picture.after(hint);
    clearTimeout(timer);
    // The first time it fades in too.
    requestAnimationFrame(() => hint.setAttribute("data-shown", ""));
    timer = window.setTimeout(() => hint.removeAttribute("data-shown"), HINT);
  }

  if (framed) {
    // The browser has taken a finger to scroll with.
    picture.addEventListener("pointercancel", ({ pointerType }) => {
      const { finger } = words();
      if (finger && pointerType === "touch" && !chosen()) tell(finger);
    });
  }

  return {
    /** Whether the wheel turns for the picture; a hint says how, when it does not. @param {WheelEvent} event */
    ownsWheel({ ctrlKey }) {
      if (!framed || ctrlKey || chosen()) return true;
      tell(words().wheel);
      return false;
    },

    /** Whether the picture follows what presses on it: a finger only once it has been tapped. @param {PointerEvent} event */
    ownsPress: ({ pointerType }) => !framed || pointerType !== "touch" || chosen(),
  };
}
