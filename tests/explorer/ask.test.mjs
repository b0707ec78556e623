// Questions of the check page: their links, typed tables and the judge's advice.

import assert from "node:assert/strict";
import test from "node:test";
import { makeOffer } from "../../page/src/check/form.js";
import { findArm, EMPTY, parseQuestionLink, makeStartingQuestion, formatQuestionLink } from "../../page/src/check/question.js";
import { formatNumber } from "../../judge/sentences.js";

const ARMS = ["PANDA", "ELBOW"];
const TARGET = Array(4).fill("0.123456 -0.123456 0.123456 -0.123456").join("\n");
const asked = { ...EMPTY, arm: "ELBOW", q: "0.5, 0.7, -0.4", unit: "deg", frame: "2", target: TARGET, answer: "[1 2;\n 3 4]" };

test("a question link restores the question", () => {
  assert.deepEqual(parseQuestionLink(formatQuestionLink(asked), ARMS), { question: asked, message: "" });
});

for (const [fragment, words] of [
  ["#ask=jacobian&arm=Nobody", /no arm called “Nobody”/],
  ["#ask=everything&arm=ELBOW", /not judged here/],
  ["#ask=jacobian&arm=ELBOW&frame=1e3", /frame/],
  ["#ask=jacobian&arm=ELBOW&unit=gon", /unit/],
  ["#ask=jacobian&arm=ELBOW&script=1", /a field “script”/],
  [`#ask=jacobian&arm=ELBOW&answer=${"1".repeat(8001)}`, /answer is too long/],
  [`#ask=jacobian&arm=ELBOW&answer=${"1".repeat(13000)}`, /13\d{3} characters; 12000 are the most/],
]) {
  test(`a bad question link is refused: ${words}`, () => {
    const link = parseQuestionLink(fragment, ARMS);
    assert.equal(link.question, null);
    assert.match(link.message, words);
  });
}

test("other fragments contain no question", () => {
  assert.deepEqual(parseQuestionLink("#sec-check-table", ARMS), { question: null, message: "" });
  assert.deepEqual(parseQuestionLink("", ARMS), { question: null, message: "" });
});

test("a typed table reports how it was read", () => {
  const own = { ...EMPTY, arm: "own", table: "a, alpha, d, theta\n0, pi/2, 0.5, q1\n0.4, 0, d2, 0" };
  assert.equal(findArm(own, []).reading, "columns a α d θ; the standard convention; lengths in m");
});

test("numbers are formatted with three digits", () => {
  const sizes = [[0, "0"], [-0.00001234, "-0.0000123"], [1234567, "1230000"], [12.5, "12.5"], [100, "100"], [99.96, "100"]];
  for (const [x, text] of sizes) assert.equal(formatNumber(x), text);
}); // prettier-ignore

const LISTED = [
  { key: "PANDA", title: "Panda" },
  { key: "PANDA.lock(3)", title: "Panda, joint 3 locked" },
];
for (const [advice, patch, key, value, words] of [
  [["angles", "deg"], {}, "unit", "deg", "Angles in: deg"],
  [["angles", "deg"], { ask: "table" }, "angles", "deg", "Angles in: deg"],
  [["angularFirst", true], {}, "first", "omega", "Order of the rows: ω, then v"],
  [["frame", 6], {}, "frame", "6", "Rows in the axes of: frame 6"],
  [["convention", "craig"], { ask: "table" }, "convention", "craig", "Convention: modified (Craig)"],
  [["lengths", "mm"], { ask: "table" }, "lengths", "mm", "Lengths in: mm"],
  [["locked", 3], {}, "arm", "PANDA.lock(3)", "Arm: Panda, joint 3 locked"],
  [["arm", "Panda"], { arm: "PANDA.lock(3)" }, "arm", "PANDA", "Arm: Panda"],
  [["values", "L"], { values: "h = 1" }, "values", "h = 1, L = ", "Your own symbols: h = 1, L = …"],
]) {
  test(`an advice sets its field: ${words}`, () => {
    const question = { ...EMPTY, arm: "PANDA", ...patch };
    const offer = makeOffer({ field: advice[0], value: advice[1] }, question, LISTED);
    assert.deepEqual(offer, { key, value, text: words });
    assert.equal(makeOffer({ field: advice[0], value: advice[1] }, { ...question, [key]: value }, LISTED)?.value === value, false);
  });
}

test("advice without a field has no button", () => {
  const question = { ...EMPTY, arm: "PANDA" };
  for (const [field, value] of [["ownJoints", true], ["locked", 5], ["arm", "Nobody"]])
    assert.equal(makeOffer({ field, value }, question, LISTED), null);
});

test("a question without an example starts at the home configuration", () => {
  const rows = [{ kind: "revolute" }, { kind: "prismatic" }];
  const pages = { arms: [{ key: "MINE", home: [Math.PI / 2, 0.5], rows }], examples: [{ ask: "pose", arm: "MINE", answer: "1" }] };
  const begun = (given) => makeStartingQuestion({ ask: "jacobian", arm: "MINE", unit: "rad", ...given }, pages);
  assert.deepEqual([begun({}).q, begun({}).answer], ["π/2, 0.5", ""]);
  assert.equal(begun({ unit: "deg" }).q, "90, 0.5");
  assert.equal(begun({ ask: "pose" }).answer, "1");
  assert.equal(begun({ ask: "pose", unit: "deg" }).answer, ""); // the example's angles are in rad
});
