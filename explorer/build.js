// Bundle the explorer into two classic scripts: explorer.js, which a page loads once an instrument is near, and
// explorer-more.js, the small figures, which needs the first. The widget adds an export to both. A third one, judge.js,
// is what a page loads that judges answers.

import { build } from "esbuild";
import { readdir, readFile } from "node:fs/promises";
import { dirname, join, relative, sep } from "node:path";

const folder = process.argv[2] ?? "../helpers/explorer/static";
const common = { bundle: true, minify: true, target: "es2022", charset: "utf8", legalComments: "eof" };

// A worker inside the bundle, as the text of a script of its own.
const worker = {
  name: "worker",
  setup(bundle) {
    bundle.onResolve({ filter: /^worker:/ }, ({ path, resolveDir }) => ({
      path: join(resolveDir, path.slice(7)),
      namespace: "worker",
    }));
    bundle.onLoad({ filter: /.*/, namespace: "worker" }, async ({ path }) => {
      const made = await build({ ...common, entryPoints: [path], format: "iife", write: false });
      return { contents: made.outputFiles[0].text, loader: "text" };
    });
  },
};

// What the second script imports from the first one's sources it finds in ArmExplorer.kit, by its path.
const kit = {
  name: "kit",
  setup(bundle) {
    bundle.onResolve({ filter: /^\.\.\// }, ({ path, importer, resolveDir }) => {
      if (dirname(importer).split(sep).at(-1) !== "more" || path.endsWith(".css")) return null;
      return { path: relative(join(resolveDir, ".."), join(resolveDir, path)), namespace: "kit" };
    });
    bundle.onLoad({ filter: /.*/, namespace: "kit" }, ({ path }) => ({
      contents: `module.exports = ArmExplorer.kit[${JSON.stringify(path)}];`,
    }));
  },
};

// Of the checkers' sentences, those that the judge's sources name.
const sentences = {
  name: "sentences",
  setup(bundle) {
    bundle.onLoad({ filter: /sentences\.json$/ }, async ({ path }) => {
      const names = await readdir("src/judge");
      const sources = await Promise.all(names.map((name) => readFile(join("src/judge", name), "utf8")));
      const all = Object.entries(JSON.parse(await readFile(path, "utf8")));
      const named = ([key]) => sources.some((source) => source.includes(`"${key}"`));
      return { contents: JSON.stringify(Object.fromEntries(all.filter(named))), loader: "json" };
    });
  },
};

await build({
  ...common,
  entryPoints: ["src/index.js"],
  outfile: join(folder, "explorer.js"),
  format: "iife",
  globalName: "ArmExplorer",
  loader: { ".css": "text" },
  plugins: [worker],
});
await build({
  ...common,
  entryPoints: ["src/more/index.js"],
  outfile: join(folder, "explorer-more.js"),
  format: "iife",
  loader: { ".css": "text" },
  plugins: [kit],
});
await build({
  ...common,
  entryPoints: ["src/judge/main.js"],
  outfile: join(folder, "judge.js"),
  format: "iife",
  loader: { ".css": "text" },
  plugins: [sentences],
});
