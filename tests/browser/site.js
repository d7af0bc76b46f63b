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
 * What somebody on the way answers in the server's place.
 * @typedef {object} WrongAnswer
 * @property {Buffer} body
 * @property {number} [after]  right answers before it
 * @property {Record<string, string>} [headers]
 */

/**
 * @typedef {object} Site
 * @property {string} origin
 * @property {() => void} close
 * @property {() => string[]} asked  paths that were asked for
 * @property {(path: string | undefined, answer?: WrongAnswer) => void} answerWrongly  from now on, with status 200; without a path no longer
 * @property {() => number} wrongAnswers
 * @property {(from: string, to: string) => void} redirect
 */

/**
 * Serves folders on a free port of this machine.
 * @param {Record<string, string>} mounts path with slashes around it → folder
 * @returns {Promise<Site>}
 */
export async function startSite(mounts) {
  /** @type {Map<string, Promise<Buffer>>} */
  const packed = new Map();
  /** @type {string[]} */
  const asked = [];
  /** @type {{ path?: string, answer?: WrongAnswer, before: number, given: number }} */
  let wrong = { before: 0, given: 0 };
  /** @type {Map<string, string>} */
  const redirects = new Map();
  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url ?? "/", "http://site");
    asked.push(pathname);
    if (pathname === wrong.path && wrong.answer && wrong.before-- <= 0) {
      wrong.given++;
      response.writeHead(200, { "content-type": "text/html", ...wrong.answer.headers }).end(wrong.answer.body);
      return;
    }
    const target = redirects.get(pathname);
    if (target) return void response.writeHead(302, { location: target }).end();
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
    asked: () => asked,
    answerWrongly: (path, answer) => (wrong = { path, answer, before: answer?.after ?? 0, given: 0 }),
    wrongAnswers: () => wrong.given,
    redirect: (from, to) => void redirects.set(from, to),
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
