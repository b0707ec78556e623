// Finds all joint vectors that take the tip to a target, by the closed forms of helpers/inverse,
// which names the sources. Free joints are at 0. The chapters' forms stay beside
// inverse_structure.js because they give branches the chapters' names, such as "front, elbow up".
// Their solutions, free joints and multiplicities equal those by structure, except for joint 6 of
// the form ur (tests/explorer/inverse.test.mjs).

import { ArmError, formatNumber } from "../sentences.js";
import { solveByStructure } from "./inverse_structure.js";
import { solveUr } from "./inverse_ur.js";
import { cross, dot, linkFrames, minus, vectorInFrame } from "./kinematics.js";
import {
  collectBranches,
  solveShoulder,
  VECTOR_ROUND_OFF,
  withTwist,
  BOUNDARY_DISTANCE,
  subtractOffset,
  SIDES,
  SINGULAR,
  solveTwoLinks,
  removeLastRow,
  wrapAngle,
  WRISTS,
} from "./planar.js";
import { findStructure } from "./structure.js";

const ELBOWS = ["elbow up", "elbow down"];
const RODS = ["rod out", "rod through"];

/** @typedef {import("./arm.js").Arm} Arm */
/**
 * A solution of inverse kinematics.
 * @typedef {object} Branch
 * @property {string} name such as "front, elbow up"
 * @property {number[]} q joint values (rad or m)
 * @property {boolean[]} free whether each joint may have any value here
 * @property {number} times how many branches coincide here: 1, 2, 4 or 8
 * @property {number} [uncertainty] of the joint angles because of round-off (rad)
 */

// Shoulders: the first three joints for a position

/** @returns {Branch[]} */
function solveElbow(arm, p) {
  const [first, second, third, tool] = arm.rows.map(withTwist);
  const links = findLinks(second, third, tool?.d ?? 0);
  const plane = solveShoulder(first, links.offset, p);
  return collectBranches([SIDES, ELBOWS], (side, bend) => {
    const sign = first.sa * (side === bend ? -1 : 1);
    const elbow = solveTwoLinks(links, [plane.x[side], plane.y], sign, second.theta);
    if (!plane.exists || !elbow.exists) return null;
    const q = [
      subtractOffset(plane.phi[side], first.theta),
      subtractOffset(elbow.phi2, second.theta),
      subtractOffset(second.ca * elbow.phi3, links.beta + third.theta),
    ];
    const free = [plane.free, elbow.free, false];
    const uncertainty = plane.uncertainty + elbow.uncertainty;
    return { q, free, merged: [plane.isDouble, elbow.isDouble], uncertainty };
  });
}

// Return the lengths of the two links, the angle `beta` of the second one from x_3 to its end, and
// the offset of their plane from axis 1 (m, rad).
function findLinks(second, third, tool) {
  const across = -tool * third.sa;
  return {
    upper: second.a,
    fore: Math.hypot(third.a, across),
    beta: Math.atan2(across, third.a),
    offset: second.d + second.ca * (third.d + tool * third.ca),
  };
}

/** @returns {Branch[]} */
function solveRod(arm, p) {
  const [first, second, third, tool] = arm.rows.map(withTwist);
  const plane = solveShoulder(first, second.d, p);
  return collectBranches([SIDES, RODS], (side, through) => {
    if (!plane.exists) return null;
    const out = through ? -1 : 1;
    const length = out * Math.hypot(plane.x[side], plane.y);
    const lean = second.sa * out;
    const isAtCentre = Math.abs(length) < BOUNDARY_DISTANCE;
    const phi2 = Math.atan2(lean * plane.x[side], -lean * plane.y);
    const q = [
      subtractOffset(plane.phi[side], first.theta),
      isAtCentre ? 0 : subtractOffset(phi2, second.theta),
      length - third.d - (tool?.d ?? 0),
    ];
    const endUncertainty = VECTOR_ROUND_OFF + Math.hypot(p[0], p[1]) * plane.uncertainty; // m
    const uncertainty = plane.uncertainty + (isAtCentre ? 0 : endUncertainty / Math.abs(length));
    const free = [plane.free, isAtCentre, false];
    return { q, free, merged: [plane.isDouble, isAtCentre], uncertainty };
  });
}

// A spherical wrist on a shoulder

const cutAtWristCentre = (arm) => ({
  ...arm,
  rows: [...arm.rows.slice(0, 3), { kind: "fixed", a: 0, alpha: 0, d: arm.rows[3].d, theta: 0 }],
});

/** @returns {Branch[]} */
function solveDecoupled(solvePosition, arm, target) {
  const rows = arm.rows.map(withTwist);
  const tool = removeLastRow(rows[5], target);
  const shoulder = cutAtWristCentre(arm);
  return solvePosition(shoulder, tool.centre).flatMap(({ name, q, free, times, uncertainty }) => {
    const frame = linkFrames(shoulder, q).at(-1);
    const [x, z] = [tool.x, tool.z].map((v) => vectorInFrame(frame, v));
    const { pairs, singular } = solveWrist(rows, x, z, uncertainty);
    return WRISTS.slice(0, singular ? 1 : 2).map((wrist, k) => ({
      name: `${name}, ${wrist}`,
      times: singular ? 2 * times : times,
      q: [...q, ...pairs.map((pair, j) => wrapAngle(pair[k] - rows[3 + j].theta))],
      free: [...free, singular, false, false],
    }));
  });
}

// Return both solutions of joints 4 to 6 from the tool's axes x and z in frame 3. Round-off may
// have turned the first three joints by `uncertainty` (rad).
function solveWrist(rows, x, z, uncertainty) {
  const [s4, s5] = [rows[3].sa, rows[4].sa];
  const cosine = -s4 * s5 * z[2];
  const singular = Math.hypot(z[0], z[1]) < SINGULAR + uncertainty;
  const sine = singular ? 0 : Math.hypot(z[0], z[1]);
  const phi4 = singular ? rows[3].theta : Math.atan2(s5 * z[1], s5 * z[0]);
  const [c, s] = [Math.cos(phi4), Math.sin(phi4)];
  const [ahead, aside] = [c * x[0] + s * x[1], c * x[1] - s * x[0]];
  const phi5 = Math.atan2(sine, cosine);
  const phi6 = Math.atan2(-s4 * s5 * aside, cosine * ahead + s4 * sine * x[2]);
  const flip = singular ? 0 : Math.PI;
  return {
    pairs: [
      [phi4, phi4 + flip],
      [phi5, -phi5],
      [phi6, phi6 + flip],
    ],
    singular,
  };
}

// The closed form of an arm

const listKindLetters = (rows) => rows.map(({ kind }) => kind[0]).join("");

function isElbowArm({ rows }) {
  if (!["rrr", "rrrf"].includes(listKindLetters(rows))) return false;
  const [first, second, third, tool] = rows.map(withTwist);
  const isPlanar = first.a === 0 && first.ca === 0 && second.sa === 0 && second.a !== 0;
  return isPlanar && findLinks(second, third, tool?.d ?? 0).fore > 0 && !tool?.a;
}

function hasRod({ rows }) {
  if (!["rrp", "rrpf"].includes(listKindLetters(rows))) return false;
  const [first, second, third] = rows.map(withTwist);
  const isRightAngled = first.ca === 0 && second.ca === 0 && third.sa === 0 && third.ca === 1;
  return isRightAngled && rows.every(({ a }) => a === 0);
}

function hasRightAngledWrist({ rows }) {
  if (rows.length !== 6 || listKindLetters(rows.slice(3)) !== "rrr") return false;
  const [fourth, fifth] = rows.slice(3).map(withTwist);
  return fourth.a === 0 && fifth.a === 0 && fifth.d === 0 && fourth.ca === 0 && fifth.ca === 0;
}

function isUrArm({ rows }) {
  if (listKindLetters(rows) !== "rrrrrr") return false;
  const [first, second, third, fourth, fifth] = rows.map(withTwist);
  const areRightAngled = [first, fourth, fifth].every(({ a, ca }) => a === 0 && ca === 0);
  return areRightAngled && second.sa === 0 && third.sa === 0 && second.a * third.a !== 0;
}

const FORMS = {
  elbow: { fits: isElbowArm, solve: solveElbow, pose: false },
  rod: { fits: hasRod, solve: solveRod, pose: false },
  stanford: {
    fits: (arm) => hasRightAngledWrist(arm) && hasRod(cutAtWristCentre(arm)),
    solve: (arm, target) => solveDecoupled(solveRod, arm, target),
    pose: true,
  },
  spherical_wrist: {
    fits: (arm) => hasRightAngledWrist(arm) && isElbowArm(cutAtWristCentre(arm)),
    solve: (arm, target) => solveDecoupled(solveElbow, arm, target),
    pose: true,
  },
  ur: { fits: isUrArm, solve: solveUr, pose: true },
  solutions: { fits: (arm) => isSolvedForPoses(arm) === true, solve: solveByStructure, pose: true },
  positions: {
    fits: (arm) => isSolvedForPoses(arm) === false,
    solve: solveByStructure,
    pose: false,
  },
};

// Return whether the structure of an arm is solved for poses, not for points. It is null for an arm
// without a structure.
function isSolvedForPoses(arm) {
  const structure = findStructure(arm);
  return structure && !["position", "two links"].includes(structure.kind);
}

/**
 * Return the name of the arm's closed form, or null if it has none. For the arms of the chapters it
 * is the name of the function in helpers.inverse.
 * @param {Arm} arm
 */
export const findClosedForm = (arm) =>
  Object.keys(FORMS).find((name) => FORMS[name].fits(arm)) ?? null;

/** Return whether the targets of a closed form are poses, not points. @param {string} form */
export const needsPose = (form) => FORMS[form].pose;

/**
 * Find all branches of the inverse kinematics for a target.
 * @param {Arm} arm
 * @param {string} form name of the closed form
 * @param {any} target three coordinates (m), or a frame where the form needs a pose
 * @returns {Branch[]}
 */
export function solveInverse(arm, form, target) {
  if (FORMS[form].pose) checkRigid(arm, target);
  return FORMS[form].solve(arm, target);
}

// Error of a rotation typed with six decimals. helpers/poses.py has the same bound
// (tests/test_poses.py).
const LARGEST_ROTATION_ERROR = 1e-6;

function checkRigid(arm, { x, y, z }) {
  const errors = [...minus(cross(x, y), z), ...[x, y, z].map((v) => dot(v, v) - 1)];
  const error = Math.max(...errors.map(Math.abs));
  if (error > LARGEST_ROTATION_ERROR) {
    throw new ArmError(
      `${arm.name}: a target is no rigid transform, by ${formatNumber(error, 2)};` +
        " expected a rotation and a position over (0, 0, 0, 1)",
    );
  }
}
