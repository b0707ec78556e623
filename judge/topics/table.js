// Is my table wrong, or only different?

import { makeCause, causeName, hedgeMessage, joinCauseMessages } from "../causes/ranking.js";
import { findFewestMistakes } from "../causes/table.js";
import { RIGHT, ROUNDED, units, WRONG } from "../digits.js";
import { DEG } from "../geometry/angles.js";
import { compareAxes, describeAxes } from "../geometry/axes.js";
import {
  ANGLE_TOLERANCE,
  isAngleColumn,
  snapAngle,
  snapRows,
  jointColumn,
} from "../geometry/rows.js";
import { meant, read } from "../reading/table.js";
import { NoLink } from "../reading/table_matrices.js";
import { withoutOtherColumns } from "../reading/table_other_columns.js";
import { ENTRIES } from "../reading/table_rows.js";
import { formatMessage, formatNumber, uncapitalize } from "../sentences.js";
import { completeVerdicts, makeVerdict } from "../verdict.js";
import { judgeFirstRows } from "./table_part.js";
import { judgeSameArm } from "./table_same.js";
import { DECIMAL, describeEntry, describeDifference, entryUnit } from "./table_words.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */

const LENGTH = 1e-6; // m
const COARSEST = 1e-3; // m: lengths typed to the millimetre are still lengths
const WHOLES = /^(?:[-+−()$\s0-9]|(?<=[0-9])\.(?![0-9]))*$/; // and their sums

/** @typedef {import("../geometry/arm.js").TableRow} TableRow */
/** @typedef {import("../causes/ranking.js").Cause} Cause */
/** @typedef {import("../verdict.js").Finding} Finding */
/** @typedef {import("../verdict.js").Verdict} Verdict */

/**
 * How the table is to be read; what is empty or not said is guessed.
 * @typedef {object} Options
 * @property {string} [columns] their order, as "theta d a alpha"
 * @property {string} [lengths] "m", "cm" or "mm"
 * @property {string} [angles] "rad" or "deg"
 * @property {string} [convention] "standard" or "craig"
 * @property {number} [tolerance] the largest deviation of a length (m)
 * @property {number[]} [startPose] joint values whose pose the question fixes (rad or m)
 * @property {[string, number][]} [values] of symbols that the arm does not have
 */

/**
 * A student's table in numbers, in SI units where they were said, with the units of the last
 * places. In the modified convention a and alpha stand one row further down than in `rows`; `added`
 * is 1 where a fixed row before the typed ones holds the first of them.
 * @typedef {object} Table
 * @property {string} name
 * @property {TableRow[]} rows
 * @property {Record<string, string>[]} texts
 * @property {number} lengthUnit
 * @property {number} angleUnit
 * @property {number} lengthScale
 * @property {number} angleScale
 * @property {string[]} said
 * @property {boolean} modified
 * @property {number} added
 * @property {boolean} exchanged whether the heads of alpha and theta are
 */

/**
 * Compare a typed table with the reference: where they differ, and why.
 * @param {string | Arm} mine text, or an arm that Python holds
 * @param {Arm} reference
 * @param {Options} options
 * @returns {Verdict}
 */
export const compareTables = completeVerdicts(tablesCompared);

function tablesCompared(mine, reference, options = {}) {
  const kinds = reference.rows.map(({ kind }) => kind);
  const known = new Map([...(reference.values ?? []), ...(options.values ?? [])]);
  const isText = typeof mine === "string";
  const typed = isText ? readOrNot(mine, options, [...known]) : [];
  if (typed instanceof NoLink) return noLink(typed, reference);
  const held = typed.map((one) => withLocked(one, kinds));
  const tables = isText ? held.map((one) => tableOf(one, meant(one, kinds))) : [ofArm(mine)];
  const readings = tables.map((table) => judgedTable(table, reference, options));
  const whole = (report, k) => {
    if (!isText)
      return { ...report, table: { rows: tables[k].rows, cells: [], trees: [], wrong: [] } };
    const cells = shown(typed[k], tables[k], report.findings);
    return {
      ...report,
      left: typed[k].left,
      tokens: typed[k].tokens,
      table: { rows: tables[k].rows, typed: typed[k].rows, ...cells },
    };
  };
  const good = readings.map((one) => one.good());
  const isGood = [
    (verdict) => verdict?.grade === RIGHT,
    (verdict) => verdict && verdict.grade !== WRONG,
    Boolean,
  ];
  const same = isGood.map((test) => good.findIndex(test)).find((k) => k >= 0);
  const astray = isText && same !== undefined ? outOfTurn(typed[same].rows) : null;
  if (astray) return whole(bad(tables[same], reference, [astray]), same);
  if (same !== undefined) return whole(good[same], same);
  const parts = readings.map((one) => one.part());
  const part = parts.findIndex(Boolean);
  if (part >= 0) return whole(parts[part], part);
  const wrong = readings.slice(0, MOST_READINGS).map((one) => one.bad());
  const slips = wrong.map(slipsIn);
  const fewest = slips.indexOf(Math.min(...slips));
  return whole(wrong[fewest], fewest);
}

// The tables that a text may be, or why its matrices are none.
function readOrNot(text, options, known) {
  try {
    return read(text, options, known);
  } catch (error) {
    if (error instanceof NoLink) return error;
    const { text: fewerColumns, others } = withoutOtherColumns(text);
    if (!others.length) throw error;
    // The numbers' positions are those in the shorter text, so that none can be marked.
    return read(fewerColumns, options, known).map((table) => ({
      ...table,
      left: [...table.left, ...others],
      tokens: undefined,
    }));
  }
}

// The rows of links or of lists without theta, of which none can be said to be locked, with those
// fixed that should be.
function withLocked(table, kinds) {
  const { rows, said } = table;
  const isUnlocked = ["taken: links", "taken: no theta"].some((key) =>
    said.includes(formatMessage(key)),
  );
  if (!isUnlocked || rows.length !== kinds.length) return table;
  return { ...table, rows: rows.map((row, k) => (kinds[k] === "fixed" ? fixed(row) : row)) };
}

const fixed = (row) => ({ ...row, kind: "fixed", joint: null });

/** @returns {Verdict} */
function noLink({ message, causes, tokens }, { name }) {
  const findings = [{ what: "cause", where: "", words: `${message}.` }];
  const fields = {
    mine: formatMessage("your table"),
    reference: name,
    cause: uncapitalize(message),
  };
  return makeVerdict("table", { name }, WRONG, formatMessage("table wrong", fields), {
    findings,
    causes,
    tokens,
  });
}

// The first row that is named after an earlier joint than the row before it.
function outOfTurn(rows) {
  const named = rows.flatMap(({ joint }, k) => (joint ? [{ ...joint, row: k + 1 }] : []));
  const astray = named.find(
    ({ number }, k) => k + 1 < named.length && number >= named[k + 1].number,
  );
  return astray ? makeCause("table.names", { row: astray.row, name: astray.name }) : null;
}

const MOST_READINGS = 4; // orders of columns that are tried, where none was said

// How many slips a report needs: those that it names, and what it can only list.
function slipsIn({ causes, findings }) {
  const named = causes.length ? causes[0].split(" + ").length : 0;
  return named + findings.filter(({ what }) => what !== "cause" && !what.includes(".")).length;
}

// The table as it was read, a row of cells for each that was typed, and which of them are wrong.
function shown(typed, { lengthScale, angleScale }, findings) {
  const wheres = findings.map(({ where }) => where);
  const trees = typed.rows.map((row) => ENTRIES.map((column) => row.trees?.[column]));
  const cells = typed.rows.map(({ kind, numbers, radians, backwards }, k) =>
    ENTRIES.map((column) => {
      const scale = DEG * (radians.has(column) ? 1 : angleScale);
      const text = isAngleColumn(column)
        ? `${formatNumber(numbers[column] * scale, 6)}°`
        : formatNumber(numbers[column] * lengthScale, 6);
      if (column !== jointColumn(kind)) return text;
      const variable = `${backwards ? "-" : ""}q_${k + 1}`;
      return numbers[column]
        ? `${variable} ${text.replace(/^-?/, (sign) => (sign ? "- " : "+ "))}`
        : variable;
    }),
  );
  const wrong = cells.map((_, k) =>
    ENTRIES.map((column) => wheres.includes(`row ${k + 1}, ${column}`)),
  );
  return { cells, trees, wrong };
}

// What was typed

/** @returns {Table} */
export function tableOf(typed, found) {
  const texts = typed.rows.map((row) => row.texts);
  const modified = typed.convention === "craig";
  const { a, alpha } = typed.rows[0].numbers;
  return {
    name: formatMessage("your table"),
    rows: found.rows,
    texts,
    lengthUnit: wholeUnit(typed, found.length) || unitOf(texts, ["a", "d"]) * found.length,
    angleUnit: unitOf(texts, ["alpha", "theta"]) * found.angle,
    lengthScale: found.length,
    angleScale: found.angle,
    said: found.said,
    modified,
    exchanged: Boolean(typed.exchanged),
    added: Number(modified && Boolean(a || alpha)),
  };
}

/**
 * An arm that Python holds, as a table in m and rad.
 * @param {{ name: string, rows: TableRow[], texts: Record<string, string>[] }} arm
 * @returns {Table}
 */
const ofArm = ({ name, rows, texts }) => ({
  name,
  rows,
  texts,
  lengthUnit: unitOf(texts, ["a", "d"]),
  angleUnit: unitOf(texts, ["alpha", "theta"]),
  lengthScale: 1,
  angleScale: 1,
  said: [],
  modified: false,
  exchanged: false,
  added: 0,
});

// The finest last place of the decimals in some columns; 0 where there are none.
function unitOf(texts, columns) {
  const found = texts.flatMap((row) =>
    columns.flatMap((column) => row[column].match(DECIMAL) ?? []),
  );
  const shown = units(found).filter(Boolean);
  return shown.length ? Math.min(...shown) : 0;
}

// The unit of lengths that are all whole numbers of a small size; 0 for others. Whole numbers among
// formulas are exact.
function wholeUnit(typed, scale) {
  const lengths = typed.rows.flatMap(({ kind, texts }) =>
    kind === "prismatic" ? [texts.a] : [texts.a, texts.d],
  );
  return scale <= COARSEST && lengths.every((text) => WHOLES.test(text)) ? scale : 0;
}

// The rows with angles that were cut to two decimals or more taken as the right angles that they
// are near: 1.57 is meant as pi/2.
export const meantRows = (table) =>
  table.rows.map((row, k) => {
    const [alpha, theta] = ["alpha", "theta"].map((c) =>
      snapAngle(row[c], entryUnit(table, k + 1, c)),
    );
    return { ...row, alpha, theta };
  });

// The verdict

/**
 * One reading of a table beside the reference: the verdicts on the same arm and on its first
 * joints, null where it is neither, and that on another arm.
 * @param {Table} table
 * @returns {{ good: () => Verdict | null, part: () => Verdict | null, bad: () => Verdict }}
 */
function judgedTable(table, reference, { tolerance = null, startPose = null }) {
  const wanted = snapRows(reference.rows);
  const rows = meantRows(table);
  const [mine, ref] = [describeAxes(rows), describeAxes(wanted)];
  const exact = tolerance === null ? LENGTH : Math.max(tolerance, 1e-12);
  const [length, angle] = [table.lengthUnit, table.angleUnit].map((unit) =>
    tolerance === null && unit <= COARSEST ? 0.51 * unit : 0,
  );
  // a turned axis meets the next one elsewhere
  const wide = tolerance === null ? Math.max(exact, 2 * length, 2.5 * angle * reach(rows)) : exact;
  const sides = { table, reference, rows, wanted, mine, ref };
  const judgeSame = (comparison, grade) => {
    if (table.exchanged) return bad(table, reference, [makeCause("table.alpha and theta")]);
    const last = Math.min(table.lengthUnit || table.angleUnit * reach(rows), COARSEST);
    const mapped = grade === RIGHT ? LENGTH : 10 * last;
    return judgeSameArm(sides, comparison, grade, { length: wide, mapped, startPose });
  };
  const comparison = compareAxes(mine, ref, exact);
  const good = () => {
    const higher = Math.abs(comparison.baseHigher);
    const isRounded = higher > exact && higher <= wide;
    if (!comparison.differences.length) return judgeSame(comparison, isRounded ? ROUNDED : RIGHT);
    if (tolerance !== null) return null;
    const near = compareAxes(mine, ref, wide, Math.max(ANGLE_TOLERANCE, 4 * angle));
    return near.differences.length ? null : judgeSame(near, ROUNDED);
  };
  const part = () => judgeFirstRows(sides, wide, Math.max(ANGLE_TOLERANCE, 4 * angle));
  return {
    good,
    part,
    bad: () => different(table, reference, rows, wanted, Math.max(exact, length)),
  };
}

const reach = (rows) => Math.max(...rows.flatMap(({ a, d }) => [Math.abs(a), Math.abs(d)]));

// What differs, and why

// Why a table is another arm: by the fewest slips.
/** @param {Table} table @returns {Verdict} */
function different(table, reference, rows, wanted, length) {
  const found = findFewestMistakes(rows, reference, wanted, table.modified, length);
  const causes = found.flatMap((t) => t.cause ?? []);
  const [t] = found;
  const { a, alpha } = table.rows[0];
  const isCraig = causes.some(({ keys }) => keys.includes("table.craig"));
  const own = isCraig ? { ...table, modified: true, added: Number(Boolean(a || alpha)) } : table;
  const findings = t.left.map((at) =>
    Array.isArray(at) ? describeEntry(own, t, at, length) : describeDifference(own, at),
  );
  return bad(table, reference, causes, findings);
}

// `causes` explain the same; of the findings those with a cause of their own add to it.
/** @param {Table} table @param {Cause[]} causes @param {Finding[]} findings @returns {Verdict} */
function bad(table, reference, causes, findings = []) {
  const own = findings.map(({ what }) => what).filter((what) => what.includes("."));
  const added = own.length === findings.length ? own : [];
  const names = causes.length
    ? causes.map((why) => [causeName(why), ...added].join(" + "))
    : added.length
      ? [added.join(" + ")]
      : [];
  const fields = { mine: table.name, reference: reference.name };
  const report = {
    topic: "table",
    arm: reference.name,
    grade: WRONG,
    headline: formatMessage("table other arm", fields),
    findings,
    causes: names,
    taken: table.said,
    notes: [],
  };
  if (causes.length) {
    const words = hedgeMessage(joinCauseMessages(causes), findings);
    const rest = findings.length ? formatMessage("and what remains") : "";
    const headline = formatMessage("table wrong", { cause: uncapitalize(words) + rest, ...fields });
    return {
      ...report,
      headline,
      findings: [{ what: "cause", where: "", words: `${words}.` }, ...findings],
    };
  }
  if (findings.length !== 1 || own.length !== 1) return report;
  const [only] = findings;
  const headline = formatMessage("table wrong", { cause: inside(only.words), ...fields });
  return { ...report, headline, findings: [{ ...only, what: "cause" }] };
}

// A sentence inside another.
const inside = (words) => uncapitalize(words).replace(/\.+$/, "");
