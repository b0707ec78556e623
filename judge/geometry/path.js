// Makes paths of the tip, as helpers/motion/paths.py does. A path has a position and a velocity at
// any time.

import { cross, linkFrames, minus, norm } from "./kinematics.js";

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

const SAME_POINT = 1e-9; // m: a path whose ends are nearer to each other is closed

/**
 * Make a path of samples from Python. Between two samples it is a cubic, and from its end a closed
 * path goes round again.
 * @param {{ times: number[], samples: [number, number[], number[]][], normal: number[] }} path each
 *   sample has a time, the position and the velocity; the times of the path are among them
 * @returns {Path}
 */
export function makeSampledPath({ times, samples, normal }) {
  const [[begin, first], [end, last]] = [samples[0], samples.at(-1)];
  const isClosed = norm(minus(last, first)) < SAME_POINT;
  const interpolate = (time) => {
    const isBeyond = time < begin || time > end;
    const t = isClosed && isBeyond ? begin + modulo(time - begin, end - begin) : time;
    const next = samples.findIndex(([sampleTime]) => sampleTime > t);
    const k = next < 0 ? samples.length - 2 : Math.max(0, next - 1);
    const [[t0, p0, v0], [t1, p1, v1]] = [samples[k], samples[k + 1]];
    const [h, s] = [t1 - t0, (t - t0) / (t1 - t0)];
    if (s === 0 || s === 1) return s ? [p1, v1] : [p0, v0];
    const rise = 3 * s ** 2 - 2 * s ** 3;
    return [
      p0.map((x, i) => {
        const bend = s * (1 - s) ** 2 * v0[i] - s ** 2 * (1 - s) * v1[i];
        return x + rise * (p1[i] - x) + h * bend;
      }),
      p0.map((x, i) => {
        const ends = (1 - s) * (1 - 3 * s) * v0[i] + s * (3 * s - 2) * v1[i];
        return (6 * s * (1 - s) * (p1[i] - x)) / h + ends;
      }),
    ];
  };
  const cache = new Map();
  const at = (t) => {
    if (!cache.has(t)) cache.set(t, interpolate(t));
    return cache.get(t);
  };
  return { times, position: (t) => at(t)[0], velocity: (t) => at(t)[1], normal };
}

const modulo = (x, period) => ((x % period) + period) % period;

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
