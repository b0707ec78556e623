// All solutions of an arm for one target from the structure of its axes, as
// helpers/inverse/by_structure.py explains; joints that are free stay at 0.

import { cross, dot, minus, plus, revoluteFlags, scaled } from "./kinematics.js";
import {
  angleBetween,
  moveDirection,
  movePoint,
  partAcross,
  rotate,
  solveCosineSine,
  solveQuadratic,
  turnsToAngle,
} from "./joint_equations.js";
import { finishByNewton } from "./newton.js";
import {
  EXACT,
  findStructure,
  flatnessOf,
  invariants,
  isFlat,
  jointCurve,
  meetingPoint,
  unitAcross,
} from "./structure.js";

/** @typedef {import("./structure.js").Axis} Axis */
/** @typedef {import("./structure.js").Frame} Frame */
/** @typedef {import("./structure.js").Structure} Structure */
/** @typedef {import("./structure.js").Vector} Vector */
/**
 * The direction of three parallel axes, seen from the base and back from the target, the motion of
 * the tip, and where the other joints stay if they are free.
 * @typedef {{ h: Vector, hBack: Vector, motion: Motion, size: number, start: number[] }} Loop
 */
/**
 * Joint motions that may solve a target: by joint, with the names of the choices made so far.
 * @typedef {{ motions: number[], free: boolean[], names: string[], times: number }} Candidate
 */
/** @typedef {import("./joint_equations.js").Roots} Roots */

/**
 * Every solution for a target: a point, or a frame where the structure asks for a pose.
 * @param {import("./arm.js").Arm} arm @param {any} target
 * @returns {import("./inverse.js").Branch[]}
 */
export function solveByStructure(arm, target) {
  const structure = findStructure(arm);
  const turns = revoluteFlags(arm);
  const start = structure.reference.map((x) => -x);
  return candidatesFor(structure, target, start).flatMap((candidate) => {
    const raw = candidate.motions.map((x, k) => structure.reference[k] + x);
    const q = raw.map((x, k) => (turns[k] ? x - 2 * Math.PI * Math.round(x / (2 * Math.PI)) : x));
    const finished = q.every(Number.isFinite)
      ? finishByNewton(arm, structure.gap < EXACT, target, q)
      : null;
    if (!finished) return [];
    const { names, free, times } = candidate;
    return [{ name: names.join(", ") || "the only one", q: finished, free, times, blur: 0 }];
  });
}

/** @returns {Candidate[]} */
function candidatesFor(structure, target, start) {
  const { kind, axes, size, tip, centre } = structure;
  if (kind === "position") return placePoint(axes, tip.o, target, size, start);
  if (kind === "two links") return solveTwoLinks(structure, target, start);
  const motion = motionBetween(tip, target);
  if (kind === "wrist") return solveWrist(axes, centre, motion, size, start);
  if (kind === "parallel") return solveParallel(structure, motion, start);
  if (kind === "planar") return solvePlanar(structure, motion, start);
  const back = start.map((x) => -x).reverse();
  return solveWrist([...axes].reverse(), centre, inverseOf(motion), size, back).map((found) => ({
    ...found,
    motions: found.motions.map((x) => -x).reverse(),
    free: [...found.free].reverse(),
  }));
}

// Motions of space: a rotation by the rows of R, then a shift.

/** @typedef {{ R: Vector[], shift: Vector }} Motion */

/** @param {Frame} from @param {Frame} to @returns {Motion} */
function motionBetween(from, to) {
  const R = [0, 1, 2].map((i) =>
    [0, 1, 2].map((j) => to.x[i] * from.x[j] + to.y[i] * from.y[j] + to.z[i] * from.z[j]),
  );
  return { R, shift: minus(to.o, multiply(R, from.o)) };
}

const multiply = (R, v) => R.map((row) => dot(row, v));
const applyTo = ({ R, shift }, point) => plus(multiply(R, point), shift);

/** @param {Motion} motion @returns {Motion} */
function inverseOf({ R, shift }) {
  const back = [0, 1, 2].map((i) => R.map((row) => row[i]));
  return { R: back, shift: scaled(-1, multiply(back, shift)) };
}

/**
 * Continue from each root and put the choice's name before those of later choices.
 * @param {string} choice
 * @param {Roots} roots
 * @param {(value: number) => Candidate[]} next
 * @returns {Candidate[]}
 */
const forEachRoot = (choice, { values, equal }, next) =>
  values.flatMap((value, k) =>
    next(value).map((found) => ({
      ...found,
      names: equal ? found.names : [`${choice} ${k ? "-" : "+"}`, ...found.names],
      times: equal ? 2 * found.times : found.times,
    })),
  );

/** @returns {Candidate[]} */
const candidate = (motions, free) => [{ motions, free, names: [], times: 1 }];

// Solve three joints that take the point w to p: E1 E2 E3 w = p.

/** @param {Axis[]} axes @param {Vector} w @param {Vector} p @returns {Candidate[]} */
function placePoint([first, second, third], w, p, size, start) {
  const curve1 = invariants(second, jointCurve(first, p), size); // of joint 1 undone, by -q1
  const curve3 = invariants(second, jointCurve(third, w), size);
  const flat1 = flatnessOf(first, second, size);
  const flat3 = flatnessOf(third, second, size);
  const [shoulder, elbow] = [first.turns ? "shoulder" : "rod", third.turns ? "elbow" : "rod"];
  const add = (q1, free1) => (q3, free3) => {
    const near = movePoint(third, q3, w);
    const far = movePoint(first, -q1, p);
    if (!second.turns)
      return candidate([q1, dot(second.direction, minus(far, near)), q3], [free1, false, free3]);
    const [u, v] = [minus(near, second.point), minus(far, second.point)];
    const found = angleBetween(second.direction, u, v, size, start[1]);
    return candidate([q1, found.value, q3], [free1, found.free, free3]);
  };
  if (isFlat(flat3)) {
    const roots = crossLine(flat3, curve3, curve1, size, -start[0]);
    return forEachRoot(shoulder, roots, (back) => {
      const others = alongLine(flat3, [curve3, curve1], back, size, start[2]);
      return forEachRoot(elbow, others, (q3) => add(-back, roots.free)(q3, others.free));
    });
  }
  if (isFlat(flat1)) {
    const roots = crossLine(flat1, curve1, curve3, size, start[2]);
    return forEachRoot(elbow, roots, (q3) => {
      const others = alongLine(flat1, [curve1, curve3], q3, size, -start[0]);
      return forEachRoot(shoulder, others, (back) => add(-back, others.free)(q3, roots.free));
    });
  }
  const { roots, thirdAt } = crossAlike(curve1, curve3, -start[0]);
  return forEachRoot(shoulder, roots, (back) => add(-back, roots.free)(thirdAt(back), false));
}

const along = (n, v) => n[0] * v[0] + n[1] * v[1];
const curveAt = ({ A, turns }, q) => {
  const [x, y] = turns ? [Math.cos(q), Math.sin(q)] : [q, q * q];
  return A.map((row) => row[0] * x + row[1] * y);
};
const columnAlong = (n, { A }, j) => n[0] * A[0][j] + n[1] * A[1][j];
const subtract = (u, v) => u.map((x, i) => x - v[i]);

function solveCurve(n, curve, c, size, chosen) {
  const [a, b] = [0, 1].map((j) => columnAlong(n, curve, j));
  return curve.turns ? solveCosineSine(a, b, c, size, chosen) : solveQuadratic(a, b, c, size);
}

// Find the points where a conic crosses the line of a segment.
const crossLine = ({ across }, segment, conic, size, chosen) =>
  solveCurve(across, conic, along(across, subtract(segment.b, conic.b)), size, chosen);

// Find the points of the segment where the conic crosses it.
function alongLine(flat, [segment, conic], q, size, chosen) {
  const at = curveAt(conic, q);
  const offset = at.map((x, i) => x + conic.b[i] - segment.b[i]);
  return solveCurve(flat.along, segment, along(flat.along, offset), size, chosen);
}

// Find the points where two circles, or two parabolas, cross: their difference is a line.
function crossAlike(curve1, curve3, chosen) {
  const [[a, b], [c, d]] = curve3.A;
  const det = a * d - b * c;
  const solve = ([x, y]) => [(d * x - b * y) / det, (a * y - c * x) / det];
  const [X, Y] = [0, 1].map((j) => solve([curve1.A[0][j], curve1.A[1][j]]));
  const e = solve(subtract(curve1.b, curve3.b));
  const point = (q) => {
    const [x, y] = curve1.turns ? [Math.cos(q), Math.sin(q)] : [q, q * q];
    return [X[0] * x + Y[0] * y + e[0], X[1] * x + Y[1] * y + e[1]];
  };
  if (!curve1.turns) {
    const roots = solveQuadratic(2 * X[0] * e[0] - X[1], X[0] ** 2 - Y[1], e[1] - e[0] ** 2, 1);
    return { roots, thirdAt: (q) => point(q)[0] };
  }
  const right = 1 - along(e, e) - along(X, X);
  const roots = solveCosineSine(2 * along(X, e), 2 * along(Y, e), right, 1, chosen);
  return { roots, thirdAt: (q) => Math.atan2(point(q)[1], point(q)[0]) };
}

// Solve three joints that place the point w, and three axes that meet there.

/** @param {Axis[]} axes @param {Vector} w @param {Motion} motion @returns {Candidate[]} */
function solveWrist(axes, w, motion, size, start) {
  const [fourth, fifth, sixth] = axes.slice(3).map((axis) => axis.direction);
  return placePoint(axes.slice(0, 3), w, applyTo(motion, w), size, start).flatMap((placed) => {
    const before = (v) =>
      placed.motions.reduce((moved, q, k) => moveDirection(axes[k], -q, moved), v);
    const wanted = before(multiply(motion.R, sixth));
    const mark = cross(sixth, fifth);
    const turned = before(multiply(motion.R, mark));
    const roots = turnsToAngle(fifth, sixth, fourth, wanted);
    const found = forEachRoot("wrist", roots, (q5) => {
      const q4 = angleBetween(fourth, rotate(fifth, q5, sixth), wanted, 1, start[3]);
      const back = rotate(fifth, -q5, rotate(fourth, -q4.value, turned));
      const q6 = angleBetween(sixth, mark, back, 1, start[5]);
      return candidate([q4.value, q5, q6.value], [q4.free, false, false]);
    });
    return found.map((wrist) => joined(placed, wrist));
  });
}

/** @returns {Candidate} */
const joined = (placed, rest) => ({
  motions: [...placed.motions, ...rest.motions],
  free: [...placed.free, ...rest.free],
  names: [...placed.names, ...rest.names],
  times: placed.times * rest.times,
});

// Solve an arm with three parallel axes. The other joints a, b, c follow them in the closed loop.

/** @param {Structure} structure @param {Motion} motion @returns {Candidate[]} */
function solveParallel({ axes, first, size }, motion, start) {
  const three = axes.slice(first, first + 3);
  const back = inverseOf(motion);
  const others = [0, 1, 2].map((i) => (first + 3 + i) % 6);
  const seen = others.map((i) => (i < first ? movedAxis(back, axes[i]) : axes[i]));
  const meets = (i) => others[i + 1] === others[i] + 1;
  const pointOf = (i) => {
    const met = meets(i) && meetingPoint([axes[others[i]], axes[others[i + 1]]], size);
    return met && (others[i] < first ? applyTo(back, met.point) : met.point);
  };
  const h = three[0].direction;
  const loop = { h, hBack: multiply(back.R, h), motion, size, start: others.map((i) => start[i]) };
  const point = pointOf(0);
  const rest = point ? solveLastFirst(loop, seen, point) : solveFirstFirst(loop, seen, pointOf(1));
  return rest.flatMap((found) => {
    const planar = (v) =>
      applyTo(
        motion,
        found.motions.reduce((moved, q, k) => movePoint(seen[k], -q, moved), v),
      );
    return solveTriangle(three, planar, size, start.slice(first, first + 3)).map((triangle) => {
      const motions = new Array(6);
      const free = new Array(6);
      for (const k of [0, 1, 2]) {
        [motions[first + k], free[first + k]] = [triangle.motions[k], triangle.free[k]];
        [motions[others[k]], free[others[k]]] = [found.motions[k], found.free[k]];
      }
      const names = [...found.names, ...triangle.names];
      return { motions, free, names, times: found.times * triangle.times };
    });
  });
}

const movedAxis = (motion, axis) => ({
  direction: multiply(motion.R, axis.direction),
  point: applyTo(motion, axis.point),
  turns: axis.turns,
});

/**
 * Solve joints a and b, which meet in a point whose height only joint c changes.
 * @param {Loop} loop
 * @param {Axis[]} axes
 * @returns {Candidate[]}
 */
function solveLastFirst({ h, hBack, motion, size, start }, [a, b, c], point) {
  const { centre, X, Y } = jointCurve(c, point);
  const height = dot(h, point) - dot(h, motion.shift) - dot(hBack, centre);
  const roots = solveCosineSine(dot(hBack, X), dot(hBack, Y), height, size, -start[2]);
  return forEachRoot("shoulder", roots, (undone) => {
    const seen = rotate(c.direction, -undone, hBack);
    return forEachRoot("wrist", turnsToAngle(b.direction, seen, a.direction, h), (qb) => {
      const qa = angleBetween(a.direction, rotate(b.direction, qb, seen), h, 1, start[0]);
      return candidate([qa.value, qb, -undone], [qa.free, false, roots.free]);
    });
  });
}

/**
 * Solve joints b and c, which meet in a point whose height only joint a changes.
 * @param {Loop} loop
 * @param {Axis[]} axes
 * @returns {Candidate[]}
 */
function solveFirstFirst({ h, hBack, motion, size, start }, [a, b, c], point) {
  const { centre, X, Y } = jointCurve(a, point);
  const height = dot(h, applyTo(motion, point)) - dot(h, centre);
  const roots = solveCosineSine(dot(h, X), dot(h, Y), height, size, start[0]);
  return forEachRoot("shoulder", roots, (qa) => {
    const seen = rotate(a.direction, -qa, h);
    return forEachRoot("wrist", turnsToAngle(c.direction, hBack, b.direction, seen), (qc) => {
      const turned = rotate(c.direction, qc, hBack);
      const qb = angleBetween(b.direction, turned, seen, 1, start[1]);
      return candidate([qa, qb.value, qc], [roots.free, qb.free, false]);
    });
  });
}

/**
 * Solve the triangle of three parallel joints that move points as `planar` does.
 * @param {Axis[]} axes
 * @param {(point: Vector) => Vector} planar
 * @returns {Candidate[]}
 */
function solveTriangle([first, second, third], planar, size, start) {
  const h = first.direction;
  const end = partAcross(h, minus(planar(third.point), first.point));
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
  const mark = unitAcross(h);
  const heading = minus(planar(plus(third.point, mark)), planar(third.point));
  const turned = angleBetween(h, mark, heading, 1, start[2]).value;
  return forEachRoot("elbow", roots, (q2) => {
    const reached = partAcross(h, minus(movePoint(second, q2, third.point), first.point));
    const q1 = angleBetween(h, reached, end, size, start[0]);
    const sign2 = dot(second.direction, h);
    const q3 = dot(third.direction, h) * (turned - q1.value - sign2 * q2);
    return candidate([q1.value, q2, q3], [q1.free, roots.free, false]);
  });
}

// Solve a planar three-link arm, or one with a slide across its plane (SCARA).
function solvePlanar({ axes, size }, motion, start) {
  const turning = axes.flatMap((axis, k) => (axis.turns ? [k] : []));
  const three = turning.map((k) => axes[k]);
  const planar = (v) => applyTo(motion, v);
  const startOfThree = turning.map((k) => start[k]);
  return solveTriangle(three, planar, size, startOfThree).map((found) => {
    const [motions, free] = [[], []];
    axes.forEach(({ direction, point, turns }, k) => {
      const i = turning.indexOf(k);
      motions.push(turns ? found.motions[i] : dot(direction, minus(planar(point), point)));
      free.push(turns && found.free[i]);
    });
    return { ...found, motions, free };
  });
}

function solveTwoLinks({ axes, size, tip }, target, start) {
  const end = { direction: axes[0].direction, point: tip.o, turns: true };
  const found = solveTriangle([...axes, end], () => target, size, [...start, start[0]]);
  return found.map((one) => ({
    ...one,
    motions: one.motions.slice(0, 2),
    free: one.free.slice(0, 2),
  }));
}
