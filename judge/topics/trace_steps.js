// Looks at the steps of a typed trajectory: jumps, whole turns, singular poses, ranges and speeds.

import { makeCause } from "../causes/ranking.js";
import { makeChain, flatJacobian, chainFrames } from "../geometry/chains.js";
import {
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

const NO_INVERSE = 1e-9; // of the largest singular value: a smaller one is a zero
const JUMP = 0.3; // rad or m in one step, and ten times the usual one: another branch

// List the steps that change a joint by far more than usual; if large steps are usual, those that
// leave the path between their ends.
export function findJumps(q, arm, path) {
  const change = q.slice(1).map((row, k) => Math.max(...subtractEach(row, q[k]).map(Math.abs)));
  const usual = computeMedian(change);
  const findStepsOver = (least) => change.flatMap((x, k) => (x > JUMP && x > least ? [k] : []));
  const far = findStepsOver(10 * usual);
  return far.length || usual <= JUMP
    ? far
    : findStepsOver(JUMP).filter((k) => leavesPath(q, arm, path, k));
}

// Return whether half way from row k to the next the tip is off the path by more than the step.
function leavesPath(q, arm, { times, position }, k) {
  const half = q[k].map((x, i) => (x + q[k + 1][i]) / 2);
  const wanted = position(times[k] + 0.5 * (times[k + 1] - times[k]));
  const off = norm(minus(linkFrames(arm, half).at(-1).o, wanted));
  return off > norm(minus(position(times[k + 1]), position(times[k])));
}

// Remove jumps by whole turns, as atan2 makes them, and report it; change nothing if other jumps
// remain.
/** @returns {[number[][], string[]]} */
export function removeWholeTurns(q, arm, path) {
  const turns = revoluteFlags(arm);
  const whole = q
    .slice(1)
    .map((row, k) =>
      row.map((x, i) => (turns[i] ? roundHalfToEven((x - q[k][i]) / (2 * Math.PI)) : 0)),
    );
  const steps = whole.flatMap((row, k) => (row.some(Boolean) ? [k] : []));
  if (!steps.length) return [q, []];
  const sum = q[0].map(() => 0);
  const counted = q.map((row, k) =>
    row.map((x, i) => x - 2 * Math.PI * (k ? (sum[i] += whole[k - 1][i]) : 0)),
  );
  if (findJumps(counted, arm, path).length) return [q, []];
  const step = steps[0];
  const joint = jointNumbers(arm)[whole[step].findIndex(Boolean)];
  return [
    counted,
    [formatMessage("trace whole turn", { step, to: step + 1, joint, count: steps.length })],
  ];
}

export function measureStep(q, arm, k) {
  const change = subtractEach(q[k + 1], q[k]).map(Math.abs);
  const most = Math.max(...change);
  return { step: k, joint: jointNumbers(arm)[change.indexOf(most)], by: formatNumber(most) };
}

// Return the cause of a first jump that begins at a singular pose.
/** @returns {import("../causes/ranking.js").Cause | null} */
export function findSingularStart(q, arm, [k]) {
  const dof = movingRows(arm).length;
  const rows = dof >= 6 ? 6 : 3;
  if (k === undefined || dof < rows) return null;
  const at = makeChain(arm, q[k]);
  const J = flatJacobian(at, chainFrames(at));
  const each = Array.from({ length: dof }, (_, i) =>
    Array.from({ length: rows }, (_, r) => J[r * dof + i]),
  );
  const { values } = decomposeSingular(each, rows);
  const rank = values.filter((x) => x > NO_INVERSE * values[0]).length;
  if (rank === rows) return null;
  const { step, joint, by } = measureStep(q, arm, k);
  return makeCause("trace.no inverse", { step, _rank: rank, _rows: rows, _joint: joint, _by: by });
}

function computeMedian(list) {
  const sorted = [...list].sort((x, y) => x - y);
  const half = sorted.length >> 1;
  return sorted.length % 2 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}

// List the joints that leave their ranges or exceed their speeds.
export function* listNotes(arm, path, q) {
  const dt = path.times.slice(1).map((t, k) => t - path.times[k]);
  const rates = q.slice(1).map((row, k) => row.map((x, i) => (x - q[k][i]) / dt[k]));
  const turns = revoluteFlags(arm);
  const listExcesses = (list, per, over) =>
    jointNumbers(arm).flatMap((joint, k) => {
      const by = list.reduce(
        (top, row) => Math.max(top, over(row[k], arm.rows[joint - 1])),
        -Infinity,
      );
      const unit = (turns[k] ? "rad" : "m") + per;
      return by > 1e-9 ? [formatMessage("joint by", { joint, by: formatNumber(by, 2), unit })] : [];
    });
  const range = listExcesses(q, "", (x, { lower: least, upper: most }) =>
    Math.max(x - (most ?? Infinity), (least ?? -Infinity) - x),
  );
  if (range.length) yield formatMessage("trace beyond range", { joints: joinList(range) });
  const speed = listExcesses(rates, "/s", (x, row) => Math.abs(x) - (row.speed ?? Infinity));
  if (speed.length) yield formatMessage("trace beyond speed", { joints: joinList(speed) });
}
