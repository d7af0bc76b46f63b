/** The picture of the first design that the packed page shows until it lives. */

/** Takes it away, in the same frame in which the living page is drawn in its place. */
export function yieldPoster() {
  for (const part of document.querySelectorAll("[data-poster]")) part.remove();
  delete document.documentElement.dataset["other"];
  delete document.getElementById("verdict")?.dataset["level"];
}
