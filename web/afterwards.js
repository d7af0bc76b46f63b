/**
 * The work that can wait until the first picture is there: recent designs, dropped files, the worker for use without the network, the
 * offer of a guided minute at the first visit, the other language, the report for a print that the browser's own menu asks for.
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
import { learn } from "./strings/index.js";

/** Milliseconds after which whatever the visit begins with is done. */
const SETTLED = 4000;

/**
 * @param {ShellContext} context
 * @param {Engine} engine
 */
export function begin(context, engine) {
  keepRecent(context, (design) => engine.check(design));
  acceptDrops(context, opener(context, engine));
  if (hasWorker()) void keepOffline(context);
  // Each of these is asked for again when it is needed, should it not arrive now.
  const later = [learn("en"), learn("es")];
  if (recall("tour") === null) later.push(import("./help/offer.js").then(({ offerTour }) => offerTour(context)));
  for (const part of later) part.catch(console.warn);
  // A print from the browser's own menu gives no time to load anything.
  setTimeout(() => void import("./exports/report.js").then(({ reportOnPaper }) => reportOnPaper(context)).catch(console.warn), SETTLED);
}
