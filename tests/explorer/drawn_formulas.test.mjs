// Matrices and lists as SymPy draws them over several lines, and what is refused of them.

import assert from "node:assert/strict";
import { test } from "node:test";
import { numbers } from "../../judge/reading/numbers.js";
import { ArmError } from "../../judge/sentences.js";

const [PI, ROOT2, ROOT3] = [Math.PI, Math.SQRT2, Math.sqrt(3)];

function checkText(lines, expected) {
  const read = () => numbers(lines.join("\n"), "q", () => new Map([["x", 2]]));
  if (!expected) return assert.throws(read, ArmError, lines.join("\n"));
  const actual = read().values;
  assert.equal(actual.length, expected.length, lines.join("\n"));
  expected.forEach((x, i) =>
    assert.ok(Math.abs(x - actual[i]) < 1e-9, `${lines.join("\n")}: ${actual}`),
  );
}

test("SymPy's drawn matrices and lists keep their values", () => {
  const both = [ROOT2 / 2, PI / 3, -PI / 4, 0.25, 0.5, ROOT3];
  const cases = [
    [
      [
        "⎡√2    π   -π ⎤",
        "⎢──    ─   ───⎥",
        "⎢2     3    4 ⎥",
        "⎢             ⎥",
        "⎣1/4  0.5  √3 ⎦",
      ],
      both,
    ],
    [
      [
        "[  ___            ]",
        "[\\/ 2   pi   -pi  ]",
        "[-----  --   ---- ]",
        "[  2    3     4   ]",
        "[                 ]",
        "[              ___]",
        "[ 1/4   0.5  \\/ 3 ]",
      ],
      both,
    ],
    [
      ["⎡π          ⎤", "⎢─  0.2  0.3⎥", "⎣3          ⎦"],
      [PI / 3, 0.2, 0.3],
    ],
    [
      ["[pi          ]", "[--  0.2  0.3]", "[3           ]"],
      [PI / 3, 0.2, 0.3],
    ],
    [
      ["⎡π ⎤", "⎢─ ⎥", "⎢3 ⎥", "⎢  ⎥", "⎢√2⎥", "⎢──⎥", "⎣2 ⎦"],
      [PI / 3, ROOT2 / 2],
    ],
    [
      ["[ pi  ]", "[ --  ]", "[ 3   ]", "[     ]", "[  ___]", "[\\/ 2 ]", "[-----]", "[  2  ]"],
      [PI / 3, ROOT2 / 2],
    ],
    [
      ["⎡π       -√2 ⎤", "⎢─, 0.2, ────⎥", "⎣3        2  ⎦"],
      [PI / 3, 0.2, -ROOT2 / 2],
    ],
    [
      ["             ___  ", " pi       -\\/ 2   ", "[--, 0.2, -------]", " 3           2    "],
      [PI / 3, 0.2, -ROOT2 / 2],
    ],
    [["  ___", "╲╱ 2 "], [ROOT2]],
    [
      ["q1  q2", "--  --", "1   2"],
      [1, 2],
    ], // headers above a rule
    [
      ["pi    0.5 ", "----  ----", "2     0.25"],
      [PI, 0.5, 2, 0.25],
    ], // a rule between rows
    [
      ["⎡0.1  0.2⎤", "⎣0.3  0.4⎦", "in rad"],
      [0.1, 0.2, 0.3, 0.4],
    ], // 0.4 is no power of the word below
    [
      ["is a matrix", "⎡pi  0.2⎤", "⎣0.3  1 ⎦"],
      [PI, 0.2, 0.3, 1],
    ], // the word above pi is no power
  ];
  for (const each of cases) checkText(...each);
});

test("another drawn formula is refused", () => {
  const cases = [
    ["⎡3 ___   ⎤", "⎢╲╱ 2   1⎥", "⎢        ⎥", "⎣  0    2⎦"],
    ["[3 ___   ]", "[\\/ 2   1]", "[        ]", "[  0    2]"],
    ["⎡ 2   ⎤", "⎢x   1⎥", "⎢     ⎥", "⎣1   1⎦"],
    ["[3 ___   ]", "[\\/ 2   1]"],
    ["[       ___  ]", "[0.2  \\/ x   1]"],
    ["⎡  ____    ⎤", "⎢╲╱ 2x   1⎥", "⎣          ⎦"],
    ["⎡3 ___⎤", "⎢╲╱ 2 ⎥", "⎢     ⎥", "⎣  1  ⎦"],
    ["⎡1.5    ⎤", "⎢───  1 ⎥", "⎣ 2     ⎦"],
    ["⎡ π     ⎤", "⎢───  1 ⎥", "⎣0.5    ⎦"],
    ["⎡√2    π", "⎢──    ─", "⎢2     3", "⎢", "⎣1/4  0.5", "", "  0.1⎤", "     ⎥", "     ⎥", "  0.2⎦"], // cut
    ["⎡√2  ⎤ ⎡  π⎤", "⎢── 0⎥⋅⎢0 ─⎥", "⎣2   ⎦ ⎣  3⎦"],
    ["⎡√2  1⎤", "⎢──   ⎥", "⎣2    ⎦"],
    ["⎡√2   ⎤", "⎢──   ⎥", "⎣2   1⎦"],
    ["[x      ___ ]", "[--,  \\/ 2 ]", "[2         ]"],
    ["  ___", "\\/ 25"],
  ];
  for (const lines of cases) checkText(lines, null);
});
