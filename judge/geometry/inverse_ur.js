// Solves arms with three parallel axes in the middle, as Universal Robots builds them. They have at
// most eight branches. The module stays beside inverse_structure.js because it frees joint 6 if
// axes 4 and 6 are parallel and keeps the branches around it, as chapter 5 does.

import {
  clamp,
  collectBranches,
  solveShoulder,
  innerRadius,
  VECTOR_ROUND_OFF,
  withTwist,
  outerRadius,
  BOUNDARY_DISTANCE,
  subtractOffset,
  SIDES,
  SINGULAR,
  solveTwoLinks,
  removeLastRow,
  wrapAngle,
  WRISTS,
} from "./planar.js";

/** @typedef {import("./inverse.js").Branch} Branch */

const BENDS = ["elbow +", "elbow -"];

/** @returns {Branch[]} */
export function solveUr(arm, target) {
  const rows = arm.rows.map(withTwist);
  const [, second, third, fourth] = rows;
  const sign3 = second.ca * third.ca; // 1, or -1 if z_3 points against z_1
  const offset = second.d + second.ca * third.d + sign3 * fourth.d;
  const links = { upper: second.a, fore: third.a };
  const shape = { rows, links, side: -fourth.sa * sign3 };
  const tool = removeLastRow(rows[5], target);
  const plane = solveShoulder(rows[0], offset, tool.centre);
  const wrists = [0, 1].map((side) => solveUrWrist(shape, plane, tool, side));
  return collectBranches([SIDES, WRISTS, BENDS], (side, flip, bend) => {
    const { phi5, phi6, u, singular, uncertainty } = wrists[side][flip];
    const end = endOfLinks(shape, plane.x[side], plane.y, u);
    const elbow = solveTwoLinks(links, end, bend ? -1 : 1, second.theta, uncertainty);
    if (!plane.exists || !elbow.exists) return null;
    const heading = Math.atan2(u[1], u[0]);
    const q = [
      subtractOffset(plane.phi[side], rows[0].theta),
      subtractOffset(elbow.phi2, second.theta),
      subtractOffset(second.ca * elbow.phi3, third.theta),
      wrapAngle(sign3 * (heading - elbow.phi2 - elbow.phi3) - fourth.theta),
      subtractOffset(phi5, rows[4].theta),
      subtractOffset(phi6, rows[5].theta),
    ];
    const isSixthFree = singular && !isIsolated(shape, plane.x[side], plane.y);
    const free = [plane.free, elbow.free, false, false, false, isSixthFree];
    return { q, free, merged: [plane.isDouble, singular, elbow.isDouble] };
  });
}

// Return both solutions of joints 5 and 6 for one side of the shoulder. `u` is x_4 in the arm's
// plane, and `uncertainty` how far round-off may have moved the end of the links (m).
function solveUrWrist(shape, plane, tool, side) {
  const { rows } = shape;
  const [c, s] = [Math.cos(plane.phi[side]), Math.sin(plane.phi[side])];
  const { sa } = rows[0];
  const along = [tool.x, tool.y, tool.z].map(([x, y]) => sa * (s * x - c * y));
  const inPlane = ([x, y, z]) => [c * x + s * y, sa * z];
  const [X, Y, Z] = [tool.x, tool.y, tool.z].map(inPlane);
  const across = Math.sqrt(along[0] * along[0] + along[1] * along[1]);
  const cosine = shape.side * rows[4].sa * along[2];
  const singular = across < SINGULAR + plane.uncertainty;
  const sine = singular ? 0 : across;
  const angleUncertainty = singular ? 0 : (VECTOR_ROUND_OFF + plane.uncertainty) / sine; // rad
  const uncertainty = Math.abs(rows[4].d) * angleUncertainty;
  const scale = shape.side / (singular ? 1 : sine);
  let [c6, s6] = [-scale * along[0], scale * along[1]];
  const phi6 = singular ? rows[5].theta : Math.atan2(s6, c6);
  if (singular) [c6, s6] = [Math.cos(phi6), Math.sin(phi6)];
  const tilt = rows[4].sa * sine;
  const u = [0, 1].map((i) => tilt * Z[i] + cosine * (c6 * X[i] - s6 * Y[i]));
  const phi5 = Math.atan2(sine, cosine);
  const halfTurn = phi6 < 0 || Object.is(phi6, -0) ? -Math.PI : Math.PI;
  const wrists = [
    { phi5, phi6, u, singular, uncertainty },
    {
      phi5: -phi5,
      phi6: singular ? phi6 : phi6 - halfTurn,
      u: singular ? u : u.map((x) => -x),
      singular,
      uncertainty,
    },
  ];
  // Above 1e-12 rad the links may just miss an end that they just reach.
  const isUncertain = singular || angleUncertainty > BOUNDARY_DISTANCE;
  return isUncertain
    ? wrists.map((wrist) => turnWithinReach(shape, plane.x[side], plane.y, wrist))
    : wrists;
}

/**
 * Return the point where the two links must end, which is d_5 along z_4 before the wrist's centre.
 * @param {any} shape of the arm
 * @param {number} x @param {number} y wrist's centre in the arm's plane (m)
 * @param {number[]} u direction x_4 in the arm's plane
 * @returns {number[]}
 */
function endOfLinks({ side, rows }, x, y, u) {
  const d5 = side * rows[4].d;
  return [x + d5 * u[1], y - d5 * u[0]];
}

// Return whether the circle of possible ends of the links touches their reach in one point only.
// Its centre is the wrist's centre (x, y), its radius |d_5|.
function isIsolated({ rows, links }, x, y) {
  const [distance, radius] = [Math.hypot(x, y), Math.abs(rows[4].d)];
  const [nearest, farthest] = [Math.abs(distance - radius), distance + radius];
  const touches =
    nearest >= outerRadius(links) - 2 * BOUNDARY_DISTANCE ||
    farthest <= innerRadius(links) + 2 * BOUNDARY_DISTANCE;
  return touches && Math.min(distance, radius) > BOUNDARY_DISTANCE;
}

// Turn a free or uncertain joint 6 until the links reach their end.
function turnWithinReach(shape, x, y, wrist) {
  const { rows, links, side } = shape;
  const radius = Math.abs(rows[4].d);
  const [ux, uy] = wrist.u;
  const [endX, endY] = endOfLinks(shape, x, y, wrist.u);
  const [distance, length] = [Math.hypot(x, y), Math.hypot(endX, endY)];
  const reachable = clamp(length, innerRadius(links), outerRadius(links));
  const isolated = isIsolated(shape, x, y);
  // The angle at the wrist's centre from the base to the end, now and where the links reach.
  const [vx, vy] = [x - endX, y - endY];
  const angle = Math.atan2(x * vy - y * vx, x * vx + y * vy);
  const ratio =
    (distance ** 2 + radius ** 2 - reachable ** 2) / Math.max(2 * distance * radius, 1e-300);
  const size = Math.acos(clamp(isolated ? Math.round(ratio) : ratio, -1, 1));
  const turn = (angle < 0 || Object.is(angle, -0) ? -size : size) - angle;
  const shift = Math.max(Math.abs(length - reachable), (radius * Math.abs(turn)) / 2);
  const isNeeded = wrist.singular ? isolated || length !== reachable : shift <= wrist.uncertainty;
  if (!isNeeded) return { ...wrist, phi6: wrapAngle(wrist.phi6) };
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  const along = side * rows[4].sa * Math.cos(wrist.phi5);
  return {
    ...wrist,
    u: [c * ux - s * uy, s * ux + c * uy],
    phi6: wrapAngle(wrist.phi6 - Math.sign(along) * turn),
  };
}
