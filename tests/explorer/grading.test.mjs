// Names and messages of causes.

import assert from "node:assert/strict";
import test from "node:test";
import { combineCauses, makeCause, causeName, joinCauseMessages, causeMessage } from "../../judge/causes/ranking.js";
import { uncapitalize } from "../../judge/sentences.js";

const [ONE, TWO, THREE] = [
  makeCause("J.halves"),
  makeCause("J.all signs"),
  makeCause("J.frame", { k: 3, _name: "frame 3" }),
];

test("combined causes join names and messages", () => {
  assert.equal(causeName(THREE), "J.frame:3");
  const two = combineCauses(ONE, TWO);
  assert.equal(causeName(two), "J.halves + J.all signs");
  assert.equal(causeMessage(two), `${causeMessage(ONE)}; also, every sign is reversed`);
  const signs = [1, 2, 3].map((i) => makeCause("J.column of", { i }));
  const words = signs.map(causeMessage);
  const same = "which gives the same numbers here";
  assert.equal(joinCauseMessages([signs[0], signs[0]]), words[0]);
  assert.equal(joinCauseMessages(signs), `${words[0]}; or ${uncapitalize(words[1])} or ${uncapitalize(words[2])}, ${same}`);
  assert.equal(joinCauseMessages([two, combineCauses(TWO, ONE)]), causeMessage(two));
});

test("a nested sentence starts in lower case", () => {
  const sentences = ["The sign", "A", "NM", "A_i is", "q_1 is", "It_is"];
  assert.deepEqual(sentences.map(uncapitalize), ["the sign", "a", "NM", "A_i is", "q_1 is", "it_is"]);
});
