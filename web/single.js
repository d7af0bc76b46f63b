/**
 * Where the single file begins: with the cam, or with a page of theory, terms or manual when its address asks for one. Such a page
 * takes the whole window, as it does from a server; its places and those of its sisters are addresses within the file.
 */
import { asked, pageOf, placeOf } from "./help/pages-inline.js";

/** True in a window that reads. */
const reads = asked() !== undefined;

addEventListener("hashchange", () => {
  if (reads !== (asked() !== undefined)) location.reload();
  else if (reads) void show();
});
await (reads ? show() : import("./main.js"));

/** The page that the address asks for; the theory when there is none of that name. */
async function show() {
  const name = asked() ?? "";
  if (document.body.dataset["page"] === name) return;
  put(name, await pageOf(name).catch(() => pageOf(document.documentElement.lang)));
  // Going there once more scrolls to the place and marks it, now that it is there.
  location.replace(location.hash);
}

/**
 * @param {string} name
 * @param {Document} page
 */
function put(name, page) {
  const { body } = page;
  for (const marked of body.querySelectorAll("[id]")) marked.id = placeOf(`${name}#${marked.id}`).slice(1);
  for (const link of body.querySelectorAll("a")) {
    const target = link.getAttribute("href") ?? "";
    link.setAttribute("href", target.startsWith("#") ? placeOf(name + target) : target.endsWith("index.html") ? "#" : placeOf(target));
  }
  document.title = page.title;
  document.documentElement.lang = page.documentElement.lang;
  for (const style of document.querySelectorAll("style")) style.media = style.id === "pages-style" ? "all" : "not all";
  // What is packed stays: it lies in scripts that do not run.
  for (const node of [...document.body.children]) if (node.localName !== "script") node.remove();
  document.body.append(...[...body.children].map((node) => document.importNode(node, true)));
  document.body.dataset["page"] = name;
  scrollTo(0, 0);
}
