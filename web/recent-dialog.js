/**
 * The window with the recent designs: open one, or take it from the list.
 *
 * @import { ShellContext } from "./types.d.ts"
 * @import { Check } from "./recent.js"
 */
import { h } from "./dom.js";
import { forget } from "./memory.js";
import { inOtherTabs, recentDesigns } from "./recent.js";
import { createTexts } from "./texts.js";

/**
 * @param {ShellContext} context
 * @param {Check} check
 */
export function createRecentDialog({ store, t, banner, announce }, check) {
  const texts = createTexts(t);
  const list = h("ul", { class: "recent" });
  const none = texts.text(h("p"), "recent.none");
  const heading = texts.text(h("h2", { id: "recent-heading" }), "recent.title");
  const clear = texts.text(h("button", { type: "button", class: "quiet" }), "recent.clear");
  const close = texts.text(h("button", { type: "button" }), "recent.close");
  const dialog = h("dialog", { class: "recent-dialog", "aria-labelledby": heading.id }, heading, texts.text(h("p"), "recent.about"), list, none, h("div", { class: "row" }, clear, close));
  /** Stays true until the list has been drawn for the last change. */
  let again = false;

  async function draw() {
    again = true;
    const busy = await inOtherTabs();
    if (!again) return;
    again = false;
    const dates = new Intl.DateTimeFormat(store.state.language, { dateStyle: "medium", timeStyle: "short" });
    const entries = recentDesigns(check);
    list.replaceChildren(
      ...entries.map(({ name, saved, design }) => {
        const title = design.title || t("app.untitled");
        const open = h(
          "button",
          { type: "button", class: "open" },
          h("strong", {}, title),
          h("small", {}, `${t(`follower.${design.follower.motion}-${design.follower.contact}`)} · ${dates.format(saved)}${busy.has(name) ? ` · ${t("recent.elsewhere")}` : ""}`),
        );
        const remove = h("button", { type: "button", class: "quiet", title: t("recent.remove") }, "×");
        remove.setAttribute("aria-label", t("recent.remove.of", { title }));
        open.addEventListener("click", () => {
          dialog.close();
          banner.hide();
          store.replace(design, t("edit.recent"));
        });
        remove.addEventListener("click", async () => {
          const at = entries.findIndex((entry) => entry.name === name);
          forget(name);
          announce(t("recent.removed", { title }));
          await draw();
          (list.children[Math.min(at, list.children.length - 1)]?.querySelector("button") ?? close).focus();
        });
        return h("li", {}, open, remove);
      }),
    );
    none.hidden = entries.length > 0;
    clear.hidden = entries.length === 0;
  }

  clear.addEventListener("click", async () => {
    for (const { name } of recentDesigns(check)) forget(name);
    await draw();
    close.focus();
  });
  close.addEventListener("click", () => dialog.close());
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close();
  });
  // Another tab has written.
  addEventListener("storage", () => {
    if (dialog.open) void draw();
  });
  store.subscribe(["language"], () => {
    texts.refresh();
    if (dialog.open) void draw();
  });
  document.body.append(dialog);

  return async function show() {
    await draw();
    dialog.showModal();
    (list.querySelector("button") ?? close).focus();
  };
}
