// Judges a table that describes the same arm. The student may choose the zero and direction of each
// joint. The question fixes the base, the tip and the last axis, and may fix the pose at some joint
// values.

import { makeCause, causeMessage } from "../causes/ranking.js";
import { RIGHT, RIGHT_BY_MAP, ROUNDED, WRONG } from "../digits.js";
import { DEG } from "../geometry/angles.js";
import { angleDistance, isBaseHeightGap, listDifferentEntries } from "../geometry/axes.js";
import { findJointMap, formatJointValue, listMappedJoints, wrap } from "../geometry/joint_map.js";
import { linkFrames, minus, norm, rotationBetween } from "../geometry/kinematics.js";
import { expressInOwnJoints, formatRows, toOwnJoints } from "../geometry/own_joints.js";
import { ANGLE_TOLERANCE, snapAngle } from "../geometry/rows.js";
import {
  formatMessage,
  formatNumber,
  toClause,
  uncapitalize,
  formatRowNumbers,
} from "../sentences.js";
import { makeVerdict } from "../verdict.js";
import {
  describeEntry,
  entryText,
  RIGHT_ANGLES,
  entryUnit,
  roundTo,
  typedRowNumber,
} from "./table_messages.js";

const TIP_TOLERANCE = 1e-4; // m: tips this close are at the same point
const TURN_TOLERANCE = 1e-3; // rad, of a joint's zero
const MOST_MISTAKES = 3; // with more wrong entries, the student chose other zeros of the joints

/** @typedef {import("./table.js").Table} Table */
/** @typedef {import("../geometry/arm.js").Arm} Arm */
/** @typedef {import("../geometry/arm.js").TableRow} TableRow */
/** @typedef {import("../geometry/axes.js").AxisComparison} AxisComparison */
/** @typedef {import("../geometry/axes.js").TableAxes} TableAxes */
/** @typedef {import("../geometry/joint_map.js").JointMap} JointMap */
/** @typedef {import("../verdict.js").Verdict} Verdict */
/** @typedef {import("../verdict.js").Finding} Finding */
/**
 * The student's table beside the reference. Angles near a right angle are right angles in both
 * lists of rows.
 * @typedef {object} TablePair
 * @property {Table} table the student's table as typed
 * @property {Arm} reference
 * @property {TableRow[]} rows of the student's table
 * @property {TableRow[]} expectedRows of the reference
 * @property {TableAxes} axes of the student's table
 * @property {TableAxes} expectedAxes of the reference
 */
/**
 * A fault of a table that the question does not allow, such as a wrong base. It has a message
 * without a full stop, the position in the table, and the column of the wrong entry ("" for any).
 * @typedef {{ message: string, where: string, entry: string }} Fault
 */
/**
 * @typedef {object} Tolerances
 * @property {number} length how much lengths may differ (m)
 * @property {number} mapLength how much lengths may differ in the search for a joint map (m)
 * @property {number[] | null} startConfiguration joint values whose pose the question fixes
 */

/**
 * Judge a table whose axes are those of the reference.
 * @param {TablePair} pair
 * @param {AxisComparison} comparison
 * @param {string} grade by the digits of the lengths: RIGHT or ROUNDED
 * @param {Tolerances} tolerances
 * @returns {Verdict}
 */
export function judgeSameArm(pair, comparison, grade, tolerances) {
  const { table, reference, axes, expectedAxes } = pair;
  const map = findJointMap(axes, expectedAxes, comparison, tolerances.mapLength);
  const fault = findFault(pair, comparison, map, tolerances);
  if (fault) return makeFaultVerdict(pair, fault, tolerances.mapLength);
  const joints = listMappedJoints(map, listOwnNumbers(table, axes), expectedAxes);
  const names = { mine: table.name, reference: reference.name };
  const shared = { taken: table.assumptions, figures: { "same machine": true } };
  const isToolReversed = angleDistance(...comparison.toolAngles) > 1;
  if (isIdentity(map, expectedAxes, grade) && !isToolReversed) {
    const headline = formatMessage(grade === RIGHT ? "table same" : "table rounded", names);
    return makeVerdict("table", reference, grade, headline, {
      ...shared,
      notes: noteRightAngles(table),
    });
  }
  const ownName = formatMessage("own joints", { arm: reference.name });
  const arm = expressInOwnJoints(reference, axes, map, ownName);
  const start = wrapAngles(arm.home, joints);
  return makeVerdict("table", reference, RIGHT_BY_MAP, formatMessage("table right by map", names), {
    ...shared,
    map: {
      ...map,
      start,
      arm,
      ...describeMap(map, joints, reference),
    },
    advice: [{ field: "ownJoints", value: formatRows(axes.rows) }],
    notes: [
      ...noteLastFrame(pair, map, isToolReversed),
      ...noteStart(start, joints),
      ...noteMistakes(pair, tolerances.mapLength),
      ...(grade === ROUNDED ? [formatMessage("map rounded")] : []),
      ...noteRightAngles(table),
    ],
  });
}

/**
 * Note how the last frame is turned where both tips meet. The student may choose its axes.
 * @param {TablePair} pair @param {JointMap} map @returns {string[]}
 */
function noteLastFrame({ reference, axes, expectedAxes }, map, isToolReversed) {
  if (isToolReversed) return [formatMessage("tool reversed")];
  const q = reference.home ?? expectedAxes.joints.map(() => 0);
  const [lastFrame, expectedFrame] = [
    linkFrames(axes, toOwnJoints(map, q)),
    linkFrames(expectedAxes, q),
  ].map((frames) => frames.at(-1));
  const turn = rotationBetween(lastFrame, expectedFrame) * DEG;
  return turn < 1 ? [] : [formatMessage("tool turned", { degrees: formatNumber(turn, 3) })];
}

const listOwnNumbers = (table, axes) => axes.joints.map((i) => typedRowNumber(table, i, "d"));

// Requirements of the question

/** @param {TablePair} pair @param {JointMap | null} map @returns {Fault | null} */
function findFault(pair, comparison, map, { length, startConfiguration }) {
  return (
    findBaseFault(pair, comparison, map, length) ??
    findToolFault(pair, comparison) ??
    (map ? null : { message: formatMessage("no joint map"), where: "", entry: "" }) ??
    (startConfiguration ? findStartFault(pair, startConfiguration, length) : null)
  );
}

/** Find a base frame that is elsewhere on axis 1, or upside down. @returns {Fault | null} */
function findBaseFault({ table, axes }, { upsideDown, baseHigher }, map, length) {
  const gap = axes.gaps.find(isBaseHeightGap)?.parallelJoints.at(-1) ?? 0;
  const row = typedRowNumber(table, axes.joints[gap], "d");
  const where = `row ${row}, d`;
  if (upsideDown)
    return { message: formatMessage("base upside down"), where: "row 1, alpha", entry: "" };
  // If axis 1 leans from z_0, the height is measured along axis 1.
  const higher = map && axes.axis1Angle <= ANGLE_TOLERANCE ? map.base.o[2] : baseHigher;
  if (Math.abs(higher) <= length) return null;
  const height = formatNumber(roundTo(1000 * Math.abs(higher), 6), 4);
  const way = formatMessage(higher > 0 ? "higher" : "lower");
  return { message: formatMessage("base", { height, way, row }), where, entry: "d" };
}

// Find a last frame whose z axis is at a wrong angle to the last joint axis. The student may choose
// the direction of z along that axis.
/** @returns {Fault | null} */
function findToolFault({ table, axes }, { toolAngles: [angle, expected] }) {
  const error = Math.min(angleDistance(angle, expected), angleDistance(angle, Math.PI - expected));
  if (error <= Math.max(ANGLE_TOLERANCE, 0.51 * table.angleUnit)) return null;
  const [mine, reference] = [angle, expected].map((x) => formatNumber(roundTo(x * DEG, 4), 4));
  const row = typedRowNumber(table, axes.rows.length, "alpha");
  const message = formatMessage("tool", { mine, reference, row });
  return { message, where: `row ${row}, alpha`, entry: "alpha" };
}

/** Find a tool elsewhere at the joint values whose pose is fixed. @returns {Fault | null} */
function findStartFault({ rows, reference }, startConfiguration, length) {
  const [tip, expectedTip] = [rows, reference.rows].map((arm) =>
    linkFrames({ rows: arm }, startConfiguration).at(-1),
  );
  const away = norm(minus(tip.o, expectedTip.o));
  const turn = rotationBetween(tip, expectedTip) * DEG;
  if (away <= Math.max(TIP_TOLERANCE, 2 * rows.length * length) && turn < 1) return null;
  const fields = {
    start: `(${startConfiguration.map((x) => formatNumber(x, 4)).join(", ")})`,
    away: formatNumber(away < TIP_TOLERANCE ? 0 : away, 3),
    turned: turn < 1 ? "" : formatMessage("table tool turned", { degrees: formatNumber(turn, 3) }),
  };
  return { message: formatMessage("start configuration", fields), where: "", entry: "" };
}

/** @param {TablePair} pair @param {Fault} fault @returns {Verdict} */
function makeFaultVerdict(pair, fault, length) {
  const { table, reference } = pair;
  const entries = describeDifferentEntries(pair, length, fault.entry);
  const cause = entries.map(({ words }) => toClause(words)).join("; ");
  const fields = { mine: table.name, reference: reference.name, fault: fault.message, cause };
  const headline = formatMessage(cause ? "table other base because" : "table other base", fields);
  const { where } = fault;
  const ownCauses = entries.map(({ what }) => what).filter((what) => what.includes("."));
  const isOneCause = entries.length === 1 && ownCauses.length === 1;
  return makeVerdict("table", reference, WRONG, headline, {
    findings: entries.length
      ? entries.map((entry) => (isOneCause ? { ...entry, what: "cause" } : entry))
      : [{ what: "cause", where, words: headline }],
    causes: ownCauses.length ? [ownCauses.join(" + ")] : [],
    taken: table.assumptions,
    figures: { "same machine": true },
  });
}

// The joint map

/** Return whether all joints count as in the reference. @param {JointMap} map */
function isIdentity({ signs, offsets }, { rows, joints }, grade) {
  // Rounded lengths turn a joint's zero a little.
  const turn = grade === RIGHT ? TURN_TOLERANCE : 1 / DEG;
  const isRevolute = (k) => rows[joints[k] - 1].kind === "revolute";
  return (
    signs.every((sign) => sign > 0) &&
    offsets.every((offset, k) => Math.abs(offset) <= (isRevolute(k) ? turn : TIP_TOLERANCE))
  );
}

/** @param {import("../geometry/joint_map.js").MappedJoint[]} joints */
function describeMap(map, joints, { home = [] }) {
  const equations = joints
    .filter(({ countsOtherwise }) => countsOtherwise)
    .map(({ number, ownNumber, sign, shift }) =>
      formatMessage(sign < 0 ? "map back" : "map joint", {
        joint: number,
        mine: ownNumber,
        tail: shift,
      }),
    );
  const ownHome = wrapAngles(toOwnJoints(map, home), joints);
  const hasHome = home.length === joints.length;
  const rows = joints.map(({ number, ownNumber, sign, shift, isRevolute }, k) => [
    `q_${number}`,
    `${sign < 0 ? "-" : ""}q_${ownNumber}${shift}`,
    ...(hasHome ? [home[k], ownHome[k]].map((x) => formatJointValue(x, isRevolute)) : []),
  ]);
  const headers = ["map table reference", "map table own"];
  if (hasHome) headers.push("map table start", "map table own start");
  return {
    message: formatMessage("map", { equations: equations.join("; ") }),
    table: { headers: headers.map((key) => formatMessage(key)), rows },
  };
}

// Take whole turns off the values of joints that turn.
const wrapAngles = (q, joints) => q.map((x, k) => (joints[k].isRevolute ? wrap(x) : x));

function noteStart(start, joints) {
  if (start.length !== joints.length) return [];
  const values = start.map((x, k) => formatJointValue(x, joints[k].isRevolute));
  return [formatMessage("map start", { start: values.join(", ") })];
}

// Note the mistakes that would give this joint map, as a question to the student.
/** @param {TablePair} pair */
function noteMistakes(pair, length) {
  const { rows, expectedRows } = pair;
  const entries = listDifferentEntries(rows, expectedRows, length) ?? [];
  const areOffsets = entries.every(([k, column]) => column === "theta" && !rows[k].theta);
  const cause =
    entries.length > 1 && areOffsets
      ? causeMessage(makeCause("table.offsets"))
      : describeDifferentEntries(pair, length)
          .map(({ words }) => toClause(words))
          .join("; ");
  return cause ? [formatMessage("map mistake", { cause: uncapitalize(cause) })] : [];
}

/**
 * Describe the entries that differ from the reference's, if they are few.
 * @param {TablePair} pair @param {number} length tolerance (m) @param {string} [column] "" for all
 * @returns {Finding[]}
 */
function describeDifferentEntries({ table, rows, expectedRows }, length, column = "") {
  const entries = listDifferentEntries(rows, expectedRows, length) ?? [];
  if (entries.length > MOST_MISTAKES) return [];
  const comparison = { cause: null, rows, reference: expectedRows };
  return entries
    .filter(([, entry]) => !column || entry === column)
    .map((entry) => describeEntry(table, comparison, entry, length));
}

// Note the angles that were replaced by multiples of a right angle more than `tolerance` (rad)
// away. The table has a single note, which joins equal angles of a column.
/** @param {Table} table */
export function noteRightAngles(table, tolerance = 1e-9) {
  const groups = new Map();
  for (const { column, typed, wanted, row } of listNearRightAngles(table, tolerance)) {
    const key = `${column} ${typed}`;
    const group = groups.get(key) ?? { column, typed, wanted, rows: [] };
    groups.set(key, group);
    group.rows.push(row);
  }
  if (!groups.size) return [];
  const angles = [...groups.values()].map(({ rows, ...fields }) =>
    formatMessage("right angle", { ...fields, rows: formatRowNumbers(rows) }),
  );
  const count = [...groups.values()].flatMap(({ rows }) => rows).length;
  const key = count > 1 ? "write right angles" : "write right angle";
  return [formatMessage(key, { angles: angles.join("; ") })];
}

/** @param {Table} table @param {number} tolerance */
const listNearRightAngles = (table, tolerance) =>
  table.rows.flatMap((row, k) =>
    ["alpha", "theta"].flatMap((column) => {
      const right = snapAngle(row[column], entryUnit(table, k + 1, column));
      if (Math.abs(row[column] - right) <= tolerance) return [];
      const turns = Math.round(right / (Math.PI / 2));
      return [
        {
          column,
          row: typedRowNumber(table, k + 1, column),
          typed: entryText(table, k + 1, column),
          wanted: RIGHT_ANGLES[turns] ?? `${turns} pi/2`,
        },
      ];
    }),
  );
