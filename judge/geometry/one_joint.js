// Finds by how much a single joint must change so that the tip comes as near to a goal as it can.

import { cross, dot, linkFrames, minus, movingRows, plus } from "./kinematics.js";

/** @typedef {import("./arm.js").Arm} Arm */
/** @typedef {import("./kinematics.js").Frame} Frame */
/** @typedef {{ point: number[], tool: Frame | null }} Goal `tool` is null if the tool may turn */

/**
 * Change each joint in turn, with the others as they are, so that the tip comes as near to a goal
 * as it can.
 * @param {Arm} arm
 * @param {number[]} q joint values (rad or m)
 * @param {Goal} goal
 * @returns {number[][]} for each joint the values with that joint changed
 */
export function listConfigurationsWithOneChange(arm, q, goal) {
  const frames = linkFrames(arm, q);
  const actual = listPoints(frames.at(-1), goal);
  const wanted = listPoints({ ...goal.tool, o: goal.point }, goal);
  return movingRows(arm).map((row, k) => {
    const isRevolute = arm.rows[row].kind === "revolute";
    const change = (isRevolute ? findTurn : findSlide)(frames[row], actual, wanted);
    return q.map((x, i) => (i === k ? x + change : x));
  });
}

// Return the origin of a frame, and the ends of its axes if the tool may not turn. The ends are 1 m
// away.
const listPoints = ({ x, y, z, o }, { tool }) => [
  o,
  ...(tool ? [x, y, z].map((v) => plus(o, v)) : []),
];

// Return the angle about the z axis of a frame by which points come nearest to others, in the sense
// of least squares.
function findTurn({ z, o }, actual, wanted) {
  let [sine, cosine] = [0, 0];
  actual.forEach((point, i) => {
    const [u, v] = [minus(point, o), minus(wanted[i], o)];
    sine += dot(z, cross(u, v));
    cosine += dot(u, v) - dot(u, z) * dot(v, z);
  });
  return Math.atan2(sine, cosine);
}

const findSlide = ({ z }, actual, wanted) =>
  actual.reduce((sum, point, i) => sum + dot(z, minus(wanted[i], point)), 0) / actual.length;
