// Paths of the tip as helpers/motion/paths.py makes them: where it should be, and how fast, at any
// time.

import { cross, linkFrames } from "./kinematics.js";

/**
 * @typedef {object} Path
 * @property {number[]} times when the steps begin and the last one ends (s)
 * @property {(t: number) => number[]} position (m)
 * @property {(t: number) => number[]} velocity (m/s)
 * @property {number[]} normal of the wall that it lies on
 */

const UNIT = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/**
 * A path that Python holds, by where and how fast it is at some times; `wanted` collects the others
 * that are asked for.
 * @param {{ times: number[], at: [number, number[], number[]][], normal: number[] }} held
 * @param {Set<number>} wanted
 * @returns {Path}
 */
export function sampledPath({ times, at, normal }, wanted) {
  const known = new Map(at.map(([t, ...both]) => [t, both]));
  const nowhere = [NaN, NaN, NaN];
  const one = (k) => (t) => {
    if (!known.has(t)) wanted.add(t);
    return known.get(t)?.[k] ?? nowhere;
  };
  return { times, position: one(0), velocity: one(1), normal };
}

/**
 * A circle at even speed; `plane` names the base axes that it sets out from and towards, as in
 * "zy".
 * @param {{ centre: number[], radius: number, plane: string, period: number, steps: number, phase?:
 *   number }} asked
 * @returns {Path}
 */
export function circlePath({ centre, radius, plane, period, steps, phase = 0 }) {
  const [first, second] = [...plane].map((axis) => UNIT["xyz".indexOf(axis)]);
  const rate = (2 * Math.PI) / period;
  const at = (t) => {
    const angle = phase + rate * t;
    return [Math.cos(angle), Math.sin(angle)];
  };
  return {
    times: Array.from({ length: steps + 1 }, (_, k) =>
      k === steps ? period : k * (period / steps),
    ),
    position: (t) => {
      const [c, s] = at(t);
      return centre.map((x, i) => x + radius * (c * first[i] + s * second[i]));
    },
    velocity: (t) => {
      const [c, s] = at(t);
      return centre.map((_, i) => radius * rate * (c * second[i] - s * first[i]));
    },
    normal: cross(first, second),
  };
}

/**
 * The circle that begins at the tip of an arm at `start` and hangs below it; `plane` has z in it.
 * @param {any} arm
 * @param {{ start: number[], radius: number, plane: string, period: number, steps: number }} asked
 */
export function circleBelow(arm, asked) {
  const [x, y, z] = linkFrames(arm, asked.start).at(-1).o;
  const phase = asked.plane[0] === "z" ? 0 : Math.PI / 2;
  return circlePath({ ...asked, centre: [x, y, z - asked.radius], phase });
}

/** The same path in the same time, begun and ended at rest. @param {Path} path @returns {Path} */
export function restToRest(path) {
  const [begin, end] = [path.times[0], path.times.at(-1)];
  const period = end - begin;
  const share = (t) => (t - begin) / period;
  const there = (u) => begin + period * u ** 3 * (10 + u * (6 * u - 15));
  return {
    ...path,
    position: (t) => path.position(there(share(t))),
    velocity: (t) => {
      const u = share(t);
      return path.velocity(there(u)).map((v) => 30 * (u * (1 - u)) ** 2 * v);
    },
  };
}
