/* Before the first paint: theme and language as they were left, so that nothing flashes. A classic script on purpose. Where the page is packed it also
   asks for the words of that language, which its module would find out about later, and finds out whether the design in the page is the one that
   will be shown: of another cam nothing is ever seen. */
{
  /** @param {"localStorage" | "sessionStorage"} keeper @param {string} name */
  const recall = (keeper, name) => {
    try {
      return JSON.parse(window[keeper].getItem(`levalab:${name}`) ?? "null");
    } catch {
      return null;
    }
  };
  const view = recall("localStorage", "view") ?? {};
  const { theme, language = navigator.languages.find((tag) => /^(en|es)\b/i.test(tag)) } = view;
  const dark = theme === "dark" || (theme !== "light" && matchMedia("(prefers-color-scheme: dark)").matches);
  const root = document.documentElement;
  root.dataset.theme = dark ? "dark" : "light";
  // Pages of theory have a language of their own.
  const spoken = typeof language === "string" && /^es\b/i.test(language) ? "es" : "en";
  if (!("page" in root.dataset)) root.lang = spoken;
  const { words, known } = document.currentScript?.dataset ?? {};
  if (words) document.head.append(Object.assign(document.createElement("link"), { rel: "modulepreload", href: `${words}.${spoken}.js` }));

  /**
   * Whether the address, what this tab or any tab kept, or the view as it was left may lead to another picture than the one in the page.
   * @param {string[]} usual  what each of them may hold all the same
   */
  const another = (usual) => {
    const fragment = location.hash.slice(1);
    const differs = (/** @type {unknown} */ kept) => kept !== null && kept !== undefined && !usual.includes(typeof kept === "string" ? kept : JSON.stringify(kept));
    try {
      return (
        (fragment === "" ? differs(recall("localStorage", "design")) : differs(fragment)) ||
        /^\?\d+\./.test(location.search) ||
        differs(recall("sessionStorage", "design")?.design) ||
        differs(view.layers) || (view.tab ?? "svaj") !== "svaj" || view.perSecond === true
      );
    } catch {
      // Nested too deep to be compared.
      return true;
    }
  };
  if (known) root.toggleAttribute("data-other", another(JSON.parse(known)[spoken]));

  /**
   * Shows a sentence of index.html about the page in a single file, which needs nothing but itself; its link opens the same design.
   * @param {string} id
   */
  const nameSingleFile = (id) => {
    const sentence = document.getElementById(id);
    for (const link of sentence?.querySelectorAll("a") ?? []) link.hash = location.hash;
    sentence?.removeAttribute("hidden");
    sentence?.classList.add("now");
  };
  // The module may not arrive, or come as something that is no script. A page without an origin, in a frame with a sandbox or from disk, may
  // load classic scripts such as this one, but no modules. Only the tag of the module learns of it, and its event does not rise: it is
  // caught on the way down.
  addEventListener(
    "error",
    ({ target }) => {
      if (!(target instanceof HTMLScriptElement) || target.type !== "module") return;
      const name = () => nameSingleFile(origin === "null" ? "unstarted" : "late");
      if (document.readyState === "loading") addEventListener("DOMContentLoaded", name);
      else name();
    },
    true,
  );
}
