// Tables from a clipboard: one table in the manners of six programs.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { learn } from "../../judge/sentences.js";
import { tableText } from "../../page/src/text.js";
import { readTable } from "../../page/src/paste.js";
import { PANDA, STANFORD } from "./arms.mjs";

learn(JSON.parse(readFileSync(new URL("../../judge/sentences.json", import.meta.url), "utf8")));

const H = Math.PI / 2;
const wanted = [[0, H, 0.5, 0], [0.4, 0, 0, H], [0.3, 0, -0.1, 0]]; // prettier-ignore
const same = (text, unit = "rad") => {
  const table = readTable(text, unit);
  assert.equal(table?.error, undefined, text);
  const rows = table.rows.map((row) => ["a", "alpha", "d", "theta"].map((key) => row[key]));
  rows.forEach((row, i) => row.forEach((v, k) => assert.ok(Math.abs(v - wanted[i][k]) < 1e-12, `${text}\n${rows}`)));
  return table.rows;
};

const TABLES = {
  spreadsheet: "0\tpi/2\t0.5\t0\n0.4\t0\t0\tpi/2\n0.3\t0\t-0.1\t0\n",
  "spreadsheet with heads": "i\ta (m)\tα (rad)\td (m)\tθ (rad)\n1\t0\tπ/2\t0.5\tq1\n2\t0.4\t0\t0\tq2 + π/2\n3\t0.3\t0\t−0.1\tq3",
  "decimal commas": "0\tpi/2\t0,5\t0\n0,4\t0\t0\tpi/2\n0,3\t0\t-0,1\t0",
  CSV: "a,alpha,d,theta\n0,pi/2,0.5,0\n0.4,0,0,pi/2\n0.3,0,-0.1,0",
  MATLAB: "DH = [0 pi/2 0.5 0; 0.4 0 0 pi/2; 0.3 0 -0.1 0];",
  NumPy: "[[0, pi/2, 0.5, 0],\n [0.4, 0, 0, pi/2],\n [0.3, 0, -0.1, 0]]",
  Markdown: "| a | alpha | d | theta |\n|---|---|---|---|\n| 0 | pi/2 | 0.5 | q_1 |\n| 0.4 | 0 | 0 | q_2 + pi/2 |\n| 0.3 | 0 | -0.1 | q_3 |",
  LaTeX: "\\begin{bmatrix} 0 & \\pi/2 & 0.5 & \\theta_1 \\\\ 0.4 & 0 & 0 & \\theta_2 + \\pi/2 \\\\ 0.3 & 0 & -0.1 & 0 \\end{bmatrix}",
};
for (const [name, text] of Object.entries(TABLES)) test(`a table out of ${name}`, () => void same(text));

test("bare angles are in the unit shown", () => void same("0\t90\t0.5\t0\n0.4\t0\t0\t90\n0.3\t0\t-0.1\t0", "deg"));

test("a variable in d makes a joint that slides", () => {
  const { rows } = readTable("0\t0\t0.4\tq1\n0\t0\td2\t0", "rad");
  assert.deepEqual(rows.map((row) => row.kind), ["revolute", "prismatic"]);
});

test("one entry is no table, and what is none is refused in words", () => {
  assert.equal(readTable("0.333", "rad"), null);
  assert.equal(readTable("−90°", "rad"), null);
  for (const text of ["1\t2\t3", "0\tpi/2\t0.5\t0\n1\t2", "0\tpi/2\t0.5 +\t0"]) assert.match(readTable(text, "rad").error, /\w{3}/);
});

test("what is copied is read back", () => {
  for (const arm of [PANDA, STANFORD]) {
    const { rows, error } = readTable(tableText(arm), "deg");
    assert.equal(error, undefined);
    for (const [i, { kind, a, alpha, d, theta }] of arm.rows.entries()) {
      assert.equal(rows[i].kind, kind);
      for (const [key, value] of Object.entries({ a, alpha, d, theta })) assert.ok(Math.abs(rows[i][key] - value) < 1e-8);
    }
  }
});
