// Finds jumps, whole turns, singular configurations, and exceeded ranges and speeds in the steps of
// a typed trajectory.

import { makeCause } from "../causes/ranking.js";
import {
  jacobianColumns,
  jointNumbers,
  linkFrames,
  minus,
  movingRows,
  norm,
  revoluteFlags,
} from "../geometry/kinematics.js";
import { subtractEach, decomposeSingular } from "../geometry/linear.js";
import { roundHalfToEven } from "../geometry/planar.js";
import { formatMessage, formatNumber, joinList } from "../sentences.js";

const ZERO_SHARE = 1e-9; // singular values below this share of the largest count as 0
// rad or m: a larger change in one step, which is also ten times the usual change, is a jump to a
// different branch.
const JUMP = 0.3;

/**
 * List the steps that change a joint by far more than usual. If large steps are usual, these are
 * the steps that leave the path between their ends.
 * @param {number[][]} q joint values of each step (rad or m)
 * @param {import("../geometry/arm.js").Arm} arm
 * @param {import("../geometry/path.js").Path} path
 */
export function findJumps(q, arm, path) {
  const changes = q.slice(1).map((row, k) => Math.max(...subtractEach(row, q[k]).map(Math.abs)));
  const usual = computeMedian(changes);
  const findStepsOver = (limit) => changes.flatMap((x, k) => (x > JUMP && x > limit ? [k] : []));
  const jumps = findStepsOver(10 * usual);
  return jumps.length || usual <= JUMP
    ? jumps
    : findStepsOver(JUMP).filter((k) => leavesPath(q, arm, path, k));
}

// Return whether the tip half way through step k is farther from the path than the step is long.
function leavesPath(q, arm, { times, position }, k) {
  const middle = q[k].map((x, i) => (x + q[k + 1][i]) / 2);
  const expected = position(times[k] + 0.5 * (times[k + 1] - times[k]));
  const error = norm(minus(linkFrames(arm, middle).at(-1).o, expected));
  return error > norm(minus(position(times[k + 1]), position(times[k])));
}

// Remove jumps by whole turns, as atan2 makes them, and note it. If further jumps remain, nothing
// is changed.
/** @returns {[number[][], string[]]} the joint values and the notes */
export function removeWholeTurns(q, arm, path) {
  const isRevolute = revoluteFlags(arm);
  const turns = q
    .slice(1)
    .map((row, k) =>
      row.map((x, i) => (isRevolute[i] ? roundHalfToEven((x - q[k][i]) / (2 * Math.PI)) : 0)),
    );
  const steps = turns.flatMap((row, k) => (row.some(Boolean) ? [k] : []));
  if (!steps.length) return [q, []];
  const sum = q[0].map(() => 0);
  const unwrapped = q.map((row, k) =>
    row.map((x, i) => x - 2 * Math.PI * (k ? (sum[i] += turns[k - 1][i]) : 0)),
  );
  if (findJumps(unwrapped, arm, path).length) return [q, []];
  const [step] = steps;
  const joint = jointNumbers(arm)[turns[step].findIndex(Boolean)];
  return [
    unwrapped,
    [formatMessage("trace whole turn", { step, to: step + 1, joint, count: steps.length })],
  ];
}

/** Return the joint that step k changes most, and by how much. */
export function measureStep(q, arm, k) {
  const change = subtractEach(q[k + 1], q[k]).map(Math.abs);
  const most = Math.max(...change);
  return { step: k, joint: jointNumbers(arm)[change.indexOf(most)], by: formatNumber(most) };
}

// Return the cause of a first jump that begins at a singular configuration, or null.
/** @returns {import("../causes/ranking.js").Cause | null} */
export function findSingularStart(q, arm, jumps) {
  const [k] = jumps;
  const dof = movingRows(arm).length;
  const rows = dof >= 6 ? 6 : 3;
  if (k === undefined || dof < rows) return null;
  const columns = jacobianColumns(arm, linkFrames(arm, q[k]));
  const { values } = decomposeSingular(columns, rows);
  const rank = values.filter((x) => x > ZERO_SHARE * values[0]).length;
  if (rank === rows) return null;
  const { step, joint, by } = measureStep(q, arm, k);
  return makeCause("trace.no inverse", { step, _rank: rank, _rows: rows, _joint: joint, _by: by });
}

function computeMedian(list) {
  const sorted = [...list].sort((x, y) => x - y);
  const half = sorted.length >> 1;
  return sorted.length % 2 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}

// Note the joints that leave their ranges or exceed their speeds.
export function* listNotes(arm, path, q) {
  const dt = path.times.slice(1).map((t, k) => t - path.times[k]);
  const rates = q.slice(1).map((row, k) => row.map((x, i) => (x - q[k][i]) / dt[k]));
  const isRevolute = revoluteFlags(arm);
  const listExcesses = (list, perTime, measureExcess) =>
    jointNumbers(arm).flatMap((joint, k) => {
      const excess = list.reduce(
        (most, row) => Math.max(most, measureExcess(row[k], arm.rows[joint - 1])),
        -Infinity,
      );
      if (!(excess > 1e-9)) return [];
      const unit = (isRevolute[k] ? "rad" : "m") + perTime;
      return [formatMessage("joint by", { joint, by: formatNumber(excess, 2), unit })];
    });
  const range = listExcesses(q, "", (x, { lower, upper }) =>
    Math.max(x - (upper ?? Infinity), (lower ?? -Infinity) - x),
  );
  if (range.length) yield formatMessage("trace beyond range", { joints: joinList(range) });
  const speed = listExcesses(rates, "/s", (x, row) => Math.abs(x) - (row.speed ?? Infinity));
  if (speed.length) yield formatMessage("trace beyond speed", { joints: joinList(speed) });
}
