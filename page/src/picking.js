// Find which link of an arm is under a pixel.

import { minus, movingRows, plus, scaled } from "../../judge/geometry/kinematics.js";

// Return the centre line of the links as segments: along d and along a of each row.
export const getLinkSegments = (arm, frames) =>
  arm.rows.flatMap((row, i) => {
    const [before, after] = [frames[i].o, frames[i + 1].o];
    const corner = minus(after, scaled(row.a, frames[i + 1].x));
    return [
      { row: i, from: before, to: corner },
      { row: i, from: corner, to: after },
    ];
  });

// Return the centre lines of the barrels around the joints' axes; `size` is the arm's reach.
export const getBarrelSegments = (arm, frames, size) =>
  movingRows(arm).map((row) => {
    const half = scaled(0.05 * size, frames[row].z);
    return { row, from: minus(frames[row].o, half), to: plus(frames[row].o, half) };
  });

/**
 * Find the segment nearest to a pixel. Of two that are equally near, the first is returned.
 * @param {{ row: number, from: number[], to: number[] }[]} pieces segments with their rows
 * @param {number[]} pixel
 * @param {number} within largest distance in pixels
 * @param {(point: number[]) => number[]} pixelOf
 * @returns {{ row: number, point: number[], gap: number } | null}
 */
export function findNearestSegment(pieces, pixel, within, pixelOf) {
  let best = null;
  for (const { row, from, to } of pieces) {
    const { share, gap } = projectOnSegment(pixel, pixelOf(from), pixelOf(to));
    if (gap > within || (best && gap >= best.gap - 0.5)) continue;
    best = { row, gap, point: plus(from, scaled(share, minus(to, from))) };
  }
  return best;
}

// Measure the distance in pixels from a pixel to the segment from a to b.
export const measureGap = (pixel, a, b) => projectOnSegment(pixel, a, b).gap;

// Project a pixel on the segment from a to b: `share` along the segment, and `gap` in pixels.
function projectOnSegment(pixel, a, b) {
  const [x, y] = pixel;
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const long = dx * dx + dy * dy;
  const along = ((x - a[0]) * dx + (y - a[1]) * dy) / long;
  const share = long < 1 ? 1 : Math.min(1, Math.max(0, along));
  return { share, gap: Math.hypot(a[0] + share * dx - x, a[1] + share * dy - y) };
}
