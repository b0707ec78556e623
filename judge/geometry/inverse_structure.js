// Finds all solutions of an arm for one target from the structure of its axes. Free joints stay at
// 0. helpers/inverse/by_structure.py explains the method. Newton's method from 200 random starts
// finds the same branches of random targets (in 10 to 40 ms), but not of 106 among 160 targets at
// configurations of right angles, where branches coincide or joints are free.

import { cross, dot, minus, plus, revoluteFlags, scaled } from "./kinematics.js";
import { crossAlike, crossLine, findOnSegment } from "./curve_crossings.js";
import {
  angleBetween,
  moveDirection,
  movePoint,
  partAcross,
  rotate,
  solveCosineSine,
  turnsToAngle,
} from "./joint_equations.js";
import { finishByNewton } from "./newton.js";
import {
  EXACT,
  findStructure,
  findFlatness,
  invariants,
  isFlat,
  jointCurve,
  meetingPoint,
  unitAcross,
} from "./structure.js";

/** @typedef {import("./structure.js").Axis} Axis */
/** @typedef {import("./structure.js").Structure} Structure */
/** @typedef {import("./kinematics.js").Frame} Frame */
/** @typedef {import("./kinematics.js").Vector} Vector */
/**
 * An arm with three parallel axes, as a closed loop from the base to the target and back.
 * @typedef {object} Loop
 * @property {Vector} h direction of the parallel axes in the base frame
 * @property {Vector} hBack the same direction, moved back with the target
 * @property {Motion} motion of the tip, from the reference pose to the target
 * @property {number} size of the arm (m)
 * @property {number[]} start motions of joints a, b, c if they are free
 */
/**
 * Joint motions that may solve a target. A motion is the change of a joint value from the
 * reference pose.
 * @typedef {object} Candidate
 * @property {number[]} motions of each joint (rad or m)
 * @property {boolean[]} free whether each joint may have any value
 * @property {string[]} names of the choices made so far
 * @property {number} times how many solutions coincide here
 */
/** @typedef {import("./joint_equations.js").Roots} Roots */

/**
 * Find every solution for a target.
 * @param {import("./arm.js").Arm} arm
 * @param {any} target a point, or a frame if the structure needs a pose
 * @returns {import("./inverse.js").Branch[]}
 */
export function solveByStructure(arm, target) {
  const structure = findStructure(arm);
  const turns = revoluteFlags(arm);
  const start = structure.reference.map((x) => -x);
  return listCandidates(structure, target, start).flatMap((candidate) => {
    const unwrapped = candidate.motions.map((x, k) => structure.reference[k] + x);
    const q = unwrapped.map((x, k) =>
      turns[k] ? x - 2 * Math.PI * Math.round(x / (2 * Math.PI)) : x,
    );
    const finished = q.every(Number.isFinite)
      ? finishByNewton(arm, structure.gap < EXACT, target, q)
      : null;
    if (!finished) return [];
    const { names, free, times } = candidate;
    return [{ name: names.join(", ") || "the only one", q: finished, free, times, uncertainty: 0 }];
  });
}

/** @returns {Candidate[]} */
function listCandidates(structure, target, start) {
  const { kind, axes, size, tip, centre } = structure;
  if (kind === "position") return placePoint(axes, tip.o, target, size, start);
  if (kind === "two links") return solveTwoLinks(structure, target, start);
  const motion = motionBetween(tip, target);
  if (kind === "wrist") return solveWrist(axes, centre, motion, size, start);
  if (kind === "parallel") return solveParallel(structure, motion, start);
  if (kind === "planar") return solvePlanar(structure, motion, start);
  // The first three axes meet: seen from the tip, they are the wrist of the reversed arm.
  const reversedStart = start.map((x) => -x).reverse();
  const reversed = solveWrist(
    [...axes].reverse(),
    centre,
    invertMotion(motion),
    size,
    reversedStart,
  );
  return reversed.map((candidate) => ({
    ...candidate,
    motions: candidate.motions.map((x) => -x).reverse(),
    free: [...candidate.free].reverse(),
  }));
}

/**
 * A rigid motion of space: a rotation by the rows of R, then a shift (m).
 * @typedef {{ R: Vector[], shift: Vector }} Motion
 */

/** @param {Frame} from @param {Frame} to @returns {Motion} */
function motionBetween(from, to) {
  const R = [0, 1, 2].map((i) =>
    [0, 1, 2].map((j) => to.x[i] * from.x[j] + to.y[i] * from.y[j] + to.z[i] * from.z[j]),
  );
  return { R, shift: minus(to.o, rotateBy(R, from.o)) };
}

const rotateBy = (R, v) => R.map((row) => dot(row, v));
const transformPoint = ({ R, shift }, point) => plus(rotateBy(R, point), shift);

/** @param {Motion} motion @returns {Motion} */
function invertMotion({ R, shift }) {
  const transposed = [0, 1, 2].map((i) => R.map((row) => row[i]));
  return { R: transposed, shift: scaled(-1, rotateBy(transposed, shift)) };
}

/**
 * Solve for the remaining joints from each root. The name of this choice goes before theirs.
 * @param {string} choice
 * @param {Roots} roots
 * @param {(value: number) => Candidate[]} solveRest
 * @returns {Candidate[]}
 */
const solveFromEachRoot = (choice, { values, equal }, solveRest) =>
  values.flatMap((value, k) =>
    solveRest(value).map((candidate) => ({
      ...candidate,
      names: equal ? candidate.names : [`${choice} ${k ? "-" : "+"}`, ...candidate.names],
      times: equal ? 2 * candidate.times : candidate.times,
    })),
  );

/** @returns {Candidate[]} */
const makeCandidates = (motions, free) => [{ motions, free, names: [], times: 1 }];

/**
 * Solve three joints that take the point w to p: E1 E2 E3 w = p.
 * @param {Axis[]} axes of the three joints
 * @param {Vector} w @param {Vector} p (m)
 * @param {number} size of the arm (m)
 * @param {number[]} start motions of the joints if they are free
 * @returns {Candidate[]}
 */
function placePoint([first, second, third], w, p, size, start) {
  // Joint 1 moves p back by -q1, joint 3 moves w by q3, and joint 2 takes one point to the other.
  const [curve1, curve3] = [jointCurve(first, p), jointCurve(third, w)].map((curve) =>
    invariants(second, curve, size),
  );
  const [flat1, flat3] = [first, third].map((axis) => findFlatness(axis, second, size));
  const [shoulder, elbow] = [first.turns ? "shoulder" : "rod", third.turns ? "elbow" : "rod"];
  const addJoint2 = (undone1, free1, q3, free3) => {
    const [from, to] = [movePoint(third, q3, w), movePoint(first, undone1, p)];
    const q2 = solveSecondJoint(second, from, to, size, start[1]);
    return makeCandidates([-undone1, q2.value, q3], [free1, q2.free, free3]);
  };
  if (isFlat(flat3)) {
    const roots1 = crossLine(flat3, curve3, curve1, size, -start[0]);
    return solveFromEachRoot(shoulder, roots1, (undone1) => {
      const roots3 = findOnSegment(flat3, [curve3, curve1], undone1, size, start[2]);
      return solveFromEachRoot(elbow, roots3, (q3) =>
        addJoint2(undone1, roots1.free, q3, roots3.free),
      );
    });
  }
  if (isFlat(flat1)) {
    const roots3 = crossLine(flat1, curve1, curve3, size, start[2]);
    return solveFromEachRoot(elbow, roots3, (q3) => {
      const roots1 = findOnSegment(flat1, [curve1, curve3], q3, size, -start[0]);
      return solveFromEachRoot(shoulder, roots1, (undone1) =>
        addJoint2(undone1, roots1.free, q3, roots3.free),
      );
    });
  }
  const { roots, getThird } = crossAlike(curve1, curve3, -start[0]);
  return solveFromEachRoot(shoulder, roots, (undone1) =>
    addJoint2(undone1, roots.free, getThird(undone1), false),
  );
}

// Return the motion of joint 2 that takes one point to the other, and whether it is free.
function solveSecondJoint({ direction, point, turns }, from, to, size, chosen) {
  if (!turns) return { value: dot(direction, minus(to, from)), free: false };
  return angleBetween(direction, minus(from, point), minus(to, point), size, chosen);
}

/**
 * Solve six joints of which the last three meet in the point w, which the first three place.
 * @param {Axis[]} axes
 * @param {Vector} w (m)
 * @param {Motion} motion of the tip
 * @param {number} size of the arm (m)
 * @param {number[]} start motions of the joints if they are free
 * @returns {Candidate[]}
 */
function solveWrist(axes, w, motion, size, start) {
  const [fourth, fifth, sixth] = axes.slice(3).map((axis) => axis.direction);
  return placePoint(axes.slice(0, 3), w, transformPoint(motion, w), size, start).flatMap(
    (placed) => {
      const undoPlacing = (v) =>
        placed.motions.reduce((moved, q, k) => moveDirection(axes[k], -q, moved), v);
      const wantedSixth = undoPlacing(rotateBy(motion.R, sixth));
      const normal = cross(sixth, fifth);
      const wantedNormal = undoPlacing(rotateBy(motion.R, normal));
      const roots = turnsToAngle(fifth, sixth, fourth, wantedSixth);
      const wrists = solveFromEachRoot("wrist", roots, (q5) => {
        const q4 = angleBetween(fourth, rotate(fifth, q5, sixth), wantedSixth, 1, start[3]);
        const turnedNormal = rotate(fifth, -q5, rotate(fourth, -q4.value, wantedNormal));
        const q6 = angleBetween(sixth, normal, turnedNormal, 1, start[5]);
        return makeCandidates([q4.value, q5, q6.value], [q4.free, false, false]);
      });
      return wrists.map((wrist) => joinCandidates(placed, wrist));
    },
  );
}

/** @returns {Candidate} */
const joinCandidates = (placed, rest) => ({
  motions: [...placed.motions, ...rest.motions],
  free: [...placed.free, ...rest.free],
  names: [...placed.names, ...rest.names],
  times: placed.times * rest.times,
});

/**
 * Solve an arm with three parallel axes. The other joints a, b, c follow them in the closed loop.
 * @param {Structure} structure
 * @param {Motion} motion of the tip
 * @param {number[]} start motions of the joints if they are free
 * @returns {Candidate[]}
 */
function solveParallel({ axes, first, size }, motion, start) {
  const parallelAxes = axes.slice(first, first + 3);
  const back = invertMotion(motion);
  const others = [0, 1, 2].map((i) => (first + 3 + i) % 6);
  const otherAxes = others.map((i) => (i < first ? moveAxis(back, axes[i]) : axes[i]));
  const areNeighbours = (i) => others[i + 1] === others[i] + 1;
  const findMeetingPoint = (i) => {
    const pair = [axes[others[i]], axes[others[i + 1]]];
    const meeting = areNeighbours(i) && meetingPoint(pair, size);
    return meeting && (others[i] < first ? transformPoint(back, meeting.point) : meeting.point);
  };
  const h = parallelAxes[0].direction;
  const loop = { h, hBack: rotateBy(back.R, h), motion, size, start: others.map((i) => start[i]) };
  const pointAB = findMeetingPoint(0);
  const candidates = pointAB
    ? solveLastFirst(loop, otherAxes, pointAB)
    : solveFirstFirst(loop, otherAxes, findMeetingPoint(1));
  return candidates.flatMap((candidate) => {
    const planarMotion = (point) =>
      transformPoint(
        motion,
        candidate.motions.reduce((moved, q, k) => movePoint(otherAxes[k], -q, moved), point),
      );
    const parallelStart = start.slice(first, first + 3);
    return solveTriangle(parallelAxes, planarMotion, size, parallelStart).map((triangle) => {
      const motions = new Array(6);
      const free = new Array(6);
      for (const k of [0, 1, 2]) {
        [motions[first + k], free[first + k]] = [triangle.motions[k], triangle.free[k]];
        [motions[others[k]], free[others[k]]] = [candidate.motions[k], candidate.free[k]];
      }
      const names = [...candidate.names, ...triangle.names];
      return { motions, free, names, times: candidate.times * triangle.times };
    });
  });
}

const moveAxis = (motion, axis) => ({
  direction: rotateBy(motion.R, axis.direction),
  point: transformPoint(motion, axis.point),
  turns: axis.turns,
});

/**
 * Solve joint c, then b and a, whose axes meet in a point. Only joint c changes the point's height
 * along the parallel axes.
 * @param {Loop} loop
 * @param {Axis[]} axes of a, b and c
 * @param {Vector} point where axes a and b meet
 * @returns {Candidate[]}
 */
function solveLastFirst({ h, hBack, motion, size, start }, [a, b, c], point) {
  const { centre, X, Y } = jointCurve(c, point);
  const height = dot(h, point) - dot(h, motion.shift) - dot(hBack, centre);
  const roots = solveCosineSine(dot(hBack, X), dot(hBack, Y), height, size, -start[2]);
  return solveFromEachRoot("shoulder", roots, (undoneC) => {
    const hBeforeC = rotate(c.direction, -undoneC, hBack);
    return solveFromEachRoot("wrist", turnsToAngle(b.direction, hBeforeC, a.direction, h), (qb) => {
      const qa = angleBetween(a.direction, rotate(b.direction, qb, hBeforeC), h, 1, start[0]);
      return makeCandidates([qa.value, qb, -undoneC], [qa.free, false, roots.free]);
    });
  });
}

/**
 * Solve joint a, then c and b, whose axes meet in a point. Only joint a changes the point's height
 * along the parallel axes.
 * @param {Loop} loop
 * @param {Axis[]} axes of a, b and c
 * @param {Vector} point where axes b and c meet
 * @returns {Candidate[]}
 */
function solveFirstFirst({ h, hBack, motion, size, start }, [a, b, c], point) {
  const { centre, X, Y } = jointCurve(a, point);
  const height = dot(h, transformPoint(motion, point)) - dot(h, centre);
  const roots = solveCosineSine(dot(h, X), dot(h, Y), height, size, start[0]);
  return solveFromEachRoot("shoulder", roots, (qa) => {
    const hAfterA = rotate(a.direction, -qa, h);
    const rootsC = turnsToAngle(c.direction, hBack, b.direction, hAfterA);
    return solveFromEachRoot("wrist", rootsC, (qc) => {
      const hAfterC = rotate(c.direction, qc, hBack);
      const qb = angleBetween(b.direction, hAfterC, hAfterA, 1, start[1]);
      return makeCandidates([qa, qb.value, qc], [roots.free, qb.free, false]);
    });
  });
}

/**
 * Solve the triangle of three parallel joints whose motions together are `planarMotion`.
 * @param {Axis[]} axes
 * @param {(point: Vector) => Vector} planarMotion
 * @param {number} size of the arm (m)
 * @param {number[]} start motions of the joints if they are free
 * @returns {Candidate[]}
 */
function solveTriangle([first, second, third], planarMotion, size, start) {
  const h = first.direction;
  const end = partAcross(h, minus(planarMotion(third.point), first.point));
  const { centre, X, Y } = jointCurve(second, third.point);
  const r = partAcross(h, minus(centre, first.point));
  const needed = (dot(end, end) - dot(r, r) - dot(X, X)) / size;
  const roots = solveCosineSine(
    (2 * dot(r, X)) / size,
    (2 * dot(r, Y)) / size,
    needed,
    size,
    start[1],
  );
  const across = unitAcross(h);
  const heading = minus(planarMotion(plus(third.point, across)), planarMotion(third.point));
  const totalAngle = angleBetween(h, across, heading, 1, start[2]).value;
  return solveFromEachRoot("elbow", roots, (q2) => {
    const reached = partAcross(h, minus(movePoint(second, q2, third.point), first.point));
    const q1 = angleBetween(h, reached, end, size, start[0]);
    const sign2 = dot(second.direction, h);
    const q3 = dot(third.direction, h) * (totalAngle - q1.value - sign2 * q2);
    return makeCandidates([q1.value, q2, q3], [q1.free, roots.free, false]);
  });
}

// Solve a planar three-link arm, which may have a slide at a right angle to its plane (SCARA).
function solvePlanar({ axes, size }, motion, start) {
  const revolute = axes.flatMap((axis, k) => (axis.turns ? [k] : []));
  const revoluteAxes = revolute.map((k) => axes[k]);
  const revoluteStart = revolute.map((k) => start[k]);
  const planarMotion = (point) => transformPoint(motion, point);
  return solveTriangle(revoluteAxes, planarMotion, size, revoluteStart).map((triangle) => {
    const [motions, free] = [[], []];
    axes.forEach(({ direction, point, turns }, k) => {
      const i = revolute.indexOf(k);
      motions.push(turns ? triangle.motions[i] : dot(direction, minus(planarMotion(point), point)));
      free.push(turns && triangle.free[i]);
    });
    return { ...triangle, motions, free };
  });
}

// Solve a planar two-link arm as a triangle whose third axis passes through the tip.
function solveTwoLinks({ axes, size, tip }, target, start) {
  const tipAxis = { direction: axes[0].direction, point: tip.o, turns: true };
  const triangles = solveTriangle([...axes, tipAxis], () => target, size, [...start, start[0]]);
  return triangles.map((triangle) => ({
    ...triangle,
    motions: triangle.motions.slice(0, 2),
    free: triangle.free.slice(0, 2),
  }));
}
