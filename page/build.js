// Bundle the explorer into two classic scripts: explorer.js, which a page loads once an instrument
// is near, and explorer-more.js, the small figures, which needs the first. The widget adds an
// export to both. A page that judges answers loads judge.js, and with the question that is asked
// one of judge-jacobian.js and its like: src/check/scripts.

import { build } from "esbuild";
import { readdir, readFile } from "node:fs/promises";
import { join, relative, resolve, sep } from "node:path";

const helpers = process.argv[2] ?? "helpers";
const folder = join(helpers, "explorer/static");
// A style sheet inside a script, as text.
const css = {
  name: "css",
  setup(bundle) {
    bundle.onLoad({ filter: /\.css$/ }, async ({ path }) => {
      const made = await build({
        entryPoints: [path],
        minify: true,
        charset: "utf8",
        write: false,
      });
      return { contents: made.outputFiles[0].text, loader: "text" };
    });
  },
};

const common = {
  bundle: true,
  minify: true,
  target: "es2022",
  charset: "utf8",
  legalComments: "eof",
  plugins: [css],
};

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

// What a further script imports from the first one's sources it finds in `global`, by its path from
// the root: all modules that the first one's shared.js lists.
const kit = async (global, list) => {
  const shared = new Set((await readFile(list, "utf8")).match(/(?<=")[\w/]+\.js(?=":)/g));
  const pathOf = ({ path, resolveDir }) =>
    relative(resolve("."), join(resolveDir, path)).replaceAll(sep, "/");
  return {
    name: "kit",
    setup(bundle) {
      bundle.onResolve({ filter: /^\.\.?\/.*\.js$/ }, (asked) =>
        shared.has(pathOf(asked)) ? { path: pathOf(asked), namespace: "kit" } : null,
      );
      bundle.onLoad({ filter: /.*/, namespace: "kit" }, ({ path }) => ({
        contents: `module.exports = ${global}.kit[${JSON.stringify(path)}];`,
      }));
    },
  };
};

// A script that reads or judges, taught those of the checkers' sentences that its sources name.
async function judgeScript(name, entry, options = {}) {
  const made = (words) => ({
    ...common,
    ...options,
    stdin: {
      contents: [
        `import { learn } from "../../../judge/sentences.js";`,
        `learn(${JSON.stringify(words)});`,
        `export * from "./${entry}";`,
      ].join("\n"),
      resolveDir: "page/src/check",
    },
    outfile: join(folder, name),
    format: /** @type {"iife"} */ ("iife"),
  });
  const { metafile } = await build({ ...made({}), write: false, metafile: true });
  const files = Object.keys(metafile.inputs).filter((path) => /^(judge|page)\//.test(path));
  const sources = await Promise.all(files.map((path) => readFile(path, "utf8")));
  const all = Object.entries(JSON.parse(await readFile("judge/sentences.json", "utf8")));
  const named = ([key]) => sources.some((source) => source.includes(`"${key}"`));
  await build(made(Object.fromEntries(all.filter(named))));
}

// The judge alone, with all of its sentences, for Python.
await build({
  ...common,
  stdin: {
    contents: [
      `import sentences from "./sentences.json";`,
      `import { learn } from "./sentences.js";`,
      `learn(sentences);`,
      `export { ask } from "./index.js";`,
    ].join("\n"),
    resolveDir: "judge",
  },
  outfile: join(helpers, "checks/judge.js"),
  format: "iife",
  globalName: "Judge",
});
await build({
  ...common,
  entryPoints: ["page/src/index.js"],
  outfile: join(folder, "explorer.js"),
  format: "iife",
  globalName: "ArmExplorer",
  plugins: [css, worker],
});
const explorers = await kit("ArmExplorer", "page/src/shared.js");
await build({
  ...common,
  entryPoints: ["page/src/more/index.js"],
  outfile: join(folder, "explorer-more.js"),
  format: "iife",
  plugins: [css, explorers],
});
await judgeScript("explorer-table.js", "../paste.js", { plugins: [explorers] });
await judgeScript("judge.js", "main.js", { globalName: "ArmJudge" });
const parts = await kit("ArmJudge", "page/src/check/shared.js");
for (const entry of await readdir("page/src/check/scripts"))
  await judgeScript(`judge-${entry}`, `scripts/${entry}`, { plugins: [css, parts] });
