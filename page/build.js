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

// three.js from its modules, without shaders of materials and effects that no picture here has.
const EFFECTS =
  "alpha|aomap|batch|bump|clear|clipping|displace|dither|emissive|envmap_(?!physical)|fog|" +
  "gradient|iridescence|light(map|probes|s_(lambert|phong|toon))|logdepth|map_particle|morph|" +
  "normalmap|skin|tonemapping|transmission|uv";
const UNUSED = new RegExp(
  `ShaderLib/(?!(mesh)?(basic|physical|depth|shadow))|ShaderChunk/(${EFFECTS})`,
);
const three = {
  name: "three",
  setup(bundle) {
    const path = resolve("node_modules/three/src/Three.js");
    bundle.onResolve({ filter: /^three$/ }, () => ({ path, sideEffects: false }));
    bundle.onLoad({ filter: /\.glsl\.js$/ }, async ({ path }) => {
      const text = await readFile(path, "utf8");
      return UNUSED.test(path.replaceAll(sep, "/"))
        ? { contents: text.replace(/`[^`]*`/g, '""') }
        : { contents: text.replace(/^[ \t]+|[ \t]*\/\/.*$/gm, "").replace(/\n+/g, "\n") };
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

const SENTENCES = Object.entries(JSON.parse(await readFile("judge/sentences.json", "utf8")));
const plugins = [three, css, worker];

// What a script is made from: its entry, and those of the checkers' sentences that it says.
const stdin = (entry, words = {}, more = []) => ({
  contents: [
    ...(Object.keys(words).length
      ? [`import { learn } from "./judge/sentences.js";`, `learn(${JSON.stringify(words)});`]
      : []),
    `export * from "./${entry}";`,
    ...more,
  ].join("\n"),
  resolveDir: ".",
});

// Modules of the first script, in a further one: left to `load`, by their path from the root.
const elsewhere = (shared, load) => ({
  name: "elsewhere",
  setup(bundle) {
    bundle.onResolve({ filter: /^\.\.?\/.*\.js$/ }, ({ path, resolveDir }) => {
      const asked = relative(".", join(resolveDir, path)).replaceAll(sep, "/");
      return shared.has(asked) ? { path: asked, ...load } : null;
    });
  },
});

// A script before it is made small: its text, its modules, and the sentences that it says.
async function drafted(entry, { shared = new Set(), more = [] } = {}) {
  const { outputFiles, metafile } = await build({
    ...common,
    minify: false,
    format: "esm",
    stdin: stdin(entry, {}, more),
    plugins: [...plugins, elsewhere(shared, { external: true })],
    write: false,
    metafile: true,
  });
  const { text } = outputFiles[0];
  const modules = Object.keys(metafile.inputs).filter((path) =>
    /^(judge|page)\/.*\.js$/.test(path),
  );
  return { text, modules, said: SENTENCES.filter(([key]) => text.includes(`"${key}"`)) };
}

// The names that drafts import from modules of the first script, by the modules' paths.
function importsOf(drafts) {
  const found = {};
  for (const { text } of drafts)
    for (const [, list, path] of text.matchAll(/^import \{([^}]*)\} from "([^"]+)";$/gm))
      for (const name of list.split(","))
        (found[path] ??= new Set()).add(name.trim().split(" ")[0]);
  return found;
}

/**
 * The first script of a page, and those that are loaded after it: what they share stands in the
 * first one alone, whose global has it by name.
 * @param {string} globalName
 * @param {[string, string][]} scripts names and entries
 */
async function scriptsOf(globalName, [[name, entry], ...further]) {
  const { modules } = await drafted(entry);
  const shared = new Set([...modules, "judge/sentences.js"]);
  const drafts = await Promise.all(further.map(([, one]) => drafted(one, { shared })));
  const asked = importsOf([...drafts, { text: `import { learn } from "judge/sentences.js";` }]);
  const names = (path) => [...asked[path]].join(", ");
  const given = Object.keys(asked).map((path) => `export { ${names(path)} } from "./${path}";`);
  const script = (file, words, of, more = []) =>
    build({
      ...common,
      ...of,
      format: "iife",
      stdin: stdin(words.entry, Object.fromEntries(words.said), more),
      outfile: join(folder, file),
    });
  // with what it has for the others, which has sentences too
  const first = await drafted(entry, { more: given });
  await script(name, { entry, said: first.said }, { plugins, globalName }, given);
  const taken = {
    name: "taken",
    setup(bundle) {
      bundle.onLoad({ filter: /.*/, namespace: "first" }, ({ path }) => ({
        contents: `export const { ${names(path)} } = ${globalName};`,
      }));
    },
  };
  const known = new Set(first.said.map(([key]) => key));
  const later = [...plugins, elsewhere(shared, { namespace: "first" }), taken];
  for (const [i, [file, one]] of further.entries()) {
    const said = drafts[i].said.filter(([key]) => !known.has(key));
    await script(file, { entry: one, said }, { plugins: later });
  }
}

await scriptsOf("ArmExplorer", [
  ["explorer.js", "page/src/index.js"],
  ["explorer-more.js", "page/src/more/index.js"],
  ["explorer-table.js", "page/src/paste.js"],
]);
const questions = await readdir("page/src/check/scripts");
await scriptsOf("ArmJudge", [
  ["judge.js", "page/src/check/main.js"],
  ...questions.map(
    (file) => /** @type {[string, string]} */ ([`judge-${file}`, `page/src/check/scripts/${file}`]),
  ),
]);
