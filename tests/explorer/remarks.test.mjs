// Tests the words by which a remark corrects, doubts or takes back an answer, each once.

import assert from "node:assert/strict";
import { test } from "node:test";
import { isRemark } from "../../judge/reading/remarks.js";

const ALONE = false; // a line without an entry
const BESIDE_ENTRY = true;

const assertRemarks = (lines, hasEntry = ALONE) => {
  for (const line of lines) assert.ok(isRemark(line, hasEntry), line);
};

const PARTS = [
  ...["joint 3", "joints 3", "Gelenk 3", "line 3", "lines 3", "row 3", "rows 3", "Zeile 3", "column 3", "columns 3", "Spalte 3", "entry 3", "link 3"],
  ...["no. 3", "solution 3", "theta3", "th3", "q3", "tau3", "alpha3", "a3", "d3", "j3", "θ3", "τ_3", "α₃"],
  ...["first", "second", "third", "fourth", "fifth", "sixth", "last"].map((ordinal) => `the ${ordinal} joint`),
  ...["row", "column", "entry"].map((noun) => `the last ${noun}`),
];

test("a remark names a part of the answer", () => {
  assertRemarks(PARTS.map((part) => `${part} is wrong`));
  assertRemarks(PARTS.map((part) => `Wrong: ${part}`));
  assertRemarks(PARTS.map((part) => `Correction: ${part} is 0.5`));
});

const DOUBTS = [
  ...["wrong", "incorrect", "falsch", "typo", "mistyped", "opposite sign", "other sign", "reversed", "please read", "not as written"],
  ...["positive, of course", "negative of course", "natürlich positiv", "natürlich negativ"],
];

test("a remark doubts a part, or the entry beside it", () => {
  assertRemarks(DOUBTS.map((doubt) => `joint 3: ${doubt}`));
  assertRemarks(DOUBTS.map((doubt) => `${doubt}: joint 3`));
  assertRemarks(DOUBTS.map((doubt) => `0.5 ${doubt}`), BESIDE_ENTRY);
  for (const doubt of DOUBTS) assert.ok(!isRemark(`that is ${doubt}`, ALONE), doubt);
});

const CORRECTIONS = [
  ...["should", "must", "had to", "has to", "have to", "needs to", "muss"].map((must) => `${must} be 4`),
  ...["have", "read", "sein"].map((verb) => `should ${verb} 4`),
  ...["-4", "−.4", "an 8", "a 4", "the opposite", "negative", "positive", "negativ", "minus 4", "plus 4", "reversed"].map((value) => `should be ${value}`),
];

test("a remark says what an entry should be", () => {
  assertRemarks(CORRECTIONS.map((correction) => `joint 3 ${correction}`));
  assertRemarks(CORRECTIONS.map((correction) => `this ${correction}`), BESIDE_ENTRY);
  for (const heading of ["Corrected", "Erratum", "Errata", "Korrektur", "Edit", "Sorry"])
    assertRemarks([`${heading}: joint 3 is 0.5`]);
});

test("a remark takes an answer back or leaves work to do", () => {
  assertRemarks(["do not", "don't"].map((not) => `${not} mark this`));
  assertRemarks(["use", "grade", "count"].map((verb) => `do not ${verb} this`));
  assertRemarks(["not my answer", "not my final answer", "not my own answer", "discarded", "Draft"]);
  assertRemarks(["ignore", "wrong, ignore", "ignore this.", "ignore these:"]);
  assertRemarks(["the gear is still missing", "still to be divided by 2", "to be multiplied by 2", "divide by the gear ratio", "in multiples of pi", "in multiples of π"]);
  const changes = ["added", "subtracted", "multiplied", "divided", "doubled", "halved", "negated", "flipped", "swapped", "exchanged"];
  assertRemarks(changes.map((change) => `d_2 must be ${change}`));
  assertRemarks(["should", "had to", "has to", "have to", "need to", "needs to", "still"].map((must) => `0.05 ${must} be added`));
});

test("a remark leaves solutions out", () => {
  const reasons = ["do not reach", "does not reach", "dropped", "rejected", "left out", "invalid", "is not valid", "are not valid"];
  assertRemarks(reasons.map((reason) => `Solution 3: ${reason}`));
  const subjects = ["Solutions", "Branch", "Branches", "Answer", "Answers", "Row", "Rows", "No.", "Nos"];
  assertRemarks(subjects.map((subject) => `${subject} 3 dropped`));
  assertRemarks(["first", "the first", "last", "row", "rows", "solution", "solutions"].map((few) => `only ${few} 2 are my answer`));
  assertRemarks(["only the first 2 is my answer"]);
});

test("marks beside an entry take it back", () => {
  assertRemarks(["0.5 ✗", "0.5 ✘", "0.5 ❌", "not 0.5"], BESIDE_ENTRY);
  assertRemarks(["no", "non", "nein", "rather", "actually"].map((word) => `0.5 (${word} 0.6)`), BESIDE_ENTRY);
});

test("questions, comments and older answers are no remarks", () => {
  for (const line of ["joint 3 wrong?", "is joint 3 right? wrong", "# joint 3 is wrong", "% joint 3 is wrong", "// joint 3 is wrong", "old: joint 3 is wrong"])
    assert.ok(!isRemark(line, ALONE), line);
  assert.ok(!isRemark("0.5 is not the same as 0.6", BESIDE_ENTRY));
});
