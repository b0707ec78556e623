// An angle is read alike wherever it stands: in a field, in a formula and in a table.

import assert from "node:assert/strict";
import { test } from "node:test";
import { number } from "../../judge/reading/formula.js";
import { readEntry } from "../../judge/reading/entry.js";
import { read } from "../../judge/reading/table.js";

const H = Math.PI / 2;
const R = Math.PI / 180;
/** @type {[string, number][]} */
const ANGLES = [
  ["pi/2", H], ["-pi/2", -H], ["π/2", H], ["−π/2", -H], ["np.pi/2", H], ["-np.pi / 2", -H], ["math.pi/2", H],
  ["\\frac{\\pi}{2}", H], ["-\\frac{\\pi}{2}", -H], ["\\dfrac\\pi2", H], ["$\\pi/2$", H], ["\\pi", 2 * H], ["pi", 2 * H],
  ["0.5*pi", H], ["0.5pi", H], ["π·0.5", H], ["3π/4", 1.5 * H], ["3*pi/4", 1.5 * H], ["½π", H], ["(pi)/2", H],
  ["90°", H], ["90 °", H], ["-90°", -H], ["90 deg", H], ["90deg", H], ["90 degrees", H], ["90^\\circ", H],
  ["45.5°", 45.5 * R], ["radians(90)", H], ["np.deg2rad(-90)", -H], ["pi/2 + 10°", H + 10 * R], ["1.57 rad", 1.57],
]; // prettier-ignore

for (const [text, wanted] of ANGLES) {
  test(`read alike everywhere: ${text}`, () => {
    const near = (found) => assert.ok(Math.abs(found - wanted) < 1e-12, `${found}`);
    near(number(text));
    for (const unit of ["deg", "rad"]) near(readEntry(text, "angle", unit).value);
    const [table] = read(`a\talpha\td\ttheta\n0\t${text}\t0.5\tq1\n0.4\t0\t0\tq2`);
    near(table.rows[0].numbers.alpha);
  });
}

test("a bare number is in the unit of its field, one with a unit in its own", () => {
  for (const [text, kind, unit, wanted] of [
    ["90", "angle", "deg", H],
    ["1.5", "angle", "rad", 1.5],
    ["333 mm", "length", undefined, 0.333],
    ["0.333", "length", undefined, 0.333],
    ["2 N m", "moment", undefined, 2],
    ["2 kN", "force", undefined, 2000],
  ])
    assert.ok(Math.abs(readEntry(text, kind, unit).value - wanted) < 1e-12, text);
});

test("what cannot be told apart is refused in words", () => {
  for (const [text, kind, words] of [
    ["pi°", "angle", /two units/],
    ["0.1 + 5 mm", "length", /mixes/],
    ["5 N", "length", /has the unit N; a length/],
    ["90°", "length", /has the unit °/],
    ["q1", "angle", /is no number/],
  ])
    assert.match(readEntry(text, kind, "deg").error, words, text);
});
