/**
 * The panel: what is driven, its parameters, the diagrams of what comes out, and the points to hit.
 *
 * @import { ShellContext } from "../types.d.ts"
 */
import { h } from "../dom.js";
import { createTexts } from "../texts.js";
import { createFields } from "./fields.js";
import { createPlots } from "./plots.js";
import { createTargets } from "./targets.js";
import { createWork } from "./work.js";

/**
 * @param {ShellContext} context
 * @param {HTMLButtonElement} button  that opens and closes it
 */
export function createPanel(context, button) {
  const { store, t } = context;
  const texts = createTexts(t);
  const { work, renew } = createWork(context);
  const heading = texts.text(h("h2", { id: "application-heading", tabindex: "-1" }), "application.title");
  const close = texts.text(h("button", { type: "button" }), "application.close");
  const about = texts.text(h("p"), "application.about");
  const refusal = texts.text(h("p", { hidden: true }), "application.swings");
  const pair = texts.text(h("p", { hidden: true }), "application.second");
  const parts = [createFields(context, work), createPlots(context, work), createTargets(context, work)];
  const root = h(
    "section",
    { id: "application", "aria-labelledby": heading.id, hidden: true },
    h("div", { class: "application-head" }, heading, close),
    about,
    refusal,
    ...parts.slice(0, 1).map((part) => part.root),
    pair,
    ...parts.slice(1).map((part) => part.root),
  );
  document.querySelector("main")?.append(root);
  button.setAttribute("aria-controls", root.id);

  close.addEventListener("click", hide);
  root.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || event.defaultPrevented) return;
    event.stopPropagation();
    hide();
  });
  store.subscribe(["design", "report", "error", "language"], (_, changed) => {
    if (changed.has("language")) texts.refresh();
    if (!root.hidden) update();
  });

  function update() {
    renew();
    const { design, report } = store.state;
    const swings = design.follower.motion === "oscillating";
    refusal.hidden = !swings;
    about.hidden = swings || Boolean(design.application);
    pair.hidden = report.conjugate === null || !design.application;
    for (const part of parts) {
      part.root.hidden = swings || (part !== parts[0] && !work.report);
      if (!part.root.hidden) part.update();
    }
  }

  function hide() {
    root.hidden = true;
    button.setAttribute("aria-expanded", "false");
    button.focus();
  }

  return {
    toggle() {
      if (!root.hidden) return hide();
      root.hidden = false;
      button.setAttribute("aria-expanded", "true");
      update();
      heading.focus();
    },
  };
}
