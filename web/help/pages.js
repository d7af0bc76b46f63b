/** The pages of theory, terms and manual as files of their own. The single file has `pages-inline.js` in its stead. */

/** Documents by name, read once. @type {Map<string, Promise<Document>>} */
const read = new Map();

/** The address of a page, or of a place in it. @param {string} file  as `terms-es.html#rho` */
export function addressOf(file) {
  const help = document.querySelector('link[rel="help"]');
  return new URL(file, help instanceof HTMLLinkElement ? help.href : document.baseURI).href;
}

/** A page as a document, in which nothing runs. @param {string} name  as `terms-es` @returns {Promise<Document>} */
export async function pageOf(name) {
  let page = read.get(name);
  if (!page) read.set(name, (page = request(addressOf(`${name}.html`))));
  try {
    return await page;
  } catch (error) {
    read.delete(name);
    throw error;
  }
}

/** @param {string} address @returns {Promise<Document>} */
function request(address) {
  return new Promise((resolve, reject) => {
    const request = new XMLHttpRequest();
    request.responseType = "document";
    request.addEventListener("load", () => (request.response instanceof Document && request.status < 400 ? resolve(request.response) : reject(new Error(address))));
    request.addEventListener("error", () => reject(new Error(address)));
    request.open("GET", address);
    request.send();
  });
}
