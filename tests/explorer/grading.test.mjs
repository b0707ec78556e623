// What causes say, and how they are called.

import assert from "node:assert/strict";
import test from "node:test";
import { both, cause, nameOf, several, wordsOf } from "../../judge/causes/ranking.js";
import { lower } from "../../judge/sentences.js";

const [ONE, TWO, THREE] = [
  cause("J.halves"),
  cause("J.all signs"),
  cause("J.frame", { k: 3, _name: "frame 3" }),
];

test("what causes say and how they are called", () => {
  assert.equal(nameOf(THREE), "J.frame:3");
  const two = both(ONE, TWO);
  assert.equal(nameOf(two), "J.halves + J.all signs");
  assert.equal(wordsOf(two), `${wordsOf(ONE)}; and besides, every sign is reversed`);
  const signs = [1, 2, 3].map((i) => cause("J.column of", { i }));
  const words = signs.map(wordsOf);
  const same = "which gives the same numbers here";
  assert.equal(several([signs[0], signs[0]]), words[0]);
  assert.equal(several(signs), `${words[0]}; or ${lower(words[1])} or ${lower(words[2])}, ${same}`);
  assert.equal(several([two, both(TWO, ONE)]), wordsOf(two));
});

test("sentences inside others", () => {
  const sentences = ["The sign", "A", "NM", "A_i is", "q_1 is", "It_is"];
  assert.deepEqual(sentences.map(lower), ["the sign", "a", "NM", "A_i is", "q_1 is", "it_is"]);
});
