// Descriptions of the homework's runs.

import { movingRows } from "../../../judge/geometry/kinematics.js";
import { DEFAULT_RUN } from "../homework_run.js";
import { listJointsWhere, listJointsPastLimits } from "../statements.js";
import { formatDegrees, formatFixed, formatScientific } from "../text.js";
import { joinList } from "../../../judge/sentences.js";

/** @typedef {import("../../../judge/geometry/arm.js").Arm} Arm */

export const METHOD_NAMES = {
  euler: "Euler",
  rk4: "Runge-Kutta 4",
  exact: "exact inverse kinematics",
  inverse: "J⁻¹",
  pseudo: "pseudo-inverse",
  damped: "damped",
};
export const MISTAKE_NAMES = {
  "": "none",
  angular: "z_i in the angular rows",
  z_i: "z_i and o_i throughout",
  o_i: "o_i instead of o_i−1",
  sign: "rates with the wrong sign",
  next: "velocity of the next step",
};

/**
 * Return the run that the homework asks of an arm. Null if it asks for none, or if the reader's
 * table has a different number of joints.
 * @param {Arm} arm
 * @param {Arm} base the listed arm whose table was edited
 * @returns {import("../homework_run.js").Run | null}
 */
export function makeStartingRun(arm, base) {
  const hasSameJoints = movingRows(arm).length === movingRows(base).length;
  return base.circle && hasSameJoints ? { ...DEFAULT_RUN, ...base.circle } : null;
}

/**
 * Describe which arms of a list the homework asks for a circle.
 * @param {Arm[]} arms
 */
export function describeCircleArms(arms) {
  const names = arms.filter(({ circle }) => circle).map(({ name }) => `the ${name}`);
  if (!names.length) return "No homework asks this arm for a circle.";
  return `The homework’s circle is drawn by ${joinList(names, "or")}: choose one of them above.`;
}

export function formatMillimetres(v) {
  if (v < 1e-12) return "under 1e−9 mm";
  if (v < 1e-5) return `${formatScientific(1000 * v, 1)} mm`;
  return `${formatFixed(1000 * v, v < 1e-2 ? 3 : 1)} mm`;
}
export const describeRun = ({ method, rates, steps, gain, mistake }) => {
  const how =
    method === "exact"
      ? METHOD_NAMES.exact
      : `${METHOD_NAMES[method]}, ${METHOD_NAMES[rates]}, N = ${steps}`;
  return (
    how +
    (gain ? `, gain ${formatFixed(gain, 1)}` : "") +
    (mistake ? `, ${MISTAKE_NAMES[mistake]}` : "")
  );
};

// Describe why a run ended early.
function describeFailure({ failedStep, isSingular, run }) {
  const where = failedStep ? `at step ${failedStep} of ${run.steps}` : "where the run starts";
  if (isSingular)
    return `J has no inverse ${where}, where the arm is singular: choose another of the rates.`;
  if (run.mistake)
    return `With this mistake the matrix has no inverse ${where}, though the arm could go on.`;
  if (run.method === "exact") return `The circle is out of reach ${where}.`;
  return `The run leaves all bounds ${where}.`;
}

function formatSingularValue(v) {
  if (v < 1e-9) return "0";
  return v < 1e-4 ? formatScientific(v, 1) : formatFixed(v, 4);
}

export function describeResult(result, arm) {
  if (!result) return "Computing …";
  if (result.failedStep !== null) return describeFailure(result);
  const winding = listJointsWhere(arm, (_, k) => Math.abs(result.windings[k]) > 0.9);
  const past = listJointsPastLimits(arm, result.path);
  const turns = winding.length ? ` Once round: ${joinList(winding)}.` : "";
  const limits = past.length ? ` Past its limits: ${joinList(past)}.` : "";
  const error = `Largest error ${formatMillimetres(result.largestError)}`;
  const speed =
    result.run.method === "exact"
      ? ""
      : `, fastest joint ${formatFixed(result.fastestRate, 2)} rad/s`;
  const tilt =
    result.largestTilt > 1e-3 ? `, the tool tilts by ${formatDegrees(result.largestTilt, 1)}` : "";
  const smallest = `Smallest σ on the way: ${formatSingularValue(result.smallestSigma)}.`;
  return `${error}${tilt}${speed}. ${smallest}${turns}${limits}`;
}
