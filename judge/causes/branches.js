// Why a joint vector is none of the branches.

import { DEG } from "../geometry/angles.js";
import { turning } from "../reading/numbers.js";
import { listed, lower, say, size } from "../sentences.js";
import { gapBetween, gapOf, marginsOf, missOf } from "../topics/branches_matching.js";
import { double, kept, scales, single, variable, whole } from "./joints.js";
import { cause, nameOf, several } from "./ranking.js";

/** @typedef {import("./ranking.js").Cause} Cause */
/** @typedef {import("../report.js").Finding} Finding */

// told rather than that joints of two branches are mixed
const OF_ONE_STEP = ["ik.sign", "ik.plus for minus"];

const VAGUE = 0.025; // rad: with a wider margin any slip would explain anything

/** @returns {{ causes: Cause[], finding: Finding }} */
export function wrongAnswer(right, { values, units }, number, tolerance) {
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
  const vague = turning(arm).some((turns, k) => turns && margin[k] > VAGUE);
  for (const slips of [first(), double(arm, q, worth)]) {
    const found = fitting(right, q, slips, margin).filter(([one]) => !vague || scales(one));
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
