// All joint vectors that take the tip to a target, by the closed forms of helpers/inverse (elbow,
// rod, stanford, spherical_wrist, ur, solutions). Free joints are at 0; sources are named there.
// The chapters' forms stay beside inverse_structure.js: they give branches the chapters' names
// (front, elbow up), and ur frees joint 6 where axes 4 and 6 are parallel. Solutions, free joints
// and multiplicities of the others equal those by structure (tests/explorer/inverse.test.mjs).

import { ArmError, formatNumber } from "../sentences.js";
import { solveByStructure } from "./inverse_structure.js";
import { solveUr } from "./inverse_ur.js";
import { dot, linkFrames, minus } from "./kinematics.js";
import {
  collectBranches,
  solveShoulder,
  ROUND_OFF,
  withTwist,
  BOUNDARY,
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
/** @typedef {import("./kinematics.js").Frame} Frame */
/**
 * A solution of inverse kinematics.
 * @typedef {object} Branch
 * @property {string} name such as "front, elbow up"
 * @property {number[]} q joint values (rad or m)
 * @property {boolean[]} free whether each joint may have any value here
 * @property {number} times how many branches coincide here: 1, 2, 4 or 8
 */

// Shoulders: the first three joints for a position

/** @returns {Branch[]} */
function solveElbow(arm, p) {
  const [first, second, third, tool] = arm.rows.map(withTwist);
  const links = linksOf(second, third, tool?.d ?? 0);
  const plane = solveShoulder(first, links.offset, p);
  return collectBranches([SIDES, ELBOWS], (side, bend) => {
    const sign = first.sa * (side === bend ? -1 : 1);
    const found = solveTwoLinks(links, [plane.x[side], plane.y], sign, second.theta);
    if (!plane.exists || !found.exists) return null;
    const q = [
      subtractOffset(plane.phi[side], first.theta),
      subtractOffset(found.phi2, second.theta),
      subtractOffset(second.ca * found.phi3, links.beta + third.theta),
    ];
    const blur = plane.blur + found.blur;
    return { q, free: [plane.free, found.free, false], merged: [plane.one, found.one], blur };
  });
}

function linksOf(second, third, tool) {
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
    const central = Math.abs(length) < BOUNDARY;
    const phi2 = Math.atan2(lean * plane.x[side], -lean * plane.y);
    const q = [
      subtractOffset(plane.phi[side], first.theta),
      central ? 0 : subtractOffset(phi2, second.theta),
      length - third.d - (tool?.d ?? 0),
    ];
    const leaning = ROUND_OFF + Math.hypot(p[0], p[1]) * plane.blur;
    const blur = plane.blur + (central ? 0 : leaning / Math.abs(length));
    return { q, free: [plane.free, central, false], merged: [plane.one, central], blur };
  });
}

// A spherical wrist on a shoulder

const toCentre = (arm) => ({
  ...arm,
  rows: [...arm.rows.slice(0, 3), { kind: "fixed", a: 0, alpha: 0, d: arm.rows[3].d, theta: 0 }],
});

/** @returns {Branch[]} */
function solveDecoupled(solveShoulderFor, arm, target) {
  const rows = arm.rows.map(withTwist);
  const tool = removeLastRow(rows[5], target);
  const shoulder = toCentre(arm);
  return solveShoulderFor(shoulder, tool.centre).flatMap(({ name, q, free, times, blur }) => {
    const frame = linkFrames(shoulder, q).at(-1);
    const seen = (v) => [dot(frame.x, v), dot(frame.y, v), dot(frame.z, v)];
    const { pairs, singular } = solveWrist(rows, seen(tool.x), seen(tool.z), blur);
    return WRISTS.slice(0, singular ? 1 : 2).map((which, k) => ({
      name: `${name}, ${which}`,
      times: singular ? 2 * times : times,
      q: [...q, ...pairs.map((pair, j) => wrapAngle(pair[k] - rows[3 + j].theta))],
      free: [...free, singular, false, false],
    }));
  });
}

// Return both solutions of joints 4 to 6 from the tool's axes x and z in frame 3. Rounding may have
// turned the first three joints by `blur` (rad).
function solveWrist(rows, x, z, blur) {
  const [s4, s5] = [rows[3].sa, rows[4].sa];
  const cosine = -s4 * s5 * z[2];
  const singular = Math.hypot(z[0], z[1]) < SINGULAR + blur;
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

const kindsOf = (rows) => rows.map(({ kind }) => kind[0]).join("");

function isElbow({ rows }) {
  if (!["rrr", "rrrf"].includes(kindsOf(rows))) return false;
  const [first, second, third, tool] = rows.map(withTwist);
  const flat = first.a === 0 && first.ca === 0 && second.sa === 0 && second.a !== 0;
  return flat && linksOf(second, third, tool?.d ?? 0).fore > 0 && !tool?.a;
}

function hasRod({ rows }) {
  if (!["rrp", "rrpf"].includes(kindsOf(rows))) return false;
  const [first, second, third] = rows.map(withTwist);
  const square = first.ca === 0 && second.ca === 0 && third.sa === 0 && third.ca === 1;
  return square && rows.every(({ a }) => a === 0);
}

function hasWrist({ rows }) {
  if (rows.length !== 6 || kindsOf(rows.slice(3)) !== "rrr") return false;
  const [fourth, fifth] = rows.slice(3).map(withTwist);
  return fourth.a === 0 && fifth.a === 0 && fifth.d === 0 && fourth.ca === 0 && fifth.ca === 0;
}

function isUr({ rows }) {
  if (kindsOf(rows) !== "rrrrrr") return false;
  const [first, second, third, fourth, fifth] = rows.map(withTwist);
  const meeting = [first, fourth, fifth].every(({ a, ca }) => a === 0 && ca === 0);
  return meeting && second.sa === 0 && third.sa === 0 && second.a * third.a !== 0;
}

const FORMS = {
  elbow: { fits: isElbow, solve: solveElbow, pose: false },
  rod: { fits: hasRod, solve: solveRod, pose: false },
  stanford: {
    fits: (arm) => hasWrist(arm) && hasRod(toCentre(arm)),
    solve: (arm, target) => solveDecoupled(solveRod, arm, target),
    pose: true,
  },
  spherical_wrist: {
    fits: (arm) => hasWrist(arm) && isElbow(toCentre(arm)),
    solve: (arm, target) => solveDecoupled(solveElbow, arm, target),
    pose: true,
  },
  ur: { fits: isUr, solve: solveUr, pose: true },
  solutions: { fits: (arm) => isSolvedForPoses(arm) === true, solve: solveByStructure, pose: true },
  positions: {
    fits: (arm) => isSolvedForPoses(arm) === false,
    solve: solveByStructure,
    pose: false,
  },
};

// Return whether the structure of an arm is solved for poses, not for points; null without a
// structure.
function isSolvedForPoses(arm) {
  const structure = findStructure(arm);
  return structure && !["position", "two links"].includes(structure.kind);
}

/**
 * Return the name of the arm's closed form, which for taught arms is that in helpers.inverse; null
 * if it has none.
 * @param {Arm} arm
 */
export const findClosedForm = (arm) =>
  Object.keys(FORMS).find((name) => FORMS[name].fits(arm)) ?? null;

/** Return whether a closed form takes poses as targets, not points. */
export const needsPose = (form) => FORMS[form].pose;

/**
 * Solve the inverse kinematics of one target.
 * @param {Arm} arm
 * @param {string} form name of the closed form
 * @param {any} target three coordinates (m), or a frame where the form needs a pose
 * @returns {Branch[]}
 */
export function solveInverse(arm, form, target) {
  if (FORMS[form].pose) checkRigid(arm, target);
  return FORMS[form].solve(arm, target);
}

function checkRigid(arm, { x, y, z }) {
  const third = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
  const gaps = [...minus(third, z), ...[x, y, z].map((v) => dot(v, v) - 1)];
  const error = Math.max(...gaps.map(Math.abs));
  if (error > 1e-6) {
    throw new ArmError(
      `${arm.name}: a target is no rigid transform, by ${formatNumber(error, 2)};` +
        " expected a rotation and a position over (0, 0, 0, 1)",
    );
  }
}
