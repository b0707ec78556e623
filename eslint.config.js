// What a reader of the sources may count on; formatting is Prettier's.

import globals from "globals";

export default [
  { ignores: ["node_modules/"] },
  {
    files: ["judge/**/*.js", "page/**/*.js"],
    linterOptions: { reportUnusedDisableDirectives: "error" },
    rules: {
      "no-undef": "error",
      "no-unused-vars": ["error", { varsIgnorePattern: "^_$", argsIgnorePattern: "^_" }],
      "no-var": "error",
      "prefer-const": ["error", { destructuring: "all" }],
      eqeqeq: "error",
      "no-shadow-restricted-names": "error",
      "no-implied-eval": "error",
      "no-eval": "error",
      "no-self-compare": "error",
      "no-unsafe-finally": "error",
      "no-unreachable": "error",
      "no-constant-condition": "error",
      "no-dupe-keys": "error",
      "no-fallthrough": "error",
      "no-restricted-properties": [
        "error",
        { property: "innerHTML", message: "Text that a reader typed must never become HTML." },
      ],
      complexity: ["error", 15],
      "max-lines-per-function": ["error", 60],
      "max-params": ["error", 5],
      "max-len": ["error", 100],
      "max-lines": ["error", 400],
    },
  },
  {
    files: ["page/src/**/*.js"],
    languageOptions: { globals: { ...globals.browser, WORKER: "readonly" } },
  },
  { files: ["page/build.js"], languageOptions: { globals: globals.node } },
];
