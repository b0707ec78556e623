// Corrections of a pasted text, marks on its numbers, the grid of numbers, and stored questions.

import assert from "node:assert/strict";
import { test } from "node:test";
import { commentLines, putBehindHash, replaceSpan } from "../../page/src/check/corrections.js";
import { includeSign, includeWord, listMarks } from "../../judge/marks.js";
import { compareTables } from "../../judge/topics/table.js";
import { splitNumbers } from "../../page/src/check/number_grid.js";
import { EMPTY, findQuestionFault } from "../../page/src/check/question.js";

const spanOf = (text, word) => ({ from: text.indexOf(word), to: text.indexOf(word) + word.length });

test("a span includes a sign but no subtraction", () => {
  const signOf = (text, digits) => {
    const { from, to } = includeSign(text, spanOf(text, digits));
    return text.slice(from, to);
  };
  assert.deepEqual(
    [signOf("| -1.5 |", "1.5"), signOf("(−1.5", "1.5"), signOf("2-1.5", "1.5")],
    ["-1.5", "−1.5", "1.5"],
  );
});

test("a word ends at blanks and separators", () => {
  const text = "| 2 | **7.67l2**, 3";
  const { from, to } = includeWord(text, spanOf(text, "7.67"));
  assert.equal(text.slice(from, to), "**7.67l2**");
});

test("a single number in a line becomes a comment", () => {
  const text = "1.5\n99\n2.5";
  assert.equal(putBehindHash(text, spanOf(text, "99")), "1.5\n# 99\n2.5");
});

test("one number of several moves behind a hash", () => {
  const text = "1.5 99 2.5\n3 4 5";
  const once = putBehindHash(text, spanOf(text, "99 "));
  assert.equal(once, "1.5 2.5  # 99 \n3 4 5");
  assert.equal(putBehindHash(once, spanOf(once, "2.5")), "1.5   # 99 2.5\n3 4 5");
});

test("a corrected number replaces only its own span", () => {
  const text = "1 2 1";
  assert.equal(replaceSpan(text, { from: 4, to: 5 }, "7"), "1 2 7");
});

test("choosing an answer turns other answers into comments", () => {
  assert.equal(
    commentLines("a\n1 2\n\n3 4", (line) => line < 3),
    "a\n# 1 2\n\n3 4",
  );
});

const ELBOW_ROWS = [[0, Math.PI / 2, 0.5], [0.4, 0, 0], [0.3, 0, 0]].map(([a, alpha, d]) => ({
  kind: "revolute", a, alpha, d, theta: 0,
})); // prettier-ignore

function describeTable(answer) {
  const arm = { name: "Elbow arm", rows: ELBOW_ROWS, home: [0, 0, 0] };
  const verdict = compareTables(answer, arm, {});
  const marks = listMarks({ ...EMPTY, ask: "table", answer }, { verdict, arm, tokens: verdict.tokens });
  return marks.map(({ from, to, kind, isWrong, description }) => [answer.slice(from, to), kind, isWrong, description]);
}

test("each number of a table is entry or label", () => {
  const answer = "i | a | alpha | d | theta\n1 | 0 | pi/2 | 0.5 | q1\n2 | 0.4 | 0 | 0 | q2\n3 | 0.35 | 0 | 0 | q3";
  const marks = describeTable(answer);
  assert.deepEqual(marks.slice(0, 5), [
    ["1", "label", false, "a label: it orders the answer"],
    ["0", "entry", false, "entry of row 1, a, read as 0 m"],
    ["2", "entry", false, "entry of row 1, α, read as 90°"],
    ["0.5", "entry", false, "entry of row 1, d, read as 0.5 m"],
    ["1", "label", false, "part of a name, such as q_1"],
  ]);
  const wrong = marks.filter(([, , isWrong]) => isWrong);
  assert.deepEqual(wrong, [["0.35", "entry", true, "entry of row 3, a, read as 0.35 m, wrong"]]);
});

test("numbers of a transposed table name rows of joints", () => {
  const marks = describeTable("theta | q1 | q2 | q3\nd | 0.5 | 0 | 0\na | 0 | 0.4 | 0.3\nalpha | 90 | 0 | 0");
  const twist = marks.find(([text]) => text === "90");
  const length = marks.find(([text]) => text === "0.3");
  assert.equal(twist[3], "entry of row 1, α, read as 90°");
  assert.equal(length[3], "entry of row 3, a, read as 0.3 m");
});

const wrongIn = (marks) =>
  marks.filter(([, , isWrong]) => isWrong).map(([text, , , description]) => [text, description]);

test("numbers of link matrices name their entries", () => {
  const turn = (q, a) =>
    `cos(${q}) -sin(${q}) 0 ${a}*cos(${q})\nsin(${q}) cos(${q}) 0 ${a}*sin(${q})\n0 0 1 0\n0 0 0 1`;
  const first = "cos(q1) 0 sin(q1) 0\nsin(q1) 0 -cos(q1) 0\n0 1 0 0.5\n0 0 0 1";
  const marks = describeTable([first, turn("q2", 0.4), turn("q3", 0.35)].join("\n\n"));
  assert.equal(marks[0][3], "part of a name, such as q_1");
  assert.equal(marks[1][3], "entry of A_1, row 1, column 2");
  assert.equal(marks.find(([text]) => text === "0.5")[3], "entry of A_1, row 3, column 4, gives d = 0.5 m");
  assert.deepEqual(wrongIn(marks), [
    ["0.35", "entry of A_3, row 1, column 4, gives a = 0.35 m, wrong"],
    ["0.35", "entry of A_3, row 2, column 4, gives a = 0.35 m, wrong"],
  ]);
});

test("only lists of plain numbers become a grid", () => {
  assert.deepEqual(splitNumbers(" [0.5, −pi/2; 3] "), ["0.5", "−pi/2", "3"]);
  assert.deepEqual(splitNumbers(""), []);
  for (const text of ["q1 = 0.5", "| 1 | 2 |", "np.array([1, 2])"]) assert.equal(splitNumbers(text), null, text);
});

test("a stored question with an unknown arm or field is refused", () => {
  assert.equal(findQuestionFault({ ...EMPTY, arm: "PANDA" }, ["PANDA"]), "");
  for (const change of [{ arm: "GONE" }, { ask: "x" }, { unit: "gon" }, { frame: "a" }, { more: "1" }, { q: 3 }])
    assert.notEqual(findQuestionFault({ ...EMPTY, arm: "PANDA", ...change }, ["PANDA"]), "");
});
