// Tests what touches the numbers of an answer and would change them.

import assert from "node:assert/strict";
import { test } from "node:test";
import { findComputation } from "../../judge/reading/surroundings.js";

// Find what stands around the entries 0.1 to 0.4 of a text, a row on each line.
function findAround(text) {
  const rows = [];
  for (const { 0: entry, index: from } of text.matchAll(/0\.[1-4]/g)) {
    const line = text.slice(0, from).split("\n").length;
    if (rows.at(-1)?.line !== line) rows.push({ line, cells: [] });
    rows.at(-1).cells.push({ from, to: from + entry.length });
  }
  return findComputation(text, rows);
}
const checkAll = (cases) =>
  cases.forEach(([text, expected]) => assert.equal(findAround(text), expected, text));

test("factors before lists and matrices are found", () => {
  const layouts = [
    ["[", "]"],
    ["[(", ")]"],
    ["\\left[", "\\right]"],
    ["\\bigl[", "\\bigr]"],
    ["\\Big[", "\\Big]"],
    ["\\,[", "\\,]"],
    ["np.array([", "])"],
    ["np.asarray(", ")"],
    ["Matrix([", "])"],
    ["torch.tensor([", "])"],
    ["vector(", ")"],
    ["\\begin{bmatrix}", "\\end{bmatrix}"],
    ["\\begin{array}{cc}", "\\end{array}"],
    ["\\begin{bmatrix}[r]", "\\end{bmatrix}"],
    ["\\left[\\begin{array}{cc} ", " \\end{array}\\right]"],
  ];
  for (const [open, close] of layouts)
    checkAll([
      [`q = ${open}0.1, 0.2${close}`, null],
      [`q = 2*${open}0.1, 0.2${close}`, "2*"],
      [`q = ${open}0.1, 0.2${close}*2`, "*2"],
    ]);
});

test("what stands before a bracket is found", () =>
  checkAll([
    ["q = -[0.1, 0.2]", "-"],
    ["q: \u2212[0.1, 0.2]", "\u2212"],
    ["-[0.1, 0.2]", "-"],
    ["then\n-[0.1, 0.2]", "-"],
    ["(-[0.1, 0.2])", "-"],
    ["- [0.1, 0.2]", null],
    ["3/[0.1, 0.2]", "3/"],
    ["3\\cdot[0.1, 0.2]", "3\\cdot"],
    ["3 \\times [0.1, 0.2]", "3 \\times"],
    ["10⁻³·[0.1, 0.2]", "10⁻³·"],
    ["10⁻¹²·[0.1, 0.2]", "10⁻¹²·"],
    ["π[0.1, 0.2]", "π"],
    ["\\pi[0.1, 0.2]", "\\pi"],
    ["pi [0.1, 0.2]", "pi"],
    ["\\frac{1}{2}[0.1, 0.2]", "\\frac{1}{2}"],
    ["\\frac12[0.1, 0.2]", "\\frac12"],
    ["10^{-3}[0.1, 0.2]", "10^{-3}"],
    ["10⁻³[0.1, 0.2]", "10⁻³"],
    ["q = 2 [0.1, 0.2]", "2"],
    ["q = 1/2 [0.1, 0.2]", "1/2"],
    ["3\\begin{bmatrix}0.1 & 0.2\\end{bmatrix}", "3"],
    ["3 [0.1, 0.2]", null],
    ["J = 1.0e+03 * 0.1 0.2", "1.0e+03 *"],
    ...["inv", "pinv", "transpose", "rad2deg", "np.degrees", "sin", "cos", "tan", "abs"].map(
      (name) => [`${name}([0.1, 0.2])`, name],
    ),
  ]));

test("what stands behind a bracket is found", () =>
  checkAll([
    ["[0.1, 0.2] × 3", "×"],
    ["[0.1, 0.2]·3", "·"],
    ["[0.1, 0.2]\\cdot 3", "\\cdot"],
    ["[0.1, 0.2]\\times 3", "\\times"],
    ["[0.1, 0.2]π", "π"],
    ["[0.1, 0.2]\\pi", "\\pi"],
    ["[0.1, 0.2] pi", "pi"],
    ["[0.1, 0.2]/3", "/3"],
    ["[0.1, 0.2].*L", ".*L"],
    ["[0.1, 0.2]^{-1}", "^{-"],
    ["[0.1, 0.2]*pi/180", null],
    ["[0.1, 0.2]*np.pi/180", null],
    ["[0.1, 0.2] N m", null],
  ]));

test("lists and rows may be transposed, matrices not", () => {
  for (const mark of ["'", ".T", ".transpose", "ᵀ", "^T", "^{T", "^\\top"]) {
    checkAll([
      [`[0.1, 0.2]${mark}`, null],
      [`[[0.1],\n[0.2]]${mark}`, null],
      [`[[0.1, 0.2],\n[0.3, 0.4]]${mark}`, mark],
    ]);
  }
  for (const mark of ["'", ".T", "^T"]) checkAll([[`[0.1, 0.2]${mark}\n[0.3, 0.4]${mark}`, null]]); // each row is a column of the matrix
});
