// What mistakes make of right torques tau = g(q) - J^T F. Torques are one list for all poses, pose
// by pose.

import { DEG, RAD } from "../geometry/angles.js";
import * as chains from "../geometry/chains.js";
import { joints } from "../geometry/kinematics.js";
import { minusEach } from "../geometry/linear.js";
import { numbered, turning } from "../reading/numbers.js";
import { both, cause } from "./ranking.js";
import { listed, size } from "../sentences.js";

const SEEN = 1e-3; // N m
const LIGHT = 0.01; // kg: nobody types a lighter link

/** @typedef {import("./ranking.js").Cause} Cause */
/** @type {[Cause | null, (tau: number[][]) => number[][]][]} */
const WRITINGS = [
  [null, (tau) => tau],
  [cause("tau.all signs"), (tau) => tau.map((row) => row.map((x) => -x))],
  [cause("tau.newton millimetres"), (tau) => tau.map((row) => row.map((x) => 1000 * x))],
  [cause("tau.reversed order"), (tau) => tau.map((row) => [...row].reverse())],
];

// What torques, a list for all poses, are off by in N m and by joint, however a mistake in how they
// are written has scaled and ordered them.
export function mended({ keys }, off, dof) {
  const scaled = keys.includes("tau.newton millimetres") ? off.map((x) => x / 1000) : off;
  const back = (_, i) => scaled[i - (i % dof) + dof - 1 - (i % dof)];
  return keys.includes("tau.reversed order") ? scaled.map(back) : scaled;
}

/**
 * An arm with masses at some poses, under a wrench.
 * @typedef {object} Load
 * @property {any} arm
 * @property {number[][]} q
 * @property {number[][]} wrenches one for each pose
 * @property {number[]} gravity
 * @property {number[]} masses
 * @property {number[][]} centres
 * @property {{ c: import("../geometry/chains.js").Chain, T: any[], J: number[] }[]} at each pose
 */

/** @returns {Load} */
export function loadOf(arm, q, wrenches, gravity) {
  const at = q.map((one) => {
    const c = chains.chain(arm, one);
    const T = chains.framesOf(c);
    return { c, T, J: chains.columns(c, T) };
  });
  const bodies = arm.rows.map((row) => row.body);
  const [masses, centres] = [bodies.map(([mass]) => mass), bodies.map(([, ...centre]) => centre)];
  return { arm, q, wrenches, gravity, masses, centres, at };
}

// g(q), with other masses or centres where given; a list for each pose.
const weight = ({ at, gravity, ...load }, { masses = load.masses, centres = load.centres } = {}) =>
  at.map(({ c, T }) => chains.weights(c, T, masses, centres, gravity));

// J^T F.
const force = ({ at, wrenches }, change = (F, _T) => F) =>
  at.map(({ J, T }, i) => chains.through(J, change(wrenches[i], T.at(-1))));

const less = (p, q) => p.map((row, i) => minusEach(row, q[i]));
const times = (factor, p) => p.map((row) => row.map((x) => factor * x));

export const torques = (load) => less(weight(load), force(load));

// Every combination of up to two causes, fewest first, and the torques that they give.
export function catalogue(load) {
  const found = [];
  for (const [whole, other] of loads(load)) {
    const pushed = [...forces(other)];
    for (const [first, heavy] of weights(other)) {
      for (const [second, push] of pushed) {
        const named = [whole, first, second].filter(Boolean);
        if (named.length > 2) continue;
        const tau = less(heavy, push);
        for (const [third, write] of WRITINGS) {
          const causes = third ? [...named, third] : named;
          if (causes.length && causes.length <= 2)
            found.push([causes.reduce(both), write(tau).flat()]);
        }
      }
    }
  }
  found.sort(([p], [q]) => p.keys.length - q.keys.length);
  return { causes: found.map(([one]) => one), made: found.map(([, tau]) => tau) };
}

// Joints that count the other way in the torques, and in q as well, fewest first.
export function reversedJoints(load, right) {
  const joint = numbered(load.arm);
  const dof = joint.length;
  const sets = chains.signSets(dof);
  const here = sets.map((signs) => right.map((x, i) => x * signs[i % dof]));
  const there = sets.map((signs) => {
    const q = load.q.map((one) => one.map((x, k) => signs[k] * x));
    const other = loadOf(load.arm, q, load.wrenches, load.gravity);
    return torques(other).flatMap((row) => row.map((x, k) => x * signs[k]));
  });
  const joints = (signs, name) =>
    listed(joint.filter((_, k) => signs[k] < 0).map((i) => `${name}${i}`));
  const causes = [
    ["tau.signs", "tau_"],
    ["tau.joints reversed", "q_"],
  ].flatMap(([key, name]) => sets.map((signs) => cause(key, { joints: joints(signs, name) })));
  return { causes, made: [...here, ...there] };
}

// Centres of mass as a paper gives them, unconverted: in the maker's Craig frames. Where the
// maker's joint counts the other way, y and z point the other way; the last frame may stand before
// its offset d. All choices are tried.
export function paperCentres(load) {
  const craig = craigCentres(load.arm, load.centres);
  const last = load.arm.rows.at(-1).d;
  const none = load.centres.map(() => [0, 0, 0]);
  let sums = [times(0, force(load))];
  craig.forEach(([x, y, z], i) => {
    const mass = load.masses[i];
    const ways = [
      [x, y, z],
      [x, -y, -z],
    ];
    if (i === craig.length - 1 && last) ways.push([x, y, z + last], [x, -y, -z - last]);
    const masses = load.masses.map((_, k) => (k === i ? mass : 0));
    const spread = ways.map((way) =>
      weight(load, { masses, centres: none.map((zero, k) => (k === i ? way : zero)) }),
    );
    sums = sums.flatMap((sum) => spread.map((one) => less(sum, times(-1, one))));
  });
  const key = cause("tau.craig centres");
  const push = force(load);
  const ways = [
    [key, 1],
    [both(key, cause("tau.force sign")), -1],
    [both(key, cause("tau.force missing")), 0],
  ];
  return {
    causes: ways.flatMap(([one]) => sums.map(() => one)),
    made: ways.flatMap(([, sign]) => sums.map((sum) => less(sum, times(sign, push)).flat())),
  };
}

function* loads(load) {
  yield [null, load];
  const { arm, q, wrenches, gravity } = load;
  const turns = turning(arm);
  for (const change of [(x) => x * RAD, (x) => x * DEG]) {
    const other = q.map((one) => one.map((x, k) => (turns[k] ? change(x) : x)));
    yield [cause("tau.degrees"), loadOf(arm, other, wrenches, gravity)];
  }
  if (arm.penless) yield [cause("table.pen"), loadOf(arm.penless, q, wrenches, gravity)];
  for (const { name, other, rows } of arm.alike ?? []) {
    yield [cause("table.length", { name, other }), loadOf({ ...arm, rows }, q, wrenches, gravity)];
  }
  yield* robots(load);
}

function* robots({ arm, q, wrenches, gravity }) {
  for (const { name, rows } of arm.robots ?? [])
    yield [cause("table.robot", { name }), loadOf({ ...arm, rows }, q, wrenches, gravity)];
}

function* weights(load) {
  const right = weight(load);
  yield [null, right];
  yield [cause("tau.weight missing"), times(0, right)];
  yield [cause("tau.weight sign"), times(-1, right)];
  const much = Math.hypot(...load.gravity);
  if (much) {
    for (const g of [9.8, 10, 9.80665, 1]) {
      if (Math.abs(g - much) <= 1e-9) continue;
      yield [
        cause("tau.gravity", { g: size(g, 6) }),
        right.map((row) => row.map((x) => (x * g) / much)),
      ];
    }
  }
  yield [
    cause("tau.craig centres"),
    weight(load, { centres: craigCentres(load.arm, load.centres) }),
  ];
  yield [
    cause("tau.centres at origins"),
    weight(load, { centres: load.centres.map(() => [0, 0, 0]) }),
  ];
  const total = load.masses.reduce((sum, mass) => sum + mass, 0);
  const pull = [...load.gravity.map((g) => total * g), 0, 0, 0];
  yield [
    cause("tau.tip weights"),
    times(
      -1,
      load.at.map(({ J }) => chains.through(J, pull)),
    ),
  ];
  yield* links(load, right);
}

// Links that are left out or taken for one another.
function* links(load, right) {
  const each = load.masses.map((mass, i) =>
    weight(load, { masses: load.masses.map((_, k) => (k === i ? mass : 0)) }),
  );
  for (const [i, one] of each.entries())
    if (load.masses[i]) yield [cause("tau.mass missing", { link: i + 1 }), less(right, one)];
  const own = right.map((_, p) => joints(load.arm).map((row, k) => each[row][p][k]));
  yield [cause("tau.own link"), less(right, own)];
  for (const [_way, step] of [
    ["early", 1],
    ["late", -1],
  ]) {
    const moved = (list, none) => list.map((_, k) => list[k + step] ?? none);
    const taken = { masses: moved(load.masses, 0), centres: moved(load.centres, [0, 0, 0]) };
    yield [cause("tau.links moved", { _way }), weight(load, taken)];
  }
  const other = (load.arm.robots ?? []).find(({ masses }) => masses);
  if (other) yield [cause("tau.robot", { name: other.name }), weight(load, other)];
}

// The one mass that would give these torques, where another does: of each link, by least squares.
export function otherMasses(load, mine, right) {
  const found = load.masses.map((mass, i) => {
    const masses = load.masses.map((_, k) => Number(k === i));
    const each = weight(load, { masses }).flat();
    const size = each.reduce((sum, x) => sum + x * x, 0);
    const more = each.reduce((sum, x, k) => sum + x * (mine[k] - right[k]), 0) / (size || 1);
    const fields = { link: i + 1, _mass: size3(mass + more), _wanted: size3(mass) };
    return {
      why: cause("tau.mass", fields),
      made: right.map((x, k) => x + more * each[k]),
      mass: mass + more,
      seen: each.filter((x) => Math.abs(x * more) > SEEN).length,
    };
  });
  // one torque alone fits any link's mass
  const likely = found.filter(({ mass, seen }) => mass > LIGHT && seen > 1);
  return { causes: likely.map(({ why }) => why), made: likely.map(({ made }) => made) };
}

const size3 = (x) => size(x, 3);

// Centres of mass given in Craig's frames, used as if they were in the table's: a turn by alpha and
// a step of a apart.
const craigCentres = (arm, centres) =>
  arm.rows.map(({ a, alpha }, i) => {
    const [x, y, z] = centres[i];
    const [c, s] = chains.cosSin(alpha);
    return [x + a, c * y - s * z, s * y + c * z];
  });

function* forces(load) {
  const right = force(load);
  yield [null, right];
  if (!load.wrenches.some((F) => F.some(Boolean))) return;
  yield [cause("tau.force sign"), times(-1, right)];
  yield [cause("tau.force missing"), times(0, right)];
  yield [cause("tau.force in tool"), force(load, (F, tip) => chains.wrenchFrom(tip, F))];
  yield [cause("tau.force turned back"), force(load, (F, tip) => chains.wrenchIn(tip, F))];
  if (load.wrenches.some((F) => F.slice(3).some(Boolean) && F.slice(0, 3).some(Boolean)))
    yield [cause("tau.moment missing"), force(load, (F) => [...F.slice(0, 3), 0, 0, 0])];
  yield [cause("tau.force and moment"), force(load, (F) => [...F.slice(3), ...F.slice(0, 3)])];
  const late = load.at.map(({ c, T }, i) => {
    const next = c.at.map((row) => row + 1);
    return chains.through(chains.columns(c, T, { axis: next, origin: next }), load.wrenches[i]);
  });
  yield [cause("J.one frame late"), late];
}
