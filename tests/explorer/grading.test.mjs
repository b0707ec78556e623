// The parts of a verdict by hand: what digits promise, how far off is right, which mistake explains most.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { better, both, cause, explain, nameOf, several, wordsOf } from "../../judge/causes/ranking.js";
import { bands, decimalsOf, graded, margins } from "../../judge/digits.js";
import { learn, lower } from "../../judge/sentences.js";

learn(JSON.parse(readFileSync(new URL("../../judge/sentences.json", import.meta.url), "utf8")));

const near = (found, wanted) =>
  found.forEach((x, i) =>
    assert.ok(Math.abs(x - wanted[i]) <= 1e-12 + 1e-12 * Math.abs(wanted[i]), `${found}`),
  );

test("margins grow with the unit and the scale", () => {
  const m = margins([0, 0.01, 1e-9], [2, 2, 5], [0, 0.2, 0.1]);
  near(m.allowed, [2e-6, 0.51 * 0.01, 5e-6]);
  near(m.band, [2e-6, 3.01 * 0.01, 5e-6]);
  near(m.loose, [2e-3, 0.0301, 5e-3]);
  const wide = [2e-6, 0.4301, 0.200005];
  [m.band, wide, [2e-3, 0.4301, 0.200005], m.allowed].forEach((band, k) => near(bands(m)[k], band));
  const even = margins([0, 0.01, 1e-9], [2, 2, 5]);
  [even.band, even.loose, even.allowed].forEach((band, k) => near(bands(even)[k], band));
  assert.deepEqual(
    [decimalsOf([0.1, 1e-4, 0]), decimalsOf([10, 100]), decimalsOf([0])],
    [4, 0, null],
  );
});

for (const [tolerance, wanted] of [[0.1, 0.1], [0, 2e-9]]) {
  test(`a tolerance of ${tolerance} is all that is allowed`, () => {
    const m = margins([0, 0.01, 1e-9], [2, 2, 2], [1, 1, 1], tolerance);
    for (const width of [m.allowed, m.band, m.loose]) near(width, [wanted, wanted, wanted]);
    for (const none of [m.units, m.slop]) assert.deepEqual(none, [0, 0, 0]);
  });
}

// Of two entries that should be 1 the first is x; `made` says what known mistakes make of it.
for (const [x, widths, made, grade] of [
  [1.11, [0.01, 0.03, 0.1], [5], "wrong"],
  // The mistake is as near: the digits cannot tell the two apart, unless it changes too little to ask.
  [1.02, [0.05, 0.06, 0.1], [1.04], "so far"],
  [1.02, [0.05, 0.06, 0.1], [1.002], "right"],
  // Units so coarse that the mistake, 0.04 away, would round to the same.
  [1, [0.01, 0.02, 0.1, 0.0195], [1.04], "so far"],
  [1, [0.01, 0.02, 0.1, 0.0185], [1.04], "right"],
  [1, [0.01, 0.02, 0.1, 0.5], [], "right"],
  // What is right fits only with the digits of q, the mistake without.
  [1.04, [0.01, 0.03, 0.1, 0, 0.1], [1.04], "wrong"],
  [1.05, [0.01, 0.03, 0.1, 0, 0.1], [5], "right"],
  [1.16, [0.01, 0.03, 0.1, 0, 0.1], [1.25], "wrong"],
  // Rounded on the way, and by how much: with the digits of q, and nearer to a mistake.
  [1.22, [0.01, 0.03, 0.1, 0, 0.1], [], "rounded"],
  [1.03, [0.01, 0.04, 0.1], [1.07], "rounded"],
  [1.03, [0.01, 0.04, 0.1], [9, 1.06], "so far"],
]) {
  test(`${x} instead of 1 beside ${made} within ${widths} is ${grade}`, () => {
    const [allowed, band, loose, units, slop] = [0, 1, 2, 3, 4].map((k) => [widths[k] ?? 0, widths[k] ?? 0]);
    const answers = made.map((y) => [y, 1]);
    assert.equal(graded([x, 1], [1, 1], { allowed, band, loose, units, slop }, answers), grade);
  });
}

// Which mistake explains most

const SIX = [0, 0, 0, 0, 0, 0];
const [ONE, TWO, THREE] = [
  cause("J.halves"),
  cause("J.all signs"),
  cause("J.frame", { k: 3, _name: "frame 3" }),
];
const BAND = SIX.map(() => 0.1);
const told = (mine, made, causes = [ONE, TWO, THREE], weight = undefined) =>
  explain(mine, SIX, BAND, { causes: causes.slice(0, made.length), made }, weight);
const oddOf = (found) => found && found.odd.flatMap((is, i) => (is ? [i] : []));

test("what explains all is named, however little is wrong", () => {
  const found = told([1, 0, 0, 0, 0, 0], [[1, 1, 1, 1, 1, 1], [1.05, 0, 0, 0, 0, 0]]);
  assert.deepEqual([found.causes.map(nameOf), oddOf(found)], [["J.all signs"], []]);
  near(found.rest, [-0.05, 0, 0, 0, 0, 0]);
  assert.equal(told([0.05, 0, 0, 0, 0, 0], [[0.05, 0, 0, 0, 0, 0]]), null);
  assert.equal(told([1, 0, 0, 0, 0, 0], [SIX]), null);
});

for (const [mine, made, odd] of [
  [[1, 1, 1, 2, 2, 0], [1, 1, 1, 0, 0, 0], [3, 4]], // three of five are 60 %
  [[1, 1, 1, 2, 2, 2], [1, 1, 1, 0, 0, 0], null], // three of six are less
  [[1, 1, 1, 0, 0, 0], [1, 1, 1, 1, 0, 0], null], // one spoiled of three
]) {
  test(`a mistake must gain three entries and most of what is wrong: ${mine} by ${made}`, () => {
    assert.deepEqual(oddOf(told(mine, [made])), odd);
  });
}

test("two mistakes must gain more, and the simplest comes first", () => {
  const pair = [both(ONE, TWO)];
  assert.equal(told([1, 1, 1, 1, 2, 0], [[1, 1, 1, 1, 0, 0]], pair), null); // four of five are 80 %
  assert.deepEqual(told([1, 1, 1, 1, 1, 1], [[1, 1, 1, 1, 1, 1]], pair).causes, pair);
  const mine = [1, 1, 1, 1, 1, 0];
  assert.deepEqual(told(mine, [[1, 1, 1, 1, 0, 0], mine, mine]).causes, [TWO, THREE]);
  // No two mistakes are needed for one wrong entry.
  assert.equal(told([1, 0, 0, 0, 0, 0], [[1, 0, 0, 0, 0, 0]], pair), null);
  // One entry left costs 0.7, less than a second mistake; with a weight of 1.2 it costs more.
  const made = [mine, [1, 1, 1, 1, 0, 0]];
  assert.deepEqual(told(mine, made, [pair[0], THREE]).causes, [THREE]);
  assert.deepEqual(told(mine, made, [pair[0], THREE], 1.2).causes, pair);
  const found = (left, one) => ({ causes: [one], odd: SIX.map((_, i) => i < left), rest: SIX });
  const [single, two, spoiled] = [found(0, ONE), found(0, pair[0]), found(1, THREE)];
  assert.deepEqual([better([null, two, single]), better([two, spoiled])], [single, spoiled]);
  assert.deepEqual([better([two, spoiled], 1.2), better([null])], [two, null]);
});

test("what causes say and how they are called", () => {
  assert.equal(nameOf(THREE), "J.frame:3");
  assert.equal(
    nameOf(cause("J in half", { half: "linear", words: "x", _of: "J.halves" })),
    "J.halves",
  );
  const two = both(ONE, TWO);
  assert.equal(nameOf(two), "J.halves + J.all signs");
  assert.equal(wordsOf(two), `${wordsOf(ONE)}; and besides, every sign is reversed`);
  const signs = [1, 2, 3, 4].map((i) => cause("J.column sign", { i }));
  const words = signs.map(wordsOf);
  const same = "which gives the same numbers here";
  assert.equal(several([signs[0], signs[0]]), words[0]);
  assert.equal(several(signs), `${words[0]}; or ${lower(words[1])} or ${lower(words[2])}, ${same}`);
  assert.equal(several(signs, 2), `${words[0]}; or ${lower(words[1])}, ${same}`);
  assert.equal(several([two, both(TWO, ONE)]), wordsOf(two));
});

test("sentences inside others", () => {
  const sentences = ["The sign", "A", "NM", "A_i is", "q_1 is", "It_is"];
  assert.deepEqual(sentences.map(lower), ["the sign", "a", "NM", "A_i is", "q_1 is", "it_is"]);
});
