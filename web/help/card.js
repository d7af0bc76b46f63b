/**
 * The card of a magnitude: its entry in the page of terms, beside the question mark that asked for it.
 *
 * @import { Language, ShellContext } from "../types.d.ts"
 */
import { h } from "../dom.js";
import { followerEntry } from "../follower-choice.js";
import { createHelpDrawing } from "../help-drawing.js";
import { addressOf, pageOf } from "./pages.js";
import { beside } from "../floating.js";
import { dressed } from "./words.js";

const close = h("button", { type: "button", class: "quiet close" }, "×");
const content = h("div");
const card = h("div", { popover: "auto", role: "dialog", class: "card", id: "term-card", tabindex: "-1", "aria-labelledby": "term-name" }, content, close);
close.addEventListener("click", () => card.hidePopover());

/**
 * @param {ShellContext} context
 * @param {HTMLElement} asked  the question mark
 */
export async function show(context, asked) {
  const { store, t } = context;
  const term = asked.dataset["term"] ?? "";
  const { language } = store.state;
  const [entry] = await Promise.all([find(language, term), dressed]);
  close.setAttribute("aria-label", t("help.close"));
  content.replaceChildren(entry ? dress(context, entry, term) : h("p", { id: "term-name" }, t("help.missing")));
  if (!card.isConnected) document.body.append(card);
  asked.focus();
  card.showPopover();
  beside(card, asked.getBoundingClientRect());
  card.focus();
}

/**
 * @param {Language} language
 * @param {string} term
 */
async function find(language, term) {
  try {
    return (await pageOf(`terms-${language}`)).getElementById(term);
  } catch {
    return null;
  }
}

/**
 * The entry as it fits this page: the drawing is that of the follower at hand, and links open beside the cam.
 * @param {ShellContext} context
 * @param {HTMLElement} entry
 * @param {string} term
 */
function dress({ store, catalogue, t }, entry, term) {
  const article = document.importNode(entry, true);
  article.removeAttribute("id");
  const name = article.querySelector("h3");
  const title = h("h2", { id: "term-name" }, ...(name?.querySelector("a")?.childNodes ?? []));
  name?.replaceWith(title);
  for (const link of article.querySelectorAll("a")) {
    link.href = addressOf(link.getAttribute("href") ?? "");
    link.target = "_blank";
    link.rel = "noopener";
  }
  const follower = followerEntry(catalogue.followers, store.state.design.follower);
  const own = follower && (["base_radius", "breadth", "length"].includes(term) || follower.parameters.some(({ key }) => key === term));
  if (follower && own) {
    const drawing = createHelpDrawing({ pick() {}, point() {} });
    drawing.show(follower, t(`follower.${follower.id}`), store.state.design.cam.kind);
    drawing.light(term);
    article.querySelector(".drawing")?.replaceChildren(drawing.root);
  }
  return article;
}
