// The page without the network: a second visit works, and a new release never mixes with an old one.
import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { copyFile, cp, mkdir, mkdtemp, readFile, readdir, rename, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, test } from "node:test";
import { drawn, launchBrowser, root } from "./browser.js";
import { startSite } from "./site.js";
import { LINKS, becomes, en, es, eventually, field, fragment, level } from "./user.js";

/** @typedef {import("playwright-core").Page} Page */

const PREFIX = "/course/levalab/";
const dist = path.join(root, "dist");
const release = await folderOf(dist);

/** @type {ReturnType<typeof launchBrowser> | undefined} */
let browser;
after(async () => (await browser)?.close());

/** The folder that the page's files lie in, named by their content. @param {string} packed */
async function folderOf(packed) {
  const [, folder] = /src="(\w+)\/main\.js"/.exec(await readFile(path.join(packed, "index.html"), "utf8")) ?? [];
  assert(folder, "index.html names no main.js");
  return folder;
}

/** The packed page served from a path that can be changed, and a profile of its own. @param {import("node:test").TestContext} t */
async function visit(t) {
  const mounts = { [PREFIX]: dist };
  const site = await startSite(mounts);
  browser ??= launchBrowser();
  const context = await (await browser).newContext({ locale: "en-GB", reducedMotion: "reduce" });
  t.after(async () => {
    await context.close();
    site.close();
  });
  return { mounts, site, context, page: await context.newPage(), url: site.origin + PREFIX };
}

/** Waits until the worker has the whole release and would answer the next visit. @param {Page} page */
const kept = (page) => page.evaluate(async () => void (await navigator.serviceWorker.ready));

/** What the page was made of: the folders of all that it loaded. @param {Page} page */
const folders = (page) =>
  page.evaluate((prefix) => {
    const files = performance.getEntriesByType("resource").map(({ name }) => new URL(name).pathname.slice(prefix.length));
    return [...new Set(files.filter((file) => file.includes("/")).map((file) => file.split("/")[0]))];
  }, PREFIX);

/** Another release: the same page under another name, as if something in it had changed. @param {import("node:test").TestContext} t */
async function nextRelease(t) {
  const folder = await mkdtemp(path.join(tmpdir(), "levalab-"));
  t.after(() => rm(folder, { recursive: true }));
  await cp(dist, folder, { recursive: true });
  const fresh = release.split("").reverse().join("x").slice(0, 8);
  await rename(path.join(folder, release), path.join(folder, fresh));
  for (const file of ["index.html", "worker.js", "levalab.html"]) {
    const text = await readFile(path.join(folder, file), "utf8");
    const next = text.replaceAll(release, fresh).replace("</body>", "<!-- second --></body>");
    await writeFile(path.join(folder, file), next);
  }
  await repack(folder, "worker.js", "index.html");
  await repack(folder, "levalab-worker.js", "levalab.html");
  return { folder, fresh };
}

/** Brings the digests of a worker's list up to date, as packing does. @param {string} folder @param {string} worker @param {string} page */
async function repack(folder, worker, page) {
  const [list, ...rest] = (await readFile(path.join(folder, worker), "utf8")).split("\n");
  const packed = JSON.parse(list.slice("globalThis.packed = ".length, -1));
  for (const file of Object.keys(packed.files)) {
    const bytes = await readFile(path.join(folder, file || page));
    packed.files[file] = `sha256-${createHash("sha256").update(bytes).digest("base64")}`;
  }
  packed.release = "second";
  await writeFile(path.join(folder, worker), [`globalThis.packed = ${JSON.stringify(packed)};`, ...rest].join("\n"));
}

/**
 * Waits until the browser has given up installing the worker that it was asked to: nothing of the release is left, and none is at work.
 * @param {Page} page
 * @param {string[]} [left]  addresses that were kept before
 */
async function refused(page, left = []) {
  await becomes(() => keptAddresses(page), left);
  await page.waitForFunction(async () => {
    const registration = await navigator.serviceWorker.getRegistration();
    return !(registration?.installing || registration?.waiting);
  });
  assert.deepEqual(await keptAddresses(page), left);
}

/** Waits until somebody on the way has answered wrongly. @param {Awaited<ReturnType<typeof startSite>>} site */
const answeredWrongly = (site) => eventually(async () => site.wrongAnswers(), (count) => assert(count > 0, "the file was not asked for"));

/** Addresses that are kept, in all caches. @param {Page} page */
const keptAddresses = (page) =>
  page.evaluate(async () => {
    const names = await caches.keys();
    const requests = await Promise.all(names.map(async (name) => (await caches.open(name)).keys()));
    return requests.flat().map(({ url }) => url).sort();
  });

test("the second visit works with the network off, link and all", async (t) => {
  const { site, context, page, url } = await visit(t);
  await page.goto(url);
  await drawn(page);
  await kept(page);
  site.close();
  await context.setOffline(true);
  const again = await context.newPage();
  await again.goto(`${url}#${LINKS["2RO"]}`);
  await drawn(again);
  assert.equal(await level(again), "acceptable");
  await again.getByRole("button", { name: "ES", exact: true }).click();
  await becomes(() => again.getByRole("button", { name: es("header.files"), exact: true }).count(), 1);
  // What is loaded when it is first asked for is there as well.
  await again.getByRole("button", { name: es("header.files"), exact: true }).click();
  await again.getByRole("menuitem", { name: es("header.recent"), exact: true }).click();
  await again.getByRole("dialog", { name: es("recent.title") }).waitFor();
});

test("everything that was packed is kept", async (t) => {
  const { page, url } = await visit(t);
  await page.goto(url);
  await kept(page);
  const names = await keptAddresses(page);
  const files = (await readdir(dist, { recursive: true, withFileTypes: true })).filter((entry) => entry.isFile());
  const addresses = files.map((entry) => path.relative(dist, path.join(entry.parentPath, entry.name)).split(path.sep).join("/"));
  const others = ["worker.js", "levalab.html", "levalab-worker.js"];
  const expected = addresses.filter((file) => !others.includes(file)).map((file) => url + (file === "index.html" ? "" : file));
  assert.deepEqual(names, expected.sort());
});

test("a new release is said to be ready, and takes over whole when it is asked for", async (t) => {
  const { mounts, site, context, page, url } = await visit(t);
  await page.goto(url);
  await drawn(page);
  await kept(page);
  const { folder, fresh } = await nextRelease(t);
  mounts[PREFIX] = folder;

  const second = await context.newPage();
  await second.goto(`${url}#${LINKS["9RT"]}`);
  await drawn(second);
  assert.deepEqual(await folders(second), [release], "the old page is still the one that opens, whole");
  await field(second, "base_radius").fill("36");
  const note = second.getByRole("status").filter({ hasText: en("offline.ready") });
  await note.waitFor();
  const edited = await eventually(() => fragment(second), (now) => assert.match(now, /\.R36_7/));
  await note.getByRole("button", { name: en("offline.reload") }).click();
  await becomes(() => folders(second).catch(() => []), [fresh]);
  await drawn(second);
  assert.equal(await fragment(second), edited, "the design is still there");
  // The other tab goes on with what it had, and is told.
  assert.deepEqual(await folders(page), [release]);
  await page.getByRole("status").filter({ hasText: en("offline.ready") }).waitFor();

  site.close();
  await context.setOffline(true);
  const third = await context.newPage();
  await third.goto(url);
  await drawn(third);
  assert.deepEqual(await folders(third), [fresh]);
});

test("while the server is changing, a page and files that do not belong together are not kept", async (t) => {
  const { mounts, site, context, page, url } = await visit(t);
  const { folder, fresh } = await nextRelease(t);
  // The new worker is there already, the page is still the old one.
  await cp(path.join(dist, "index.html"), path.join(folder, "index.html"));
  await cp(path.join(dist, release), path.join(folder, release), { recursive: true });
  mounts[PREFIX] = folder;
  await page.goto(url);
  await drawn(page);
  await eventually(async () => site.asked().includes(`${PREFIX}worker.js`), (asked) => assert(asked));
  await refused(page);
  const next = await nextRelease(t);
  mounts[PREFIX] = next.folder;
  const again = await context.newPage();
  await again.goto(url);
  await kept(again);
  assert.deepEqual(await folders(again), [fresh]);
});

/** What a captive portal answers, whatever it is asked for. */
const PORTAL = Buffer.from("<!doctype html><title>Sign in</title><p>Accept the terms to go online.</p>");

/** Files that somebody on the way gets wrong, by what they are: none but the worker asks for them while the page opens. */
const WRONG = {
  "the page itself": "",
  "a page of theory": "theory/es.html",
  "a module of the calculation": `${release}/pkg/levalab_export_wasm_bg.wasm`,
  "an icon": `${release}/icons/icon-512.png`,
};

for (const [name, file] of Object.entries(WRONG)) {
  test(`a release is not kept while one of its files arrives wrong: ${name}`, async (t) => {
    const { site, context, page, url } = await visit(t);
    await page.goto("about:blank");
    site.answerWrongly(PREFIX + file, { body: PORTAL, after: file === "" ? 1 : 0 });
    await page.goto(url);
    await drawn(page);
    await answeredWrongly(site);
    await refused(page);
    assert.equal(await level(page), "low-speed");
    await field(page, "base_radius").fill("36");
    await becomes(() => fragment(page), /\.R36_7/);

    site.answerWrongly(undefined);
    const again = await context.newPage();
    await again.goto(url);
    await drawn(again);
    await kept(again);
    site.close();
    await context.setOffline(true);
    const third = await context.newPage();
    await third.goto(url);
    await drawn(third);
    assert.equal(await level(third), "low-speed");
  });
}

test("a wrong answer that the browser may store for a year does not stand in the way of the right one", async (t) => {
  const { site, context, page, url } = await visit(t);
  const file = `${PREFIX}${release}/icons/icon-512.png`;
  site.answerWrongly(file, { body: PORTAL, headers: { "content-type": "text/html", "cache-control": "max-age=31536000" } });
  await page.goto(url);
  await drawn(page);
  await answeredWrongly(site);
  await refused(page);
  site.answerWrongly(undefined);
  const again = await context.newPage();
  await again.goto(url);
  await drawn(again);
  await kept(again);
  assert((await keptAddresses(again)).includes(site.origin + file));
});

test("with a wrong next release, the one that is kept goes on", async (t) => {
  const { mounts, site, context, page, url } = await visit(t);
  await page.goto(url);
  await drawn(page);
  await kept(page);
  const before = await keptAddresses(page);
  const { folder, fresh } = await nextRelease(t);
  mounts[PREFIX] = folder;
  site.answerWrongly(`${PREFIX}${fresh}/icons/icon-512.png`, { body: PORTAL });
  const second = await context.newPage();
  await second.goto(url);
  await drawn(second);
  await answeredWrongly(site);
  await refused(second, before);
  assert.deepEqual(await folders(second), [release]);
  site.answerWrongly(undefined);
  const third = await context.newPage();
  await third.goto(url);
  await drawn(third);
  const note = third.getByRole("status").filter({ hasText: en("offline.ready") });
  await note.getByRole("button", { name: en("offline.reload") }).click();
  await becomes(() => folders(third).catch(() => []), [fresh]);
});

test("a server that sends the page's address on to another one is kept from, all the same", async (t) => {
  const { site, context, page, url } = await visit(t);
  site.redirect(PREFIX, `${PREFIX}index.html`);
  await page.goto(url);
  await drawn(page);
  await kept(page);
  site.close();
  await context.setOffline(true);
  for (const address of [url, `${url}index.html`, `${url}?from=course#${LINKS["2RO"]}`]) {
    const again = await context.newPage();
    await again.goto(address);
    await drawn(again);
  }
});

/** The single file on the server, and what the server is asked for. @param {import("node:test").TestContext} t */
async function visitSingle(t) {
  const visited = await visit(t);
  return { ...visited, single: `${visited.url}levalab.html` };
}

test("the single file works without the network once it was opened from a server, and nothing else is kept for it", async (t) => {
  const { site, context, page, single } = await visitSingle(t);
  await page.goto(single);
  await drawn(page);
  await kept(page);
  assert.deepEqual(await keptAddresses(page), [single]);
  site.close();
  await context.setOffline(true);
  for (const address of [single, `${single}?lang=es#${LINKS["2RO"]}`]) {
    const again = await context.newPage();
    await again.goto(address);
    await drawn(again);
  }
  for (const [place, seen] of /** @type {const} */ ([["terms-es/rho", "math"], ["licences-es/", ".works li"]])) {
    const reading = await context.newPage();
    await reading.goto(`${single}#help/${place}`);
    await eventually(() => reading.locator(`main ${seen}`).count(), (count) => assert(count > 50, place));
  }
});

test("a visitor of the page loads nothing of the single file, and each is kept by a worker of its own", async (t) => {
  const { site, context, page, url, single } = await visitSingle(t);
  await page.goto(url);
  await drawn(page);
  await kept(page);
  assert.deepEqual(site.asked().filter((address) => address.includes("levalab.html") || address.includes("levalab-worker")), []);
  await page.goto(single);
  await drawn(page);
  await eventually(() => keptAddresses(page), (addresses) => assert(addresses.includes(single)));
  await becomes(() => page.evaluate(() => navigator.serviceWorker.controller?.scriptURL), `${url}levalab-worker.js`);
  assert.equal(await page.getByRole("status").filter({ hasText: en("offline.ready") }).count(), 0, "nothing is old on a first visit");
  site.close();
  await context.setOffline(true);
  for (const address of [single, url]) {
    const again = await context.newPage();
    await again.goto(address);
    await drawn(again);
  }
});

test("a new release of the single file is said to be ready, and a wrong one is not kept", async (t) => {
  const { mounts, site, context, page, single } = await visitSingle(t);
  const isSecond = (/** @type {Page} */ page) => page.content().then((text) => text.includes("<!-- second -->"));
  await page.goto(single);
  await drawn(page);
  await kept(page);
  mounts[PREFIX] = (await nextRelease(t)).folder;
  site.answerWrongly(`${PREFIX}levalab.html`, { body: PORTAL });
  const second = await context.newPage();
  await second.goto(single);
  await drawn(second);
  await answeredWrongly(site);
  await refused(second, [single]);
  site.answerWrongly(undefined);
  const third = await context.newPage();
  await third.goto(single);
  await drawn(third);
  assert.equal(await isSecond(third), false);
  const note = third.getByRole("status").filter({ hasText: en("offline.ready") });
  await note.getByRole("button", { name: en("offline.reload") }).click();
  await eventually(() => isSecond(third).catch(() => false), (now) => assert(now));
  await drawn(third);
});

test("the single file works under another name, and alone on a server", async (t) => {
  const { mounts, site, context, page, url } = await visit(t);
  const folder = await mkdtemp(path.join(tmpdir(), "levalab-"));
  t.after(() => rm(folder, { recursive: true }));
  await mkdir(path.join(folder, "both"));
  await copyFile(path.join(dist, "levalab.html"), path.join(folder, "both/my cams.html"));
  await copyFile(path.join(dist, "levalab-worker.js"), path.join(folder, "both/levalab-worker.js"));
  await copyFile(path.join(dist, "levalab.html"), path.join(folder, "alone.html"));
  mounts[PREFIX] = folder;
  await page.goto(`${url}alone.html`);
  await drawn(page);
  await page.goto(`${url}both/my%20cams.html`);
  await drawn(page);
  await kept(page);
  site.close();
  await context.setOffline(true);
  const again = await context.newPage();
  await again.goto(`${url}both/my%20cams.html`);
  await drawn(again);
});

test("the page can be installed: its manifest and icons are there", async (t) => {
  const { page, url } = await visit(t);
  await page.goto(url);
  const href = await page.locator('link[rel="manifest"]').getAttribute("href");
  const address = new URL(href ?? "", url);
  const manifest = await (await page.request.get(address.href)).json();
  assert.equal(new URL(manifest.start_url, address).href, url);
  assert.equal(new URL(manifest.scope, address).href, url);
  for (const { src, sizes, type } of manifest.icons) {
    const size = await page.evaluate(async (src) => {
      const image = new Image();
      image.src = src;
      await image.decode();
      return `${image.naturalWidth}x${image.naturalHeight}`;
    }, new URL(src, address).href);
    if (type === "image/png") assert.equal(size, sizes, src);
  }
  const session = await page.context().newCDPSession(page);
  const { installabilityErrors } = await session.send("Page.getInstallabilityErrors");
  assert.deepEqual(installabilityErrors.filter(({ errorId }) => errorId !== "in-incognito"), []);
});
