// Converts an arm to the joint values of a student's table, which counts the joints otherwise.

import { findRowsFault, NO_LIMITS } from "./arm.js";
import { compareAxes, describeAxes } from "./axes.js";
import { findJointMap } from "./joint_map.js";
import { dot, linkFrames, plus, pointInBase, pointInFrame, scaled } from "./kinematics.js";
import { snapRows } from "./rows.js";

/** @typedef {import("./arm.js").Arm} Arm */
/** @typedef {import("./arm.js").Row} Row */
/** @typedef {import("./joint_map.js").JointMap} JointMap */

/**
 * Return the student's joint values of a configuration of the reference arm.
 * @param {JointMap} map
 * @param {number[]} q joint values of the reference (rad or m)
 */
export const toOwnJoints = ({ signs, offsets }, q) =>
  q.map((x, k) => signs[k] * (x - offsets[k]) + 0);

/**
 * Return the reference arm with the student's rows and converted limits, home and bodies.
 * @param {Arm} reference
 * @param {{ rows: Row[] }} table the student's rows
 * @param {JointMap} map
 * @param {string} name of the new arm
 * @returns {Arm}
 */
export function expressInOwnJoints(reference, table, map, name) {
  const joints = reference.rows.filter(({ kind }) => kind !== "fixed");
  let k = 0;
  const rows = table.rows.map(({ kind, a, alpha, d, theta }) => {
    const row = { kind, a, alpha, d, theta, ...NO_LIMITS };
    if (kind === "fixed") return row;
    const limits = convertLimits(joints[k], map.signs[k], map.offsets[k]);
    k++;
    return { ...row, ...limits };
  });
  const bodies = convertBodies(reference, table, map);
  return {
    name,
    home: toOwnJoints(map, reference.home ?? []),
    rows: bodies ? rows.map((row, i) => ({ ...row, body: bodies[i] })) : rows,
  };
}

/** @param {Row} joint of the reference @param {number} sign @param {number} offset */
function convertLimits({ lower, upper, speed, effort }, sign, offset) {
  const convert = (limit) => (limit === null ? null : sign * (limit - offset));
  const [first, last] = sign > 0 ? [lower, upper] : [upper, lower];
  return { lower: convert(first), upper: convert(last), speed, effort };
}

// Return the mass and centre of mass of each row of the student's table. A link of the reference
// goes to the last row that moves with it. A link that is fixed to the base has no row and is left
// out. The result is null if the reference has no bodies.
function convertBodies(reference, table, map) {
  if (!reference.rows.some(({ body }) => body)) return null;
  const frames = linkFrames(reference, map.offsets);
  const ownFrames = linkFrames(
    table,
    map.offsets.map(() => 0),
  );
  const ownJoints = countMovingRows(table.rows);
  const totals = table.rows.map(() => ({ mass: 0, moment: [0, 0, 0] }));
  countMovingRows(reference.rows).forEach((joint, i) => {
    const row = ownJoints.lastIndexOf(joint);
    if (row < 0) return;
    const [mass, ...centre] = reference.rows[i].body;
    const point = pointInFrame(ownFrames[row + 1], pointInBase(frames[i + 1], centre));
    totals[row].mass += mass;
    totals[row].moment = plus(totals[row].moment, scaled(mass, point));
  });
  return totals.map(({ mass, moment }) => [mass, ...(mass ? scaled(1 / mass, moment) : moment)]);
}

// Return for each row the number of joints that move its link.
function countMovingRows(rows) {
  let count = 0;
  return rows.map(({ kind }) => (kind === "fixed" ? count : ++count));
}

const LENGTH_TOLERANCE = 2e-3; // m: rows of a right table, typed to the millimetre
const ANGLE_TOLERANCE = 5e-3; // rad: typed to two decimals or to half a degree

/**
 * Return the reference arm in the joints of a student's table. It ends in the reference's tool
 * frame, and it is null if the table describes a different arm.
 * @param {Arm} reference
 * @param {Row[]} rows of the student's table
 * @param {string} name of the new arm
 * @returns {Arm | null}
 */
export function findOwnArm(reference, rows, name) {
  const [own, ref] = [rows, reference.rows].map((table) => describeAxes(snapRows(table)));
  const comparison = compareAxes(own, ref, LENGTH_TOLERANCE, ANGLE_TOLERANCE);
  if (comparison.differences.length) return null;
  const map = findJointMap(own, ref, comparison, LENGTH_TOLERANCE);
  if (!map) return null;
  const arm = expressInOwnJoints(reference, own, map, name);
  return { ...arm, rows: [...arm.rows, ...makeToolRow(reference, arm, map)] };
}

// Return the fixed row from the student's last frame to the reference's, or none if they are equal.
function makeToolRow(reference, arm, map) {
  const tool = linkFrames(reference, map.offsets).at(-1);
  const own = linkFrames(
    arm,
    map.offsets.map(() => 0),
  ).at(-1);
  const theta = Math.atan2(dot(tool.x, own.y), dot(tool.x, own.x));
  const alpha = dot(tool.z, own.z) < 0 ? Math.PI : 0;
  if (!alpha && Math.abs(theta) < ANGLE_TOLERANCE) return [];
  const body = arm.rows[0].body ? { body: [0, 0, 0, 0] } : {};
  return [
    { kind: /** @type {const} */ ("fixed"), a: 0, alpha, d: 0, theta, ...NO_LIMITS, ...body },
  ];
}

const KIND_LETTERS = { revolute: "R", prismatic: "P", fixed: "F" };

/** Write rows as text for a link or the browser's storage. @param {Row[]} rows */
export const formatRows = (rows) =>
  rows
    .map(({ kind, a, alpha, d, theta }) =>
      [KIND_LETTERS[kind], ...[a, alpha, d, theta].map((x) => Number(x.toPrecision(12)))].join(" "),
    )
    .join(", ");

/**
 * Read rows from the text of a link or of the storage. The result is null if they make no arm.
 * @param {string} text
 * @returns {Row[] | null}
 */
export function parseRows(text) {
  const kinds = Object.entries(KIND_LETTERS);
  const rows = text.split(",").map((row) => {
    const [letter, ...entries] = row.trim().split(" ");
    const kind = kinds.find(([, kindLetter]) => kindLetter === letter)?.[0];
    const [a, alpha, d, theta] = entries.map(Number);
    return /** @type {Row} */ ({ kind, a, alpha, d, theta });
  });
  return findRowsFault(rows) ? null : rows;
}
