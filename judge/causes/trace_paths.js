// Lists the wrong paths that usual mistakes make of the right path. Factors and axes come from
// homeworks. None is fitted to an answer.

import { minus, norm, plus, scaled } from "../geometry/kinematics.js";
import { joinList, formatNumber } from "../sentences.js";
import { combineCauses, makeCause } from "./ranking.js";

/** @typedef {import("./ranking.js").Cause} Cause */
/** @typedef {import("../geometry/path.js").Path} Path */
/** @typedef {{ cause: Cause, path: Path }} WrongPath the path that a mistake makes */

// A factor of 2 exchanges diameter and radius. A factor of 4 exchanges the homeworks' durations,
// 5 s and 20 s.
const FACTORS = [1 / 2, 2, 1 / 4, 4];
const AXES = [0, 1, 2];
const PAIRS = [
  [0, 1],
  [0, 2],
  [1, 2],
];

// Mistakes in the times

/**
 * List mistakes in time. The path is followed at `rate`, from its start or backwards from its end.
 * @returns {{ cause: Cause, rate: number, from: number }[]} all handed in
 */
function listTimeMistakes({ times }) {
  const [begin, end] = [times[0], times.at(-1)];
  return [
    { cause: makeCause("trace.backwards"), rate: -1, from: begin + end },
    ...FACTORS.map((f) => {
      const fields = { _share: formatNumber(100 * f), _over: formatNumber(1 / f) };
      return { cause: makeCause("trace.fraction", fields), rate: f, from: (1 - f) * begin };
    }),
    ...listAngleSteps({ times }),
  ];
}

/**
 * List wrong angles of step i, 2 pi i/(N + 1) or, as linspace(90, 450, N) gives, 2 pi i/(N - 1).
 * Both were handed in.
 */
export function listAngleSteps({ times }) {
  const steps = times.length - 1;
  return [
    ["trace.open", 1],
    ["trace.short", -1],
  ].map(([key, more]) => {
    const rate = steps / (steps + Number(more));
    return { cause: makeCause(String(key)), rate, from: (1 - rate) * times[0] };
  });
}

/** @param {Path} path @returns {WrongPath[]} */
const listPathsInOtherTimes = (path) =>
  listTimeMistakes(path).map(({ cause, rate, from }) => {
    const position = (t) => path.position(from + rate * t);
    const velocity = (t) => scaled(rate, path.velocity(from + rate * t));
    return { cause, path: { ...path, position, velocity } };
  });

// Mistakes in the points

/** @returns {Generator<WrongPath>} all handed in */
function* listMovedPaths(path) {
  const makeWrongPath = (cause, o, map) => {
    const position = (t) => plus(o, map(minus(path.position(t), o)));
    return { cause, path: { ...path, position, velocity: (t) => map(path.velocity(t)) } };
  };
  yield makeWrongPath(makeCause("trace.other side"), startPoint(path), (p) => scaled(-1, p));
  for (const o of [startPoint(path), circleCentre(path)]) {
    for (const f of FACTORS)
      yield makeWrongPath(makeCause("trace.scaled", { _scale: formatNumber(f) }), o, (p) =>
        scaled(f, p),
      );
    for (const [i, j] of PAIRS) {
      const order = AXES.map((k) => (k === i ? j : k === j ? i : k));
      const cause = makeCause("trace.axes exchanged", { first: "xyz"[i], second: "xyz"[j] });
      yield makeWrongPath(cause, o, (p) => order.map((k) => p[k]));
    }
  }
}

const startPoint = (path) => path.position(path.times[0]);
const middleTime = ({ times }) => (times[0] + times.at(-1)) / 2;
const circleCentre = (path) => scaled(0.5, plus(startPoint(path), path.position(middleTime(path))));

/** List the paths that a single mistake makes. @param {Path} path @returns {WrongPath[]} */
export const listPathsWithOneMistake = (path) => [
  ...listPathsInOtherTimes(path),
  ...listMovedPaths(path),
];

/** List the paths that two mistakes make. @param {Path} path @returns {Generator<WrongPath>} */
export function* listPathsWithTwoMistakes(path) {
  for (const first of listPathsWithOneMistake(path))
    for (const second of listMovedPaths(first.path))
      yield { cause: combineCauses(first.cause, second.cause), path: second.path };
}

/**
 * List the path shifted to the point where the trajectory begins. There is none if that is the
 * right point. The shift leaves out coordinates of the circle's centre (slip 11) or has any other
 * cause (handed in).
 * @param {Path} path @param {number[]} start @returns {WrongPath[]}
 */
export function listDisplacedPaths(path, start, allowed) {
  const shift = minus(start, startPoint(path));
  if (norm(shift) <= allowed) return [];
  const removeCentre = (axes) => circleCentre(path).map((x, i) => (axes.includes(i) ? -x : 0));
  const missing = [...AXES.map((i) => [i]), ...PAIRS, AXES].find(
    (axes) => norm(minus(shift, removeCentre(axes))) <= allowed,
  );
  const cause = missing
    ? makeCause("trace.centre", { axes: joinList(missing.map((i) => "xyz"[i])) })
    : makeCause("trace.displaced", { _by: formatShift(shift) });
  return [{ cause, path: { ...path, position: (t) => plus(path.position(t), shift) } }];
}

// Format a vector in mm, with at most three digits of its largest coordinate.
function formatShift(metres) {
  const largest = 1e3 * Math.max(...metres.map(Math.abs));
  const unit = 10 ** [100, 10, 1].filter((limit) => largest < limit).length;
  return `(${metres.map((x) => formatNumber(Math.round(1e3 * x * unit) / unit + 0)).join(", ")})`;
}
