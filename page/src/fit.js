// Fits points of a plane into a picture.

/**
 * Return a function from points to pixels. The points fill a share of the picture, in its middle,
 * at one scale for both axes; the second axis points up.
 * @param {number[][]} points
 * @param {number[]} room width and height of the picture
 * @param {number} share
 * @returns {(point: number[]) => number[]}
 */
export function fitPoints(points, room, share) {
  const ranges = room.map((_, i) => {
    const values = points.map((p) => p[i]);
    return [Math.min(...values), Math.max(...values)];
  });
  const scales = ranges.map(([low, high], i) => (share * room[i]) / Math.max(high - low, 1e-9));
  const scale = Math.min(...scales);
  const [x, y] = ranges.map(([low, high]) => (low + high) / 2);
  return ([u, v]) => [room[0] / 2 + scale * (u - x), room[1] / 2 - scale * (v - y)];
}
