// Every joint vector that takes a tip to a target, where a formula gives them all: as
// helpers/inverse (elbow, rod, stanford, spherical_wrist, ur) for one target, from joints at 0.
// Sources stand there.

import { cosSin, dot, linkFrames, minus, plus, scaled } from "./kinematics.js";
import { ArmError, size } from "../sentences.js";

const REACH = 1e-12; // m: a target this near to the boundary counts as on it
const SINGULAR = 1e-11; // a sine this small counts as 0
const NOISE = 1e-15; // what rounding does to a point (m) or to an axis
const SIDES = ["front", "back"];
const ELBOWS = ["elbow up", "elbow down"];
const RODS = ["rod out", "rod through"];
const WRISTS = ["q_5 > 0", "q_5 < 0"];
const BENDS = ["elbow +", "elbow -"];

/**
 * `times`: 2 where two branches have become one, or are of one family; 4, 8.
 * @typedef {{ name: string, q: number[], free: boolean[], times: number }} Branch
 */
/** @typedef {{ x: number[], y: number[], z: number[], o: number[] }} Frame */

// Rounded to a whole number as NumPy does: halves to the even one.
export function rint(x) {
  const whole = Math.round(x);
  return whole - x === 0.5 && whole % 2 ? whole - 1 : whole;
}

// An angle in (-pi, pi], up to rounding.
export const wrapped = (angle) => rint(angle * (0.5 / Math.PI)) * (-2 * Math.PI) + angle;
const shifted = (angle, offset) => (offset ? wrapped(angle - offset) : angle);
const clipped = (x, least, most) => Math.min(Math.max(x, least), most);

// A row with the sine and cosine of its twist.
function numeric(row) {
  const [ca, sa] = cosSin(row.alpha);
  return { ...row, ca, sa };
}

// Geometry

// Joint 1's two angles that turn the plane, `offset` along z_1 beside the axis, to the target p,
// and p in its axes.
function facing(first, offset, p) {
  const [x, y, z] = p;
  const delta = first.sa * offset;
  const square = x * x + y * y - delta * delta;
  const edge = Math.max(2 * Math.abs(delta) * REACH, REACH ** 2);
  const one = Math.abs(square) <= edge;
  const reach = Math.sqrt(square > edge ? square : 0);
  const both = [reach, -reach];
  const free = one && delta === 0;
  const chosen = [first.theta, first.theta + Math.PI];
  return {
    phi: both.map((b, k) => (free ? chosen[k] : Math.atan2(y * b + x * delta, x * b - y * delta))),
    x: both,
    y: first.sa * (z - first.d),
    exists: square >= -edge,
    one,
    free,
    blur: one ? 0 : NOISE / Math.max(reach, REACH),
  };
}

const outerOf = ({ upper, fore }) => Math.abs(upper) + Math.abs(fore);
const innerOf = ({ upper, fore }) => Math.abs(Math.abs(upper) - Math.abs(fore));

// The two angles of a planar pair of links that ends at (px, py); `sign` is that of sin(phi_3),
// `blur` by how much rounding may move the point.
/** @param {any} links @param {number[]} end @param {number} sign @param {number} chosen */
function twoLinks(links, [px, py], sign, chosen, blur = 0) {
  const { upper, fore } = links;
  const [outer, inner, square] = [outerOf(links), innerOf(links), px * px + py * py];
  const far = Math.sqrt(square);
  const off = Math.min(Math.abs(far - outer), Math.abs(far - inner));
  const one = off <= REACH + blur;
  const ratio = clipped((square - (upper ** 2 + fore ** 2)) * (0.5 / (upper * fore)), -1, 1);
  const cosine = off <= REACH ? Math.round(ratio) : ratio;
  const sine = Math.sqrt(1 - cosine * cosine);
  const [along, across] = [upper + fore * cosine, sign * (fore * sine)];
  const free = one && far <= REACH;
  const exists = one || (inner < far && far < outer);
  return {
    phi2: free ? chosen : Math.atan2(py * along - px * across, px * along + py * across),
    phi3: sign * Math.atan2(sine, cosine),
    exists,
    one,
    free,
    blur: one || !exists ? 0 : (NOISE * outer) / (Math.abs(upper * fore) * sine),
  };
}

// The tool's frame with the last row's twist taken back, and the origin before that row's lengths.
function unwound(last, { x, y, z, o }) {
  const [c, s] = [last.ca, last.sa];
  const turned = { x, y: plus(scaled(c, y), scaled(-s, z)), z: plus(scaled(s, y), scaled(c, z)) };
  const centre = minus(o, scaled(last.d, turned.z));
  return { ...turned, centre: last.a ? minus(centre, scaled(last.a, x)) : centre };
}

// Shoulders: the first three joints for a position

/** @returns {Branch[]} */
function elbow(arm, p) {
  const [first, second, third, tool] = arm.rows.map(numeric);
  const links = linksOf(second, third, tool?.d ?? 0);
  const plane = facing(first, links.offset, p);
  return each([SIDES, ELBOWS], (side, bend) => {
    const sign = first.sa * (side === bend ? -1 : 1);
    const found = twoLinks(links, [plane.x[side], plane.y], sign, second.theta);
    if (!plane.exists || !found.exists) return null;
    const q = [
      shifted(plane.phi[side], first.theta),
      shifted(found.phi2, second.theta),
      shifted(second.ca * found.phi3, links.beta + third.theta),
    ];
    const blur = plane.blur + found.blur;
    return { q, free: [plane.free, found.free, false], merged: [plane.one, found.one], blur };
  });
}

function linksOf(second, third, tool) {
  const across = -tool * third.sa;
  return {
    upper: second.a,
    fore: Math.hypot(third.a, across),
    beta: Math.atan2(across, third.a),
    offset: second.d + second.ca * (third.d + tool * third.ca),
  };
}

/** @returns {Branch[]} */
function rod(arm, p) {
  const [first, second, third, tool] = arm.rows.map(numeric);
  const plane = facing(first, second.d, p);
  return each([SIDES, RODS], (side, through) => {
    if (!plane.exists) return null;
    const out = through ? -1 : 1;
    const length = out * Math.hypot(plane.x[side], plane.y);
    const lean = second.sa * out;
    const central = Math.abs(length) < REACH;
    const phi2 = Math.atan2(lean * plane.x[side], -lean * plane.y);
    const q = [
      shifted(plane.phi[side], first.theta),
      central ? 0 : shifted(phi2, second.theta),
      length - third.d - (tool?.d ?? 0),
    ];
    const leaning = NOISE + Math.hypot(p[0], p[1]) * plane.blur;
    const blur = plane.blur + (central ? 0 : leaning / Math.abs(length));
    return { q, free: [plane.free, central, false], merged: [plane.one, central], blur };
  });
}

// How many branches one is, of choices that make no difference; of those that are one the first is.
const timesOf = (merged, at) =>
  merged.some((one, k) => one && at[k]) ? 0 : 2 ** merged.filter(Boolean).length;

// Each choice of branches, named, where `make` finds one.
function each(choices, make, names = [], at = []) {
  if (!choices.length) {
    const found = make(...at);
    const times = found ? timesOf(found.merged, at) : 0;
    return times ? [{ name: names.join(", "), times, ...found }] : [];
  }
  const [first, ...rest] = choices;
  return first.flatMap((name, k) => each(rest, make, [...names, name], [...at, k]));
}

// A spherical wrist on a shoulder

const toCentre = (arm) => ({
  ...arm,
  rows: [...arm.rows.slice(0, 3), { kind: "fixed", a: 0, alpha: 0, d: arm.rows[3].d, theta: 0 }],
});

/** @returns {Branch[]} */
function decoupled(place, arm, target) {
  const rows = arm.rows.map(numeric);
  const tool = unwound(rows[5], target);
  const shoulder = toCentre(arm);
  return place(shoulder, tool.centre).flatMap(({ name, q, free, times, blur }) => {
    const frame = linkFrames(shoulder, q).at(-1);
    const seen = (v) => [dot(frame.x, v), dot(frame.y, v), dot(frame.z, v)];
    const { pairs, singular } = wrist(rows, seen(tool.x), seen(tool.z), blur);
    return WRISTS.slice(0, singular ? 1 : 2).map((which, k) => ({
      name: `${name}, ${which}`,
      times: singular ? 2 * times : times,
      q: [...q, ...pairs.map((pair, j) => wrapped(pair[k] - rows[3 + j].theta))],
      free: [...free, singular, false, false],
    }));
  });
}

// Joints 4 to 6 both ways, from the tool's axes x and z in frame 3; joint 6 from what joint 4's
// turn leaves of x. Rounding may turn the first three joints by `blur`.
function wrist(rows, x, z, blur) {
  const [s4, s5] = [rows[3].sa, rows[4].sa];
  const cosine = -s4 * s5 * z[2];
  const singular = Math.hypot(z[0], z[1]) < SINGULAR + blur;
  const sine = singular ? 0 : Math.hypot(z[0], z[1]);
  const phi4 = singular ? rows[3].theta : Math.atan2(s5 * z[1], s5 * z[0]);
  const [c, s] = [Math.cos(phi4), Math.sin(phi4)];
  const [ahead, aside] = [c * x[0] + s * x[1], c * x[1] - s * x[0]];
  const phi5 = Math.atan2(sine, cosine);
  const phi6 = Math.atan2(-s4 * s5 * aside, cosine * ahead + s4 * sine * x[2]);
  const flip = singular ? 0 : Math.PI;
  return {
    pairs: [
      [phi4, phi4 + flip],
      [phi5, -phi5],
      [phi6, phi6 + flip],
    ],
    singular,
  };
}

// Three parallel axes in the middle, as Universal Robots builds them

/** @returns {Branch[]} */
function ur(arm, target) {
  const rows = arm.rows.map(numeric);
  const [, second, third, fourth] = rows;
  const turn3 = second.ca * third.ca;
  const offset = second.d + second.ca * third.d + turn3 * fourth.d;
  const links = { upper: second.a, fore: third.a };
  const shape = { rows, links, turn3, side: -fourth.sa * turn3, offset };
  const tool = unwound(rows[5], target);
  const plane = facing(rows[0], offset, tool.centre);
  const wrists = [0, 1].map((side) => urWrist(shape, plane, tool, side));
  return each([SIDES, WRISTS, BENDS], (side, flip, bend) => {
    const { phi5, phi6, u, singular, blur } = wrists[side][flip];
    const end = endOfLinks(shape, plane.x[side], plane.y, u);
    const bent = twoLinks(links, end, bend ? -1 : 1, second.theta, blur);
    if (!plane.exists || !bent.exists) return null;
    const heading = Math.atan2(u[1], u[0]);
    const q = [
      shifted(plane.phi[side], rows[0].theta),
      shifted(bent.phi2, second.theta),
      shifted(second.ca * bent.phi3, third.theta),
      wrapped(turn3 * (heading - bent.phi2 - bent.phi3) - fourth.theta),
      shifted(phi5, rows[4].theta),
      shifted(phi6, rows[5].theta),
    ];
    const loose = singular && !isolated(shape, plane.x[side], plane.y);
    const free = [plane.free, bent.free, false, false, false, loose];
    return { q, free, merged: [plane.one, singular, bent.one] };
  });
}

// Joints 5 and 6, and the axis x_4 = u in the plane, both ways, for one shoulder.
function urWrist(shape, plane, tool, side) {
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
  const uncertain = singular ? 0 : (NOISE + plane.blur) / sine;
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
  const loose = singular || uncertain > REACH;
  return loose ? both.map((one) => withinReach(shape, plane.x[side], plane.y, one)) : both;
}

// Where the two links must end: the wrist's centre (x, y) in the plane less d_5 along z_4.
/** @param {any} shape @param {number} x @param {number} y @param {number[]} u @returns {number[]} */
function endOfLinks({ side, rows }, x, y, u) {
  const reach = side * rows[4].d;
  return [x + reach * u[1], y - reach * u[0]];
}

// Whether no turn about the wrist's centre but one leaves the links within reach.
function isolated({ rows, links }, x, y) {
  const [far, arc] = [Math.hypot(x, y), Math.abs(rows[4].d)];
  const [nearest, farthest] = [Math.abs(far - arc), far + arc];
  const touching = nearest >= outerOf(links) - 2 * REACH || farthest <= innerOf(links) + 2 * REACH;
  return touching && Math.min(far, arc) > REACH;
}

// Joint 6 turned where the links cannot quite reach and it is free, or uncertain by enough; and to
// the only angle where there is but one.
function withinReach(shape, x, y, found) {
  const { rows, links, side } = shape;
  const arc = Math.abs(rows[4].d);
  const [ux, uy] = found.u;
  const [px, py] = endOfLinks(shape, x, y, found.u);
  const [far, length] = [Math.hypot(x, y), Math.hypot(px, py)];
  const wanted = clipped(length, innerOf(links), outerOf(links));
  const alone = isolated(shape, x, y);
  const [vx, vy] = [x - px, y - py];
  const angle = Math.atan2(x * vy - y * vx, x * vx + y * vy);
  const ratio = (far ** 2 + arc ** 2 - wanted ** 2) / Math.max(2 * far * arc, 1e-300);
  const size = Math.acos(clipped(alone ? Math.round(ratio) : ratio, -1, 1));
  const turn = (angle < 0 || Object.is(angle, -0) ? -size : size) - angle;
  const near = Math.max(Math.abs(length - wanted), (arc * Math.abs(turn)) / 2) <= found.blur;
  const needed = found.singular ? alone || length !== wanted : near;
  if (!needed) return { ...found, phi6: wrapped(found.phi6) };
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  const along = side * rows[4].sa * Math.cos(found.phi5);
  return {
    ...found,
    u: [c * ux - s * uy, s * ux + c * uy],
    phi6: wrapped(found.phi6 - Math.sign(along) * turn),
  };
}

// Which form an arm has

const kindsOf = (rows) => rows.map(({ kind }) => kind[0]).join("");

function isElbow({ rows }) {
  if (!["rrr", "rrrf"].includes(kindsOf(rows))) return false;
  const [first, second, third, tool] = rows.map(numeric);
  const flat = first.a === 0 && first.ca === 0 && second.sa === 0 && second.a !== 0;
  return flat && linksOf(second, third, tool?.d ?? 0).fore > 0 && !tool?.a;
}

function hasRod({ rows }) {
  if (!["rrp", "rrpf"].includes(kindsOf(rows))) return false;
  const [first, second, third] = rows.map(numeric);
  const square = first.ca === 0 && second.ca === 0 && third.sa === 0 && third.ca === 1;
  return square && rows.every(({ a }) => a === 0);
}

function hasWrist({ rows }) {
  if (rows.length !== 6 || kindsOf(rows.slice(3)) !== "rrr") return false;
  const [fourth, fifth] = rows.slice(3).map(numeric);
  return fourth.a === 0 && fifth.a === 0 && fifth.d === 0 && fourth.ca === 0 && fifth.ca === 0;
}

function isUr({ rows }) {
  if (kindsOf(rows) !== "rrrrrr") return false;
  const [first, second, third, fourth, fifth] = rows.map(numeric);
  const meeting = [first, fourth, fifth].every(({ a, ca }) => a === 0 && ca === 0);
  return meeting && second.sa === 0 && third.sa === 0 && second.a * third.a !== 0;
}

const FORMS = {
  elbow: { fits: isElbow, of: elbow, pose: false },
  rod: { fits: hasRod, of: rod, pose: false },
  stanford: {
    fits: (arm) => hasWrist(arm) && hasRod(toCentre(arm)),
    of: (arm, target) => decoupled(rod, arm, target),
    pose: true,
  },
  spherical_wrist: {
    fits: (arm) => hasWrist(arm) && isElbow(toCentre(arm)),
    of: (arm, target) => decoupled(elbow, arm, target),
    pose: true,
  },
  ur: { fits: isUr, of: ur, pose: true },
};

// The name, in helpers.inverse, of the closed form that serves an arm; null where none does.
export const formOf = (arm) => Object.keys(FORMS).find((name) => FORMS[name].fits(arm)) ?? null;

// Whether its targets are poses, not points.
export const asksPose = (form) => FORMS[form].pose;

/**
 * All branches for a target: three coordinates, or a frame where the form asks for a pose.
 * @returns {Branch[]}
 */
export function inverse(arm, form, target) {
  if (FORMS[form].pose) mustBeRigid(arm, target);
  return FORMS[form].of(arm, target);
}

function mustBeRigid(arm, { x, y, z }) {
  const third = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
  const gaps = [...minus(third, z), ...[x, y, z].map((v) => dot(v, v) - 1)];
  const error = Math.max(...gaps.map(Math.abs));
  if (error > 1e-6) {
    throw new ArmError(
      `${arm.name}: a target is no rigid transform, by ${size(error, 2)}; expected a rotation and` +
        " a position over (0, 0, 0, 1)",
    );
  }
}
