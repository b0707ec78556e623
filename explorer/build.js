// Bundle the explorer into one classic script: the book's pages load it as it is, and the widget adds an export to it.

import { build } from "esbuild";

const common = { bundle: true, minify: true, target: "es2022", charset: "utf8" };

// A worker inside the bundle, as the text of a script of its own.
const worker = {
  name: "worker",
  setup(bundle) {
    bundle.onResolve({ filter: /^worker:/ }, ({ path, resolveDir }) => ({
      path: new URL(path.slice(7), `file://${resolveDir}/`).pathname,
      namespace: "worker",
    }));
    bundle.onLoad({ filter: /.*/, namespace: "worker" }, async ({ path }) => {
      const made = await build({ ...common, entryPoints: [path], format: "iife", write: false });
      return { contents: made.outputFiles[0].text, loader: "text" };
    });
  },
};

await build({
  ...common,
  entryPoints: ["src/index.js"],
  outfile: process.argv[2] ?? "../helpers/explorer/static/explorer.js",
  format: "iife",
  globalName: "ArmExplorer",
  legalComments: "eof",
  loader: { ".css": "text" },
  plugins: [worker],
});
