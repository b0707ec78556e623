// Improves joint values that nearly reach a target by Newton's method.

import { cross, dot, jacobianColumns, linkFrames, minus, plus } from "./kinematics.js";
import { solveLinear } from "./linear.js";

const VALID = 1e-9; // m and rad: largest pose error of a solution
const FINISHED_FROM = 1e-6; // largest pose error (m, rad) to start from with an exact closed form
const NEARLY_FINISHED_FROM = 1e-2; // the same for axes that meet or are parallel only nearly

/**
 * Return joint values near q that reach the target to 1e-9, or null if there are none.
 * @param {import("./arm.js").Arm} arm
 * @param {boolean} isExact
 * @param {any} target a point or a frame
 * @param {number[]} q
 */
export function finishByNewton(arm, isExact, target, q) {
  const startLimit = isExact ? FINISHED_FROM : NEARLY_FINISHED_FROM;
  let [best, error] = [q, poseError(arm, target, q)];
  for (let k = 0; k < 4; k++) {
    const worst = largest(error);
    if (worst < VALID / 1000 || worst >= startLimit) break;
    const step = newtonStep(arm, best, error);
    if (largest(step) > 0.1) break;
    const trial = best.map((x, i) => x + step[i]);
    const after = poseError(arm, target, trial);
    if (!(largest(after) < worst)) break;
    [best, error] = [trial, after];
  }
  return largest(error) < VALID ? best : null;
}

const largest = (v) => Math.max(...v.map(Math.abs));

// Return J^T (J J^T + k I)^-1 error. The small k keeps the step finite near a singular
// configuration.
function newtonStep(arm, q, error) {
  const columns = jacobianColumns(arm, linkFrames(arm, q)).map((c) => c.slice(0, error.length));
  const normal = error.map((_, i) =>
    error.map((__, j) => columns.reduce((sum, c) => sum + c[i] * c[j], i === j ? 1e-12 : 0)),
  );
  const y = solveLinear(normal, error);
  return columns.map((c) => c.reduce((sum, x, i) => sum + x * y[i], 0));
}

// Return the error from the tip to the target. It holds the position's error (m) and, for a pose,
// the rotation vector's sines. 1 is added to the sines beyond 90°, since the sine of half a turn is
// 0.
function poseError(arm, target, q) {
  const { x, y, z, o } = linkFrames(arm, q).at(-1);
  if (Array.isArray(target)) return minus(target, o);
  const sum = plus(plus(cross(x, target.x), cross(y, target.y)), cross(z, target.z));
  const far = dot(x, target.x) + dot(y, target.y) + dot(z, target.z) < 0 ? 1 : 0;
  return [...minus(target.o, o), ...sum.map((s) => s / 2 + far)];
}
