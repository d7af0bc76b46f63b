/** Giving a file to the browser to keep. */
import { h } from "../dom.js";

/** How long the browser may take to fetch what it keeps, ms. */
const PATIENCE = 10_000;

/**
 * @param {Blob} blob
 * @param {string} title   of the design
 * @param {string} ending  with its points
 * @returns {string} the name of the file
 */
export function saveBlob(blob, title, ending) {
  const name = `${title.replaceAll(/[\\/:*?"<>|.]+/g, " ").trim().replaceAll(/\s+/g, "-") || "levalab"}${ending}`;
  const url = URL.createObjectURL(blob);
  h("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), PATIENCE);
  return name;
}

/**
 * A drawing as pixels, on white.
 * @param {string} svg
 * @param {number} width
 * @returns {Promise<Blob>}
 */
export async function picture(svg, width) {
  const url = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  try {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = document.createElement("canvas");
    canvas.width = width;
    canvas.height = Math.round((width * image.naturalHeight) / image.naturalWidth);
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
    context.fillStyle = "#ffffff";
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.drawImage(image, 0, 0, canvas.width, canvas.height);
    const blob = await new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
    if (!(blob instanceof Blob)) throw new Error("no picture");
    return blob;
  } finally {
    URL.revokeObjectURL(url);
  }
}
