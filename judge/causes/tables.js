// Slips in an arm's table or in its joint values, whatever is computed from them: functions of a
// chain, which is rows and q. Sources: homework.md slip numbers, or work that was handed in.

import { DEG, RAD } from "../geometry/angles.js";
import { movingRows, jointNumbers, revoluteFlags } from "../geometry/kinematics.js";
import { makeCause } from "./ranking.js";

/** @typedef {import("../geometry/chains.js").Chain} Chain */
/** @typedef {[import("./ranking.js").Cause, (c: Chain) => Chain]} Change */

// The usual mistakes in a table's numbers.
/** @returns {Change[]} */
export const tableMistakes = (arm) => [...ofArm(arm), ...arm.rows.flatMap(ofRow)];

/** @returns {Generator<Change>} */
function* ofArm({ penless, alike = [], robots = [], rows }) {
  const put = (change) => (c) => ({
    ...c,
    rows: c.rows.map((row, i) => ({ ...row, ...change(row, i) })),
  });
  if (penless) {
    // handed in: without the pen, and the pen the wrong way
    yield [makeCause("table.pen"), put((_, i) => ({ d: penless.rows[i].d }))];
    yield [makeCause("table.pen sign"), put((row, i) => ({ d: 2 * penless.rows[i].d - row.d }))];
  }
  for (const { name, other, rows: its } of alike)
    // slip 2
    yield [makeCause("table.length", { name, other }), put((_, i) => ({ a: its[i].a }))];
  for (const { name, rows: its } of robots)
    // slip 9
    yield [makeCause("table.robot", { name }), put((_, i) => ({ a: its[i].a, d: its[i].d }))];
  const offset = (row) => row.kind === "revolute" && row.theta;
  if (rows.filter(offset).length > 1)
    yield [makeCause("table.offsets"), put((row) => (offset(row) ? { theta: 0 } : {}))];
  const links = rows.flatMap((row, i) => (row.a ? [i] : []));
  for (const [n, i] of links.entries()) {
    const j = links[n + 1];
    if (j === undefined || Math.abs(rows[i].a) === Math.abs(rows[j].a)) continue;
    const other = { [i]: rows[j].a, [j]: rows[i].a };
    const fields = { i: i + 1, j: j + 1 };
    const change = put((row, k) =>
      k in other ? { a: Math.sign(row.a) * Math.abs(other[k]) } : {},
    );
    yield [makeCause("table.a exchanged", fields), change]; // handed in: a_2 and a_3
  }
  const before = put((_, i) => ({ a: rows[i - 1]?.a ?? 0, alpha: rows[i - 1]?.alpha ?? 0 }));
  yield [makeCause("table.craig rows"), before]; // handed in: Craig's rows in the standard matrix
  const moving = rows.filter(({ kind }) => kind !== "fixed");
  if (moving.length < rows.length)
    yield [
      makeCause("table.locked row"),
      (c) => ({ ...c, rows: moving, at: movingRows({ rows: moving }) }),
    ]; // slip 3
}

/** @returns {Change[]} */
function ofRow(row, k) {
  const at = { row: k + 1 };
  const put = (key, fields, entries) => [
    makeCause(key, fields),
    (c) => ({ ...c, rows: c.rows.map((one, i) => (i === k ? { ...one, ...entries } : one)) }),
  ];
  const found = [];
  if (Math.abs(Math.sin(row.alpha)) > 1e-9)
    found.push(put("table.twist", at, { alpha: -row.alpha }));
  if (row.alpha) found.push(put("table.no twist", at, { alpha: 0 }));
  for (const column of ["a", "d"]) {
    if (!row[column]) continue;
    found.push(put("table.sign", { column, ...at }, { [column]: -row[column] }));
    found.push(put("table.missing", { column, ...at }, { [column]: 0 }));
  }
  if (row.theta && row.kind === "revolute") {
    found.push(put("table.offset", at, { theta: 0 }));
    found.push(put("table.offset sign", at, { theta: -row.theta }));
  }
  return found;
}

const MAKERS = [2, 4, 7]; // joints that the Panda's maker counts the other way

// The signs of an arm's joints as the Panda's maker has them; none where there are not seven rows.
export const makerJointSigns = (arm) =>
  arm.rows.length === 7 ? jointNumbers(arm).map((i) => (MAKERS.includes(i) ? -1 : 1)) : null;

// Other joint values: in degrees, or in radians where degrees were meant; one joint the other way,
// or those of the Panda's maker.
/** @returns {Change[]} */
export function poseMistakes(key, arm) {
  const turns = revoluteFlags(arm);
  const joint = jointNumbers(arm);
  /** @returns {Change} */
  const put = (one, change) => [one, (c) => ({ ...c, q: c.q.map(change) })];
  const found = [RAD, DEG].map((factor) =>
    put(makeCause(key), (x, k) => (turns[k] ? x * factor : x)),
  );
  const signs = makerJointSigns(arm);
  if (signs) found.push(put(makeCause("ik.makers signs"), (x, k) => signs[k] * x));
  for (const k of joint.keys())
    found.push(put(makeCause("ik.sign", { joint: `q_${joint[k]}` }), (x, i) => (i === k ? -x : x)));
  return found; // all handed in
}
