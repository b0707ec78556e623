// Units that a text names for several numbers, each spelling once, and far too long lists.

import assert from "node:assert/strict";
import { test } from "node:test";
import { numbers } from "../../judge/reading/numbers.js";
import { findOtherUnit, readUnits } from "../../judge/reading/units.js";
import { judgeWholeOrBeginning } from "../../judge/topics/beginning.js";

const DEGREES = [
  "q [deg]: 1 2",
  "degrees\n1 2",
  "q1_deg, q2_deg\n1, 2",
  "Winkel (Grad): 1 2",
  "en degrés : 1 2",
  "degres: 1 2",
  "in gradi: 1 2",
  "en grados: 1 2",
  "em graus: 1 2",
  "в градусах: 1 2",
  "角度(度): 1 2",
  "np.radians([1, 2])",
  "deg2rad([1, 2])",
  "rad = deg2rad([1, 2])",
  "[1, 2]*pi/180",
  "[1 2] .* pi/180",
  "[1, 2] * np.pi/180",
];
const LENGTHS = { "d3 (mm)": 1e-3, "in mm:": 1e-3, "d [cm]": 1e-2, "rows in mm/rad": 1e-3 };
const MOMENTS = {
  tau_mNm: 1e-3,
  "[N mm]": 1e-3,
  "in N·mm": 1e-3,
  tau_Ncm: 1e-2,
  "(N cm)": 1e-2,
  tau_kNm: 1e3,
  "kN m": 1e3,
};
const OTHER = [
  "28° 38' 52''",
  "28°38′",
  "q_mrad = 1",
  "5 milliradians",
  "31.8 gon",
  "5 grads",
  "5 gradians",
  "5 arcmin",
  "q in grad: 1",
  "0.08 turns",
  "0.08 revs",
  "0.08 revolutions",
  "in turns: 1",
  "[rev]",
  "(turns)",
  "5 ft-lb",
  "5 lbf ft",
  "5 lb in",
  "5 in-lb",
  "5 kgf m",
  "5 kgf·cm",
  "(×10³) 1 2",
  "[x 10^-3]",
  "(10^-3 Nm) 1 2",
  "×10⁻³: 1 2",
];
const NO_OTHER = [
  "gear of 3 revs",
  "T (rev 2)",
  "2 kg m_1",
  "1.5 × 10^3",
  "gradient 1 2",
  "turn 1",
];

test("a unit is read in each of its spellings", () => {
  for (const text of DEGREES) assert.equal(readUnits(text).angles, "deg", text);
  for (const text of ["q [rad]: 1 2", "radians: 1 2"])
    assert.equal(readUnits(text).angles, "rad", text);
  for (const text of ["1 2", "q [rad] q [deg]", "grad: 1 2", "gradient: 1 2"])
    assert.equal(readUnits(text).angles, null, text);
  for (const [text, factor] of Object.entries(LENGTHS))
    assert.equal(readUnits(text).lengths, factor, text);
  for (const [text, factor] of Object.entries(MOMENTS))
    assert.equal(readUnits(text).moments, factor, text);
  for (const text of ["d = 400 mm", "tau in N m"])
    assert.deepEqual([readUnits(text).lengths, readUnits(text).moments], [null, null], text);
});

test("each spelling of an unconverted unit is found", () => {
  for (const text of OTHER) assert.ok(findOtherUnit(text), text);
  for (const text of NO_OTHER) assert.equal(findOtherUnit(text), null, text);
});

test("far too long lists are not tried as parts", () => {
  const isPartTried = (length) => {
    let isTried = false;
    const wants = [{ rows: 1, columns: 7 }];
    const text = Array.from({ length }, (_, k) => `0.${k + 10}`).join(" ");
    const read = () => numbers(text, "tau", undefined, undefined, { wants });
    assert.throws(() => judgeWholeOrBeginning(text, read, { listBeginnings: () => ((isTried = true), []) }), /expected: 7 numbers/);
    return isTried;
  };
  assert.ok(isPartTried(70));
  assert.ok(!isPartTried(71)); // of 3 200 numbers each part would take a second
});
