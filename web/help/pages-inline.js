/** The pages of theory, terms and manual in the single file: packed text, and addresses within the file itself. */
import { inlined } from "../inlined.js";
import { parseOwn } from "../own-markup.js";

/** What an address of such a page begins with; no link to a design does. */
const BEGINNING = "#help/";

/** @param {string} file  as `terms-es.html#rho` */
export const addressOf = (file) => location.href.split("#")[0] + placeOf(file);

/** As `#help/terms-es/rho`. @param {string} file  as `terms-es.html#rho` */
export function placeOf(file) {
  const [page = "", place = ""] = file.split("#");
  return `${BEGINNING}${page.replace(/\.html$/, "")}/${place}`;
}

/** The page that the address asks for, if it asks for one. */
export const asked = () => (location.hash.startsWith(BEGINNING) ? (location.hash.slice(BEGINNING.length).split("/")[0] ?? "") : undefined);

/** @param {string} name  as `terms-es` @returns {Promise<Document>} */
export async function pageOf(name) {
  const unpacked = new Blob([inlined(`page-${name}`)]).stream().pipeThrough(new DecompressionStream("gzip"));
  return parseOwn(await new Response(unpacked).text(), "text/html");
}
