// Keeps the page for use without the network. xtask writes `packed` before it; "" among its files is the page itself.
//
// A release is kept whole or not at all, and answers for the page until the next one is whole and every tab has let go of this
// one, or somebody asks for it. So the files of two releases are never mixed.
const worker = /** @type {any} */ (globalThis);
/** @type {{ release: string, folder: string, files: string[] }} */
const packed = worker.packed;
/** @type {string} */
const scope = worker.registration.scope;
const cachePrefix = `levalab ${scope} `;
const cacheName = cachePrefix + packed.release;

worker.addEventListener("install", (/** @type {any} */ event) => event.waitUntil(keep()));
worker.addEventListener("activate", (/** @type {any} */ event) => event.waitUntil(takeOver()));
worker.addEventListener("message", (/** @type {any} */ event) => {
  if (event.data === "take-over") event.waitUntil(worker.skipWaiting());
});
worker.addEventListener("fetch", (/** @type {any} */ event) => {
  const { method, url } = event.request;
  if (method !== "GET" || !url.startsWith(scope)) return;
  const inside = url.slice(scope.length).replace(/[?#].*$/, "");
  const file = inside === "index.html" ? "" : inside;
  if (packed.files.includes(file) || file.includes("/")) event.respondWith(answer(file, event.request));
});

/** Fetches the release. A page that belongs to another one, since the server is changing just now, is not kept: next time. */
async function keep() {
  const page = await fetched("");
  if (!(await page.clone().text()).includes(packed.folder)) throw new Error("the server has another release");
  const cache = await worker.caches.open(cacheName);
  try {
    await cache.put(scope, page);
    await Promise.all(packed.files.filter(Boolean).map(async (file) => cache.put(scope + file, await fetched(file))));
  } catch (error) {
    await worker.caches.delete(cacheName);
    throw error;
  }
}

/** @param {string} file */
async function fetched(file) {
  // Past the browser's own cache, except for files whose folder is named by what is in them.
  const response = await fetch(scope + file, { cache: file.startsWith(packed.folder) ? "default" : "reload" });
  if (!response.ok) throw new Error(`${file}: ${response.status}`);
  return response;
}

/**
 * Answers for the pages that are open too: for what they load late. The release before stays until the next change, since pages of
 * it may be among them.
 */
async function takeOver() {
  const others = (await worker.caches.keys()).filter((/** @type {string} */ other) => other.startsWith(cachePrefix) && other !== cacheName);
  await Promise.all(others.slice(0, -1).map((/** @type {string} */ other) => worker.caches.delete(other)));
  await worker.clients.claim();
}

/**
 * @param {string} file
 * @param {any} request
 */
async function answer(file, request) {
  const cache = await worker.caches.open(cacheName);
  return (await cache.match(scope + file)) ?? (await worker.caches.match(scope + file)) ?? fetch(request);
}
