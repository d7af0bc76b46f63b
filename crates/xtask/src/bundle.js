// Joins and minifies the page's modules and styles: `node bundle.js '{"out": …, "modules": […], "scripts": […], "styles": […]}'`.
// Prints, for each file written, which others it needs at once: [{"file": …, "needs": […]}].
import { readFile } from "node:fs/promises";
import path from "node:path";
import { build } from "esbuild";

/** @type {{ out: string, modules: string[], scripts: string[], styles: { file: string, media: string }[] }} */
const { out, modules, scripts, styles } = JSON.parse(process.argv[2]);
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

/** @type {import("esbuild").BuildOptions} */
const common = {
  outdir: out,
  minify: true,
  charset: "utf8",
  legalComments: "none",
  target: "es2022",
  loader: { ".svg": "dataurl", ".png": "dataurl", ".woff2": "file" },
  logLevel: "warning",
};

const built = await build({
  ...common,
  entryPoints: modules,
  entryNames: "[name]",
  chunkNames: "part-[hash]",
  bundle: true,
  splitting: true,
  format: "esm",
  metafile: true,
  plugins: [ownAddress],
});
// A script in the head runs before anything is drawn and shares no names with the modules.
await build({ ...common, entryPoints: scripts, entryNames: "[name]" });
const sheet = styles.map(({ file, media }) => `@import "./${file}" ${media};`).join("\n");
await build({
  ...common,
  stdin: { contents: sheet, loader: "css", resolveDir: ".", sourcefile: "style.css" },
  entryNames: "style",
  bundle: true,
});

const written = Object.entries(built.metafile.outputs).map(([file, { imports }]) => ({
  file: path.relative(out, file),
  needs: imports.filter(({ kind }) => kind === "import-statement").map((needed) => path.relative(out, needed.path)),
}));
console.log(JSON.stringify(written));
