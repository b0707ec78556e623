// The homework's runs in words.

import { movingRows } from "../../../judge/geometry/kinematics.js";
import { HOMEWORK } from "../homework_run.js";
import { jointNames, pastLimits } from "../verdicts.js";
import { degrees, fixed, powered } from "../text.js";
import { joinList } from "../../../judge/sentences.js";

export const NAMES = {
  euler: "Euler",
  rk4: "Runge-Kutta 4",
  exact: "exact inverse kinematics",
  inverse: "J⁻¹",
  pseudo: "pseudo-inverse",
  damped: "damped",
};
export const SLIPS = {
  "": "none",
  angular: "z_i in the angular rows",
  z_i: "z_i and o_i throughout",
  o_i: "o_i instead of o_i−1",
  sign: "rates with the wrong sign",
  next: "velocity of the next step",
};
// What the homework asks of this arm: the Panda with joint 3 locked, the UR10e in front of its
// wall; null where it asks nothing.
export function startingRun(arm, base) {
  if (/^Panda/.test(base.name) && movingRows(arm).length === 7) return { ...HOMEWORK };
  if (!/^UR10e/.test(base.name) || movingRows(arm).length !== 6) return null;
  return { ...HOMEWORK, locked: -1, normal: "y", seconds: 20, rates: "pseudo" };
}

export function millimetres(v) {
  if (v < 1e-12) return "under 1e−9 mm";
  if (v < 1e-5) return `${powered(1000 * v, 1)} mm`;
  return `${fixed(1000 * v, v < 1e-2 ? 3 : 1)} mm`;
}
export const named = ({ method, rates, steps, gain, slip }) => {
  const how = method === "exact" ? NAMES.exact : `${NAMES[method]}, ${NAMES[rates]}, N = ${steps}`;
  return how + (gain ? `, gain ${fixed(gain, 1)}` : "") + (slip ? `, ${SLIPS[slip]}` : "");
};

// Why a run breaks.
function broken({ failed, stuck, run }) {
  const where = failed ? `at step ${failed} of ${run.steps}` : "where the run starts";
  if (stuck)
    return `J has no inverse ${where}, where the arm is singular: choose another of the rates.`;
  if (run.slip)
    return `With this mistake the matrix has no inverse ${where}, though the arm could go on.`;
  if (run.method === "exact") return `The circle is out of reach ${where}.`;
  return `The run leaves all bounds ${where}.`;
}

function sigma(v) {
  if (v < 1e-9) return "0";
  return v < 1e-4 ? powered(v, 1) : fixed(v, 4);
}

export function said(result, arm) {
  if (!result) return "Computing …";
  if (result.failed !== null) return broken(result);
  const winding = jointNames(arm, (_, k) => Math.abs(result.wound[k]) > 0.9);
  const past = pastLimits(arm, result.path);
  const turns = winding.length ? ` Once round: ${joinList(winding)}.` : "";
  const limits = past.length ? ` Past its limits: ${joinList(past)}.` : "";
  const error = `Largest error ${millimetres(result.largest)}`;
  const speed =
    result.run.method === "exact" ? "" : `, fastest joint ${fixed(result.fastest, 2)} rad/s`;
  const tilt = result.tilt > 1e-3 ? `, the tool tilts by ${degrees(result.tilt, 1)}` : "";
  return `${error}${tilt}${speed}. Smallest σ on the way: ${sigma(result.least)}.${turns}${limits}`;
}
