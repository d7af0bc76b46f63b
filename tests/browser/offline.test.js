// The page without the network: a second visit works, and a new release never mixes with an old one.
import assert from "node:assert/strict";
import { cp, mkdtemp, readFile, readdir, rename, rm, writeFile } from "node:fs/promises";
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
  for (const file of ["index.html", "worker.js"]) {
    const text = await readFile(path.join(folder, file), "utf8");
    const release2 = text.replaceAll(release, fresh).replace(/"release":"\w+"/, '"release":"second"');
    await writeFile(path.join(folder, file), release2);
  }
  return { folder, fresh };
}

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
  const names = await page.evaluate(async () => {
    const [name] = await caches.keys();
    return (await (await caches.open(name)).keys()).map((request) => request.url);
  });
  const files = (await readdir(dist, { recursive: true, withFileTypes: true })).filter((entry) => entry.isFile());
  const addresses = files.map((entry) => path.relative(dist, path.join(entry.parentPath, entry.name)).split(path.sep).join("/"));
  const expected = addresses.filter((file) => !["worker.js", "levalab.html"].includes(file)).map((file) => url + (file === "index.html" ? "" : file));
  assert.deepEqual(names.sort(), expected.sort());
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
  const { mounts, context, page, url } = await visit(t);
  const { folder, fresh } = await nextRelease(t);
  // The new worker is there already, the page is still the old one.
  await cp(path.join(dist, "index.html"), path.join(folder, "index.html"));
  await cp(path.join(dist, release), path.join(folder, release), { recursive: true });
  mounts[PREFIX] = folder;
  await page.goto(url);
  await drawn(page);
  await page.waitForFunction(async () => {
    const registration = await navigator.serviceWorker.getRegistration();
    return registration === undefined || !(registration.installing || registration.waiting || registration.active);
  });
  assert.deepEqual(await page.evaluate(() => caches.keys()), []);
  const next = await nextRelease(t);
  mounts[PREFIX] = next.folder;
  const again = await context.newPage();
  await again.goto(url);
  await kept(again);
  assert.deepEqual(await folders(again), [fresh]);
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
