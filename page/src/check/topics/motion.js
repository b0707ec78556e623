// Joint angles, of one pose or all branches, and runs along a path.

import { cross, dot, movingRows } from "../../../../judge/geometry/kinematics.js";
import { compareBranches } from "../../../../judge/topics/branches.js";
import { numbers, pose as poseOf } from "../../../../judge/reading/numbers.js";
import { needsPose, findClosedForm } from "../../../../judge/geometry/inverse.js";
import { circleBelow, restToRest } from "../../../../judge/geometry/path.js";
import { comparePose, readTarget } from "../../../../judge/topics/pose.js";
import { ArmError } from "../../../../judge/sentences.js";
import { judgeTrace, readTrace } from "../../../../judge/topics/trace.js";

/** @typedef {import("../question.js").Question} Question */

// with fewer, a run that stays at the start would pass
const [FEWEST_STEPS, MOST_STEPS] = [8, 20_000];
// of the lengths of axes and their cosines: what a pose of two decimals is off
const ROUNDED = 0.02;

// One joint vector

/** @type {import("../question.js").Checker} */
export const pose = (question, arm) =>
  comparePose(question.answer, arm, typedTarget(question), { angles: question.unit });

function typedTarget({ target }) {
  if (!target.trim())
    throw new ArmError("Say where the tip should be: a point x, y, z in m, or a pose.");
  return target;
}

// All branches

/** @type {import("../question.js").Checker} */
export function branches(question, arm) {
  const target = rowsOf(question, arm, formFor(arm));
  return compareBranches(question.answer, arm, target, { angles: question.unit });
}

function formFor(arm) {
  const form = findClosedForm(arm);
  if (form) return form;
  throw new ArmError(
    `${arm.name}: there is no formula for all of its branches here; ` +
      "ask “Joint angles for one pose” instead",
  );
}

// The target as inverse kinematics take it: three coordinates, or the four rows of a pose.
/** @param {Question} question @returns {any[]} */
function rowsOf(question, arm, form) {
  const { values, pose } = readTarget(typedTarget(question), arm, undefined, !needsPose(form));
  if (needsPose(form)) return [...exact(values), [0, 0, 0, 1]];
  return pose ? values.map((row) => row[3]) : values[0];
}

// A pose typed with a few decimals, its axes made perpendicular and of length 1 again: the nearest
// rotation, by Newton's steps R <- (R + R^-T) / 2. What is farther off stays as it is, and is
// refused.
function exact(rows) {
  const off = (u, v, wanted) => Math.abs(dot(u, v) - wanted);
  let R = rows.map((row) => row.slice(0, 3));
  if (R.some((u, i) => R.some((v, j) => off(u, v, Number(i === j)) > ROUNDED))) return rows;
  for (let step = 0; step < 6; step++) {
    const [a, b, c] = R;
    const size = dot(a, cross(b, c));
    const back = [cross(b, c), cross(c, a), cross(a, b)];
    R = R.map((row, i) => row.map((x, k) => (x + back[i][k] / size) / 2));
  }
  return rows.map((row, i) => [...R[i], row[3]]);
}

// Runs

/** @type {import("../question.js").Checker} */
export function trace(question, arm) {
  const typed = readTrace(question.answer, arm);
  const path = pathOf(question, arm, typed);
  return judgeTrace(typed, arm, path, { angles: question.unit });
}

function pathOf(question, arm, typed) {
  const path = circleBelow(arm, asked(question, arm, typed));
  return question.pace === "rest" ? restToRest(path) : path;
}

/** @param {Question} question */
function asked(question, arm, typed) {
  const above = (key, what, unit) => {
    const { values } = numbers(question[key], what);
    if (values.length === 1 && values[0] > 0) return values[0];
    throw new ArmError(`${what} is “${question[key]}”; expected a number of ${unit} above 0`);
  };
  const steps = question.steps.trim()
    ? above("steps", "the number of steps", "steps")
    : guessed(typed, arm);
  if (!Number.isInteger(steps) || steps < FEWEST_STEPS || steps > MOST_STEPS) {
    const wanted = `a whole number from ${FEWEST_STEPS} to ${MOST_STEPS}`;
    throw new ArmError(`the number of steps is ${steps}; expected ${wanted}`);
  }
  return {
    start: poseOf(question.q, arm, question.unit).values,
    radius: above("radius", "the radius", "m"),
    plane: question.plane,
    period: above("period", "the duration", "s"),
    steps,
  };
}

// A row for each time: one more than there are steps.
function guessed({ shape: [rows, width = 1] }, arm) {
  const dof = movingRows(arm).length;
  const perJoint = width > dof + 1 && rows <= dof + 1;
  return Math.max(1, (perJoint ? width : rows) - 1);
}
