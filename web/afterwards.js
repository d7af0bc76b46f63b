/**
 * What can wait until the first picture is there: the rest of the calculation, the other language, recent designs, dropped files, the
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

/**
 * @param {ShellContext} context
 * @param {Engine} engine
 */
export async function begin(context, engine) {
  await Promise.all([context.whole(), learn("en"), learn("es")]);
  keepRecent(context, (design) => engine.check(design));
  acceptDrops(context, opener(context, engine));
  if (recall("tour") === null) void import("./help/offer.js").then(({ offerTour }) => offerTour(context));
  if (hasWorker()) void keepOffline(context);
}
