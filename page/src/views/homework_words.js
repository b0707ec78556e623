// The homework's runs in words.

import { outside } from "../../../judge/geometry/arm.js";
import { joints } from "../../../judge/geometry/kinematics.js";
import { HOMEWORK } from "../runs.js";
import { fixed, listed } from "../text.js";

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
// wall.
export const startingRun = (arm) =>
  joints(arm).length === 7
    ? { ...HOMEWORK }
    : {
        ...HOMEWORK,
        locked: -1,
        normal: /** @type {"x" | "y"} */ (/UR10e/.test(arm.name) ? "y" : "x"),
        seconds: /UR10e/.test(arm.name) ? 20 : 5,
        rates: /** @type {"pseudo"} */ ("pseudo"),
      };

export function millimetres(v) {
  if (v < 1e-12) return "under 1e−9 mm";
  if (v < 1e-5) return `${(1000 * v).toExponential(1).replace("-", "−")} mm`;
  return `${fixed(1000 * v, v < 1e-2 ? 3 : 1)} mm`;
}
export const named = ({ method, rates, steps, gain, slip }) => {
  const how = method === "exact" ? NAMES.exact : `${NAMES[method]}, ${NAMES[rates]}, N = ${steps}`;
  return how + (gain ? `, gain ${fixed(gain, 1)}` : "") + (slip ? `, ${SLIPS[slip]}` : "");
};

export function said(run, result, arm) {
  if (!result) return "Computing …";
  if (result.failed !== null) {
    return result.failed === 0
      ? "The Jacobian has no inverse where the run starts: the pose is singular. " +
          "Choose the pseudo-inverse or damped rates."
      : `The run breaks at step ${result.failed} of ${run.steps}: no inverse there.`;
  }
  const jointNames = (holds) =>
    joints(arm).flatMap((row, k) => (holds(row, k) ? [`joint ${row + 1}`] : []));
  const winding = jointNames((_, k) => Math.abs(result.wound[k]) > 0.9);
  const past = jointNames((row, k) => result.path.some((q) => outside(arm.rows[row], q[k])));
  const turns = winding.length ? ` Once round: ${listed(winding)}.` : "";
  const limits = past.length ? ` Past its limits: ${listed(past)}.` : "";
  const size =
    result.least < 1e-4 ? result.least.toExponential(1).replace("-", "−") : fixed(result.least, 4);
  const error = `Largest error ${millimetres(result.largest)}`;
  const speed =
    result.run.method === "exact" ? "" : `, fastest joint ${fixed(result.fastest, 2)} rad/s`;
  const tilt =
    result.tilt > 1e-3 ? `, the tool tilts by ${fixed((result.tilt * 180) / Math.PI, 1)}°` : "";
  return `${error}${tilt}${speed}. Smallest σ on the way: ${size}.${turns}${limits}`;
}

export function curveWords(points) {
  const broken = points.filter(({ reached }) => !reached);
  const wound = points.filter(({ turns, reached }) => reached && turns);
  const cm = (one) => `${fixed(100 * one.radius, 1)} cm`;
  const parts = [];
  if (wound.length) parts.push(`a joint winds once round from ${cm(wound[0])} on`);
  if (broken.length) parts.push(`no run from ${cm(broken[0])} to ${cm(broken.at(-1))}`);
  return `Radius from 1 to 10 cm: ${parts.join("; ") || "the joints only swing"}.`;
}
