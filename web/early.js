/* Before the first paint: theme and language as they were left, so that nothing flashes. A classic script on purpose. */
(function () {
  var root = document.documentElement;
  var kept = {};
  try {
    kept = JSON.parse(localStorage.getItem("levalab:view") || "{}") || {};
  } catch (error) {
    kept = {};
  }
  var dark = kept.theme === "dark" || (kept.theme !== "light" && matchMedia("(prefers-color-scheme: dark)").matches);
  root.dataset.theme = dark ? "dark" : "light";
  var spanish = /^es\b/i.test(kept.language || (navigator.languages && navigator.languages[0]) || navigator.language || "");
  root.lang = spanish ? "es" : "en";
})();
