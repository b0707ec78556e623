// Computes the link frames, the Jacobian and the gravity torques of an arm at one joint vector, by
// the recursion of helpers/kinematics.py and helpers/statics.py. A test compares the two.

/** @typedef {import("./arm.js").Rows} Rows */
/**
 * Three coordinates, in the base frame if nothing else is said.
 * @typedef {number[]} Vector
 */
/**
 * The axes and the origin of a frame in base coordinates.
 * @typedef {{ x: Vector, y: Vector, z: Vector, o: Vector }} Frame
 */

export const GRAVITY = [0, 0, -9.81]; // m/s²

export const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
export const scaled = (k, v) => [k * v[0], k * v[1], k * v[2]];
export const plus = (u, v) => [u[0] + v[0], u[1] + v[1], u[2] + v[2]];
export const minus = (u, v) => [u[0] - v[0], u[1] - v[1], u[2] - v[2]];
export const cross = (u, v) => [
  u[1] * v[2] - u[2] * v[1],
  u[2] * v[0] - u[0] * v[2],
  u[0] * v[1] - u[1] * v[0],
];
export const norm = (v) => Math.sqrt(v.reduce((sum, x) => sum + x * x, 0));

/** Return a frame's vector in the base's axes (R v). @param {Frame} frame @param {Vector} v */
export const vectorInBase = ({ x, y, z }, v) => [
  v[0] * x[0] + v[1] * y[0] + v[2] * z[0],
  v[0] * x[1] + v[1] * y[1] + v[2] * z[1],
  v[0] * x[2] + v[1] * y[2] + v[2] * z[2],
];

/** Return a vector of the base in a frame's axes (R^T v). @param {Frame} frame @param {Vector} v */
export const vectorInFrame = ({ x, y, z }, v) => [dot(x, v), dot(y, v), dot(z, v)];

/** Return a frame's point in base coordinates. @param {Frame} frame @param {Vector} point */
export const pointInBase = (frame, point) => plus(vectorInBase(frame, point), frame.o);

/**
 * Return a point of the base in a frame's coordinates.
 * @param {Frame} frame
 * @param {Vector} point
 */
export const pointInFrame = (frame, point) => vectorInFrame(frame, minus(point, frame.o));

// Return the linear combination a u + b v.
const combine = (a, u, b, v) => [a * u[0] + b * v[0], a * u[1] + b * v[1], a * u[2] + b * v[2]];

const QUARTER_TURNS = [
  [1, 0],
  [0, 1],
  [-1, 0],
  [0, -1],
];

/**
 * Return cosine and sine of an angle, exact at multiples of a right angle so that structural zeros
 * stay zero.
 * @param {number} angle rad
 * @returns {number[]}
 */
export function cosSin(angle) {
  const turns = angle / (Math.PI / 2);
  if (Math.abs(turns - Math.round(turns)) > 1e-12) return [Math.cos(angle), Math.sin(angle)];
  return QUARTER_TURNS[((Math.round(turns) % 4) + 4) % 4];
}

// Cache a function of an arm's rows for as long as the rows exist. The search for mistakes calls it
// thousands of times for each answer.
function keptByRows(make) {
  const results = new WeakMap();
  return ({ rows }) => {
    let result = results.get(rows);
    if (!result) results.set(rows, (result = make(rows)));
    return result;
  };
}

/** Return the indices, from 0, of the rows that move. @type {(arm: Rows) => number[]} */
export const movingRows = keptByRows((rows) =>
  rows.flatMap(({ kind }, i) => (kind === "fixed" ? [] : [i])),
);
/** Return the indices, from 0, of the rows that do not move. @type {(arm: Rows) => number[]} */
export const fixedRows = keptByRows((rows) =>
  rows.flatMap(({ kind }, i) => (kind === "fixed" ? [i] : [])),
);
/** Return the joints' numbers, counted from 1. @type {(arm: Rows) => number[]} */
export const jointNumbers = keptByRows((rows) => movingRows({ rows }).map((i) => i + 1));
/** Return for each joint whether it is revolute. @type {(arm: Rows) => boolean[]} */
export const revoluteFlags = keptByRows((rows) =>
  movingRows({ rows }).map((i) => rows[i].kind === "revolute"),
);
/** Return the names q_1, q_2, ... of the joint values. @param {Rows} arm */
export const jointNames = (arm) => jointNumbers(arm).map((i) => `q_${i}`);

/**
 * Return the link frames T_00 ... T_0n in the base frame.
 * @param {Rows} arm
 * @param {number[]} q joint values (rad or m)
 * @returns {Frame[]}
 */
export function linkFrames(arm, q) {
  let [x, y, z, o] = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
    [0, 0, 0],
  ];
  const frames = [{ x, y, z, o }];
  let joint = 0;
  for (const row of arm.rows) {
    const value = row.kind === "fixed" ? 0 : q[joint++];
    const [c, s] = cosSin(row.kind === "revolute" ? row.theta + value : row.theta);
    const [ca, sa] = cosSin(row.alpha);
    const d = row.kind === "prismatic" ? row.d + value : row.d;
    [x, y] = [combine(c, x, s, y), combine(c, y, -s, x)];
    o = plus(combine(d, z, row.a, x), o);
    [y, z] = [combine(ca, y, sa, z), combine(ca, z, -sa, y)];
    frames.push({ x, y, z, o });
  }
  return frames;
}

/** Return a frame as the four rows of its homogeneous matrix. @param {Frame} frame */
export const frameMatrix = ({ x, y, z, o }) =>
  [0, 1, 2].map((i) => [x[i], y[i], z[i], o[i]]).concat([[0, 0, 0, 1]]);

/**
 * Return the Jacobian's columns (vx, vy, vz, wx, wy, wz) in the base frame.
 * @param {Rows} arm
 * @param {Frame[]} frames link frames
 * @param {Vector} [tip] the point whose velocity is wanted; it moves with the last frame
 * @returns {number[][]} one column per joint
 */
export function jacobianColumns(arm, frames, tip = frames.at(-1).o) {
  return movingRows(arm).map((i) => {
    const { z, o } = frames[i];
    return arm.rows[i].kind === "revolute" ? [...cross(z, minus(tip, o)), ...z] : [...z, 0, 0, 0];
  });
}

/**
 * Return the torque (N m) or force (N) dP/dq with which each joint holds the arm up.
 * @param {Rows} arm rows with `body`, which has the mass and the centre of mass
 * @param {Frame[]} frames link frames
 */
export function computeHoldingTorques(arm, frames) {
  const bodies = listBodies(arm, frames);
  return movingRows(arm).map((i) => {
    const { z, o } = frames[i];
    const velocityOf = (c) => (arm.rows[i].kind === "revolute" ? cross(z, minus(c, o)) : z);
    return bodies.reduce(
      (sum, { mass, centre, row }) =>
        row < i ? sum : sum - mass * dot(GRAVITY, velocityOf(centre)),
      0,
    );
  });
}

/** Return the links' potential energy (J), 0 at the base's height. @param {Rows} arm */
export const potentialEnergy = (arm, frames) =>
  listBodies(arm, frames).reduce((sum, { mass, centre }) => sum - mass * dot(GRAVITY, centre), 0);

// The bodies of the links, with their centres of mass in the base frame.
const listBodies = (arm, frames) =>
  arm.rows.flatMap(({ body }, row) => {
    if (!body) return [];
    const [mass, ...centre] = body;
    return [{ mass, row, centre: pointInBase(frames[row + 1], centre) }];
  });

/**
 * Return J^T F, the joint torques of a wrench that the world exerts on the tool.
 * @param {number[][]} columns of the Jacobian
 * @param {number[]} wrench (Fx, Fy, Fz, Mx, My, Mz) in the base frame
 */
export const computeWrenchTorques = (columns, wrench) =>
  columns.map((column) => column.reduce((sum, entry, i) => sum + entry * wrench[i], 0));

/**
 * Return the angle (rad) of the rotation between two frames.
 * @param {Frame} from @param {Frame} to
 */
export function rotationBetween(from, to) {
  const [A, B] = [frameMatrix(from), frameMatrix(to)];
  const entry = (i, j) => A[0][i] * B[0][j] + A[1][i] * B[1][j] + A[2][i] * B[2][j];
  const R = [0, 1, 2].map((i) => [0, 1, 2].map((j) => entry(i, j)));
  const sine = norm([R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]]);
  return Math.atan2(sine, R[0][0] + R[1][1] + R[2][2] - 1);
}
