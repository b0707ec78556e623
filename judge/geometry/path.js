// Makes paths of the tip, as helpers/motion/paths.py does. A path has a position and a velocity at
// any time.

import { cross, linkFrames } from "./kinematics.js";

/**
 * @typedef {object} Path
 * @property {number[]} times the starts of the steps and the end of the last one (s)
 * @property {(t: number) => number[]} position (m)
 * @property {(t: number) => number[]} velocity (m/s)
 * @property {number[]} normal of the wall that the path lies on
 */

const UNIT = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/**
 * Make a path of samples from Python. It is NaN at all times without a sample.
 * @param {{ times: number[], at: [number, number[], number[]][], normal: number[] }} samples
 *   `at` has the time, the position and the velocity of each sample
 * @param {Set<number>} wanted collects the times that were asked for and have no sample
 * @returns {Path}
 */
export function sampledPath({ times, at, normal }, wanted) {
  const known = new Map(at.map(([t, ...both]) => [t, both]));
  const nowhere = [NaN, NaN, NaN];
  const lookUp = (k) => (t) => {
    if (!known.has(t)) wanted.add(t);
    return known.get(t)?.[k] ?? nowhere;
  };
  return { times, position: lookUp(0), velocity: lookUp(1), normal };
}

/**
 * Make a circle at constant speed.
 * @param {{ centre: number[], radius: number, plane: string, period: number, steps: number, phase?:
 *   number }} options `plane` names the two base axes of the circle, first the one that points from
 *   the centre to the start, then the direction of motion, as "zy"; `period` in s, lengths in m
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
 * Make the circle that begins at the arm's tip and lies below it.
 * @param {import("./arm.js").Rows} arm
 * @param {{ start: number[], radius: number, plane: string, period: number, steps: number }}
 *   options `start` holds joint values; `plane` contains z
 */
export function circleBelow(arm, options) {
  const [x, y, z] = linkFrames(arm, options.start).at(-1).o;
  const phase = options.plane[0] === "z" ? 0 : Math.PI / 2;
  return circlePath({ ...options, centre: [x, y, z - options.radius], phase });
}

/**
 * Return the same path in the same time, begun and ended at rest.
 * @param {Path} path
 * @returns {Path}
 */
export function restToRest(path) {
  const [begin, end] = [path.times[0], path.times.at(-1)];
  const period = end - begin;
  const share = (t) => (t - begin) / period;
  const slowed = (u) => begin + period * u ** 3 * (10 + u * (6 * u - 15));
  return {
    ...path,
    position: (t) => path.position(slowed(share(t))),
    velocity: (t) => {
      const u = share(t);
      return path.velocity(slowed(u)).map((v) => 30 * (u * (1 - u)) ** 2 * v);
    },
  };
}
