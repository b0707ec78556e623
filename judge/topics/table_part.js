// Judges a table whose rows describe the first joints of an arm and lack the last joints.

import { SO_FAR } from "../digits.js";
import { compareAxes, describeAxes } from "../geometry/axes.js";
import { formatMessage, joinList } from "../sentences.js";
import { makeVerdict } from "../verdict.js";
import { describeBeginning } from "./beginning.js";

/** @typedef {import("./table_same.js").TablePair} TablePair */
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
 * @param {TablePair} pair
 * @param {number} length how much lengths may differ (m)
 * @param {number} angle how much angles may differ (rad)
 * @returns {Verdict | null} null if its rows are not the first ones, up to a joint map
 */
export function judgeFirstRows(pair, length, angle) {
  const { table, reference, rows, expectedRows, axes, expectedAxes } = pair;
  const [count, all] = [axes.joints.length, expectedAxes.joints.length];
  if (count >= all) return null;
  const axesWithNext = describeAxes([...rows, NEXT_JOINT]);
  // Fixed rows after the last typed joint may be typed or still missing.
  const isFirst = expectedRows.some((_, end) => {
    const first = describeAxes([...expectedRows.slice(0, end), NEXT_JOINT]);
    const { differences, upsideDown, baseHigher } = compareAxes(axesWithNext, first, length, angle);
    const isElsewhere = upsideDown || Math.abs(baseHigher) > length;
    return (
      !isElsewhere && differences.every((difference) => isAlongNextAxis(difference, rows.length))
    );
  });
  if (!isFirst) return null;
  const missing = expectedAxes.joints
    .slice(count)
    .map((joint) => formatMessage("joint", { joint }));
  const joints = joinList(missing);
  const fields = { mine: table.name, reference: reference.name };
  const headline = formatMessage("table first rows", fields);
  const figures = { right: count, of: all };
  const begun = describeBeginning(headline, joints, { taken: table.assumptions, figures });
  return makeVerdict("table", reference, SO_FAR, headline, begun);
}

// Return whether a difference is the position of the last frame along the next axis, which is free.
const isAlongNextAxis = (/** @type {Difference} */ { key, row, ends }, count) =>
  (key === "table along" && row > count) || (key === "table distance" && !ends[1]);
