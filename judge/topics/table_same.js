// What is said of a table that describes the same arm: its joints' zeros, its base, its tool.

import { RIGHT, WRONG } from "../digits.js";
import { DEG } from "../geometry/angles.js";
import { angleDistance, isBaseHeightGap } from "../geometry/axes.js";
import { listMapEquations, findJointMap } from "../geometry/joint_map.js";
import { linkFrames, minus, norm, rotationBetween } from "../geometry/kinematics.js";
import { ANGLE_TOLERANCE, snapAngle } from "../geometry/rows.js";
import { formatMessage, formatNumber } from "../sentences.js";
import { entryUnit, roundTo, entryText, typedRowNumber } from "./table_words.js";

const LENGTH = 1e-6; // m
export const TIP_TOLERANCE = 1e-4; // m: a tip no farther away stands there

/** @typedef {import("./table.js").Table} Table */
/** @typedef {import("../geometry/axes.js").AxisComparison} AxisComparison */
/** @typedef {import("../verdict.js").Verdict} Verdict */

/**
 * The report on a table of the same arm: right if at the homework's start the tip is there too.
 * @param {{ grade: string, elsewhere: ReturnType<typeof measureTipMiss> }} verdict
 * @param {[Table, any]} tables typed, and the reference
 * @param {ReturnType<typeof import("../geometry/axes.js").describeAxes>[]} sides
 * @param {AxisComparison} found
 * @param {number} loose how much lengths may differ, in m
 * @returns {Verdict}
 */
export function judgeSameArm({ grade, elsewhere }, [table, reference], [mine, ref], found, loose) {
  const mapped = findJointMap(mine, ref, found, loose);
  const told = zeros(table, mapped, mine, ref);
  const key = grade === RIGHT ? "table same" : "table rounded";
  return {
    topic: "table",
    arm: reference.name,
    grade: elsewhere ? WRONG : grade,
    headline: elsewhere
      ? formatMessage("table other zeros", elsewhere)
      : formatMessage(key, { mine: table.name, reference: reference.name }),
    findings: [],
    causes: [],
    taken: table.said,
    ...(mapped ? { map: { ...mapped, rows: mine.rows } } : {}),
    figures: { "same machine": true },
    advice: mapped && told.length ? [{ field: "ownJoints", value: true }] : [],
    notes: [
      ...told,
      ...noteBaseHeight(table, mine, found, mapped),
      ...tool(found),
      ...written(table),
    ],
  };
}

/**
 * How far the same q, the reference's home, takes the tip from where it should be; null where it is
 * no more than `far`, in m, and 1°.
 * @param {Table} table
 * @returns {{ mine: string, reference: string, home: string, away: string, turned: string } | null}
 */
export function measureTipMiss(table, rows, reference, far) {
  if (!reference.home) return null;
  const at = (arm) => linkFrames(arm, reference.home).at(-1);
  const [mine, ref] = [at({ ...reference, rows }), at(reference)];
  const away = norm(minus(mine.o, ref.o));
  const turn = rotationBetween(mine, ref) * DEG;
  if (away <= far && turn < 1) return null;
  const turned =
    turn < 1 ? "" : formatMessage("table tool turned", { degrees: formatNumber(turn, 3) });
  return {
    ...{ mine: table.name, reference: reference.name, turned },
    home: `(${reference.home.map((x) => formatNumber(x, 4)).join(", ")})`,
    away: formatNumber(away < TIP_TOLERANCE ? 0 : away, 3),
  };
}

function zeros(table, mapped, mine, ref) {
  if (!mapped) return [formatMessage("map unknown")];
  const own = mine.joints.map((i) => typedRowNumber(table, i, "d"));
  const told = listMapEquations(mapped, own, ref);
  return told.length ? [formatMessage("map", { equations: told.join("; ") })] : [];
}

// A word on where the base's frame stands on axis 1, or where that leans from z_0, along it.
export function noteBaseHeight(table, mine, found, mapped = null) {
  if (found.upsideDown) return [formatMessage("base upside down")];
  const [along, lean] = [found.baseHigher, mine.foot[1]];
  const higher = mapped && lean <= ANGLE_TOLERANCE ? mapped.base.o[2] : along;
  if (Math.abs(higher) <= LENGTH) return [];
  const row = typedRowNumber(
    table,
    mine.joints[mine.gaps.find(isBaseHeightGap)?.bunch.at(-1) ?? 0],
    "d",
  );
  const way = higher > 0 ? formatMessage("higher") : formatMessage("lower");
  return [
    formatMessage("base", {
      height: formatNumber(roundTo(1000 * Math.abs(higher), 6), 4),
      way,
      row,
    }),
  ];
}

function tool({ tilts }) {
  const [mine, reference] = tilts.map((tilt) => formatNumber(roundTo(tilt * DEG, 4), 4));
  return angleDistance(...tilts) > ANGLE_TOLERANCE
    ? [formatMessage("tool", { mine, reference })]
    : [];
}

const NAMES = { "-2": "-pi", "-1": "-pi/2", 0: "0", 1: "pi/2", 2: "pi" };

// A word on each angle that was taken as a multiple of a right angle though it is not quite one.
const written = (table) =>
  table.rows.flatMap((row, k) =>
    ["alpha", "theta"].flatMap((column) => {
      const right = snapAngle(row[column], entryUnit(table, k + 1, column));
      if (Math.abs(row[column] - right) <= 1e-9) return [];
      const turns = Math.round(right / (Math.PI / 2));
      const wanted = NAMES[turns] ?? `${turns} pi/2`;
      const fields = {
        column,
        row: typedRowNumber(table, k + 1, column),
        typed: entryText(table, k + 1, column),
        wanted,
      };
      return [formatMessage("write right angle", fields)];
    }),
  );
