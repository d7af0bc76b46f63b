/** The words of recent designs, dropped files and the page without the network, which are loaded after the first picture. */
import { filesEn } from "./files.en.js";
import { filesEs } from "./files.es.js";
import { addStrings } from "./index.js";

addStrings({ en: filesEn, es: filesEs });
