// The tip's paths in the picture: tubes, the plane behind a flat path, and the axes of that plane.

import { MeshBasicMaterial } from "three";
import { linkFrames, plus, scaled } from "../../judge/geometry/kinematics.js";
import { Arrow, makePaneMaterial, makeTube, makeWall } from "./shapes.js";
import { formatShort } from "./text.js";

/**
 * Make the tubes of the played path, the wanted path or all runs, with their plane and its axes.
 * @param {Pick<import("./state.js").State, "arm" | "trace" | "wantedPath" | "tipPaths">} state
 * @param {{ size: number, look: any, dark: boolean }} options reach of the arm in m, and colours
 * @returns {{ parts: import("three").Object3D[], labels: { end: number[], letter: string,
 *   length: string }[] }}
 */
export function makeTipPaths({ arm, trace, wantedPath, tipPaths }, { size, look, dark }) {
  const points = trace?.map((q) => linkFrames(arm, q).at(-1).o) ?? tipPaths?.[0]?.points ?? [];
  const parts = tipPaths
    ? tipPaths.map(({ points: line, colour }) => makeTube(line, 0.003 * size, colour))
    : [makeTube(points, 0.0035 * size, look.path)];
  if (wantedPath?.length > trace?.length)
    parts.push(makeTube(wantedPath, 0.0018 * size, look.wantedPath));
  const pane = makePaneMaterial(look.ghost, dark ? 0.16 : 0.1);
  const plane = points.length > 2 ? makeWall(wantedPath ?? points, pane) : null;
  if (!plane) return { parts, labels: [] };
  const axes = listAxesInPlane(plane);
  const material = new MeshBasicMaterial({ color: look.wantedPath });
  for (const { start, vector } of axes) {
    const arrow = new Arrow(material);
    arrow.placeAlong(start, vector, 0.0022 * size);
    parts.push(arrow);
  }
  return { parts: [plane.wall, ...parts], labels: axes.map(({ label }) => label) };
}

// List the base axes in the plane of a path: from a corner of the wall, and as long as the path's
// radius.
function listAxesInPlane({ centre, radius, normal }) {
  const inPlane = [0, 1, 2].filter((i) => Math.abs(normal[i]) < 0.02);
  const start = centre.map((v, i) => (inPlane.includes(i) ? v - 1.5 * radius : v));
  return inPlane.map((i) => {
    const vector = [0, 1, 2].map((k) => (k === i ? radius : 0));
    const length = `${formatShort(radius, 3)} m`;
    return {
      start,
      vector,
      label: { end: plus(start, scaled(1.2, vector)), letter: "xyz"[i], length },
    };
  });
}
