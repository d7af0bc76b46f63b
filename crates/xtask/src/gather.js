// Gathers what the page needs at once into one file, and lets what is loaded on demand import from it. A bundler that splits makes a chunk
// of each set of modules that the same parts share: dozens of requests, each packed by itself.
import { writeFile } from "node:fs/promises";
import path from "node:path";
import { build } from "esbuild";

/** A file of a split build. @typedef {{ text: string, exports: string[], needs: string[] }} Chunk */

/**
 * Writes the files of a split build, those that `entry` imports at once gathered into its own.
 * @param {import("esbuild").BuildResult<{ metafile: true, write: false }>} split
 * @param {string} entry
 * @param {import("esbuild").BuildOptions & { outdir: string }} options  those of the split build
 */
export async function gather({ metafile, outputFiles }, entry, options) {
  const texts = new Map(outputFiles.map((file) => [path.basename(file.path), file.text]));
  /** @type {Map<string, Chunk>} */
  const chunks = new Map();
  let main = "";
  for (const [file, { entryPoint, exports, imports }] of Object.entries(metafile.outputs)) {
    const name = path.basename(file);
    const needs = imports.filter(({ kind }) => kind === "import-statement").map((needed) => path.basename(needed.path));
    chunks.set(name, { text: texts.get(name) ?? "", exports, needs });
    if (entryPoint === entry) main = name;
  }
  /** The chunks that go together. */
  const together = new Set([main]);
  for (const name of together) for (const needed of chunks.get(name)?.needs ?? []) together.add(needed);

  /** What the gathered file calls each name that one of its chunks exports. @type {Map<string, string>} */
  const names = new Map();
  for (const name of together) for (const own of chunks.get(name)?.exports ?? []) names.set(`${name} ${own}`, `$${names.size.toString(36)}`);
  /** @param {string} chunk @param {(own: string, outside: string) => string | undefined} told */
  const list = (chunk, told) => (chunks.get(chunk)?.exports ?? []).map((own) => told(own, names.get(`${chunk} ${own}`) ?? "")).filter(Boolean).join(",");

  /** @param {string} name @param {string} text @param {(chunk: string) => string} contents  of a gathered chunk */
  async function join(name, text, contents) {
    /** @type {import("esbuild").Plugin} */
    const gathered = {
      name: "gathered",
      setup(build) {
        build.onResolve({ filter: /^\.\// }, ({ path: asked, kind }) => {
          const chunk = path.basename(asked);
          const inside = kind === "import-statement" && together.has(chunk) && (chunk !== main || name === main);
          return inside ? { path: chunk, namespace: "chunk", sideEffects: name === main } : { path: asked, external: true };
        });
        build.onLoad({ filter: /.*/, namespace: "chunk" }, ({ path: chunk }) => ({ contents: contents(chunk), resolveDir: "." }));
      },
    };
    const { outputFiles } = await build({ ...options, stdin: { contents: text, sourcefile: name, resolveDir: "." }, bundle: true, format: "esm", write: false, plugins: [gathered], logOverride: { "ignored-bare-import": "silent" } });
    return outputFiles[0].text;
  }

  /** What the others import from the gathered file. @type {Set<string>} */
  const wanted = new Set();
  const fromMain = new RegExp(`import\\{([^}]*)\\}from"\\./${main.replace(".", "\\.")}"`, "g");
  for (const [name, { text }] of chunks) {
    if (together.has(name)) continue;
    const written = await join(name, text, (chunk) => `export {${list(chunk, (own, outside) => `${outside} as ${own}`)}} from "./${main}";`);
    for (const [, imported] of written.matchAll(fromMain)) for (const one of imported.split(",")) wanted.add(one.split(" as ")[0]);
    await writeFile(path.join(options.outdir, name), written);
  }
  const shared = [...together].map((chunk) => `export {${list(chunk, (own, outside) => (wanted.has(outside) ? `${own} as ${outside}` : undefined))}} from "./${chunk}";`);
  const whole = await join(main, `import "./${main}";${shared.join("")}`, (chunk) => chunks.get(chunk)?.text ?? "");
  await writeFile(path.join(options.outdir, main), whole);
}
