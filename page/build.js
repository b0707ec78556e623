// Bundle the two scripts with their styles: explorer.js for the explorer in pages and notebooks,
// judge.js for judging in Python and for the form in pages.

import { build } from "esbuild";
import { join } from "node:path";

const helpers = process.argv[2] ?? "helpers";

/** @type {import("esbuild").BuildOptions} */
const common = {
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  charset: "utf8",
  legalComments: "eof",
  loader: { ".css": "text" },
  logOverride: { "import-is-undefined": "error" },
};

// The explorer contains its worker's script as text, because a page opened from a file may not load
// another.
const worker = await build({ ...common, entryPoints: ["page/src/worker.js"], write: false });

await build({
  ...common,
  entryPoints: ["page/src/index.js"],
  globalName: "ArmExplorer",
  define: { WORKER: JSON.stringify(worker.outputFiles[0].text) },
  outfile: join(helpers, "explorer/static/explorer.js"),
});

await build({
  ...common,
  entryPoints: ["page/src/check/main.js"],
  globalName: "ArmJudge",
  outfile: join(helpers, "checks/judge.js"),
});
