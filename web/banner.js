/**
 * One sentence across the page when something went wrong, with what came in kept to be copied.
 *
 * @import { Banner, Translate } from "./types.d.ts"
 */
import { copy } from "./clipboard.js";
import { h } from "./dom.js";

/**
 * @param {HTMLElement} root
 * @param {Translate} t
 * @returns {Banner & { refresh(): void }}
 */
export function createBanner(root, t) {
  /** @type {(() => void) | null} */
  let again = null;

  function hide() {
    again = null;
    root.replaceChildren();
  }

  return {
    show(key, values = {}, raw) {
      again = () => {
        const close = h("button", { type: "button", class: "quiet" }, t("banner.close"));
        close.addEventListener("click", hide);
        root.replaceChildren(h("p", {}, t(key, typeof values === "function" ? values() : values)), ...(raw ? [rawText(raw)] : []), close);
      };
      again();
    },
    hide,
    refresh: () => again?.(),
  };

  /** @param {string} raw */
  function rawText(raw) {
    const field = h("input", { type: "text", readonly: true, value: raw, class: "raw", "aria-label": t("banner.copy") });
    const button = h("button", { type: "button" }, t("banner.copy"));
    button.addEventListener("click", async () => {
      if (await copy(raw)) button.textContent = t("header.share.done");
      else field.select();
    });
    return h("span", { class: "raw-text" }, field, button);
  }
}
