// Are joint torques wrong, and how? One torque vector or a whole run of them.

import { answering, reportOf } from "../report.js";
import { better, complete, explain, nameOf, perhaps, several } from "../causes/ranking.js";
import {
  catalogue,
  loadOf,
  mended,
  otherMasses,
  paperCentres,
  reversedJoints,
  torques,
} from "../causes/torques.js";
import {
  bands,
  beyond,
  decimalsOf,
  farthest,
  generous,
  graded,
  lastDigit,
  margins,
  RIGHT,
  ROUNDED,
  slopOf,
  SO_FAR,
  WRONG,
} from "../digits.js";
import { transposed } from "../geometry/chains.js";
import { joints } from "../geometry/kinematics.js";
import { minusEach } from "../geometry/linear.js";
import {
  eachJoint,
  inRadians,
  numbered,
  numbers,
  notPerJoint,
  rowsOf,
  turning,
  unnamed,
} from "../reading/numbers.js";
import { ArmError, listed, lower, say, size } from "../sentences.js";

const GRAVITY = [0, 0, -9.81];
const ODD = 1.2; // a torque that stays unexplained weighs more than a second mistake
const EMPTY = 1e-3; // N m: larger torques are no zeros
const SAMPLE = 25; // poses of a run on which causes are tried

/**
 * The report on torques, a text or nested numbers, at q or along a list of q.
 * @returns {import("../report.js").Report}
 */
export const compareTorques = answering(torquesCompared, /^\\?(?:tau|τ|torque)/i);

function torquesCompared(mine, arm, q, options = {}) {
  const { tolerance = null, briefly = false } = options;
  const at = poses(q, arm, options.angles);
  if (!arm.rows.every((row) => row.body))
    throw new ArmError(say("no masses", { arm: arm.name, rows: arm.rows.length }));
  const dof = joints(arm).length;
  const load = loaded(arm, rowsOf(at.values, dof), options);
  if (load.q.length > at.values.length / dof) at.units = load.q.flatMap(() => at.units);
  const right = torques(load).flat();
  const typed = numbers(unnamed(mine), `${arm.name}: your torques`);
  const found = upright(typed, right, dof);
  if (!found) return { ...misshapen(typed, load.q.length, arm), typed };
  const report = judged(found, right, load, at, { tolerance, briefly });
  return report && { ...report, typed };
}

// The poses with a wrench for each: one for all of them, or one pose under several.
function loaded(arm, poses, { wrench = [0, 0, 0, 0, 0, 0], gravity = GRAVITY }) {
  const wrenches = Array.isArray(wrench[0]) ? wrench : poses.map(() => wrench);
  const all = poses.length === 1 ? wrenches.map(() => poses[0]) : poses;
  return loadOf(arm, all, wrenches, gravity);
}

// Joint vectors, a pose or a list of them.
export function poses(q, arm, angles) {
  const dof = joints(arm).length;
  const typed = numbers(unnamed(q), `${arm.name}: q`, undefined, eachJoint(arm));
  if (typed.shape.at(-1) !== dof) throw notPerJoint(`${arm.name}: q`, arm, typed.shape);
  return inRadians(typed, arm, angles);
}

// The torques with a row per pose: columns and lists per joint are set right, and said.
function upright({ values, units, shape }, right, dof) {
  const count = right.length / dof;
  const sizes = shape.filter((n) => n !== 1);
  if (values.length === dof && sizes.length === 1 && count === 1)
    return { values, units, said: [] };
  const is = (rows, width) => sizes.length === 2 && sizes[0] === rows && sizes[1] === width;
  if (is(dof, count) && count !== dof) {
    const turned = (list) => transposed(list, sizes);
    return { values: turned(values), units: turned(units), said: [say("taken: list per joint")] };
  }
  return is(count, dof) ? { values, units, said: [] } : null;
}

const reported = (...told) => reportOf("torques", ...told);

function misshapen({ shape, values }, count, arm) {
  const dof = joints(arm).length;
  const key = values.length === count && values.length !== count * dof ? "tau.energy" : "tau.shape";
  const wanted = count > 1 ? `${count}x${dof}` : String(dof);
  const sizes = count > 1 ? shape : shape.filter((n) => n !== 1);
  const words = say(key, { shape: sizes.join("x") || "1", wanted, dof });
  const findings = [{ what: "shape", where: "", mine: shape, expected: [count, dof], words }];
  const headline = say("tau wrong", { arm: arm.name, cause: lower(words) });
  return reported(arm, WRONG, headline, { findings, causes: [key] });
}

// All zeros: an empty answer and a load forgotten look alike, so both are asked about.
function empty(mine, right, single, arm) {
  const band = mine.map(() => EMPTY);
  const found = explain(mine, right, band, single);
  const causes = complete(found) ? found.causes.slice(0, 1).map(nameOf) : [];
  return reported(arm, WRONG, say("tau wrong", { arm: arm.name, cause: say("tau zero") }), {
    causes,
  });
}

/** @returns {import("../report.js").Report} */
function judged(typed, right, load, at, { tolerance, briefly }) {
  const { arm } = load;
  const taken = typed.said;
  const dof = joints(arm).length;
  const count = right.length / dof;
  const step = (count - 1) / (SAMPLE - 1);
  const picked = Array.from({ length: SAMPLE - 1 }, (_, i) => Math.trunc(i * step));
  const pick = [...new Set([...picked, count - 1])];
  const some = (list) => pick.flatMap((i) => list.slice(i * dof, (i + 1) * dof));
  const of = (list) => pick.map((i) => list[i]);
  const sample = loadOf(arm, of(load.q), of(load.wrenches), load.gravity);
  const { causes, made } = catalogue(sample);
  const scale = Math.max(EMPTY, ...right.map(Math.abs));
  const m = margins(
    typed.units,
    right.map(() => scale),
    slop(load, at),
    tolerance,
  );
  const part = Object.fromEntries(Object.entries(m).map(([key, list]) => [key, some(list)]));
  const [mine, wanted] = [some(typed.values), some(right)];
  const single = singleOnes(causes, made);
  const figures = figuresOf(typed.values, right, m.band, dof);
  if (!typed.values.some(Boolean) && scale > EMPTY)
    return { ...empty(mine, wanted, single, arm), figures, wrong: right.map(() => true) };
  const grade = whole(graded(mine, wanted, part, single.made), typed.values, right, m);
  if (grade !== WRONG) return { ...good(grade, typed, right, arm), figures };
  if (briefly) {
    const one = explain(mine, wanted, part.band, single);
    return complete(one) ? { ...bad(one, [], arm, taken), figures } : null;
  }
  const found = foundIn(mine, wanted, part, sample, { causes, made });
  const symptoms = found ? besides(found, arm, count) : jointFindings(typed.values, right, m, arm);
  const report = bad(found, symptoms, arm, taken);
  return { ...report, figures, wrong: beyond(typed.values, right, m) };
}

function singleOnes(causes, made) {
  const single = causes.flatMap(({ keys }, k) => (keys.length === 1 ? [k] : []));
  return { causes: single.map((k) => causes[k]), made: single.map((k) => made[k]) };
}

// By how much the worst torque is off, and how many joints are right at every pose.
function figuresOf(mine, right, band, dof) {
  const off = mine.map((x, i) => Math.abs(x - right[i]));
  const wrong = new Set(off.flatMap((x, i) => (x <= band[i] ? [] : [i % dof])));
  return { worst: Math.max(0, ...off), right: dof - wrong.size, of: dof };
}

// The grade of the sample, unless a pose between its poses is worse.
function whole(grade, mine, right, m) {
  const worseThan = (most) => mine.some((x, i) => Math.abs(x - right[i]) > most[i]);
  const worse = (grade === RIGHT || grade === SO_FAR) && worseThan(generous(m)) ? ROUNDED : grade;
  return worse === ROUNDED && worseThan(farthest(m)) ? WRONG : worse;
}

// What the unwritten digits of q may change in each torque.
function slop({ arm, q, wrenches, gravity }, at) {
  const units = rowsOf(at.units, q[0].length);
  const each = q.map((one, p) =>
    slopOf(units[p], one, (x) => torques(loadOf(arm, [x], [wrenches[p]], gravity))[0]),
  );
  return each.some(Boolean) ? each.flatMap((one, p) => one ?? q[p].map(() => 0)) : null;
}

function good(grade, typed, right, arm) {
  const { said: taken, units, values } = typed;
  const how = lastDigit(values, right, units);
  const digits = decimalsOf(units);
  const precision = digits === null || digits > 6 ? "" : say("to decimals", { digits });
  const key = { [RIGHT]: "tau right", [SO_FAR]: "tau so far", [ROUNDED]: "tau rounded" }[grade];
  return reported(arm, grade, say(key, { arm: arm.name, precision, digits: digits ?? 0, how }), {
    taken,
  });
}

function foundIn(mine, right, m, load, known) {
  const simplest = (found) =>
    complete(found) ? { ...found, causes: found.causes.slice(0, 1) } : null;
  for (const band of bands(m)) {
    let found = explain(mine, right, band, known, ODD);
    if (!complete(found)) {
      const others = [
        reversedJoints(load, right),
        paperCentres(load),
        otherMasses(load, mine, right),
      ];
      const whole = others.map((other) => simplest(explain(mine, right, band, other)));
      found = better([found, ...whole], ODD);
    }
    if (found) return found;
  }
  return null;
}

const column = (list, k, dof) => list.filter((_, i) => i % dof === k);

// Each wrong joint.
function jointFindings(mine, right, m, arm) {
  const dof = joints(arm).length;
  const wrong = beyond(mine, right, m);
  const away = minusEach(mine, right);
  return numbered(arm).flatMap((_, k) => {
    if (!column(wrong, k, dof).includes(true)) return [];
    const [x, y, band] = [mine, right, m.band].map((list) => column(list, k, dof));
    const flipped = x.every((one, i) => Math.abs(one + y[i]) <= band[i]);
    return [offBy(flipped ? "tau other way" : "tau off", arm, k, away)];
  });
}

// Each joint that a cause leaves unexplained, by how much once the cause is mended.
function besides(found, arm, count) {
  const dof = joints(arm).length;
  const left = found.rest.map((x, i) => (found.odd[i] ? x : 0));
  const rest = mended(found.causes[0], left, dof);
  const tries = rest.length / dof;
  const tried = tries < count ? say("at poses tried", { count: tries }) : "";
  return numbered(arm).flatMap((_, k) =>
    column(rest, k, dof).some(Boolean) ? [offBy("tau besides", arm, k, rest, { tried })] : [],
  );
}

function offBy(key, arm, k, away, fields = {}) {
  const joint = numbered(arm)[k];
  const off = column(away, k, joints(arm).length).map(Math.abs);
  const said = size(Number(Math.max(...off).toFixed(9)), 3); // ties as in Python
  const unit = turning(arm)[k] ? "N m" : "N";
  const words = say(key, {
    joint,
    most: off.length > 1 ? say("up to") : "",
    off: said,
    unit,
    ...fields,
  });
  return { what: "joint", where: `joint ${joint}`, words };
}

function bad(found, symptoms, arm, taken) {
  if (!found) {
    const headline = say("tau wrong places", {
      arm: arm.name,
      places: listed(symptoms.map(({ where }) => where)),
    });
    return reported(arm, WRONG, headline, { findings: symptoms, taken });
  }
  const words = perhaps(several(found.causes), symptoms);
  const findings = [{ what: "cause", where: "", words: `${words}.` }, ...symptoms];
  const headline = say("tau wrong", { arm: arm.name, cause: `${lower(words)}.` });
  return reported(arm, WRONG, headline, { findings, causes: found.causes.map(nameOf), taken });
}
