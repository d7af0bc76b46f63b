// Keeps the page for use without the network. xtask writes RELEASE and FILES before it; "" among FILES is the page itself.
//
// A release is kept whole or not at all, and answers for the page until the next one is whole and every tab has let go of this
// one, or somebody asks for it. So the files of two releases are never mixed.
const worker = /** @type {any} */ (globalThis);
/** @type {string} */
const scope = worker.registration.scope;
const prefix = `levalab ${scope} `;
const name = prefix + RELEASE;

worker.addEventListener("install", (/** @type {any} */ event) => event.waitUntil(keep()));
worker.addEventListener("activate", (/** @type {any} */ event) => event.waitUntil(forget()));
worker.addEventListener("message", (/** @type {any} */ { data }) => {
  if (data === "take-over") worker.skipWaiting();
});
worker.addEventListener("fetch", (/** @type {any} */ event) => {
  const { method, url } = event.request;
  if (method !== "GET" || !url.startsWith(scope)) return;
  const inside = url.slice(scope.length).replace(/[?#].*$/, "");
  const file = inside === "index.html" ? "" : inside;
  if (FILES.includes(file) || file.includes("/")) event.respondWith(answer(file, event.request));
});

/** Fetches the release. A page that belongs to another one, since the server is changing just now, is not kept: next time. */
async function keep() {
  const page = await fetched("");
  if (!(await page.clone().text()).includes(FOLDER)) throw new Error("the server has another release");
  const cache = await caches.open(name);
  try {
    await cache.put(scope, page);
    await Promise.all(FILES.filter(Boolean).map(async (file) => cache.put(scope + file, await fetched(file))));
  } catch (error) {
    await caches.delete(name);
    throw error;
  }
}

/** @param {string} file */
async function fetched(file) {
  // Past the browser's own cache, except for files whose folder is named by what is in them.
  const response = await fetch(scope + file, { cache: file.startsWith(FOLDER) ? "default" : "reload" });
  if (!response.ok) throw new Error(`${file}: ${response.status}`);
  return response;
}

/** The release before stays until the next change: pages of it may still be open and ask for what they load late. */
async function forget() {
  const kept = (await caches.keys()).filter((other) => other.startsWith(prefix) && other !== name);
  await Promise.all(kept.slice(0, -1).map((other) => caches.delete(other)));
}

/**
 * @param {string} file
 * @param {any} request
 */
async function answer(file, request) {
  const cache = await caches.open(name);
  return (await cache.match(scope + file)) ?? (await caches.match(scope + file)) ?? fetch(request);
}
