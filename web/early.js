/* Before the first paint: theme and language as they were left, so that nothing flashes. A classic script on purpose. Where the page is packed it also
   asks for the words of that language, which its module would find out about later. */
{
  const view = () => {
    try {
      return JSON.parse(localStorage.getItem("levalab:view") ?? "{}") ?? {};
    } catch {
      return {};
    }
  };
  const { theme, language = navigator.languages.find((tag) => /^(en|es)\b/i.test(tag)) } = view();
  const dark = theme === "dark" || (theme !== "light" && matchMedia("(prefers-color-scheme: dark)").matches);
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  // Pages of theory have a language of their own.
  const spoken = typeof language === "string" && /^es\b/i.test(language) ? "es" : "en";
  if (!("page" in document.documentElement.dataset)) document.documentElement.lang = spoken;
  const { words } = document.currentScript?.dataset ?? {};
  if (words) document.head.append(Object.assign(document.createElement("link"), { rel: "modulepreload", href: `${words}.${spoken}.js` }));

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
