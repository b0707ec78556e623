// Judges joint torques: one vector, or the vectors along a trajectory.

import {
  makeLoad,
  listMistakePairs,
  listSingleMistakes,
  listTorqueSteps,
  makeTorqueMaker,
} from "../causes/torques.js";
import { causeName, joinCauseMessages } from "../causes/ranking.js";
import { RIGHT, SO_FAR, WRONG } from "../digits.js";
import { judgeEntries } from "../entries.js";
import { transpose } from "../geometry/chains.js";
import { movingRows, jointNumbers, revoluteFlags } from "../geometry/kinematics.js";
import { subtractEach } from "../geometry/linear.js";
import {
  eachJoint,
  inRadians,
  jointShapes,
  numbers,
  notPerJoint,
  ofMoving,
  rowsOf,
  setAside,
  unnamed,
} from "../reading/numbers.js";
import { completeVerdicts, makeVerdict } from "../verdict.js";
import { askAboutDegrees } from "./degrees.js";
import { judgeFirstTorques, judgeFirstTorquesInText, judgeWholeOrPart } from "./first_joints.js";
import { ArmError, joinList, uncapitalize, formatMessage, formatNumber } from "../sentences.js";

const GRAVITY = [0, 0, -9.81];
const NAMES = /^(?:tau|τ|t$|torque|effort|ans$)/i; // effort: of ROS
const SAMPLE = 5; // poses of a run, where slips are tried before they are on all of them

/**
 * Judge torques, a text or nested numbers, at q or along a list of q.
 * @returns {import("../verdict.js").Verdict}
 */
export const compareTorques = completeVerdicts(torquesCompared);

function torquesCompared(mine, arm, q, options = {}) {
  const { tolerance = null, gravity = GRAVITY } = options;
  if (!arm.rows.every((row) => row.body))
    throw new ArmError(formatMessage("no masses", { arm: arm.name, rows: arm.rows.length }));
  const dof = movingRows(arm).length;
  const [at, wrenches] = pairPosesWithWrenches(
    readPoses(q, arm, options.angles),
    dof,
    options.wrench,
  );
  const load = makeLoad(arm, wrenches, gravity);
  const given = [...rowsOf(at.values, dof), ...wrenches];
  const asked = {
    wants: listShapes(wrenches.length, arm),
    names: NAMES,
    given,
    which: options.which,
  };
  const taken = [...(at.locked ?? []), ...describeModel(load)];
  const context = { arm, q: at, load, tolerance, taken };
  const read = (question) =>
    convertToNewtonMetres(
      numbers(unnamed(mine), `${arm.name}: your torques`, undefined, undefined, question),
    );
  const verdict = judgeWholeOrPart(
    () => judgeTorques(read(asked), context),
    () =>
      wrenches.length > 1
        ? null
        : judgeFirstTorquesInText((wants) => read({ ...asked, wants }), context),
  );
  return askAboutDegrees(verdict, {
    arm,
    values: at.values,
    angles: options.angles,
    key: "tau.degrees",
    judgeInDegrees: () => torquesCompared(mine, arm, q, { ...options, angles: "deg" }),
    makeHeadline: (cause) => formatMessage("tau wrong", { arm: arm.name, cause: `${cause}.` }),
  });
}

/** @param {import("./first_joints.js").TorqueContext} context */
function judgeTorques(typed, context) {
  const { arm, q, load, tolerance, taken } = context;
  const count = load.wrenches.length;
  const arranged = arrangeByPose(typed, count, arm);
  if (arranged) {
    const said = [...typed.said, ...arranged.said, ...taken];
    const verdict = judgeArrangedTorques({ ...arranged, said }, q, load, { arm, tolerance });
    if (!arranged.isPerJoint) return { ...verdict, typed };
    return {
      ...verdict,
      typed,
      wrong: transpose(verdict.wrong ?? [], [count, movingRows(arm).length]),
    };
  }
  const verdict = count === 1 ? judgeFirstTorques(typed, context) : null;
  return verdict ?? { ...reportWrongShape(typed, count, arm), typed };
}

// Shapes that are read: a row for each pose, or a list for each joint, with or without locked
// joints. One number for each pose is an energy.
function listShapes(count, arm) {
  const widths = [...new Set([movingRows(arm).length, arm.rows.length])];
  return [
    ...widths.flatMap((columns) => [
      { rows: count, columns, by: "joint" },
      { rows: columns, columns: count },
    ]),
    ...(count > 1 ? [{ rows: count, columns: 1 }] : []),
  ];
}

function convertToNewtonMetres(typed) {
  const unit = typed.says?.moments;
  if (!unit) return typed;
  // an entry may have its own unit
  const scale = (list) => list.map((x, i) => (typed.entries[i].worth === 1 ? x * unit : x));
  const said = [
    ...typed.said,
    formatMessage(unit < 1 ? "taken: millinewton metres" : "taken: kilonewton metres"),
  ];
  return { ...typed, values: scale(typed.values), units: scale(typed.units), said };
}

// Pair poses with wrenches: one wrench for all poses, or one pose with several wrenches.
function pairPosesWithWrenches(at, dof, wrench = [0, 0, 0, 0, 0, 0]) {
  const count = at.values.length / dof;
  const wrenches = Array.isArray(wrench[0]) ? wrench : rowsOf(at.values, dof).map(() => wrench);
  if (count !== 1) return [at, wrenches];
  const repeat = (list) => wrenches.flatMap(() => list);
  return [{ ...at, values: repeat(at.values), units: repeat(at.units) }, wrenches];
}

// Read joint vectors: one, or a list.
export function readPoses(q, arm, angles) {
  const dof = movingRows(arm).length;
  const given = numbers(unnamed(q), `${arm.name}: q`, undefined, eachJoint(arm), {
    wants: jointShapes(arm),
  });
  const typed = given.shape.at(-1) === arm.rows.length ? ofMoving(given, arm) : given;
  if (typed.shape.at(-1) !== dof) throw notPerJoint(`${arm.name}: q`, arm, typed.shape);
  return inRadians(typed, arm, angles);
}

// Describe the masses that are used for comparison.
const describeModel = ({ masses, gravity }) => [
  formatMessage("taken: masses", {
    masses: masses.map((mass) => formatNumber(mass, 3)).join(", "),
    g: formatNumber(Math.hypot(...gravity), 4),
  }),
];

// Return the torques with a row for each pose. Transposed lists are turned and values of locked
// joints dropped, and the verdict reports both.
function arrangeByPose({ values, units, shape }, count, arm) {
  const moving = movingRows(arm);
  const [dof, rows] = [moving.length, arm.rows.length];
  const sizes = shape.filter((n) => n !== 1);
  for (const width of new Set([dof, rows])) {
    const noteLocked = (all) => (width > dof ? [setAside(arm, all)] : []);
    const dropLocked = (list) =>
      width > dof ? list.filter((_, i) => moving.includes(i % rows)) : list;
    const hasShape = (m, n) => sizes.length === 2 && sizes[0] === m && sizes[1] === n;
    if (hasShape(count, width) || (count === 1 && sizes.length === 1 && values.length === width))
      return { values: dropLocked(values), units: dropLocked(units), said: noteLocked(values) };
    if (hasShape(width, count) && count !== width) {
      const transposeList = (list) => transpose(list, sizes);
      return {
        values: dropLocked(transposeList(values)),
        units: dropLocked(transposeList(units)),
        said: [formatMessage("taken: list per joint"), ...noteLocked(transposeList(values))],
        isPerJoint: true,
      };
    }
  }
  return null;
}

const makeTorquesVerdict = (arm, grade, headline, fields) =>
  makeVerdict("torques", arm, grade, headline, fields);

function reportWrongShape({ shape, values }, count, arm) {
  const dof = movingRows(arm).length;
  const key = values.length === count && values.length !== count * dof ? "tau.energy" : "tau.shape";
  const wanted = count > 1 ? `${count}x${dof}` : String(dof);
  const sizes = count > 1 ? shape : shape.filter((n) => n !== 1);
  const words = formatMessage(key, { shape: sizes.join("x") || "1", wanted, dof });
  const findings = [{ what: "shape", where: "", mine: shape, expected: [count, dof], words }];
  const headline = formatMessage("tau wrong", { arm: arm.name, cause: uncapitalize(words) });
  return makeTorquesVerdict(arm, WRONG, headline, { findings, causes: [key] });
}

/** @returns {import("../verdict.js").Verdict} */
function judgeArrangedTorques(typed, at, load, { arm, tolerance }) {
  const verdict = findExplanation(typed, at, load, { arm, tolerance });
  const causes = verdict.slips.map((slip) => slip.cause);
  const truth = makeTorqueMaker(load, load.c.dof, at.values)()(at.values);
  const figures = measureErrors(typed.values, truth, verdict, load.c.dof);
  const rest = { taken: typed.said, figures, wrong: verdict.wrong };
  if (verdict.grade === WRONG) {
    const empty = !typed.values.some(Boolean);
    const verdictOnWrong = empty
      ? reportZeroTorques(causes, arm)
      : reportWrongTorques(causes, verdict.wrong, typed, truth, arm);
    return { ...verdictOnWrong, ...rest };
  }
  const keys = { [RIGHT]: "tau right", [SO_FAR]: "tau so far" };
  const precision = typed.units.some(Boolean) ? formatMessage("to your digits") : "";
  const places = joinList(wrongJoints(verdict.wrong, arm).map((k) => nameJoint(arm, k)));
  const headline = formatMessage(keys[verdict.grade] ?? "tau rounded", {
    arm: arm.name,
    precision,
    places,
  });
  const notes = verdict.how === "cut" ? [formatMessage("cut")] : [];
  return makeTorquesVerdict(arm, verdict.grade, headline, { ...rest, notes });
}

// Try mistakes at a few of many poses first, and only those that fit at all poses.
function findExplanation(typed, at, load, { arm, tolerance }) {
  const { dof } = load.c;
  const count = load.wrenches.length;
  const steps = listTorqueSteps(arm, load);
  const isEmpty = !typed.values.some(Boolean);
  const judge = (mine, q, maker, mistakes, further) =>
    judgeEntries({ mine, q, dof, right: maker(), slips: mistakes, tolerance, further });
  const judgeAll = (mine, q, poses) => {
    const maker = makeTorqueMaker(poses, dof, q.values);
    const pairs = isEmpty ? [] : [() => listMistakePairs(steps, maker)];
    return judge(mine, q, maker, listSingleMistakes(steps, maker), pairs);
  };
  if (count <= SAMPLE) return judgeAll(typed, at, load);
  const indices = Array.from({ length: SAMPLE }, (_, i) =>
    Math.round((i * (count - 1)) / (SAMPLE - 1)),
  );
  const select = (list) => indices.flatMap((i) => list.slice(i * dof, (i + 1) * dof));
  const sample = ({ values, units }) => ({ values: select(values), units: select(units) });
  const wrenches = indices.map((i) => load.wrenches[i]);
  const first = judgeAll(sample(typed), sample(at), { ...load, wrenches });
  const maker = makeTorqueMaker(load, dof, at.values);
  const mistakes = first.slips.map(({ cause, steps: wrong }) => ({ cause, make: maker(wrong) }));
  return judge(typed, at, maker, mistakes, []);
}

// Report the largest error of a torque, and the number of joints that are right at every pose.
function measureErrors(mine, truth, { grade, wrong }, dof) {
  const off = mine.map((x, i) => Math.abs(x - truth[i]));
  const bad = new Set(wrong.flatMap((is, i) => (is && grade === WRONG ? [i % dof] : [])));
  return { worst: Math.max(0, ...off), right: dof - bad.size, of: dof };
}

// All zeros: an empty answer or a forgotten load, so the message asks about both.
function reportZeroTorques(causes, arm) {
  const headline = formatMessage("tau wrong", {
    arm: arm.name,
    cause: uncapitalize(formatMessage("tau zero")),
  });
  return makeTorquesVerdict(arm, WRONG, headline, { causes: causes.slice(0, 1).map(causeName) });
}

const nameJoint = (arm, k) => formatMessage("joint", { joint: jointNumbers(arm)[k] });
const selectJoint = (list, k, dof) => list.filter((_, i) => i % dof === k);
const wrongJoints = (wrong, arm) => {
  const dof = movingRows(arm).length;
  return jointNumbers(arm).flatMap((_, k) =>
    selectJoint(wrong, k, dof).includes(true) ? [k] : [],
  );
};

function reportWrongTorques(causes, wrong, typed, truth, arm) {
  if (causes.length) {
    const words = joinCauseMessages(causes);
    const findings = [{ what: "cause", where: "", words: `${words}.` }];
    const headline = formatMessage("tau wrong", {
      arm: arm.name,
      cause: `${uncapitalize(words)}.`,
    });
    const report = causes.some(({ keys }) => keys.includes("tau.report"));
    const notes = report ? [formatMessage("slip 8")] : [];
    return makeTorquesVerdict(arm, WRONG, headline, {
      findings,
      causes: causes.map(causeName),
      notes,
    });
  }
  const findings = wrongJoints(wrong, arm).map((k) => describeWrongJoint(arm, k, typed, truth));
  const places = joinList(findings.map(({ where }) => where));
  const headline = formatMessage("tau wrong places", { arm: arm.name, places });
  return makeTorquesVerdict(arm, WRONG, headline, { findings });
}

// Describe a wrong joint: its sign is reversed, or by how much it is off.
function describeWrongJoint(arm, k, typed, truth) {
  const dof = movingRows(arm).length;
  const [mine, right] = [typed.values, truth].map((list) => selectJoint(list, k, dof));
  const off = formatNumber(Math.max(...subtractEach(mine, right).map(Math.abs)), 2);
  const isNegated = mine.every((x, i) => Math.abs(x + right[i]) < Math.abs(x - right[i]) / 1e3);
  const words = formatMessage(isNegated ? "tau other way" : "tau off", {
    joint: jointNumbers(arm)[k],
    most: mine.length > 1 ? formatMessage("up to") : "",
    off,
    unit: revoluteFlags(arm)[k] ? "N m" : "N",
  });
  return { what: "joint", where: nameJoint(arm, k), words };
}
