// Check joint angles, of one pose or all branches, and trajectories along a circle.

import { movingRows } from "../../../../judge/geometry/kinematics.js";
import { compareBranches } from "../../../../judge/topics/branches.js";
import { numbers, readConfiguration } from "../../../../judge/reading/numbers.js";
import { needsPose, findClosedForm } from "../../../../judge/geometry/inverse.js";
import { orthonormalize } from "../../../../judge/geometry/target.js";
import { circleBelow, restToRest } from "../../../../judge/geometry/path.js";
import { comparePose, readTarget } from "../../../../judge/topics/pose.js";
import { ArmError } from "../../../../judge/sentences.js";
import { compareTrace, readTrace } from "../../../../judge/topics/trace.js";

/** @typedef {import("../question.js").Question} Question */

// with fewer steps, a trajectory that stays at the start would pass
const [MIN_STEPS, MAX_STEPS] = [8, 20_000];

/** @type {import("../question.js").Checker} */
export const checkPose = (question, arm) =>
  comparePose(question.answer, arm, requireTarget(question), { angles: question.unit });

function requireTarget({ target }) {
  if (!target.trim())
    throw new ArmError("Say where the tip should be: a point x, y, z in m, or a pose.");
  return target;
}

/** @type {import("../question.js").Checker} */
export function checkBranches(question, arm) {
  const target = prepareTarget(question, arm, requireForm(arm));
  return compareBranches(question.answer, arm, target, { angles: question.unit });
}

function requireForm(arm) {
  const form = findClosedForm(arm);
  if (form) return form;
  throw new ArmError(
    `${arm.name}: there is no formula for all of its branches here; ` +
      "ask “Joint angles for one pose” instead",
  );
}

// Return the target for inverse kinematics: three coordinates, or the four rows of a pose.
/** @param {Question} question @returns {number[] | number[][]} */
function prepareTarget(question, arm, form) {
  const { values, pose } = readTarget(requireTarget(question), arm, undefined, !needsPose(form));
  if (needsPose(form)) return [...orthonormalize(values), [0, 0, 0, 1]];
  return pose ? values.map((row) => row[3]) : values[0];
}

/** @type {import("../question.js").Checker} */
export function checkTrace(question, arm) {
  const path = makePath(question, arm, readTrace(question.answer, arm));
  const verdict = compareTrace(question.answer, arm, path, { angles: question.unit });
  const wanted = path.times.map(path.position); // for the picture
  return { ...verdict, figures: { ...verdict.figures, wanted } };
}

function makePath(question, arm, typed) {
  const path = circleBelow(arm, readCircle(question, arm, typed));
  return question.pace === "rest" ? restToRest(path) : path;
}

/** @param {Question} question */
function readCircle(question, arm, typed) {
  const above = (key, what, unit) => {
    const { values } = numbers(question[key], what);
    if (values.length === 1 && values[0] > 0) return values[0];
    throw new ArmError(`${what} is “${question[key]}”; expected a number of ${unit} above 0`);
  };
  const steps = question.steps.trim()
    ? above("steps", "the number of steps", "steps")
    : guessSteps(typed, arm);
  if (!Number.isInteger(steps) || steps < MIN_STEPS || steps > MAX_STEPS) {
    const wanted = `a whole number from ${MIN_STEPS} to ${MAX_STEPS}`;
    throw new ArmError(`the number of steps is ${steps}; expected ${wanted}`);
  }
  return {
    start: readConfiguration(question.q, arm, question.unit).values,
    radius: above("radius", "the radius", "m"),
    plane: question.plane,
    period: above("period", "the duration", "s"),
    steps,
  };
}

// Return the number of steps: one less than there are rows of times.
function guessSteps({ shape: [rows, width = 1] }, arm) {
  const dof = movingRows(arm).length;
  const perJoint = width > dof + 1 && rows <= dof + 1;
  return Math.max(1, (perJoint ? width : rows) - 1);
}
