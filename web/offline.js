/**
 * The page without the network: a worker keeps the release that was loaded, and says when a newer one is ready.
 *
 * @import { ShellContext } from "./types.d.ts"
 */
import { showNotice } from "./notice.js";
import { isSingleFile } from "./packed.js";

/** Milliseconds after which a page that comes back into sight asks for a newer release. */
const STALE = 3_600_000;

/** The worker of this page: of the one with many files, or of the single file. */
const ADDRESS = new URL(isSingleFile() ? "levalab-worker.js" : "worker.js", document.baseURI).href;

/** @param {ShellContext} context */
export async function keepOffline(context) {
  const registration = await register();
  if (!registration) return;
  // Only now: in a frame without an origin it throws.
  const { serviceWorker } = navigator;
  let asked = false;
  // Without a worker of its own in control it is the first visit of all, and nothing is old.
  let first = serviceWorker.controller?.scriptURL !== ADDRESS;
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

/**
 * None in private windows, or where the server is not secure. The page's worker answers for the folder of the page, the single file's
 * for that file alone, whatever it is called there.
 * @returns {Promise<ServiceWorkerRegistration | undefined>}
 */
async function register() {
  try {
    return await navigator.serviceWorker.register(trusted(), isSingleFile() ? { scope: location.pathname } : undefined);
  } catch {
    return undefined;
  }
}

/** @type {{ createScriptURL(address: string): string } | undefined} */
let policy;

/** The worker's address, said to be a script of ours by the name that the page's policy has for this one purpose. */
function trusted() {
  /** @type {{ createPolicy(name: string, rules: { createScriptURL(address: string): string }): { createScriptURL(address: string): string } } | undefined} */
  const factory = Reflect.get(globalThis, "trustedTypes");
  policy ??= factory?.createPolicy("levalab-worker", { createScriptURL: (address) => (address === ADDRESS ? address : "about:blank") });
  return policy?.createScriptURL(ADDRESS) ?? ADDRESS;
}
