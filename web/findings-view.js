/**
 * The window on the list of findings: it ends below a whole line, never in the middle of a sentence or a cure, and says when there is more.
 */
import { h } from "./dom.js";

/**
 * @param {HTMLElement} root  the verdict: `open` while it is unfolded, `data-more` while something is out of sight
 * @param {HTMLElement} list
 * @param {HTMLButtonElement} unfold
 */
export function createFindingsView(root, list, unfold) {
  const view = h("div", { class: "findings" }, list);
  /** What the window leaves free below its last whole line, CSS pixels. */
  let left = 0;

  unfold.addEventListener("click", () => {
    const open = root.classList.toggle("open");
    unfold.setAttribute("aria-expanded", String(open));
    measure();
  });
  // After the layout, so that an edit never waits for one.
  const sizes = new ResizeObserver(measure);
  sizes.observe(view);
  sizes.observe(list);

  function measure() {
    const room = view.offsetHeight + left;
    const longer = list.offsetHeight > room + 1;
    root.toggleAttribute("data-more", longer || root.classList.contains("open"));
    view.toggleAttribute("data-longer", longer);
    const rest = longer ? room - lastWhole(room) : 0;
    if (rest === left) return;
    left = rest;
    view.style.marginBlockEnd = `${left}px`;
  }

  /** Where the last line ends that is whole in such a room; the room itself when not even one is. @param {number} room */
  function lastWhole(room) {
    const { top } = list.getBoundingClientRect();
    const ends = Array.from(list.querySelectorAll("button, .counsel"), (part) => Math.ceil(part.getBoundingClientRect().bottom - top));
    return Math.max(0, ...ends.filter((end) => end <= room)) || room;
  }

  return view;
}
