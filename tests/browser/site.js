// A small web server like those the page is put on: static files below some path, compressed.
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { gzipSync } from "node:zlib";

/** @type {Record<string, string>} */
const MEDIA = {
  ".css": "text/css; charset=utf-8",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".json": "application/json",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
  ".webmanifest": "application/manifest+json",
};

/**
 * Serves folders on a free port of this machine.
 * @param {Record<string, string>} mounts path with slashes around it → folder
 * @returns {Promise<{ origin: string, close: () => void }>}
 */
export async function startSite(mounts) {
  /** @type {Map<string, Promise<Buffer>>} */
  const packed = new Map();
  const server = createServer(async (request, response) => {
    const file = fileOf(mounts, request.url ?? "/");
    try {
      if (!file) throw new Error("outside");
      const body = packed.get(file) ?? readFile(file).then((bytes) => gzipSync(bytes, { level: 9 }));
      packed.set(file, body);
      const type = MEDIA[path.extname(file)] ?? "application/octet-stream";
      response.writeHead(200, { "content-type": type, "content-encoding": "gzip", "content-length": (await body).length });
      response.end(await body);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((listening) => server.listen(0, "127.0.0.1", () => listening(undefined)));
  const address = server.address();
  if (!address || typeof address === "string") throw new Error("no port");
  return {
    origin: `http://127.0.0.1:${address.port}`,
    close() {
      server.close();
      server.closeAllConnections();
    },
  };
}

/**
 * @param {Record<string, string>} mounts
 * @param {string} url
 */
function fileOf(mounts, url) {
  const asked = decodeURIComponent(new URL(url, "http://site").pathname);
  const mount = Object.keys(mounts).find((prefix) => asked.startsWith(prefix));
  if (!mount) return undefined;
  const inside = asked.slice(mount.length) || "index.html";
  const file = path.resolve(mounts[mount], inside);
  return file.startsWith(path.resolve(mounts[mount]) + path.sep) ? file : undefined;
}
