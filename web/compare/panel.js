/**
 * The window of the comparison: the table of the slate and the tournament of the laws. Overlays stay when it is closed.
 *
 * @import { ShellContext } from "../types.d.ts"
 * @import { Slate } from "./slate.js"
 */
import { h } from "../dom.js";
import { choice } from "../stage/choice.js";
import { createTexts } from "../texts.js";
import { createSlateTable } from "./slate-table.js";
import { createTournament } from "./tournament.js";

/**
 * @param {ShellContext} context
 * @param {Slate} slate
 */
export function createPanel(context, slate) {
  const { store, t } = context;
  const texts = createTexts(t);
  const heading = texts.text(h("h2", { id: "compare-heading" }), "compare.title");
  const status = h("p", { class: "compare-status", role: "status" });
  const close = texts.text(h("button", { type: "button", class: "compare-close" }), "compare.close");
  /** @type {Record<string, { root: HTMLElement, update: () => void }>} */
  const views = { slate: createSlateTable(context, slate, say), laws: createTournament(context, slate, say) };
  let shown = "slate";
  const tabs = choice("compare-view", Object.keys(views), (value) => {
    shown = value;
    say("");
    update();
  });
  const dialog = h(
    "dialog",
    { id: "compare", "aria-labelledby": heading.id },
    h("div", { class: "compare-head" }, heading, tabs.element, close),
    status,
    ...Object.values(views).map(({ root }) => root),
  );
  document.body.append(dialog);

  close.addEventListener("click", () => dialog.close());
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close();
  });
  slate.watch(update);
  store.subscribe(["report", "language", "perSecond"], (_, changed) => {
    if (changed.has("language")) texts.refresh();
    update();
  });

  function update() {
    if (!dialog.open) return;
    tabs.word(t("compare.views"), (value) => t(`compare.view.${value}`), (value) => t(`compare.view.${value}.hint`), shown);
    for (const [name, { root }] of Object.entries(views)) root.hidden = name !== shown;
    views[shown]?.update();
  }

  /** @param {string} sentence */
  function say(sentence) {
    status.textContent = sentence;
  }

  return {
    open() {
      say("");
      dialog.showModal();
      update();
    },
  };
}
