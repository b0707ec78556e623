// From a pose that hides mistakes there is a way to one that shows them, for every arm of the list.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import "../../page/src/check/scripts/jacobian.js";
import { tellingPose } from "../../page/src/check/extras/poses.js";
import { EMPTY } from "../../page/src/check/question.js";
import { learn } from "../../judge/sentences.js";

const read = (path) => JSON.parse(readFileSync(new URL(path, import.meta.url), "utf8"));
learn(read("../../judge/sentences.json"));
const ARMS = read("../../page/src/more/arms.json").map((arm) => ({ ...arm, key: arm.name }));

const ALWAYS = { "Stanford arm": 1 }; // hidden at every pose of 25 drawn ones too

for (const arm of ARMS) {
  test(`a pose of ${arm.name} shows all mistakes that can be seen`, () => {
    const { q, hidden } = tellingPose({ ...EMPTY, ask: "jacobian", arm: arm.key }, ARMS, arm);
    assert.equal(hidden, ALWAYS[arm.name] ?? 0);
    assert.equal(q.length, arm.home.length);
  });
}
