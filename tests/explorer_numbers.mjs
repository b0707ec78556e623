// Computes with the explorer's JavaScript what tests/test_explorer.py compares with Python: JSON in, JSON out.

import { readFileSync } from "node:fs";
import { gravityTorque, jacobianColumns, linkFrames, matrix, wrenchTorque } from "../explorer/src/kinematics.js";
import { determinant, singular } from "../explorer/src/linear.js";
import { otherWays, traceCircle } from "../explorer/src/motion.js";
import { entryText, readEntry } from "../explorer/src/text.js";

function numbers(arm, q, wrench) {
  const frames = linkFrames(arm, q);
  const columns = jacobianColumns(arm, frames);
  return {
    frames: frames.map(matrix), columns, gravity: gravityTorque(arm, frames), push: wrenchTorque(columns, wrench),
    values: singular(columns).values, determinant: determinant(columns),
  };
}

const jobs = {
  numbers: ({ arm, qs, wrench }) => qs.map((q) => numbers(arm, q, wrench)),
  circle: ({ arm, q, ...circle }) => traceCircle(arm, q, circle),
  ways: ({ arm, q }) => otherWays(arm, q),
  entries: ({ typed }) => typed.map(([text, angle, unit]) => readEntry(text, angle, unit)),
  written: ({ values }) => values.map(([value, angle, unit]) => entryText(value, angle, unit)),
};

const { job, ...given } = JSON.parse(readFileSync(0, "utf8"));
process.stdout.write(JSON.stringify(jobs[job](given)));
