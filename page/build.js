// Bundle the two scripts, each with its styles: explorer.js, which brings arms to life in a page
// and in a notebook's widget, and judge.js, which judges in Python and, with its form, in a page.

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
};

// The explorer has its worker's script inside, as a text: from a file a page may start no other.
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
