// Formulas as people type them.

import assert from "node:assert/strict";
import { test } from "node:test";
import { formulaSlack, isNumber, number, parse, plain, simple, symbolsIn } from "../../judge/reading/formula.js";
import { listGivenRows } from "../../judge/reading/numbers.js";

const SIN = Math.sin(0.5);
const [COS, TAN] = [Math.cos(0.5), Math.tan(0.5)];
const X = 3; // value of the symbol x

const isNear = (x, y) => Math.abs(x - y) <= 1e-9 * Math.max(1, Math.abs(y));

test("formulas have values, other texts have none", () => {
  const cases = [
    ["2^3", 8], ["10^400", null], ["1/10^400", null], ["(3+2", null], ["3+2)", null], ["2 + *3)", null], ["2+", null], [" ", null],
    ["2^0", 1], ["90^0", null], ["90^1", 90], ["10^0", 1],
    ["sin^2 0.5", SIN ** 2], ["sin^-1 0.5", null], ["sin^(-1) 0.5", null], ["sin -0.5", -SIN], ["sin(0.5)^2", SIN ** 2],
    ["x^0", null], ["x", null], ["1 234.5", null], ["2(3)", 6], ["(1+2)2", 6], ["1+".repeat(10001) + "1", null], ["(".repeat(70) + "1" + ")".repeat(70), null], ["sin ".repeat(70) + "1", null], ["{1+2}*3", 9], ["2^{1+2}", 8], ["\\frac{1}{4}", 0.25],
    ["\\frac{\\sin{0.5}}{2}", SIN / 2], ["\\frac{\\cos{0.5}}{2}", COS / 2], ["\\frac{\\tan{0.5}}{2}", TAN / 2],
    ["\\frac{\\sqrt{2}}{2}", Math.SQRT1_2], ["\\frac{2^{3}}{4}", 2], ["45 degrees", Math.PI / 4], ["45 deg.", Math.PI / 4], ["45^{\\circ}", Math.PI / 4],
  ];
  for (const [text, expected] of cases) {
    const actual = number(text);
    assert.ok(expected === null ? actual === null : actual !== null && isNear(actual, expected), `${text.slice(0, 40)}: ${actual}`);
  }
});

test("numbers in plain characters are recognized", () => {
  for (const text of [".5", "5.", "-0.5", "+1e-3"]) assert.ok(isNumber(text), text);
  for (const text of ["1e", "x", "0,5", "1+2", ""]) assert.ok(!isNumber(text), text);
});

test("an empty text is no formula", () => assert.throws(() => parse("  ", "d"), /d is empty/));

test("symbols are read in each spelling", () => {
  const cases = [
    ["c_1s_23", ["c_1", "s_23"]], ["a_2C_2", ["a_2", "C_2"]], ["q₁q₂", ["q_1", "q_2"]], ["sin^n 0.5", null],
    ["\\theta_1", ["theta_1"]], ["\\vartheta_1", ["theta_1"]], ["\\theta_{1}", ["theta_1"]], ["\\varphi_1", ["phi_1"]], ["x.*2", ["x"]], ["theta(1)", ["theta_1"]], ["theta[2]", ["theta_2"]], ["q(1)", ["q_1"]],
    ["q_1(t)", ["q_1"]], ["\\mathrm{q}_1", ["q_1"]], ["\\textbf{q}_1", ["q_1"]], ["\\boldsymbol{q}_1", ["q_1"]], ["np.cos(x)", ["x"]],
  ];
  for (const [text, expected] of cases) assert.deepEqual(symbolsIn(text), expected, text);
  assert.equal(plain("c_{2+3}*2"), "c_{2+3}*2");
  for (const name of ["\\theta_{1}", "theta_1'", "Theta 1"]) assert.equal(simple(name), "theta1", name);
});

// Among other numbers, decimals with two places or fewer are exact, as those of 0.5*cos(0.3).
test("typed decimals give a formula its round-off", () => {
  const cases = [
    ["0.68*pi", 0.005 * Math.PI], ["2.66*10^-2", 0.00005], ["-0.68", 0.005], ["2*3", 0], ["0.5*cos(0.3)", 0], ["0.68*x", 0],
    ["0.1234*x", 0.00005 * X], ["x*0.1234", 0.00005 * X], ["x/0.1234", (0.00005 * X) / 0.1234 ** 2], ["0.1234-0.2345", 0.0001],
    ["sin(0.1234)", 0.00005 * Math.cos(0.1234)], ["sqrt(0)", 0], ["asin(1)", 0], ["0^(1/2)", 0], ["0.1234^2", 0.0001 * 0.1234],
    ["2.66*10^-2 + 0.1234", 0.0001], ["2.66*2^-4 + 0.1234", 0.00005], ["2.66 + 10^-2 + 0.1234", 0.00005], ["2.66*(10/80) + 0.1234", 0.00005],
  ];
  for (const [text, expected] of cases) {
    const actual = formulaSlack(parse(text), () => X);
    assert.ok(Math.abs(actual - expected) <= 1e-4 * expected, `${text.slice(0, 40)}: ${actual}`);
  }
});

test("a target's rows of numbers are listed", () => {
  const pose = [[1, 0, 0, 0.1], [0, 1, 0, 0.2], [0, 0, 1, 0.3]];
  assert.deepEqual(listGivenRows(pose), [...pose, [0.1, 0.2, 0.3]]);
  for (const rows of [pose.slice(0, 2), [[1, 0, 0], [0, 1, 0], [0, 0, 1]]]) assert.deepEqual(listGivenRows(rows), rows);
  assert.deepEqual(listGivenRows([0.1, 0.2, 0.3]), [[0.1, 0.2, 0.3]]);
  for (const none of ["above the table", undefined, [0.1, "x"]]) assert.deepEqual(listGivenRows(none), []);
});
