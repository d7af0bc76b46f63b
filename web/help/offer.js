/**
 * The quiet offer of a guided minute at the first visit: a line in the header that blocks nothing and does not come back.
 *
 * @import { ShellContext } from "../types.d.ts"
 */
import { h } from "../dom.js";
import { keep } from "../memory.js";
import { createTexts } from "../texts.js";
import { startTour } from "./tour.js";
import { dressed } from "./words.js";

/** @param {ShellContext} context */
export async function offerTour(context) {
  const { store, t } = context;
  await dressed;
  const texts = createTexts(t);
  const yes = texts.text(h("button", { type: "button", class: "quiet" }), "tour.offer");
  const no = texts.attribute(h("button", { type: "button", class: "quiet" }, "×"), "aria-label", "tour.decline");
  const offer = h("div", { class: "offer" }, yes, no);
  const unsubscribe = store.subscribe(["language"], () => texts.refresh());
  const leave = () => {
    keep("tour", true);
    unsubscribe();
    offer.remove();
  };
  yes.addEventListener("click", () => {
    leave();
    void startTour(context);
  });
  no.addEventListener("click", leave);
  document.querySelector("#header .end")?.before(offer);
}
