// Computes with the explorer's JavaScript what tests/test_explorer.py compares with Python: a line of JSON in, a
// line of JSON out, until nobody asks.

import { createInterface } from "node:readline";
import { computeHoldingTorques, jacobianColumns, movingRows, linkFrames, frameMatrix, computeWrenchTorques } from "../judge/geometry/kinematics.js";
import { findClosedForm, needsPose, solveInverse } from "../judge/geometry/inverse.js";
import { determinant, decomposeSingular } from "../judge/geometry/linear.js";
import { findFadingDirections } from "../page/src/dragging.js";
import { parseFragment } from "../page/src/link.js";
import { findBranches } from "../page/src/motion.js";
import { simulateCircle, computeTorquesAlong, traceCircle } from "../page/src/homework_run.js";
import { makeInitialState, Store } from "../page/src/state.js";
import { formatTable } from "../page/src/text.js";
import { describeRank, describeTable, describeBranches } from "../page/src/statements.js";

const VIEWS = ["table", "pose", "jacobian", "homework", "trace", "torque", "branches"];

function computeNumbers(arm, q, wrench) {
  const frames = linkFrames(arm, q);
  const columns = jacobianColumns(arm, frames);
  return {
    frames: frames.map(frameMatrix), columns, gravity: computeHoldingTorques(arm, frames), push: computeWrenchTorques(columns, wrench),
    values: decomposeSingular(columns).values, determinant: determinant(columns),
  };
}

function describeRankAt(arm, q) {
  const { derived } = new Store(makeInitialState({ arm, q }));
  return { rank: derived.rank, said: describeRank(derived) };
}

function describePose(arm, q) {
  const branches = findBranches(arm, q);
  return { ...describeRankAt(arm, q), ways: branches, counted: describeBranches(arm, branches) };
}

// Return the state that a link opens, the tip's pose, the message about the table, energy and gravity.
function openLink(fragment, arms) {
  const { patch, message } = parseFragment(fragment, arms, VIEWS);
  const { frames, potentialEnergy, gravityTorques } = new Store(makeInitialState(patch)).derived;
  const pose = frameMatrix(frames.at(-1));
  const table = describeTable(patch, { frames });
  return { patch, words: message, pose, table, energy: potentialEnergy, gravity: gravityTorques };
}

// Return the message that compares a typed table with its reference.
function compareTables(arm, reference) {
  const q = movingRows(arm).map(() => 0);
  return describeTable({ arm, reference, q }, { frames: linkFrames(arm, q) });
}

// Return the solutions for the poses of joint values: their names, multiplicities and free joints.
function solveForPoses(arm, qs) {
  const form = findClosedForm(arm);
  return qs.map((q) => {
    const tip = linkFrames(arm, q).at(-1);
    return solveInverse(arm, form, needsPose(form) ? tip : tip.o);
  });
}

const jobs = {
  solutions: ({ arm, qs }) => solveForPoses(arm, qs),
  numbers: ({ arm, qs, wrench }) => qs.map((q) => computeNumbers(arm, q, wrench)),
  circle: ({ arm, q, ...circle }) => traceCircle(arm, q, circle),
  ways: ({ arm, q }) => findBranches(arm, q).list.map((branch) => branch.q),
  ranks: ({ arm, qs }) => qs.map((q) => describeRankAt(arm, q)),
  verdicts: ({ arm, qs }) => qs.map((q) => describePose(arm, q)),
  runs: ({ arm, start, runs }) => runs.map((run) => simulateCircle(arm, start, run)),
  torques: ({ arm, path, wrench }) => computeTorquesAlong(arm, path, wrench),
  fading: ({ arm, qs, turns }) => qs.map((q) => findFadingDirections(jacobianColumns(arm, linkFrames(arm, q)), turns)),
  tables: ({ pairs }) => pairs.map((pair) => compareTables(...pair)),
  links: ({ arms, fragments }) => fragments.map((fragment) => openLink(fragment, arms)),
  copied: ({ arm }) => formatTable(arm),
};

for await (const line of createInterface({ input: process.stdin })) {
  const { job, ...question } = JSON.parse(line);
  process.stdout.write(`${JSON.stringify(jobs[job](question))}\n`);
}
