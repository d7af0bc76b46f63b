/**
 * The page without the network: a worker keeps the release that was loaded, and says when a newer one is ready.
 *
 * @import { ShellContext } from "./types.d.ts"
 */
import { showNotice } from "./notice.js";

/** Milliseconds after which a page that comes back into sight asks for a newer release. */
const STALE = 3_600_000;

/** @param {ShellContext} context */
export async function keepOffline(context) {
  const registration = await register();
  if (!registration) return;
  // Only now: in a frame without an origin it throws.
  const { serviceWorker } = navigator;
  let asked = false;
  // Without a controller it is the first visit of all, and nothing is old.
  let first = !serviceWorker.controller;
  let looked = Date.now();

  /** @param {ServiceWorker | null} waiting */
  function ready(waiting) {
    if (!waiting || first) return;
    showNotice(context, "offline.ready", "offline.reload", () => {
      asked = true;
      // Not when it takes control, which is while it is still activating: what loads then may be answered by either.
      waiting.addEventListener("statechange", () => waiting.state === "activated" && location.reload());
      waiting.postMessage("take-over");
    });
  }

  ready(registration.waiting);
  registration.addEventListener("updatefound", () => {
    const fresh = registration.installing;
    fresh?.addEventListener("statechange", () => {
      if (fresh.state === "installed") ready(fresh);
    });
  });
  serviceWorker.addEventListener("controllerchange", () => {
    if (asked) return;
    if (first) return void (first = false);
    // Another tab asked for it. This one goes on as it is: what it still loads is kept as well.
    showNotice(context, "offline.ready", "offline.reload", () => location.reload());
  });
  document.addEventListener("visibilitychange", () => {
    if (document.hidden || Date.now() - looked < STALE) return;
    looked = Date.now();
    registration.update().catch(() => {});
  });
}

/** None in private windows, or where the server is not secure. @returns {Promise<ServiceWorkerRegistration | undefined>} */
async function register() {
  const address = new URL("worker.js", document.baseURI).href;
  const { trustedTypes } = /** @type {{ trustedTypes?: { createPolicy(name: string, rules: object): { createScriptURL(address: string): string } } }} */ (/** @type {unknown} */ (globalThis));
  // The page's policy wants a name for whoever says which script may run: this one says it of one address.
  const policy = trustedTypes?.createPolicy("levalab-worker", { createScriptURL: (/** @type {string} */ asked) => (asked === address ? asked : "about:blank") });
  try {
    return await navigator.serviceWorker.register(policy?.createScriptURL(address) ?? address);
  } catch {
    return undefined;
  }
}
