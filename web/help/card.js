/**
 * The card of a magnitude: its entry in the page of terms, beside the question mark that asked for it.
 *
 * @import { Language, ShellContext } from "../types.d.ts"
 */
import { h } from "../dom.js";
import { followerEntry } from "../follower-choice.js";
import { createHelpDrawing } from "../help-drawings.js";
import { isSingleFile } from "../packed.js";
import { beside } from "./place.js";
import { dressed, pageAddress } from "./words.js";

/** Pages of terms by language, read once. @type {Map<Language, Promise<Document>>} */
const pages = new Map();

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
  const within = document.getElementById(`terms-${language}`);
  if (within instanceof HTMLTemplateElement) return /** @type {HTMLElement | null} */ (within.content.getElementById(term));
  try {
    let page = pages.get(language);
    if (!page) pages.set(language, (page = read(pageAddress("terms-", language))));
    return (await page).getElementById(term);
  } catch {
    pages.delete(language);
    return null;
  }
}

/** A page of our own as a document, in which nothing runs. @param {string} address @returns {Promise<Document>} */
function read(address) {
  return new Promise((resolve, reject) => {
    const request = new XMLHttpRequest();
    request.responseType = "document";
    request.addEventListener("load", () => (request.response instanceof Document && request.status < 400 ? resolve(request.response) : reject(new Error(address))));
    request.addEventListener("error", () => reject(new Error(address)));
    request.open("GET", address);
    request.send();
  });
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
  if (isSingleFile()) article.querySelector(".more")?.remove();
  for (const link of article.querySelectorAll("a")) {
    link.href = new URL(link.getAttribute("href") ?? "", pageAddress("", store.state.language)).href;
    link.target = "_blank";
    link.rel = "noopener";
  }
  const follower = followerEntry(catalogue.followers, store.state.design.follower);
  const own = follower && (["base_radius", "breadth", "length"].includes(term) || follower.parameters.some(({ key }) => key === term));
  if (follower && own) {
    const drawing = createHelpDrawing({ pick() {}, point() {} });
    void drawing.show(follower, t(`follower.${follower.id}`), store.state.design.cam.kind).then(() => drawing.light(term));
    article.querySelector(".drawing")?.replaceChildren(drawing.root);
  }
  return article;
}
