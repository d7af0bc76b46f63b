// Keeps the page for use without the network. xtask writes `packed` before it: each file with the digest of its content. "" among
// the files is the page itself.
//
// A release is kept whole or not at all, and answers for the page until the next one is whole and every tab has let go of this
// one, or somebody asks for it. So the files of two releases are never mixed, and what a captive portal or a broken proxy sends in
// the place of a file never becomes part of one.
const worker = /** @type {any} */ (globalThis);
/** @type {{ release: string, folder: string, files: Record<string, string> }} */
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
  if (Object.hasOwn(packed.files, file) || file.includes("/")) event.respondWith(answer(file, event.request));
});

/** Fetches the release. When one file is not what was packed, nothing is kept: the next visit tries again. */
async function keep() {
  // The page first: while the server is changing to another release, that one file says so.
  const page = await fetched("");
  const cache = await worker.caches.open(cacheName);
  try {
    await cache.put(scope, page);
    const others = Object.keys(packed.files).filter(Boolean);
    await Promise.all(others.map(async (file) => cache.put(scope + file, await fetched(file))));
  } catch (error) {
    await worker.caches.delete(cacheName);
    throw error;
  }
}

/**
 * A file just as it was packed; the browser itself compares the digest, after undoing any compression.
 * @param {string} file
 */
async function fetched(file) {
  const ask = (/** @type {RequestCache} */ cache) => fetch(scope + file, { cache, integrity: packed.files[file] });
  // What the page has just loaded is in the browser's own cache, but so is a wrong answer that somebody let it store.
  const response = await (file.startsWith(packed.folder) ? ask("default").catch(() => ask("reload")) : ask("reload"));
  // A browser refuses an answer that came by way of another address when it asks for a page.
  return response.redirected ? new Response(response.body, { headers: response.headers }) : response;
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
