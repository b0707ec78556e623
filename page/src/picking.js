// Which link of an arm is under a pixel.

import { minus, plus, scaled } from "../../judge/geometry/kinematics.js";

// The line of the links, each piece with the row that it belongs to.
export const piecesOf = (arm, frames) =>
  arm.rows.flatMap((row, i) => {
    const [before, after] = [frames[i].o, frames[i + 1].o];
    const corner = minus(after, scaled(row.a, frames[i + 1].x));
    return [
      { row: i, from: before, to: corner },
      { row: i, from: corner, to: after },
    ];
  });

/**
 * The place on the pieces nearest to a pixel: { row, point, gap }, or null. Of two that are equally
 * near, the first.
 * @param {{ row: number, from: number[], to: number[] }[]} pieces
 * @param {number[]} pixel
 * @param {number} within pixels
 * @param {(point: number[]) => number[]} pixelOf
 */
export function nearest(pieces, pixel, within, pixelOf) {
  let best = null;
  for (const { row, from, to } of pieces) {
    const { share, gap } = foot(pixel, pixelOf(from), pixelOf(to));
    if (gap > within || (best && gap >= best.gap - 0.5)) continue;
    best = { row, gap, point: plus(from, scaled(share, minus(to, from))) };
  }
  return best;
}

// Where on the line from a to b a pixel is nearest, and how near.
function foot(pixel, a, b) {
  const [x, y] = pixel;
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const long = dx * dx + dy * dy;
  const along = ((x - a[0]) * dx + (y - a[1]) * dy) / long;
  const share = long < 1 ? 1 : Math.min(1, Math.max(0, along));
  return { share, gap: Math.hypot(a[0] + share * dx - x, a[1] + share * dy - y) };
}
