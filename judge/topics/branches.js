// Is an inverse kinematics right and complete? Each answer is judged, and what is missing is named.

import { jacobianColumns, joints, linkFrames, matrix } from "../geometry/kinematics.js";
import { singular } from "../geometry/linear.js";
import { DEG } from "../geometry/angles.js";
import { HALF, HAND, RIGHT, ROUNDED, SO_FAR, WRONG } from "../digits.js";
import { numbers, rowsInRadians, turning, unnamed } from "../reading/numbers.js";
import { asksPose, formOf, inverse, rint } from "../geometry/inverse.js";
import { cause, nameOf, several, wordsOf } from "../causes/ranking.js";
import { ArmError, listed, lower, say, size } from "../sentences.js";
import { double, kept, scales, single, variable, whole } from "../causes/joints.js";

const EXACT = 1.01e-4; // rad or m: answers copied from paper with four decimals still count
const REACHED = 1e-6; // m and rad: a pose this close is the target's, whatever the digits
const NEAR = 1e-3; // a singular value, or a sine, this small counts as 0
const BY_HAND = 0.0301; // rad or m: the most that rounding on the way is allowed
// told rather than that joints of two branches are mixed
const OF_ONE_STEP = ["ik.sign", "ik.plus for minus"];
const COARSE = 5.1e-3; // rad or m: with a larger unit, branches and slips are not told apart

/** @typedef {{ values: number[], units: number[] }} Answer a joint vector with the units of its last places */
/** @typedef {import("../causes/ranking.js").Cause} Cause */
/** @typedef {import("../report.js").Finding} Finding */

/**
 * The right answers, and how many there are with those that fall together.
 * @typedef {{ arm: any, branches: import("../geometry/inverse.js").Branch[], count: number }} Right
 */

/**
 * The report on joint vectors, a text or nested lists, for one target of an arm with a closed form:
 * three coordinates, or the rows of a pose where one is asked for.
 * @param {string | any[]} mine @param {any} arm @param {any[]} target
 * @returns {import("../report.js").Report}
 */
export function compareBranches(mine, arm, target, options = {}) {
  const { angles = "rad", tolerance = null, found = null } = options;
  const right = apart(arm, found ?? branchesOf(arm, target));
  let { answers: given, taken, typed } = answers(mine, arm, angles);
  if (
    given.length === joints(arm).length &&
    given.length > 1 &&
    !hitsOf(right, given, tolerance).hits.size
  ) {
    const columns = answers(mine, arm, angles, true);
    if (!hitsOf(right, columns.answers, tolerance).astray.length) {
      ({ answers: given, taken, typed } = columns);
    }
  }
  const { astray, ...report } = judged(right, given, angles, tolerance, taken);
  const dof = joints(arm).length;
  const asRows = !taken.length && typed.shape.at(-1) === dof;
  const wrong = asRows && given.flatMap((one, i) => one.values.map(() => astray.includes(i + 1)));
  return wrong ? { ...report, typed, wrong } : { ...report, typed };
}

// All branches by the arm's own formula, where the asker has none.
function branchesOf(arm, target) {
  const form = formOf(arm);
  return inverse(arm, form, asksPose(form) ? frameOf(target) : target);
}

const frameOf = (rows) => {
  const [x, y, z, o] = [0, 1, 2, 3].map((k) => rows.slice(0, 3).map((row) => row[k]));
  return { x, y, z, o };
};

// The branches that there are, those that fall together taken once.
/** @returns {Right} */
function apart(arm, branches) {
  const same = (p, q) => gapOf(arm, p, q).every((x) => x < REACHED);
  const once = branches.filter(
    ({ q }, n) => !branches.slice(0, n).some((other) => same(q, other.q)),
  );
  return { arm, branches: once, count: branches.length };
}

function judged(right, given, angles, tolerance, taken) {
  const degrees = angles === "rad" ? onlyAsDegrees(right, given, tolerance) : null;
  return degrees
    ? reported(right, degrees, tolerance, taken, cause("ik.degrees"))
    : reported(right, given, tolerance, taken, null);
}

// The answers taken as degrees, where they are branches so and none is as typed; null where they
// are not, or are so small that zero is as near to the branch.
/** @returns {Answer[] | null} */
function onlyAsDegrees(right, given, tolerance) {
  const { arm, branches } = right;
  if (!branches.length || !given.length || hitsOf(right, given, tolerance).hits.size) return null;
  const degrees = rowsInRadians(given, arm);
  const turns = turning(arm);
  const tells = ([k, number]) => {
    const zero = given[number - 1].values.map((x, i) => (turns[i] ? 0 : x));
    return !matches(right, zero, marginsOf(degrees[number - 1].units, tolerance, true)).includes(k);
  };
  return [...hitsOf(right, degrees, tolerance).hits].some(tells) ? degrees : null;
}

/**
 * Joint vectors with their units, however they were held, and how they were read; a square is read
 * by rows unless told.
 * @returns {{ answers: Answer[], taken: string[], typed: import("../reading/numbers.js").Typed }}
 */
export function answers(mine, arm, angles, byColumns = false) {
  const dof = joints(arm).length;
  const read = numbers(
    unnamed(mine),
    `${arm.name}: q`,
    undefined,
    `joint vectors (answers, ${dof})`,
  );
  if (!read.values.length) return { answers: [], taken: [], typed: read };
  let shape = read.shape.length > 2 ? read.shape.filter((n) => n !== 1) : read.shape;
  let { values, units } = read;
  const taken = [];
  const turn = () => {
    [values, units] = [transposed(values, shape), transposed(units, shape)];
    shape = [shape[1], shape[0]];
  };
  if (shape.length === 2 && shape[1] === 1 && shape[0] === dof) turn();
  if (shape.length < 2) shape = [1, values.length];
  if (shape.length === 2 && shape[0] === dof && (byColumns || shape[1] !== dof)) {
    turn();
    taken.push(say("taken: answer per column"));
  }
  if (shape.length !== 2 || shape[1] !== dof) {
    throw new ArmError(say("answers shape", { arm: arm.name, shape: read.shape.join("x"), dof }));
  }
  const rows = (list) =>
    Array.from({ length: shape[0] }, (_, i) => list.slice(i * dof, (i + 1) * dof));
  const both = rows(values).map((row, i) => ({ values: row, units: rows(units)[i] }));
  return { answers: angles === "deg" ? rowsInRadians(both, arm) : both, taken, typed: read };
}

/** @param {number[]} flat @param {number[]} shape */
const transposed = (flat, [rows, width]) =>
  flat.map((_, i) => flat[(i % rows) * width + Math.floor(i / rows)]);

// Which branch an answer is

function marginsOf(units, tolerance, hand = false) {
  if (tolerance !== null) return units.map(() => Math.max(tolerance, 1e-9));
  const byHand = (u) => Math.max(HALF * u, Math.min(HAND * u, BY_HAND));
  return units.map((u) => Math.max(hand ? byHand(u) : HALF * u, EXACT));
}

// The answer that gives each branch, the answers that give none, and whether all are right to their
// digits.
function hitsOf(right, given, tolerance) {
  const hits = new Map();
  const astray = [];
  let sharp = true;
  given.forEach(({ values, units }, at) => {
    let match = matches(right, values, marginsOf(units, tolerance));
    if (!match.length) {
      match = matches(right, values, marginsOf(units, tolerance, true));
      sharp = false;
    }
    for (const k of match) if (!hits.has(k)) hits.set(k, at + 1);
    if (!match.length) astray.push(at + 1);
  });
  return { hits, astray, sharp };
}

// The branches that q is: the same joints, or, where a joint is free, another member of the
// branch's family.
function matches(right, q, margin) {
  const { arm, branches } = right;
  const gaps = branches.map((branch) => gapOf(arm, q, branch.q));
  const near = (gap) => gap.map((x, k) => x <= margin[k]);
  const same = gaps.map((gap) => near(gap).every(Boolean));
  let family = branches.map(({ free }) => free.includes(true));
  if (family.includes(true) && missOf(right, q, margin) === null) {
    family = family.map((is, b) => {
      if (!is) return false;
      const loose = movingInPlace(arm, branches[b].q);
      return near(gaps[b]).every((fits, k) => fits || loose[k]);
    });
    const far = gaps.map((gap, b) =>
      gap.reduce((sum, x, k) => sum + (branches[b].free[k] ? 0 : x), 0),
    );
    const least = Math.min(...far.filter((_, b) => family[b])) + Math.max(...margin);
    family.forEach((is, b) => (same[b] ||= is && far[b] < least));
  }
  return same.flatMap((is, b) => (is ? [b] : []));
}

// Which joints can move while the tip stands still, by the Jacobian's null space.
function movingInPlace(arm, q) {
  const dof = q.length;
  const columns = jacobianColumns(arm, linkFrames(arm, q));
  const rows = Array.from({ length: dof >= 6 ? 6 : 3 }, (_, i) =>
    columns.map((column) => column[i]),
  );
  const { values, vectors } = singular(rows, dof);
  return q.map((_, k) => vectors.some((v, i) => values[i] < NEAR && Math.abs(v[k]) > NEAR));
}

// How far q's tip is from the target, [m, rad], or null where the digits of q explain it.
/** @returns {[number, number] | null} */
function missOf(right, q, margin) {
  const { arm, branches } = right;
  const [frames, target] = [q, branches[0].q].map((one) => linkFrames(arm, one));
  const away = length(target.at(-1).o.map((x, i) => x - frames.at(-1).o[i]));
  const turned = q.length >= 6 ? angleBetween(frames.at(-1), target.at(-1)) : 0;
  const columns = jacobianColumns(arm, frames);
  const spread = (i) =>
    columns.reduce((sum, column, k) => sum + Math.abs(column[i]) * margin[k], 0);
  const most = (half) => Math.max(REACHED, length(half.map(spread)));
  const [far, wide] = [most([0, 1, 2]), most([3, 4, 5])];
  return away <= far && turned <= wide ? null : [away, turned];
}

const length = (v) => Math.sqrt(v.reduce((sum, x) => sum + x * x, 0));

// The angle (rad) of the turn from one frame to another.
export function angleBetween(here, there) {
  const [A, B] = [matrix(here), matrix(there)];
  const entry = (i, j) => A[0][i] * B[0][j] + A[1][i] * B[1][j] + A[2][i] * B[2][j];
  const R = [0, 1, 2].map((i) => [0, 1, 2].map((j) => entry(i, j)));
  const off = length([R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]]);
  return Math.atan2(off, R[0][0] + R[1][1] + R[2][2] - 1);
}

function gapOf(arm, q, other) {
  const turns = turning(arm);
  return q.map((x, k) => gapBetween(turns[k], x, other[k]));
}

function gapBetween(turns, x, y) {
  const gap = Math.abs(x - y);
  return turns ? Math.abs(gap - 2 * Math.PI * rint(gap / (2 * Math.PI))) : gap;
}

// The report

/** @returns {import("../report.js").Report & { astray: number[] }} */
function reported(right, given, tolerance, taken, everywhere) {
  const { arm, branches } = right;
  const { hits, astray, sharp } = hitsOf(right, given, tolerance);
  const wrong = astray.map((number) => wrongAnswer(right, given[number - 1], number, tolerance));
  const names = (there) => branches.flatMap(({ name }, k) => (hits.has(k) === there ? [name] : []));
  const [missing, found] = [names(false), names(true)];
  const unreachable = outOfRange(right, hits, missing, found);
  const oneSided = unreachable.length ? [] : oneSign(right, hits, missing, found);
  const all = [
    ...wrong.flatMap(({ causes }) => causes.map(nameOf)),
    ...oneSided.map(({ what }) => what),
  ];
  const findings = [...wrong.map(({ finding }) => finding), ...oneSided];
  if (missing.length && (found.length || !astray.length)) {
    const words = say("ik missing", { names: missing.join("; ") });
    findings.splice(wrong.length, 0, { what: "missing", where: "", words });
  }
  if ((found.length && found.length < branches.length) || astray.length) {
    findings.unshift(
      ...found.map((name) => ({ what: "found", where: name, words: say("ik found", { name }) })),
    );
  }
  const coarse = tolerance === null && tooCoarse(right, given);
  const unfinished = missing.length > 0 || coarse;
  const grade = everywhere || astray.length ? WRONG : unfinished ? SO_FAR : sharp ? RIGHT : ROUNDED;
  if (everywhere) findings.unshift({ what: "cause", where: "", words: `${wordsOf(everywhere)}.` });
  return {
    astray: everywhere ? given.map((_, i) => i + 1) : astray,
    topic: "branches",
    arm: arm.name,
    grade,
    headline: headlineOf(grade, right, everywhere, wrong, found.length, coarse && !missing.length),
    findings,
    causes: everywhere ? [nameOf(everywhere)] : [...new Set(all)],
    taken,
    notes: [...notesOf(right), ...twice(arm, given), ...unreachable],
    figures: {
      found,
      right: everywhere ? 0 : found.length,
      of: branches.length,
      wrong: astray.length,
    },
  };
}

function headlineOf(grade, { arm, branches }, everywhere, wrong, count, coarse) {
  const fields = { arm: arm.name, count, all: branches.length };
  if (!branches.length) return say("ik none", fields);
  if (everywhere) return say("ik wrong", { cause: lower(wordsOf(everywhere)), ...fields });
  if (grade === WRONG) {
    const firsts = new Set(wrong.map(({ causes }) => (causes.length ? nameOf(causes[0]) : "")));
    const one = firsts.size === 1 && !firsts.has("") ? wrong[0].causes[0] : null;
    return one
      ? say("ik wrong", { cause: lower(wordsOf(one)), ...fields })
      : say("ik some wrong", fields);
  }
  if (grade === SO_FAR) return say(coarse ? "ik so far digits" : "ik so far", fields);
  return say(grade === RIGHT ? "ik right" : "ik rounded", fields);
}

// One sign of a root forgotten: a joint that has one sign in all that is there and the other in all
// that is missing.
/** @returns {Finding[]} */
function oneSign({ arm, branches }, hits, missing, found) {
  if (!found.length || !missing.length) return [];
  const turns = turning(arm);
  const k = variable(arm).findIndex((_, joint) => {
    const q = branches.map((branch) => branch.q[joint]);
    const clear = Math.min(...q.map((x) => Math.abs(turns[joint] ? Math.sin(x) : x))) > NEAR;
    const there = new Set(q.filter((_, b) => hits.has(b)).map(Math.sign));
    const others = q.filter((_, b) => !hits.has(b)).map(Math.sign);
    return clear && there.size === 1 && others.every((sign) => there.has(-sign));
  });
  if (k < 0) return [];
  const key = k || !turns[0] ? "ik.one sign" : "ik one side";
  return [{ what: "ik.one sign", where: "", words: say(key, { joint: variable(arm)[k] }) }];
}

// A word where what is missing has a slide beyond its range.
function outOfRange({ arm, branches }, hits, missing, found) {
  if (!found.length || !missing.length) return [];
  const lacking = branches.filter((_, b) => !hits.has(b));
  const turns = turning(arm);
  const beyond = joints(arm).flatMap((row, k) => {
    const { lower: least, upper: most } = arm.rows[row];
    const inside = (x) => (least ?? -Infinity) <= x && x <= (most ?? Infinity);
    return turns[k] || lacking.some(({ q }) => inside(q[k])) ? [] : [variable(arm)[k]];
  });
  return beyond.length ? [say("ik out of range", { joints: listed(beyond) })] : [];
}

// Whether an answer has too few digits to tell, and is not exact all the same, as whole degrees may
// be.
function tooCoarse(right, given) {
  const exact = (values) =>
    matches(
      right,
      values,
      values.map(() => REACHED),
    ).length > 0;
  return given.some(({ values, units }) => Math.max(...units) > COARSE && !exact(values));
}

// A word on the first answers that are the same.
function* twice(arm, given) {
  for (const [n, { values }] of given.entries()) {
    const same = given.map((other) =>
      gapOf(arm, other.values, values).every((gap) => gap <= EXACT),
    );
    const alike = same.flatMap((is, k) => (is ? [k + 1] : []));
    if (alike.length > 1 && alike[0] === n + 1)
      yield say("ik twice", { numbers: listed(alike.map(String)) });
  }
}

function* notesOf({ arm, branches, count }) {
  if (branches.length < count) yield say("ik together", { count: branches.length, all: count });
  for (const [k, joint] of variable(arm).entries()) {
    if (branches.some(({ free }) => free[k])) yield say("ik free", { joint });
  }
}

/** @returns {{ causes: Cause[], finding: Finding }} */
function wrongAnswer(right, { values, units }, number, tolerance) {
  const margin = marginsOf(units, tolerance, true);
  const where = `answer ${number}`;
  const plainly = (key) => ({
    causes: [],
    finding: { what: "answer", where, words: say(key, { number }) },
  });
  if (!right.branches.length) return plainly("ik no branch");
  const miss = missOf(
    right,
    values,
    units.map(() => 0),
  );
  if (!miss) return plainly("ik unlisted");
  const { causes, words } = why(right, values, margin);
  const turn = values.length >= 6 ? turnOf(miss[1]) : "";
  const off = say("ik off", { millimetres: millimetres(miss[0]), turn });
  const said = say("ik answer", { number, off, words });
  return {
    causes,
    finding: { what: causes.length ? nameOf(causes[0]) : "answer", where, words: said },
  };
}

// A length in m as so many digits of mm, not below a thousandth of one.
export const millimetres = (metres, digits = 3) => size(Number((1e3 * metres).toFixed(3)), digits);

export const turnOf = (angle) =>
  say("ik turn", { degrees: size(Number((angle * DEG).toFixed(3))) });

// What explains an answer: one slip, joints of two branches mixed, or two slips; or else the joints
// in no branch.
/** @returns {{ causes: Cause[], words: string }} */
function why(right, q, margin) {
  const { arm, branches } = right;
  const fits = branches.map((branch) => gapOf(arm, q, branch.q).map((x, k) => x <= margin[k]));
  const mixed = mixedOf(right, fits);
  const first = function* () {
    yield* single(arm, q);
    yield* whole(arm, q);
    yield* kept(
      q,
      branches.map((branch) => branch.q),
    );
  };
  // A slip in two joints can help where all the others are in one branch.
  const near = branches.map((branch) =>
    gapOf(arm, q, branch.q).map((x, k) => x <= 1.5 * margin[k]),
  );
  const worth = (i, j) => near.some((row) => row.every((is, k) => is || k === i || k === j));
  for (const slips of [first(), double(arm, q, worth)]) {
    const found = fitting(right, q, slips, margin);
    if (found.length) return slipped(right, found, mixed);
    if (mixed) return { causes: [mixed.cause], words: mixed.words };
  }
  const astray = variable(arm).filter((_, k) => !fits.some((row) => row[k]));
  const fields = { joints: listed(astray) };
  const words =
    astray.length > 1 ? say("ik in no branch", fields) : say("ik one in no branch", fields);
  return { causes: [], words };
}

function slipped({ branches }, found, mixed) {
  const all = found.map(([one]) => one);
  const causes = all.filter(
    (one, i) => all.findIndex((other) => nameOf(other) === nameOf(one)) === i,
  );
  const words = say("ik slip", {
    cause: lower(several(causes, 2)),
    branch: branches[found[0][1]].name,
  });
  const [key, second] = causes[0].keys;
  if (!mixed || OF_ONE_STEP.includes(key) || second !== undefined) return { causes, words };
  return {
    causes: [...causes, mixed.cause],
    words: say("ik or mixed", { words, mixed: mixed.words }),
  };
}

// The slips without which an answer would be a branch, and which; none that helps by less than
// half, nor a scale where zero would fit as well.
/** @returns {[Cause, number][]} */
function fitting({ arm, branches }, q, slips, margin) {
  const turns = turning(arm);
  const before = branches.map((branch) => gapOf(arm, q, branch.q));
  const largest = before.map((gaps) => Math.max(...gaps));
  // The largest gap left of a branch, or null where one is too large.
  const left = (mended, b) => {
    let most = 0;
    for (let k = 0; k < q.length; k++) {
      const gap =
        mended[k] === q[k] ? before[b][k] : gapBetween(turns[k], mended[k], branches[b].q[k]);
      if (!(gap <= 1.5 * margin[k])) return null;
      most = Math.max(most, gap);
    }
    return most;
  };
  const found = [];
  for (const [one, mended] of slips) {
    for (let b = 0; b < branches.length; b++) {
      const gap = left(mended, b);
      if (gap === null || gap > 0.5 * largest[b]) continue;
      const zero = () => mended.map((x, k) => (x === q[k] ? x : 0));
      if (!scales(one) || left(zero(), b) === null) found.push([one, b]);
    }
  }
  return found;
}

// Every joint in some branch: the branch with most of them, and the one that the others are from.
/** @returns {{ cause: Cause, words: string } | null} */
function mixedOf({ arm, branches }, fits) {
  const names = variable(arm);
  if (!names.every((_, k) => fits.some((row) => row[k]))) return null;
  const counts = fits.map((row) => row.filter(Boolean).length);
  const most = counts.indexOf(Math.max(...counts));
  const rest = names.flatMap((_, k) => (fits[most][k] ? [] : [k]));
  const other = fits.findIndex((row) => rest.every((k) => row[k]));
  const one = cause("ik.mixed");
  if (other < 0) return { cause: one, words: lower(say("ik.mixed")) };
  const fields = { joints: listed(rest.map((k) => names[k])), other: branches[other].name };
  return { cause: one, words: say("ik mixed", { ...fields, most: branches[most].name }) };
}
