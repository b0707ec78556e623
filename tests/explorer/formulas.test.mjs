// Formulas as people type them, and values that a text repeats in radians and in degrees.

import assert from "node:assert/strict";
import { test } from "node:test";
import { formulaSlack, isNumber, number, parse, plain, simple, symbolsIn } from "../../judge/reading/formula.js";
import { listGivenRows, lookup, numbers, unnamed } from "../../judge/reading/numbers.js";
import { withoutRepeatedUnits } from "../../judge/reading/repetitions.js";
import { SpannedText } from "../../judge/reading/spans.js";
import { ArmError } from "../../judge/sentences.js";

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

test("degrees replace the equal value in radians", () => {
  const read = (text) => withoutRepeatedUnits(new SpannedText(text)).text.replaceAll(/\\,| /g, "");
  for (const _ of [" ", "\\,"])
    for (const unit of ["°", "^°", "^{°}", "deg", "degree", "degrees"])
      for (const rad of ["rad", "radians"]) {
        const [degrees, radians] = [`30${_}${unit}`, `0,5236${_}${rad}`];
        const pairs = [
          `${radians}${_}(${_}≈${_}${degrees}${_})`, `${radians}${_}[${_}=${_}${degrees}${_}]`, `0,5236${_}(${degrees})`,
          `${radians}${_}=${_}${degrees}`, `${radians}${_}/${_}${degrees}`, `${degrees}${_}≈${_}${radians}`, `${degrees}${_}(${_}=${_}${radians}${_})`,
        ];
        for (const pair of pairs) assert.equal(read(`[${pair}; 1]`), `[30${unit};1]`, pair);
      }
  for (const text of ["2(45°)", "2·0.5 rad", "x0.5 rad (28.65°)", "1/0.5 rad (28.65°)"]) assert.equal(read(text), text.replaceAll(" ", ""));
  for (const text of ["0.50 rad (30.65°)", "30.65° = 0.50 rad"]) assert.throws(() => read(text), /30\.65/);
});

test("symbols of an arm have values in each spelling", () => {
  const makeArm = (...kinds) => ({ name: "arm", rows: kinds.map((kind) => ({ kind })), values: [["a_2", 0.4]] });
  const arm = makeArm("revolute", "revolute", "revolute");
  const known = lookup(arm, [0.1, 0.2, 0.3], [["l_pen", 0.05]]);
  const cases = { a_2: 0.4, l_pen: 0.05, c12: Math.cos(0.3), s_23: Math.sin(0.5), "c_{1-2}": Math.cos(0.1), "s_{1-2}": Math.sin(-0.1), C_3: Math.cos(0.3) };
  for (const [name, x] of Object.entries(cases)) assert.ok(known.has(name) && isNear(known([name]).get(name), x), name);
  for (const name of ["q2", "q_2", "th2", "theta_2", "t2", "joint2", "j2", "x2", "d2", "phi_2"]) assert.ok(known.has(name) && known([name]).get(name) === 0.2, name);
  for (const name of ["w", "q123", "b_2"]) assert.ok(!known.has(name), name);
  assert.throws(() => known(["w"]), /w.*a_2/);
  assert.throws(() => known(["b_2"]), /b_2/);
  for (const name of ["q0", "th0", "theta_0"]) assert.throws(() => known([name]), new RegExp(name.replace("0", "1")), name);
  const ofFixed = lookup(makeArm("fixed", "revolute"), [0.1]);
  assert.throws(() => ofFixed(["q3"]), /q3; .* row 1 is fixed$/);
  for (const [lookUp, name] of [[ofFixed, "w"], [known, "q9"]]) assert.throws(() => lookUp([name]), /known are [^.]*$/, name);
});

test("lists from Python are numbers, formulas or refused", () => {
  const read = (list, known = undefined) => numbers(list, "q", known);
  assert.deepEqual(read([[1, "pi/2"], [0.5, "2"]]).values, [1, Math.PI / 2, 0.5, 2]);
  assert.deepEqual(read([[1, 2, 3], [4, 5, 6]]).shape, [2, 3]);
  assert.ok(!read([1]).symbolic && read(["x"], () => new Map([["x", X]])).symbolic);
  assert.deepEqual(read(["1/3", 0.12]).units, [0, 0.01]);
  const refused = [[[[1, 2], [3]], /unequal/], [[[1, 2], [3], [4, 5, 6]], /unequal/], [[null], /NaN/], [["x"], /x has no value here/], [[{ odd: "a matrix" }], /a matrix/], [["1/0"], /finite/]];
  for (const [list, error] of refused) assert.throws(() => read(list), (thrown) => thrown instanceof ArmError && error.test(thrown.message), JSON.stringify(list));
  assert.deepEqual(unnamed([["theta1", 0.3], ["theta2", 0.4]]), [0.3, 0.4]);
  assert.deepEqual(unnamed(["0.3", "0.4"]), ["0.3", "0.4"]);
  assert.equal(unnamed(0.3), 0.3);
});

test("a target's rows of numbers are listed", () => {
  const pose = [[1, 0, 0, 0.1], [0, 1, 0, 0.2], [0, 0, 1, 0.3]];
  assert.deepEqual(listGivenRows(pose), [...pose, [0.1, 0.2, 0.3]]);
  for (const rows of [pose.slice(0, 2), [[1, 0, 0], [0, 1, 0], [0, 0, 1]]]) assert.deepEqual(listGivenRows(rows), rows);
  assert.deepEqual(listGivenRows([0.1, 0.2, 0.3]), [[0.1, 0.2, 0.3]]);
  for (const none of ["above the table", undefined, [0.1, "x"]]) assert.deepEqual(listGivenRows(none), []);
});
