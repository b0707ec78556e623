// Do these joint angles reach that pose?

import { answering, reportOf } from "../report.js";
import {
  cross,
  dot,
  jacobianColumns,
  linkFrames,
  matrix,
  minus,
  norm,
} from "../geometry/kinematics.js";
import { millimetres, turnOf } from "../causes/branches.js";
import { turnBetween, answers } from "./branches_matching.js";
import { HALF, HAND, RIGHT, ROUNDED, SO_FAR, WRONG } from "../digits.js";
import { JOINT_NAMES, lookup, numbers, numbered, turning } from "../reading/numbers.js";
import { cause, nameOf, several } from "../causes/ranking.js";
import { ArmError, counted, listed, lower, say } from "../sentences.js";
import { choices, double, scale, scales, single, variable, whole } from "../causes/joints.js";

const EXACT = 1e-6; // m or rad
const FAR = 10; // margins: what is missed by less may be several joints, each a little off
// the largest unit of a rotation's entries: a whole 0 or 1 may stand for no other
const ROUGH = 0.1;
const COARSE = 2e-3; // rad or m: angles with fewer decimals are taken as meant, unless that fails

/** @typedef {import("./branches.js").Answer} Answer */
/**
 * Rows of a pose, or one row of a point; whether there are formulas among them.
 * @typedef {{ values: number[][], units: number[][], pose: boolean, formulas: boolean }} Target
 */

/**
 * Whether a joint vector, a text or nested lists, takes an arm's tip to T: a pose (4, 4) or a point
 * (3,).
 * @returns {import("../report.js").Report}
 */
export const comparePose = answering(poseCompared, JOINT_NAMES);

function poseCompared(q, arm, T, options = {}) {
  const { angles = "rad", tolerance = null } = options;
  const { answers: given, taken, typed } = answers(q, arm, angles);
  if (given.length !== 1)
    throw new ArmError(say("one answer", { arm: arm.name, count: given.length }));
  const { known } = lookup(arm, given[0].values);
  const target = targetOf(T, arm, known);
  const units = target.formulas ? given[0].units.map(() => 0) : given[0].units;
  return {
    ...judged({ ...given[0], units }, arm, target, tolerance, taken),
    typed,
  };
}

/**
 * What was typed as a pose or, where it may be one, a point.
 * @returns {Target}
 */
export function targetOf(T, arm, known, orPoint = true) {
  const what = `${arm.name}: the target`;
  const wanted = say(orPoint ? "a point or a pose" : "a pose");
  const { values, units, shape, symbolic } = numbers(T, what, known, wanted);
  const form = shape.filter((n) => n !== 1).join("x");
  const pose = form === "4x4" || form === "3x4";
  if (!pose && !(orPoint && form === "3"))
    throw new ArmError(say("pose shape", { what, given: counted(shape), wanted }));
  const rows = (list) => (pose ? [0, 1, 2].map((i) => list.slice(4 * i, 4 * i + 4)) : [list]);
  return { values: rows(values), units: rows(units), pose, formulas: symbolic };
}

/** @returns {import("../report.js").Report} */
function judged(q, arm, T, tolerance, taken) {
  const here = linkFrames(arm, q.values).at(-1);
  const miss = missOf(here, T);
  const fine = { values: q.values, units: q.units.map((u) => (u > COARSE ? 0 : u)) };
  const margins = (of, share) => marginsOf(of, arm, T, share, tolerance);
  const [sharp, margin] = [margins(fine, HALF), margins(fine, HAND)];
  const found = within(miss, margin) ? [] : causesOf({ q, fine, arm, T, tolerance }, margin, miss);
  const grade = found.length ? WRONG : gradeOf(miss, sharp, margin, margins(q, HALF));
  const position = { position_error: miss[0], orientation_error: miss[1] };
  const rest = { taken, notes: [], figures: position };
  if (grade !== WRONG) {
    const headline = say(GOOD[grade], { arm: arm.name });
    return reported(arm, grade, headline, { ...rest, notes: [...limits(arm, q)] });
  }
  const far = !within(miss, [FAR * margin[0], FAR * margin[1]]);
  const causes = !found.length && far ? alone(q.values, arm, T, sharp) : found;
  const turn = T.pose && miss[1] > margin[1] ? turnOf(miss[1]) : "";
  const off = say("ik off", { millimetres: millimetres(miss[0]), turn });
  if (causes.length) return explained(arm, causes, off, rest);
  const findings = T.pose ? entries(here, T, miss[1] <= margin[1]) : coordinates(here, T);
  const whats = [...new Set(findings.map(({ what }) => what))];
  const headline = say("pose wrong", { arm: arm.name, off });
  return reported(arm, WRONG, headline, { ...rest, findings, causes: whats });
}

const GOOD = { [RIGHT]: "pose right", [ROUNDED]: "pose rounded", [SO_FAR]: "pose so far" };

// How near the tip comes, where no slip explains a miss; `coarse` is what few digits leave open.
function gradeOf(miss, sharp, margin, coarse) {
  if (within(miss, sharp)) return RIGHT;
  if (within(miss, margin)) return ROUNDED;
  return within(miss, coarse) ? SO_FAR : WRONG;
}

function explained(arm, causes, off, rest) {
  const words = several(causes);
  const headline = say("pose cause", { arm: arm.name, off, cause: lower(words) });
  const findings = [{ what: "cause", where: "", words: `${words}.` }];
  return reported(arm, WRONG, headline, { ...rest, findings, causes: causes.map(nameOf) });
}

const reported = (...told) => reportOf("pose", ...told);

// Distance (m) and angle (rad) between a frame and T; no angle where T is a point, half a turn
// where its axes are left-handed.
/** @returns {[number, number]} */
function missOf(here, { values, pose }) {
  const o = pose ? values.map((row) => row[3]) : values[0];
  const away = norm(minus(here.o, o));
  if (!pose) return [away, 0];
  const [x, y, z] = [0, 1, 2].map((k) => values.map((row) => row[k]));
  return [away, dot(cross(x, y), z) > 0 ? turnBetween(here, { x, y, z, o }) : Math.PI];
}

/** @returns {[number, number]} */
function marginsOf(q, arm, T, share, tolerance) {
  // below it rounding decides
  if (tolerance !== null) return [Math.max(tolerance, 1e-9), Math.max(tolerance, 1e-9)];
  const columns = jacobianColumns(arm, linkFrames(arm, q.values));
  const spread = (i) =>
    columns.reduce((sum, column, k) => sum + Math.abs(column[i]) * (share * q.units[k]), 0);
  const last = T.pose ? T.units.map((row) => row[3]) : T.units[0];
  const unit = Math.max(...T.units.flatMap((row) => row.slice(0, 3)));
  const turn = T.pose ? 2 * share * Math.min(unit, ROUGH) : 0;
  return [
    EXACT + (norm([0, 1, 2].map(spread)) + share * norm(last)),
    EXACT + norm([3, 4, 5].map(spread)) + turn,
  ];
}

const within = (miss, margin) => miss[0] <= margin[0] && miss[1] <= margin[1];

// The single slips that explain a miss, or else the first pair that does; none that helps by less
// than half, nor a scale where zero would fit as well.
function causesOf({ q, fine, arm, T, tolerance }, margin, miss) {
  const found = [];
  const least = (at, goal) =>
    marginsOf(at, arm, goal, HALF, tolerance).map((most, i) =>
      miss[i] <= margin[i] ? Math.max(most, margin[i]) : Math.min(most, miss[i] / 2),
    );
  const usual = least(fine, T);
  for (const [one, other, values, target] of slips(q.values, arm, T)) {
    const pair = one.keys.length > 1;
    if (pair && found.length) break;
    const reaches = (it, at, goal, most) => within(missOf(linkFrames(it, at).at(-1), goal), most);
    let most = target === T ? usual : least(fine, target);
    if (scales(one)) {
      const factor = scale(one, arm);
      const meant = { values, units: q.units.map((u, k) => u * factor[k]) };
      most = marginsOf(meant, arm, T, HALF, tolerance);
      const zero = values.map((x, k) => (x === q.values[k] ? x : 0));
      if (reaches(arm, zero, target, most)) continue;
    }
    if (!reaches(other, values, target, most)) continue;
    found.push(one);
    if (pair) break;
  }
  return found;
}

// The one joint of which another value, or the one pair whose exchange, takes the tip to a pose;
// nothing where more than one would, or for a point, which leaves more to chance.
function alone(q, arm, T, margin) {
  if (!T.pose) return [];
  const found = [...otherValues(q, arm, T)].filter(([, mended]) =>
    within(missOf(linkFrames(arm, mended).at(-1), T), margin),
  );
  return found.length === 1 ? [found[0][0]] : [];
}

// Each joint in turn moved as near to T as it can, then each pair exchanged.
/** @returns {Generator<[import("../causes/ranking.js").Cause, number[]]>} */
function* otherValues(q, arm, { values }) {
  const frames = linkFrames(arm, q);
  const { x, y, z, o } = frames.at(-1);
  const R = values.map((row) =>
    [0, 1, 2].map((j) => row[0] * x[j] + row[1] * y[j] + row[2] * z[j]),
  );
  const turn = [R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]];
  const step = values.map((row, i) => row[3] - o[i]);
  const names = variable(arm);
  const turns = turning(arm);
  for (const [k, column] of jacobianColumns(arm, frames).entries()) {
    const turned = Math.atan2(dot(column.slice(3), turn), R[0][0] + R[1][1] + R[2][2] - 1);
    const most = turns[k] ? turned : dot(column.slice(0, 3), step);
    yield [
      cause("pose.joint", { joint: names[k] }),
      q.map((value, i) => (i === k ? value + most : value)),
    ];
  }
  for (const [i, j] of choices(q.length, 2)) {
    const mended = q.map((value, k) => q[k === i ? j : k === j ? i : k]);
    yield [cause("pose.exchanged", { first: names[i], second: names[j] }), mended];
  }
}

/** @returns {Generator<[import("../causes/ranking.js").Cause, any, number[], Target]>} */
function* slips(q, arm, T) {
  yield [cause("pose.millimetres"), arm, q, scaled(T, 1e-3)];
  yield [cause("pose.centimetres"), arm, q, scaled(T, 1e-2)];
  for (const [one, mended] of single(arm, q)) yield [one, arm, mended, T];
  for (const [one, mended] of whole(arm, q)) yield [one, arm, mended, T];
  if (arm.penless) yield [cause("table.pen"), arm.penless, q, T];
  for (const { name, other, rows } of arm.alike ?? []) {
    yield [cause("table.length", { name, other }), { ...arm, rows }, q, T];
  }
  for (const { name, rows } of arm.robots ?? [])
    yield [cause("table.robot", { name }), { ...arm, rows }, q, T];
  if (T.pose) {
    yield [cause("pose.transposed"), arm, q, rotated(T, (i, j) => T.values[j][i])];
    for (const axis of [0, 1, 2]) {
      const turned = rotated(T, (i, j) => (j === axis ? T.values[i][j] : -T.values[i][j]));
      yield [cause("pose.half turn", { axis: "xyz"[axis] }), arm, q, turned];
    }
  }
  for (const [one, mended] of double(arm, q)) yield [one, arm, mended, T];
}

const rotated = (T, entry) => ({
  ...T,
  values: T.values.map((row, i) => row.map((x, j) => (j < 3 ? entry(i, j) : x))),
});
function scaled(T, factor) {
  const each = (rows) =>
    rows.map((row) => row.map((x, j) => (!T.pose || j === 3 ? x * factor : x)));
  return { ...T, values: each(T.values), units: each(T.units) };
}

// The entries of T that differ, where they are few and no joints give the others with them: its
// axes are not square, or are upright, as they should be. Then T is wrong, not q.
function entries(frame, T, upright) {
  const here = matrix(frame);
  const findings = T.values.flatMap((row, i) =>
    row.flatMap((x, j) => {
      if (!(Math.abs(here[i][j] - x) > Math.max(HAND * T.units[i][j], COARSE))) return [];
      const words = say("pose.entry", { row: i + 1, column: j + 1 });
      return [{ what: "pose.entry", where: `entry (${i + 1}, ${j + 1})`, words }];
    }),
  );
  return findings.length <= 3 && (upright || !square(T)) ? findings : [];
}

// Whether the axes of a pose are those of a right-handed frame, to their digits.
function square({ values, units }) {
  const axes = [0, 1, 2].map((k) => values.map((row) => row[k]));
  const unit = Math.max(...units.flatMap((row) => row.slice(0, 3)));
  const off = axes.flatMap((a, i) => axes.map((b, j) => Math.abs(dot(a, b) - Number(i === j))));
  return Math.max(...off) <= 2 * unit + EXACT && dot(cross(axes[0], axes[1]), axes[2]) > 0;
}

// The coordinate of a point in formulas that differs, where it is one; in numbers it could be q as
// well.
function coordinates({ o }, T) {
  const wrong = [0, 1, 2].filter((i) => Math.abs(o[i] - T.values[0][i]) > COARSE);
  if (!T.formulas || wrong.length !== 1) return [];
  const axis = "xyz"[wrong[0]];
  return [{ what: "pose.coordinate", where: axis, words: say("pose.coordinate", { axis }) }];
}

function* limits(arm, { values }) {
  const beyond = numbered(arm).flatMap((row, k) => {
    const { lower: least, upper: most } = arm.rows[row - 1];
    const inside = (least ?? -Infinity) <= values[k] && values[k] <= (most ?? Infinity);
    return inside ? [] : [variable(arm)[k]];
  });
  if (beyond.length) yield say("beyond limits", { joints: listed(beyond) });
}
