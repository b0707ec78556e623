// Entries of tests/cases.json: a field, a formula and a table read the same angle.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { number } from "../../judge/reading/formula.js";
import { readEntry, unfinished } from "../../judge/reading/entry.js";
import { readTables } from "../../judge/reading/table.js";
import { formatEntry } from "../../page/src/text.js";

const { entries: ENTRIES } = JSON.parse(readFileSync(new URL("../cases.json", import.meta.url), "utf8"));
const near = (found, wanted) => assert.ok(Math.abs(found - wanted) < 1e-12, `${found}`);

for (const { text, quantity, unit, value } of ENTRIES) {
  test(`${text.slice(0, 20)} as ${quantity}`, () => {
    const found = readEntry(text, quantity, unit);
    if (value === null) {
      assert.ok(found.error.length > 10);
      assert.ok(!("value" in found));
      return;
    }
    near(found.value, value);
    const other = quantity === "angle" && readEntry(text, "angle", unit === "deg" ? "rad" : "deg");
    if (other?.value !== value || text === "0") return; // a bare number, in the unit of its field
    near(number(text), value);
    const [table] = readTables(`a\talpha\td\ttheta\n0\t${text}\t0.5\tq1\n0.4\t0\t0\tq2`);
    near(table.rows[0].numbers.alpha, value);
  });
}

test("a formatted entry is read back unchanged", () => {
  for (const value of [0, Math.PI / 2, -Math.PI, (3 * Math.PI) / 4, -Math.PI / 12, 0.25, 1.234567])
    for (const unit of ["deg", "rad"])
      assert.ok(Math.abs(readEntry(formatEntry(value, true, unit), "angle", unit).value - value) < 1e-6);
});

test("the error says why a text is no entry", () => {
  const errors = {
    "5 N": /has the unit N; a length/, "90°": /has the unit °/, " ": /is empty/, ninety: /“ninety” is no number; write metres/, "0.3 + L": /is no number/,
    "1/0": /divides by zero/, "101": /too large for a length/, ["9".repeat(201)]: /has 201 characters/,
  };
  for (const [text, error] of Object.entries(errors)) assert.match(readEntry(text, "length").error, error, text);
});

test("the beginning of an entry is unfinished", () => {
  for (const text of ["", " ", "-", "2*", "sin(", "1e", "p", "360", "0,3,"]) assert.ok(unfinished(text), text);
  for (const text of ["9o", "ninety", "1 2 x"]) assert.ok(!unfinished(text), text);
});

test("undefined results are no numbers", () => {
  for (const text of ["1/0", "1/(1/0)", "0^-1", "sqrt(-1)", "1e400", "q"]) assert.equal(number(text), null);
});
