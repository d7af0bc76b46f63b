/* Before the first paint: theme and language as they were left, so that nothing flashes. A classic script on purpose. */
{
  const view = () => {
    try {
      return JSON.parse(localStorage.getItem("levalab:view") ?? "{}") ?? {};
    } catch {
      return {};
    }
  };
  const { theme, language = navigator.language } = view();
  const dark = theme === "dark" || (theme !== "light" && matchMedia("(prefers-color-scheme: dark)").matches);
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  // Pages of theory have a language of their own.
  if (!("page" in document.documentElement.dataset)) document.documentElement.lang = /^es\b/i.test(String(language)) ? "es" : "en";
}
