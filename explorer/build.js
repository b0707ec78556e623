// Bundle the explorer into one classic script: the book's pages load it as it is, and the widget adds an export to it.

import { build } from "esbuild";

await build({
  entryPoints: ["src/index.js"],
  outfile: process.argv[2] ?? "../helpers/explorer/static/explorer.js",
  bundle: true,
  minify: true,
  format: "iife",
  globalName: "ArmExplorer",
  target: "es2022",
  charset: "utf8",
  legalComments: "eof",
  loader: { ".css": "text" },
});
