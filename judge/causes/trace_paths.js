// Lists wrong paths that usual mistakes make of the wanted path. Their numbers come from homeworks;
// none is fitted to an answer.

import { minus, norm, plus, scaled } from "../geometry/kinematics.js";
import { joinList, formatNumber } from "../sentences.js";
import { combineCauses, makeCause } from "./ranking.js";

/** @typedef {import("./ranking.js").Cause} Cause */
/** @typedef {import("../geometry/path.js").Path} Path */
/** @typedef {{ one: Cause, path: Path }} Other another path, and the mistake that makes it */

// Factors: diameter and radius exchanged; 5 s and 20 s, the homeworks' durations, exchanged.
const FACTORS = [1 / 2, 2, 1 / 4, 4];
const AXES = [0, 1, 2];
const PAIRS = [
  [0, 1],
  [0, 2],
  [1, 2],
];

// Mistakes in the times

/**
 * List mistakes in time: the path is followed at `rate`, from its start or backwards from its end.
 * @returns {{ one: Cause, rate: number, from: number }[]} all handed in
 */
function clocks({ times }) {
  const [begins, ends] = [times[0], times.at(-1)];
  const round = 1 - 1 / times.length; // the angle of step i is 2 pi i/(N + 1)
  return [
    { one: makeCause("trace.backwards"), rate: -1, from: begins + ends },
    ...FACTORS.map((f) => {
      const words = { _share: formatNumber(100 * f), _over: formatNumber(1 / f) };
      return { one: makeCause("trace.fraction", words), rate: f, from: (1 - f) * begins };
    }),
    { one: makeCause("trace.open"), rate: round, from: (1 - round) * begins },
  ];
}

/** @param {Path} path @returns {Other[]} */
const timed = (path) =>
  clocks(path).map(({ one, rate, from }) => {
    const position = (t) => path.position(from + rate * t);
    const velocity = (t) => scaled(rate, path.velocity(from + rate * t));
    return { one, path: { ...path, position, velocity } };
  });

// Mistakes in the points

/** @returns {Generator<Other>} all handed in */
function* placed(path) {
  const other = (one, o, map) => {
    const position = (t) => plus(o, map(minus(path.position(t), o)));
    return { one, path: { ...path, position, velocity: (t) => map(path.velocity(t)) } };
  };
  yield other(makeCause("trace.other side"), begin(path), (p) => scaled(-1, p));
  for (const o of [begin(path), centre(path)]) {
    for (const f of FACTORS)
      yield other(makeCause("trace.scaled", { _scale: formatNumber(f) }), o, (p) => scaled(f, p));
    for (const [i, j] of PAIRS) {
      const order = AXES.map((k) => (k === i ? j : k === j ? i : k));
      const one = makeCause("trace.axes exchanged", { first: "xyz"[i], second: "xyz"[j] });
      yield other(one, o, (p) => order.map((k) => p[k]));
    }
  }
}

const begin = (path) => path.position(path.times[0]);
const half = ({ times }) => (times[0] + times.at(-1)) / 2;
const centre = (path) => scaled(0.5, plus(begin(path), path.position(half(path)))); // of a circle

/** List the paths that one mistake makes. @param {Path} path @returns {Other[]} */
export const pathsWithOneMistake = (path) => [...timed(path), ...placed(path)];

/** List the paths that two mistakes make. @param {Path} path @returns {Generator<Other>} */
export function* pathsWithTwoMistakes(path) {
  for (const first of pathsWithOneMistake(path))
    for (const second of placed(first.path))
      yield { one: combineCauses(first.one, second.one), path: second.path };
}

/**
 * Return whether the data of all these paths is known; if not, Python is asked for all at once.
 * @param {Path} path
 */
export const isPathKnown = (path) =>
  clocks(path)
    .flatMap(({ rate, from }) => path.times.map((t) => from + rate * t))
    .concat(half(path))
    .map(path.position)
    .every(([x]) => !Number.isNaN(x));

/**
 * List the path shifted to where the trajectory begins; none if it begins at the right point.
 * The shift leaves out coordinates of the circle's centre (slip 11) or has any other cause (handed
 * in).
 * @param {Path} path @param {number[]} start @returns {Other[]}
 */
export function displacedPaths(path, start, allowed) {
  const shift = minus(start, begin(path));
  if (norm(shift) <= allowed) return [];
  const gone = (axes) => centre(path).map((x, i) => (axes.includes(i) ? -x : 0));
  const out = [...AXES.map((i) => [i]), ...PAIRS, AXES].find(
    (axes) => norm(minus(shift, gone(axes))) <= allowed,
  );
  const one = out
    ? makeCause("trace.centre", { axes: joinList(out.map((i) => "xyz"[i])) })
    : makeCause("trace.displaced", { _by: vector(shift) });
  return [{ one, path: { ...path, position: (t) => plus(path.position(t), shift) } }];
}

// Format a vector in mm, with at most three digits of its largest coordinate.
function vector(metres) {
  const far = 1e3 * Math.max(...metres.map(Math.abs));
  const unit = 10 ** [100, 10, 1].filter((least) => far < least).length;
  return `(${metres.map((x) => formatNumber(Math.round(1e3 * x * unit) / unit + 0)).join(", ")})`;
}
