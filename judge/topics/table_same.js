// What is said of a table that describes the same arm: its joints' zeros, its base, its tool.

import { RIGHT, WRONG } from "../digits.js";
import { DEG } from "../geometry/angles.js";
import { angleBetween, placesBase } from "../geometry/axes.js";
import { equations, jointMap } from "../geometry/joint_map.js";
import { linkFrames, minus, norm, turnBetween } from "../geometry/kinematics.js";
import { ANGLE, square } from "../geometry/rows.js";
import { say, size } from "../sentences.js";
import { ownUnit, rounded, typedAs, typedRow } from "./table_words.js";

const LENGTH = 1e-6; // m
export const SEEN = 1e-4; // m: a tip no farther away stands there

/** @typedef {import("./table.js").Table} Table */
/** @typedef {import("../geometry/axes.js").Compared} Compared */
/** @typedef {import("../report.js").Report} Report */

/**
 * The report on a table of the same arm: right if at the homework's start the tip is there too.
 * @param {{ grade: string, elsewhere: ReturnType<typeof tipElsewhere> }} verdict
 * @param {[Table, any]} tables typed, and the reference
 * @param {ReturnType<typeof import("../geometry/axes.js").side>[]} sides
 * @param {Compared} found
 * @param {number} loose how much lengths may differ, in m
 * @returns {Report}
 */
export function same({ grade, elsewhere }, [table, reference], [mine, ref], found, loose) {
  const mapped = jointMap(mine, ref, found, loose);
  const told = zeros(table, mapped, mine, ref);
  const key = grade === RIGHT ? "table same" : "table rounded";
  return {
    topic: "table",
    arm: reference.name,
    grade: elsewhere ? WRONG : grade,
    headline: elsewhere
      ? say("table other zeros", elsewhere)
      : say(key, { mine: table.name, reference: reference.name }),
    findings: [],
    causes: [],
    taken: table.said,
    ...(mapped ? { map: { ...mapped, rows: mine.rows } } : {}),
    figures: { "same machine": true },
    advice: mapped && told.length ? [{ field: "ownJoints", value: true }] : [],
    notes: [...told, ...base(table, mine, found, mapped), ...tool(found), ...written(table)],
  };
}

/**
 * How far the same q, the reference's home, takes the tip from where it should be; null where it is
 * no more than `far`, in m, and 1°.
 * @param {Table} table
 * @returns {{ mine: string, reference: string, home: string, away: string, turned: string } | null}
 */
export function tipElsewhere(table, rows, reference, far) {
  if (!reference.home) return null;
  const at = (arm) => linkFrames(arm, reference.home).at(-1);
  const [mine, ref] = [at({ ...reference, rows }), at(reference)];
  const away = norm(minus(mine.o, ref.o));
  const turn = turnBetween(mine, ref) * DEG;
  if (away <= far && turn < 1) return null;
  const turned = turn < 1 ? "" : say("table tool turned", { degrees: size(turn, 3) });
  return {
    ...{ mine: table.name, reference: reference.name, turned },
    home: `(${reference.home.map((x) => size(x, 4)).join(", ")})`,
    away: size(away < SEEN ? 0 : away, 3),
  };
}

function zeros(table, mapped, mine, ref) {
  if (!mapped) return [say("map unknown")];
  const own = mine.joints.map((i) => typedRow(table, i, "d"));
  const told = equations(mapped, own, ref);
  return told.length ? [say("map", { equations: told.join("; ") })] : [];
}

// A word on where the base's frame stands on axis 1, or where that leans from z_0, along it.
export function base(table, mine, found, mapped = null) {
  if (found.upsideDown) return [say("base upside down")];
  const [along, lean] = [found.baseHigher, mine.foot[1]];
  const higher = mapped && lean <= ANGLE ? mapped.base.o[2] : along;
  if (Math.abs(higher) <= LENGTH) return [];
  const row = typedRow(table, mine.joints[mine.gaps.find(placesBase)?.bunch.at(-1) ?? 0], "d");
  const way = higher > 0 ? say("higher") : say("lower");
  return [say("base", { height: size(rounded(1000 * Math.abs(higher), 6), 4), way, row })];
}

function tool({ tilts }) {
  const [mine, reference] = tilts.map((tilt) => size(rounded(tilt * DEG, 4), 4));
  return angleBetween(...tilts) > ANGLE ? [say("tool", { mine, reference })] : [];
}

const NAMES = { "-2": "-pi", "-1": "-pi/2", 0: "0", 1: "pi/2", 2: "pi" };

// A word on each angle that was taken as a multiple of a right angle though it is not quite one.
const written = (table) =>
  table.rows.flatMap((row, k) =>
    ["alpha", "theta"].flatMap((column) => {
      const right = square(row[column], ownUnit(table, k + 1, column));
      if (Math.abs(row[column] - right) <= 1e-9) return [];
      const turns = Math.round(right / (Math.PI / 2));
      const wanted = NAMES[turns] ?? `${turns} pi/2`;
      const fields = {
        column,
        row: typedRow(table, k + 1, column),
        typed: typedAs(table, k + 1, column),
        wanted,
      };
      return [say("write right angle", fields)];
    }),
  );
