// Closed form of arms with three parallel axes in the middle, as Universal Robots builds them: at
// most eight branches. It stays beside inverse_structure.js because it frees joint 6 where axes 4
// and 6 are parallel and keeps the branches about it, as chapter 5 does.

import {
  clamp,
  collectBranches,
  solveShoulder,
  innerRadius,
  ROUND_OFF,
  withTwist,
  outerRadius,
  BOUNDARY,
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
  const turn3 = second.ca * third.ca;
  const offset = second.d + second.ca * third.d + turn3 * fourth.d;
  const links = { upper: second.a, fore: third.a };
  const shape = { rows, links, turn3, side: -fourth.sa * turn3, offset };
  const tool = removeLastRow(rows[5], target);
  const plane = solveShoulder(rows[0], offset, tool.centre);
  const wrists = [0, 1].map((side) => solveUrWrist(shape, plane, tool, side));
  return collectBranches([SIDES, WRISTS, BENDS], (side, flip, bend) => {
    const { phi5, phi6, u, singular, blur } = wrists[side][flip];
    const end = endOfLinks(shape, plane.x[side], plane.y, u);
    const bent = solveTwoLinks(links, end, bend ? -1 : 1, second.theta, blur);
    if (!plane.exists || !bent.exists) return null;
    const heading = Math.atan2(u[1], u[0]);
    const q = [
      subtractOffset(plane.phi[side], rows[0].theta),
      subtractOffset(bent.phi2, second.theta),
      subtractOffset(second.ca * bent.phi3, third.theta),
      wrapAngle(turn3 * (heading - bent.phi2 - bent.phi3) - fourth.theta),
      subtractOffset(phi5, rows[4].theta),
      subtractOffset(phi6, rows[5].theta),
    ];
    const loose = singular && !isIsolated(shape, plane.x[side], plane.y);
    const free = [plane.free, bent.free, false, false, false, loose];
    return { q, free, merged: [plane.one, singular, bent.one] };
  });
}

// Return both solutions of joints 5 and 6 for one shoulder, each with x_4 = u in the plane.
function solveUrWrist(shape, plane, tool, side) {
  const { rows } = shape;
  const [c, s] = [Math.cos(plane.phi[side]), Math.sin(plane.phi[side])];
  const { sa } = rows[0];
  const along = [tool.x, tool.y, tool.z].map(([x, y]) => sa * (s * x - c * y));
  const inPlane = ([x, y, z]) => [c * x + s * y, sa * z];
  const [X, Y, Z] = [tool.x, tool.y, tool.z].map(inPlane);
  const across = Math.sqrt(along[0] * along[0] + along[1] * along[1]);
  const cosine = shape.side * rows[4].sa * along[2];
  const singular = across < SINGULAR + plane.blur;
  const sine = singular ? 0 : across;
  const uncertain = singular ? 0 : (ROUND_OFF + plane.blur) / sine;
  const blur = Math.abs(rows[4].d) * uncertain;
  const scale = shape.side / (singular ? 1 : sine);
  let [c6, s6] = [-scale * along[0], scale * along[1]];
  const phi6 = singular ? rows[5].theta : Math.atan2(s6, c6);
  if (singular) [c6, s6] = [Math.cos(phi6), Math.sin(phi6)];
  const tilt = rows[4].sa * sine;
  const u = [0, 1].map((i) => tilt * Z[i] + cosine * (c6 * X[i] - s6 * Y[i]));
  const phi5 = Math.atan2(sine, cosine);
  const half = phi6 < 0 || Object.is(phi6, -0) ? -Math.PI : Math.PI;
  const both = [
    { phi5, phi6, u, singular, blur },
    {
      phi5: -phi5,
      phi6: singular ? phi6 : phi6 - half,
      u: singular ? u : u.map((x) => -x),
      singular,
      blur,
    },
  ];
  const loose = singular || uncertain > BOUNDARY;
  return loose ? both.map((one) => turnWithinReach(shape, plane.x[side], plane.y, one)) : both;
}

/**
 * Return the point where the two links must end: the wrist's centre less d_5 along z_4.
 * @param {any} shape @param {number} x @param {number} y @param {number[]} u
 * @returns {number[]}
 */
function endOfLinks({ side, rows }, x, y, u) {
  const reach = side * rows[4].d;
  return [x + reach * u[1], y - reach * u[0]];
}

// Return whether only one turn about the wrist's centre leaves the links within reach.
function isIsolated({ rows, links }, x, y) {
  const [far, arc] = [Math.hypot(x, y), Math.abs(rows[4].d)];
  const [nearest, farthest] = [Math.abs(far - arc), far + arc];
  const touching =
    nearest >= outerRadius(links) - 2 * BOUNDARY || farthest <= innerRadius(links) + 2 * BOUNDARY;
  return touching && Math.min(far, arc) > BOUNDARY;
}

// Turn a free or uncertain joint 6 until the links reach. An isolated solution has only one such
// angle.
function turnWithinReach(shape, x, y, found) {
  const { rows, links, side } = shape;
  const arc = Math.abs(rows[4].d);
  const [ux, uy] = found.u;
  const [px, py] = endOfLinks(shape, x, y, found.u);
  const [far, length] = [Math.hypot(x, y), Math.hypot(px, py)];
  const wanted = clamp(length, innerRadius(links), outerRadius(links));
  const alone = isIsolated(shape, x, y);
  const [vx, vy] = [x - px, y - py];
  const angle = Math.atan2(x * vy - y * vx, x * vx + y * vy);
  const ratio = (far ** 2 + arc ** 2 - wanted ** 2) / Math.max(2 * far * arc, 1e-300);
  const size = Math.acos(clamp(alone ? Math.round(ratio) : ratio, -1, 1));
  const turn = (angle < 0 || Object.is(angle, -0) ? -size : size) - angle;
  const near = Math.max(Math.abs(length - wanted), (arc * Math.abs(turn)) / 2) <= found.blur;
  const needed = found.singular ? alone || length !== wanted : near;
  if (!needed) return { ...found, phi6: wrapAngle(found.phi6) };
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  const along = side * rows[4].sa * Math.cos(found.phi5);
  return {
    ...found,
    u: [c * ux - s * uy, s * ux + c * uy],
    phi6: wrapAngle(found.phi6 - Math.sign(along) * turn),
  };
}
