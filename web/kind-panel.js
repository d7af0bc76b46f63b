/** What only some cams need in the design panel, with its words: loaded with the first such cam. */
import { addStrings } from "./strings/index.js";
import { kindsEn } from "./strings/kinds.en.js";
import { kindsEs } from "./strings/kinds.es.js";

export { createBreadthPanel } from "./kind-panel/breadth.js";
export { createPairPanel } from "./kind-panel/pair.js";

addStrings({ en: kindsEn, es: kindsEs });
