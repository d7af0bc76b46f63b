// Joins and minifies the page's modules and styles:
// `node bundle.js '{"out": …, "single": …, "main": …, "named": […], "glues": […], "scripts": […], "styles": […], "sheets": […]}'`.
// Into the folder `single` goes `main.js` whole, for the single-file page.
import { readFile } from "node:fs/promises";
import path from "node:path";
import { build } from "esbuild";
import { gather } from "./gather.js";

/**
 * `named` are modules that keep their names, to be asked for early; `glues` the generated JavaScript of each wasm module, and whether the
 * single-file page carries that module.
 * @type {{ out: string, single: string, main: string, named: string[], glues: { name: string, file: string, inline: boolean }[], scripts: string[], styles: { file: string, media: string }[], sheets: string[] }}
 */
const { out, single, main, named, glues, scripts, styles, sheets } = JSON.parse(process.argv[2]);
const web = path.resolve("web");

/**
 * A joined module answers for files of several folders: each keeps the address it had, relative to `web/`.
 * @type {import("esbuild").Plugin}
 */
const ownAddress = {
  name: "own-address",
  setup(build) {
    build.onLoad({ filter: /\.js$/ }, async ({ path: file }) => {
      const place = path.relative(web, file).split(path.sep).join("/");
      const own = `new URL(${JSON.stringify(place)}, import.meta.url).href`;
      return { contents: (await readFile(file, "utf8")).replaceAll("import.meta.url", own) };
    });
  },
};

/** @satisfies {import("esbuild").BuildOptions} */
const common = {
  outdir: out,
  minify: true,
  charset: "utf8",
  legalComments: "none",
  target: "es2022",
  loader: { ".svg": "dataurl", ".png": "dataurl", ".woff2": "file" },
  logLevel: "warning",
};

const split = await build({
  ...common,
  entryPoints: [main, ...named],
  entryNames: "[name]",
  chunkNames: "part-[hash]",
  bundle: true,
  splitting: true,
  format: "esm",
  metafile: true,
  write: false,
  plugins: [ownAddress],
});
await gather(split, main, common);
// The page imports the glue of a module by its address, so that it can import it afresh: each stays a file of its own.
await build({ ...common, entryPoints: glues.map(({ file }) => file), outdir: path.join(out, "pkg") });
// A script in the head runs before anything is drawn and shares no names with the modules.
await build({ ...common, entryPoints: scripts, entryNames: "[name]" });
const sheet = styles.map(({ file, media }) => `@import "./${file}" ${media};`).join("\n");
await build({
  ...common,
  stdin: { contents: sheet, loader: "css", resolveDir: ".", sourcefile: "style.css" },
  entryNames: "style",
  bundle: true,
});
// Sheets that pages of their own and parts on demand ask for by name.
await build({ ...common, entryPoints: sheets, outbase: "web", bundle: true });

// The single-file page: nothing is imported when it runs, the glue of a module is a function that makes a fresh copy of it, and the pages of
// theory are in it.
const copies = await Promise.all(
  glues.filter(({ inline }) => inline).map(async ({ name, file }) => {
    const { outputFiles } = await build({ ...common, entryPoints: [file], bundle: true, write: false, format: "iife", globalName: "glue", define: { "import.meta.url": "document.baseURI" } });
    return `${JSON.stringify(name)}: () => { ${outputFiles[0].text}; return glue; }`;
  }),
);
/** @type {import("esbuild").Plugin} */
const inOneFile = {
  name: "in-one-file",
  setup(build) {
    build.onResolve({ filter: /(^|\/)module\.js$/ }, () => ({ path: path.join(web, "module-inline.js") }));
    build.onResolve({ filter: /(^|\/)pages\.js$/ }, () => ({ path: path.join(web, "help/pages-inline.js") }));
    build.onResolve({ filter: /^levalab:glue$/ }, () => ({ path: "glue", namespace: "levalab" }));
    build.onLoad({ filter: /.*/, namespace: "levalab" }, () => ({ contents: `const copies = { ${copies.join()} };\nexport const freshGlue = (name) => copies[name]();` }));
  },
};
await build({ ...common, outdir: single, entryPoints: { main: "web/single.js" }, bundle: true, format: "esm", plugins: [inOneFile], define: { "import.meta.url": "document.baseURI" } });
