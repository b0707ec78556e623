// Judges a table whose rows describe the first joints of an arm and lack the last joints.

import { SO_FAR } from "../digits.js";
import { compareAxes, describeAxes } from "../geometry/axes.js";
import { formatMessage, joinList } from "../sentences.js";
import { makeVerdict } from "../verdict.js";

/** @typedef {import("./table_same.js").Sides} Sides */
/** @typedef {import("../geometry/axes.js").Difference} Difference */
/** @typedef {import("../verdict.js").Verdict} Verdict */

// The joint after the last typed row: its axis is the z axis of the last frame.
const NEXT_JOINT = {
  kind: /** @type {const} */ ("revolute"),
  a: 0,
  alpha: 0,
  d: 0,
  theta: 0,
};

/**
 * Judge a table with fewer joints than the reference.
 * @param {Sides} sides
 * @param {number} length how much lengths may differ (m)
 * @param {number} angle how much angles may differ (rad)
 * @returns {Verdict | null} null if its rows are not the first ones, up to a joint map
 */
export function judgeFirstRows({ table, reference, rows, wanted, mine, ref }, length, angle) {
  const count = mine.joints.length;
  if (count >= ref.joints.length) return null;
  const own = describeAxes([...rows, NEXT_JOINT]);
  // Fixed rows after the last typed joint may be typed or still missing.
  const ends = wanted.map((_, end) => end);
  const isFirst = ends
    .filter((end) => end >= ref.joints[count - 1] && end < ref.joints[count])
    .some((end) => {
      const first = describeAxes([...wanted.slice(0, end), NEXT_JOINT]);
      const { differences, upsideDown, baseHigher } = compareAxes(own, first, length, angle);
      const isElsewhere = upsideDown || Math.abs(baseHigher) > length;
      return !isElsewhere && differences.every((x) => isBeyond(x, rows.length));
    });
  if (!isFirst) return null;
  const missing = ref.joints.slice(count).map((joint) => formatMessage("joint", { joint }));
  const joints = joinList(missing);
  const fields = { mine: table.name, reference: reference.name, joints };
  const words = formatMessage("table rows missing", fields);
  return makeVerdict("table", reference, SO_FAR, formatMessage("table first rows", fields), {
    findings: [{ what: "missing", where: joints, words }],
    taken: table.assumptions,
    figures: { right: count, of: ref.joints.length },
  });
}

// Return whether a difference is the position of the last frame along the next axis, which is free.
const isBeyond = (/** @type {Difference} */ { key, row, ends }, count) =>
  (key === "table along" && row > count) || (key === "table distance" && !ends[1]);
