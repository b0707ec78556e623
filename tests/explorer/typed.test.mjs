// The typed texts of tests/cases.json that one module of judge/reading decides, and the errors of a
// field.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { readEntry, unfinished } from "../../judge/reading/entry.js";
import { formulaSlack, isNumber, number, parse, plain, simple, symbolsIn } from "../../judge/reading/formula.js";
import { readJointVectors } from "../../judge/reading/joint_vectors.js";
import { listGivenRows, numbers, readConfiguration } from "../../judge/reading/numbers.js";
import { SpannedText } from "../../judge/reading/spans.js";
import { readTables } from "../../judge/reading/table.js";
import { listDefinitions } from "../../judge/reading/table_definitions.js";
import { findOtherUnit, readUnits } from "../../judge/reading/units.js";
import { readSymbolValues } from "../../judge/reading/values.js";
import { judgeWholeOrBeginning } from "../../judge/topics/beginning.js";
import { formatEntry } from "../../page/src/text.js";

const CASES = JSON.parse(readFileSync(new URL("../cases.json", import.meta.url), "utf8"));
const KINDS = { R: "revolute", P: "prismatic", F: "fixed" };
const makeArm = (kinds) => ({ name: "arm", rows: [...kinds].map((letter) => ({ kind: KINDS[letter] })) });
const isNear = (x, y, within = 1e-9) => Math.abs(x - y) <= within * Math.max(1, Math.abs(y));
const round = (x, digits) => Number(x.toFixed(digits)) || 0;

// Check every case of a list in cases.json; a case that fails is named by its text.
const testEach = (list, title, check) =>
  test(title, () => {
    for (const entry of CASES[list])
      try {
        check(entry);
      } catch (error) {
        error.message = `${JSON.stringify(entry.text)}: ${error.message}`;
        throw error;
      }
  });

testEach("entries", "a field, a formula and a table read the same angle", ({ text, quantity, unit, value }) => {
  const entry = readEntry(text, quantity, unit);
  if (value === null) {
    assert.ok(entry.error.length > 10);
    assert.ok(!("value" in entry));
    return;
  }
  assert.ok(isNear(entry.value, value, 1e-12));
  const other = quantity === "angle" && readEntry(text, "angle", unit === "deg" ? "rad" : "deg");
  if (other?.value !== value || text === "0") return; // a number without unit has the unit of its field
  assert.ok(isNear(number(text), value, 1e-12));
  const [table] = readTables(`a\talpha\td\ttheta\n0\t${text}\t0.5\tq1\n0.4\t0\t0\tq2`);
  assert.ok(isNear(table.rows[0].numbers.alpha, value, 1e-12));
});

testEach("numbers", "formulas have values, other texts have none", ({ text, value }) => {
  const read = number(text);
  assert.ok(value === null ? read === null : read !== null && isNear(read, value), String(read));
});

testEach("symbols", "symbols are read in each spelling", ({ text, names }) => assert.deepEqual(symbolsIn(text), names));

// Among other numbers, decimals with two places or fewer are exact, as those of 0.5*cos(0.3). x is
// 3.
testEach("decimals", "typed decimals give a formula its round-off", ({ text, round_off: expected }) =>
  assert.ok(Math.abs(formulaSlack(parse(text), () => 3) - expected) <= 1e-4 * expected),
);

testEach("units", "a unit is read in each of its spellings", ({ text, other, ...units }) => {
  for (const [quantity, unit] of Object.entries(units)) assert.equal(readUnits(text)[quantity], unit);
  if (other !== undefined) assert.equal(Boolean(findOtherUnit(text)), other);
});

testEach("definitions", "each spelling defines a length unless the text changes it", ({ text, lengths }) => {
  const definitions = listDefinitions(new SpannedText(text));
  assert.deepEqual(Object.fromEntries(definitions.map(({ name, length }) => [name, round(length, 4)])), lengths);
});

testEach("vectors", "joint vectors are read in each layout", ({ text, kinds = "RRR", values, taken, options = {} }) => {
  const read = () => readJointVectors(text, makeArm(kinds), options.angles ?? "rad", options);
  if (!values) return assert.throws(read, /expected|several answers|two values|no list/);
  const { answers, taken: notes } = read();
  assert.deepEqual(answers.map((answer) => answer.values.map((x) => round(x, 3))), values);
  if (taken) assert.deepEqual(notes, taken);
});

test("a formatted entry is read back unchanged", () => {
  for (const value of [0, Math.PI / 2, -Math.PI, (3 * Math.PI) / 4, -Math.PI / 12, 0.25, 1.234567])
    for (const unit of ["deg", "rad"])
      assert.ok(isNear(readEntry(formatEntry(value, true, unit), "angle", unit).value, value, 1e-6));
});

test("the error says why a text is no entry", () => {
  const errors = {
    "5 N": /has the unit N; a length/, "90°": /has the unit °/, " ": /is empty/, ninety: /“ninety” is no number; write metres/, "0.3 + L": /is no number/,
    "1/0": /divides by zero/, "101": /too large for a length/, ["9".repeat(201)]: /has 201 characters/,
  }; // prettier-ignore
  for (const [text, error] of Object.entries(errors)) assert.match(readEntry(text, "length").error, error, text);
  assert.throws(() => parse("  ", "d"), /d is empty/);
});

test("the beginning of an entry is unfinished", () => {
  for (const text of ["", " ", "-", "2*", "sin(", "1e", "p", "360", "0,3,"]) assert.ok(unfinished(text), text);
  for (const text of ["9o", "ninety", "1 2 x"]) assert.ok(!unfinished(text), text);
});

test("too long or too deep formulas are no numbers", () => {
  for (const text of ["1+".repeat(10001) + "1", "(".repeat(70) + "1" + ")".repeat(70), "sin ".repeat(70) + "1"])
    assert.equal(number(text), null);
});

test("numbers and names in plain characters are recognized", () => {
  for (const text of [".5", "5.", "-0.5", "+1e-3"]) assert.ok(isNumber(text), text);
  for (const text of ["1e", "x", "0,5", "1+2", ""]) assert.ok(!isNumber(text), text);
  assert.equal(plain("c_{2+3}*2"), "c_{2+3}*2");
  for (const name of ["\\theta_{1}", "theta_1'", "Theta 1"]) assert.equal(simple(name), "theta1", name);
});

test("a target's rows of numbers are listed", () => {
  const pose = [[1, 0, 0, 0.1], [0, 1, 0, 0.2], [0, 0, 1, 0.3]]; // prettier-ignore
  assert.deepEqual(listGivenRows(pose), [...pose, [0.1, 0.2, 0.3]]);
  for (const rows of [pose.slice(0, 2), pose.map((row) => row.slice(0, 3)), [[0.1, 0.2, 0.3]]]) assert.deepEqual(listGivenRows(rows), rows);
  assert.deepEqual(listGivenRows([0.1, 0.2, 0.3]), [[0.1, 0.2, 0.3]]);
  for (const none of ["above the table", undefined, [0.1, "x"]]) assert.deepEqual(listGivenRows(none), []);
});

test("far too long lists are not tried as parts", () => {
  const isPartTried = (length) => {
    let isTried = false;
    const text = Array.from({ length }, (_, k) => `0.${k + 10}`).join(" ");
    const read = () => numbers(text, "tau", undefined, undefined, { wants: [{ rows: 1, columns: 7 }] });
    assert.throws(() => judgeWholeOrBeginning(text, read, { listBeginnings: () => ((isTried = true), []) }), /expected: 7 numbers/);
    return isTried;
  };
  assert.ok(isPartTried(70));
  assert.ok(!isPartTried(71)); // each part of 3 200 numbers would take a second
});

test("single values with two indices are a matrix", () => {
  const read = (text, rows) => numbers(text, "J", undefined, undefined, { wants: [{ rows, columns: 2 }] }).values;
  assert.deepEqual(read("J[1,1] = 0.5\nJ[1,2] = 0.6\nJ[2,1] = 0.7\nJ[2,2] = 0.8", 2), [0.5, 0.6, 0.7, 0.8]);
  assert.deepEqual(read("J(0,1) = 0.5\nJ(0,0) = 0.6", 1), [0.6, 0.5]);
  for (const last of ["", "\nJ[2,1] = 0.8"]) // one entry is missing, or one is given twice
    assert.throws(() => read(`J[1,1] = 0.5\nJ[1,2] = 0.6\nJ[2,1] = 0.7${last}`, 2), /expected/);
  const request = { wants: [{ rows: 3, columns: 1 }], names: /^tau/ };
  assert.throws(() => numbers("i deg N\n1 1.5 5\n2 2.5 6\n3 3.5 7", "tau", undefined, undefined, request), /expected/);
});

test("the last typed places of a vector are its units", () => {
  const { answers } = readJointVectors("10.5° 20.55° 0.4", makeArm("RRP"), "rad");
  assert.deepEqual(answers[0].units.map((unit) => Number(unit.toPrecision(3))), [0.00175, 0.000175, 0.1]);
});

test("a configuration is one vector", () => {
  const read = (q, kinds, angles) => readConfiguration(q, makeArm(kinds), angles);
  const A = [0.1, 0.2, 0.3];
  for (const q of [A, [A], [[0.1], [0.2], [0.3]], "0.1 0.2 0.3"]) assert.deepEqual(read(q, "RRR").values, A);
  for (const q of [[0.1, 0, 0.3], "0.1 0 0.3", [0.1, 0.3]]) assert.deepEqual(read(q, "RFR").values, [0.1, 0.3]);
  assert.deepEqual(read([0.1, 0, 0.3], "RFR").locked, ["all joints; 2 is locked, so its 0 is set aside"]);
  assert.match(read([0.1, 1, 2, 3, 4, 0.3], "RFFFFR").locked[0], /2, 3, 4 and 5 .* 1, 2, 3, … /);
  assert.equal(read("90", "R", "deg").values[0], Math.PI / 2);
  for (const [q, kinds] of [[[...A, 0.4], "RRR"], [[0.1, 0.2], "RRR"], [[[0.1, 0, 0.3], [0.1, 0, 0.3]], "RFR"]]) // prettier-ignore
    assert.throws(() => read(q, kinds), /expected one value for each of q_1/);
  for (const name of ["q", "th", "θ", "sol", "position", "ans", "s", "s1"])
    assert.deepEqual(read(`x = 0.4 0.5 0.6\n${name} = 0.1 0.2 0.3`, "RRR").values, A, name);
});

test("names and their numbers are read", () => {
  const values = {
    "h = 0.5, phi_0 = 1/4": [["h", 0.5], ["phi_0", 0.25]],
    "{'h': 0.5, \"L_1\": 2}": [["h", 0.5], ["L_1", 2]],
    "a=1; b=2\nc: 3,": [["a", 1], ["b", 2], ["c", 3]],
    "": [],
  }; // prettier-ignore
  for (const [text, expected] of Object.entries(values)) assert.deepEqual(readSymbolValues(text), expected);
  for (const text of ["h", "h =", "h = x", "h = 1 = 2", "1h = 2", "h = 1/0"]) assert.throws(() => readSymbolValues(text), /is not read/, text);
});
