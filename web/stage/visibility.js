/** Drawing only what can be seen: a canvas that is scrolled out of view, with its frame or within the page, is drawn when it comes back. */

/**
 * Watches whether an element is in view. The browser reports it also when this page is in a frame that is itself scrolled out of view.
 * Until the first report the element counts as visible, so that the first picture waits for nothing.
 * @param {Element} element
 */
export function watchVisibility(element) {
  let visible = true;
  /** Functions that were called while nothing could be seen. @type {Set<() => void>} */
  const due = new Set();

  new IntersectionObserver((entries) => {
    visible = entries.at(-1)?.isIntersecting ?? visible;
    if (!visible) return;
    const late = [...due];
    due.clear();
    for (const work of late) work();
  }).observe(element);

  return {
    visible: () => visible,

    /**
     * The same function, but out of view it waits, and runs once when the element comes back.
     * @param {() => void} work
     * @returns {() => void}
     */
    inView: (work) => () => {
      if (visible) work();
      else due.add(work);
    },
  };
}
