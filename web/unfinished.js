/**
 * A design on its way: what is on screen is not a cam, or a field holds what is no number yet. What leaves the page is then the last
 * valid cam, and says so.
 *
 * @import { ShellContext } from "./types.d.ts"
 */

/** @param {Pick<ShellContext, "store">} context */
export const isUnfinished = ({ store }) => store.state.error !== null || document.documentElement.hasAttribute("data-pending");

/**
 * Says what is copied, saved, printed or compared instead of an unfinished design.
 * @param {Pick<ShellContext, "store" | "banner">} context
 */
export function sayWhatLeaves(context) {
  if (!isUnfinished(context)) return;
  const { store, banner } = context;
  banner.show("banner.unfinished");
  const stop = store.subscribe(["report"], () => {
    stop();
    banner.hide();
  });
}
