// The numeric view of an arm: the same small recursion as helpers/kinematics.py and
// helpers/statics.py, for one joint vector. A test holds the two equal. Vectors are arrays of
// three; a frame is its columns { x, y, z, o }. An arm that can be judged is the explorer's, with
// its symbols, values [[name, number]], and the tables with other lengths that mistakes would give
// (helpers/checks/arms.py).

export const GRAVITY = 9.81;

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
const mixed = (a, u, b, v) => [a * u[0] + b * v[0], a * u[1] + b * v[1], a * u[2] + b * v[2]];

// Exact at multiples of a right angle, so that structural zeros stay zero.
export function cosSin(angle) {
  const turns = angle / (Math.PI / 2);
  if (Math.abs(turns - Math.round(turns)) > 1e-12) return [Math.cos(angle), Math.sin(angle)];
  return [
    [1, 0],
    [0, 1],
    [-1, 0],
    [0, -1],
  ][((Math.round(turns) % 4) + 4) % 4];
}

// The indices, from 0, of the rows that move.
export const movingRows = (arm) => arm.rows.flatMap((row, i) => (row.kind === "fixed" ? [] : [i]));
// Their numbers, from 1; whether each turns; and the names of their values.
export const jointNumbers = (arm) => movingRows(arm).map((i) => i + 1);
export const revoluteFlags = (arm) => movingRows(arm).map((i) => arm.rows[i].kind === "revolute");
export const jointNames = (arm) => jointNumbers(arm).map((i) => `q_${i}`);

// Base-to-link frames T00 .. T0n for the joint vector q.
export function linkFrames(arm, q) {
  let [x, y, z, o] = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
    [0, 0, 0],
  ];
  const frames = [{ x, y, z, o }];
  let moving = 0;
  for (const row of arm.rows) {
    const value = row.kind === "fixed" ? 0 : q[moving++];
    const [c, s] = cosSin(row.kind === "revolute" ? row.theta + value : row.theta);
    const [ca, sa] = cosSin(row.alpha);
    const d = row.kind === "prismatic" ? row.d + value : row.d;
    [x, y] = [mixed(c, x, s, y), mixed(c, y, -s, x)];
    o = plus(mixed(d, z, row.a, x), o);
    [y, z] = [mixed(ca, y, sa, z), mixed(ca, z, -sa, y)];
    frames.push({ x, y, z, o });
  }
  return frames;
}

// A frame as the four rows of its homogeneous matrix.
export const frameMatrix = ({ x, y, z, o }) =>
  [0, 1, 2].map((i) => [x[i], y[i], z[i], o[i]]).concat([[0, 0, 0, 1]]);

// The Jacobian's columns, one for each joint: (vx, vy, vz, wx, wy, wz) in the base frame, of the
// tip or of another point that moves with it.
export function jacobianColumns(arm, frames, tip = frames.at(-1).o) {
  return movingRows(arm).map((i) => {
    const { z, o } = frames[i];
    return arm.rows[i].kind === "revolute" ? [...cross(z, minus(tip, o)), ...z] : [...z, 0, 0, 0];
  });
}

// dP/dq, the torque or force with which each joint holds the arm up; masses and centres are
// row.body = [m, x, y, z].
export function gravityTorque(arm, frames, gravity = GRAVITY) {
  const loads = loadsOf(arm, frames);
  return movingRows(arm).map((i) => {
    const { z, o } = frames[i];
    const lift = (c) => (arm.rows[i].kind === "revolute" ? cross(z, minus(c, o))[2] : z[2]);
    return loads.reduce(
      (sum, { mass, centre, row }) => sum + (row < i ? 0 : mass * gravity * lift(centre)),
      0,
    );
  });
}

// The potential energy of the links, which is 0 at the base's height.
export const potentialEnergy = (arm, frames, gravity = GRAVITY) =>
  loadsOf(arm, frames).reduce((sum, { mass, centre }) => sum + mass * gravity * centre[2], 0);

const loadsOf = (arm, frames) =>
  arm.rows.flatMap((row, k) => (row.body ? [load(row.body, frames[k + 1], k)] : []));

function load([mass, ...com], { x, y, z, o }, row) {
  return { mass, row, centre: plus(o, plus(mixed(com[0], x, com[1], y), scaled(com[2], z))) };
}

// J^T F, what a wrench on the tool by the world asks of each joint.
export const wrenchTorque = (columns, wrench) =>
  columns.map((column) => column.reduce((sum, entry, i) => sum + entry * wrench[i], 0));

// The angle (rad) of the turn from one frame to another.
export function rotationBetween(here, there) {
  const [A, B] = [frameMatrix(here), frameMatrix(there)];
  const entry = (i, j) => A[0][i] * B[0][j] + A[1][i] * B[1][j] + A[2][i] * B[2][j];
  const R = [0, 1, 2].map((i) => [0, 1, 2].map((j) => entry(i, j)));
  const off = norm([R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]]);
  return Math.atan2(off, R[0][0] + R[1][1] + R[2][2] - 1);
}
