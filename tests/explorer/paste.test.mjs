// Pasted tables without headers; tests/test_pasted_tables.py compares the explorer's reading with
// the others.

import assert from "node:assert/strict";
import { test } from "node:test";
import { readPastedTable } from "../../page/src/paste.js";

test("tables without headers take the shown order", () => {
  const { rows } = readPastedTable("0.2\t1.5\t0.3\tq1\n0.4\t0\td2\t1.5");
  const entries = rows.map(({ kind, a, alpha, d, theta }) => [kind, a, alpha, d, theta]);
  assert.deepEqual(entries, [
    ["revolute", 0.2, 1.5, 0.3, 0],
    ["prismatic", 0.4, 0, 0, 1.5],
  ]);
  const [{ a, d }] = readPastedTable("0.5 30 1 -90").rows; // this row also fits another column order
  assert.deepEqual([a, d], [0.5, 1]);
});

test("single entries are no table, bad tables are refused", () => {
  assert.equal(readPastedTable("0.333"), null);
  assert.equal(readPastedTable("−90°"), null);
  const endless = "0\t0\t1\tq1\n".repeat(17);
  for (const text of ["1\t2\t3", "0\tpi/2\t0.5\t0\n1\t2", "0\tpi/2\t0.5 +\t0", endless])
    assert.match(readPastedTable(text).error, /\w{3}/);
});

test("the reading names order, convention and units", () => {
  const readings = {
    "i,theta,d,a,alpha\n1,q1,300,0,90\n2,q2,0,400,0": "columns θ d a α; the standard convention; lengths in mm; angles in degrees",
    "a_{i-1} & alpha_{i-1} & d & theta\\\\\n0 & 0 & 0.3 & q1\\\\\n0 & pi/2 & 0 & q2": "columns a α d θ; the modified (Craig) convention, turned into the standard one; lengths in m",
  };
  for (const [text, reading] of Object.entries(readings)) assert.equal(readPastedTable(text).reading, reading);
});
