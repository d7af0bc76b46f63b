/**
 * Keys of the whole page: undo, redo, projector and what it shows, help, and those of the animation while nothing has the focus.
 *
 * @import { ShellContext } from "./types.d.ts"
 */
import { afterProjectorKey, leavesProjector } from "./projector.js";
import { played } from "./stage/clock.js";

/** @param {ShellContext} context */
export function listen({ store }) {
  addEventListener("keydown", (event) => {
    if (event.defaultPrevented) return;
    const key = event.key.toLowerCase();
    if (event.ctrlKey || event.metaKey) {
      if (event.altKey) return;
      const redo = key === "y" || (key === "z" && event.shiftKey);
      if ((!redo && key !== "z") || hasOwnEdit(event.target)) return;
      event.preventDefault();
      if (redo) store.redo();
      else store.undo();
      return;
    }
    // What has a use for Escape of its own has stopped or prevented it.
    if (event.key === "Escape") {
      if (!leavesProjector(store.state)) return;
      event.preventDefault();
      store.set({ projector: false });
      return;
    }
    if (isTyping(event.target) || document.querySelector("dialog:modal")) return;
    const change = event.target === document.body ? played(store.state, event) : null;
    const besides = event.altKey ? null : afterProjectorKey(store.state, key);
    if (change) store.set(change);
    else if (event.altKey) return;
    else if (besides) store.set(besides);
    else if (key === "c") document.getElementById("pin")?.click();
    else if (key === "p") store.set({ projector: !store.state.projector });
    else if (key === "?") document.getElementById("help-button")?.click();
    else return;
    event.preventDefault();
  });
}

/**
 * A text that is not in the design yet is undone by the browser, not by us.
 * @param {EventTarget | null} target
 */
function hasOwnEdit(target) {
  return target instanceof HTMLElement && target.hasAttribute("data-pending");
}

/** @param {EventTarget | null} target */
function isTyping(target) {
  return target instanceof HTMLInputElement ? !["radio", "checkbox", "range", "button"].includes(target.type) : target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement;
}
