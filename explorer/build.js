// Bundle the explorer into two classic scripts: explorer.js, which a page loads once an instrument is near, and
// explorer-more.js, the small figures, which needs the first. The widget adds an export to both.

import { build } from "esbuild";
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
