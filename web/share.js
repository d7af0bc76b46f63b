/**
 * The button that copies the link.
 *
 * @import { ShellContext } from "./types.d.ts"
 * @import { Texts } from "./texts.js"
 */
import { copy } from "./clipboard.js";
import { h } from "./dom.js";
import { address } from "./link.js";
import { sayWhatLeaves } from "./unfinished.js";

/** Milliseconds that the confirmation stays. */
const CONFIRMED = 2200;

/**
 * @param {ShellContext} context
 * @param {Texts} texts
 */
export function createShare(context, texts) {
  const { store, t, announce } = context;
  const button = texts.text(h("button", { type: "button", class: "share" }), "header.share");
  const field = h("input", { type: "text", readonly: true, class: "link-text", hidden: true });
  texts.attribute(field, "aria-label", "header.share.manual");
  let timer = 0;

  /** @param {string} sentence */
  function confirm(sentence) {
    button.textContent = sentence;
    button.classList.add("done");
    announce(sentence);
    clearTimeout(timer);
    timer = window.setTimeout(() => {
      button.textContent = t("header.share");
      button.classList.remove("done");
    }, CONFIRMED);
  }

  button.addEventListener("click", async () => {
    sayWhatLeaves(context);
    const link = address(store.state.report.link);
    if (await copy(link)) return confirm(t("header.share.done"));
    field.hidden = false;
    field.value = link;
    field.focus();
    field.select();
    announce(t("header.share.manual"));
  });
  field.addEventListener("blur", () => (field.hidden = true));

  return {
    root: h("span", { class: "sharing" }, button, field),

    update() {
      const long = store.state.report.link === "";
      if (long === button.disabled) return;
      button.disabled = long;
      button.title = long ? t("header.share.long") : "";
    },
  };
}
