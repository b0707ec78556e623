// The example text of judge/reading/README.md.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { numbers } from "../../judge/reading/numbers.js";

const README = readFileSync(new URL("../../judge/reading/README.md", import.meta.url), "utf8");

test("numbers have the owners that the README names", () => {
  const [, text] = /```\n([\s\S]*?)```/.exec(README);
  const request = { wants: [{ rows: 2, columns: 1, by: "joint", turned: true }], names: /^tau/ };
  const { values, tokens } = numbers(text, "your torques", undefined, undefined, request);
  assert.deepEqual(values, [0, -97.5297]);
  assert.deepEqual(
    tokens.map((token) => [token.text, token.owner]),
    [["6", "context"], ["1", "label"], ["0.0", "entry"], ["2", "label"], ["97.5297", "entry"], ["99.1", "context"]],
  );
});
