/**
 * What can wait until the first picture is there: the whole calculation, the other language, recent designs, dropped files, the
 * worker for use without the network, the offer of a guided minute at the first visit.
 *
 * @import { ShellContext } from "./types.d.ts"
 * @import { Engine } from "./engine.js"
 */
import { acceptDrops } from "./drop.js";
import { opener } from "./files.js";
import { recall } from "./memory.js";
import { keepOffline } from "./offline.js";
import { hasWorker } from "./packed.js";
import { keepRecent } from "./recent.js";
import "./strings/files.js";
import { learn } from "./strings/index.js";

/** Milliseconds after which whatever the visit begins with is done. */
const SETTLED = 4000;

/**
 * @param {ShellContext} context
 * @param {Engine} engine
 */
export async function begin(context, engine) {
  // Without the whole, should the network fail just now, the others still work.
  await Promise.allSettled([context.whole(), learn("en"), learn("es")]);
  keepRecent(context, (design) => engine.check(design));
  acceptDrops(context, opener(context, engine));
  if (recall("tour") === null) void import("./help/offer.js").then(({ offerTour }) => offerTour(context));
  if (hasWorker()) void keepOffline(context);
  // For a print that the browser's own menu asks for: it gives no time to load anything.
  setTimeout(() => void import("./exports/report.js").then(({ reportOnPaper }) => reportOnPaper(context)), SETTLED);
}
