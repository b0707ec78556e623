// The arm as a small SVG in the ink of the page around it: for paper, and where there is no WebGL.
// The same picture as helpers/explorer/stub.py makes; a test holds the two equal.

import { minus, plus, scaled } from "../../judge/geometry/kinematics.js";

const [WIDTH, HEIGHT, MARGIN] = [480, 320, 36];
const RIGHT = [0.6816, 0.7317, 0.0];
const UP = [-0.2514, 0.2342, 0.9391];
const COLOURS = { x: "#D55E00", y: "#009E73", z: "#0072B2" };

const along = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
const flat = (p) => [along(RIGHT, p), -along(UP, p)];

// The corners that the links go through: after each row's slide along z, and at its frame.
function skeleton(arm, frames) {
  const corners = arm.rows.flatMap((row, i) => [
    minus(frames[i + 1].o, scaled(row.a, frames[i + 1].x)),
    frames[i + 1].o,
  ]);
  return [frames[0].o, ...corners];
}

/**
 * The picture's shapes, in tenths of a pixel: lines with their ink, and spots.
 * @param {import("../../judge/geometry/arm.js").Arm} arm
 * @param {{ x: number[], y: number[], z: number[], o: number[] }[]} frames
 */
export function stillShapes(arm, frames) {
  const corners = skeleton(arm, frames);
  const extent = [0, 1, 2].map(
    (k) => Math.max(...corners.map((c) => c[k])) - Math.min(...corners.map((c) => c[k])),
  );
  const size = 0.12 * Math.max(...extent);
  const ends = [frames[0], frames.at(-1)];
  const axes = ends.flatMap((f) =>
    ["x", "y", "z"].map((n) => ({ n, o: f.o, tip: plus(f.o, scaled(size, f[n])) })),
  );
  const shadow = corners.map(([x, y]) => [x, y, 0]);
  const held = [...corners, ...shadow, ...axes.map(({ tip }) => tip)].map(flat);
  const [low, high] = [Math.min, Math.max].map((pick) =>
    [0, 1].map((k) => pick(...held.map((p) => p[k]))),
  );
  const room = [WIDTH - 2 * MARGIN, HEIGHT - 2 * MARGIN];
  const scale = Math.min(...room.map((r, k) => r / Math.max(high[k] - low[k], 1e-9)));
  const shift = [WIDTH, HEIGHT].map((v, k) => v / 2 - (scale * (low[k] + high[k])) / 2);
  const place = (p) => flat(p).map((v, k) => Math.round(10 * (scale * v + shift[k])) / 10 + 0);
  return {
    shadow: shadow.map(place),
    links: corners.map(place),
    spots: frames.slice(0, -1).map(({ o }) => place(o)),
    axes: axes.map(({ n, o, tip }) => ({ n, from: place(o), to: place(tip) })),
  };
}

export function stillSvg(arm, frames, words) {
  const { shadow, links, spots, axes } = stillShapes(arm, frames);
  const line = (points, opacity) =>
    `<polyline points="${points.join(" ")}" fill="none" stroke="currentColor" stroke-width="8"` +
    ` stroke-linejoin="round" stroke-linecap="round" stroke-opacity="${opacity}"/>`;
  const parts = [
    line(shadow, 0.12),
    line(links, 0.5),
    ...spots.map(([x, y]) => `<circle cx="${x}" cy="${y}" r="7" fill="currentColor"/>`),
    ...axes.map(
      ({ n, from, to }) =>
        `<line x1="${from[0]}" y1="${from[1]}" x2="${to[0]}" y2="${to[1]}" ` +
        `stroke="${COLOURS[n]}" stroke-width="3"/>`,
    ),
  ];
  const picture = new DOMParser().parseFromString(
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${HEIGHT}" width="${WIDTH}"` +
      ` style="max-width:100%;height:auto" role="img">${parts.join("")}</svg>`,
    "image/svg+xml",
  ).documentElement;
  picture.setAttribute("aria-label", words);
  return document.importNode(picture, true);
}

export const poseText = (arm, q) => {
  const moving = arm.rows.flatMap((row, i) => (row.kind === "fixed" ? [] : [i + 1]));
  const values = q.map((v, k) => `q_${moving[k]} = ${Number(v.toFixed(3)) + 0}`);
  return `${arm.name} at ${values.join(", ")}.`;
};
