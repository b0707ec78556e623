// Judges a Denavit-Hartenberg table. It may be right, right with joints that count otherwise, right
// so far, or wrong with the mistake that explains it.

import { makeCause, causeName, hedgeMessage, joinCauseMessages } from "../causes/ranking.js";
import { findFewestMistakes } from "../causes/table.js";
import { RIGHT, ROUNDED, WRONG } from "../digits.js";
import { DEG } from "../geometry/angles.js";
import { compareAxes, describeAxes } from "../geometry/axes.js";
import { isAngleColumn, snapAngle, snapRows, jointColumn } from "../geometry/rows.js";
import { readTables } from "../reading/table.js";
import { convertTable, lengthInMetres } from "../reading/table_conversion.js";
import { NoLink } from "../reading/table_matrices.js";
import { addOtherNumbers, dropOtherColumns } from "../reading/table_other_columns.js";
import { ENTRIES } from "../reading/table_rows.js";
import { dropUnfilledEnd } from "../reading/unfilled.js";
import { formatMessage, formatNumber, tryOrNull, uncapitalize } from "../sentences.js";
import { completeVerdicts, makeVerdict } from "../verdict.js";
import { judgeFirstRows } from "./table_part.js";
import { judgeSameArm } from "./table_same.js";
import { describeEntry, describeDifference, entryUnit } from "./table_messages.js";
import {
  computeTolerances,
  EXACT_LENGTH,
  findFinestUnit,
  findWholeUnit,
} from "./table_tolerances.js";

/** @typedef {import("../geometry/arm.js").Arm} Arm */

const MOST_ORDERS = 4; // orders of columns that are searched for mistakes if the order is a guess

/** @typedef {import("../geometry/arm.js").TableRow} TableRow */
/** @typedef {import("../causes/ranking.js").Cause} Cause */
/** @typedef {import("../verdict.js").Finding} Finding */
/** @typedef {import("../verdict.js").Verdict} Verdict */

/**
 * The student's settings for reading the table. An empty or missing option is guessed.
 * @typedef {object} Options
 * @property {string} [columns] the order of the columns, such as "theta d a alpha"
 * @property {string} [lengths] "m", "cm" or "mm"
 * @property {string} [angles] "rad" or "deg"
 * @property {string} [convention] "standard" or "craig"
 * @property {number} [tolerance] the largest deviation of a length (m)
 * @property {number[]} [startConfiguration] joint values whose pose the question fixes (rad or m)
 * @property {[string, number][]} [values] of symbols that the arm does not have
 */

/**
 * A student's table in m and rad.
 * @typedef {object} Table
 * @property {string} name
 * @property {TableRow[]} rows
 * @property {Record<string, string>[]} texts its entries as they were typed
 * @property {number} lengthUnit the unit of the last typed place of the lengths (m); 0 if exact
 * @property {number} angleUnit the unit of the last typed place of the angles (rad)
 * @property {number} lengthScale the unit in which lengths are typed (m)
 * @property {number} angleScale the unit in which angles are typed (rad)
 * @property {string[]} assumptions the guesses, as phrases
 * @property {boolean} modified whether it is in Craig's convention, where a and alpha stand one row
 *   further down than in `rows`
 * @property {number} added 1 if `rows` begins with a fixed row for Craig's first a and alpha
 * @property {boolean} isExchanged whether the headers of alpha and theta are exchanged
 */
/**
 * A reading of a table, with the functions that compare it with the reference.
 * @typedef {object} Reading
 * @property {() => Verdict | null} judgeSame null if the table describes a different arm
 * @property {() => Verdict | null} judgeFirst null if it is not the arm's first joints
 * @property {() => Verdict} reportDifferences
 */

/**
 * Judge a table by comparing it with the reference.
 * @param {string | Arm} answer a text, or an arm from Python
 * @param {Arm} reference
 * @param {Options} options
 * @returns {Verdict}
 */
export const compareTables = completeVerdicts((answer, reference, options = {}) =>
  typeof answer === "string"
    ? judgeText(answer, reference, options)
    : judgeArm(answer, reference, options),
);

/** Judge an arm from Python. @param {Arm} arm @returns {Verdict} */
function judgeArm(arm, reference, options) {
  const table = makeTableOfArm(/** @type {any} */ (arm));
  const { verdict } = chooseVerdict([makeReading(table, reference, options)]);
  return { ...verdict, table: { rows: table.rows, cells: [], trees: [], wrong: [] } };
}

/** Judge a text. @param {string} text @returns {Verdict} */
function judgeText(text, reference, options) {
  const kinds = reference.rows.map(({ kind }) => kind);
  const known = new Map([...(reference.values ?? []), ...(options.values ?? [])]);
  const typedTables = readTextOrNoLink(text, options, [...known]);
  if (typedTables instanceof NoLink) return reportNoLink(typedTables, reference);
  const tables = typedTables.map((typed) => {
    const fixed = fixLockedRows(typed, kinds);
    return makeTable(fixed, convertTable(fixed, kinds));
  });
  const readings = tables.map((table) => makeReading(table, reference, options));
  const { verdict, index, isSame } = chooseVerdict(readings);
  const [typed, table] = [typedTables[index], tables[index]];
  const misnamed = isSame ? findMisnamedRow(typed.rows) : null;
  const judged = misnamed ? reportWrong(table, reference, [misnamed]) : verdict;
  const { tokens, rows } = typed;
  const cells = formatReadTable(typed, table, judged.findings);
  return { ...judged, tokens, table: { rows: table.rows, typed: rows, ...cells } };
}

// Choose the best verdict over all readings. A verdict on the same arm comes first, then a verdict
// on its first joints, then the verdict with the fewest mistakes.
/** @param {Reading[]} readings */
function chooseVerdict(readings) {
  const sameArm = readings.map((reading) => reading.judgeSame());
  const index = [
    (verdict) => verdict?.grade === RIGHT,
    (verdict) => verdict && verdict.grade !== WRONG,
    Boolean,
  ]
    .map((isWanted) => sameArm.findIndex(isWanted))
    .find((k) => k >= 0);
  if (index !== undefined) return { verdict: sameArm[index], index, isSame: true };
  const firstJoints = readings.map((reading) => reading.judgeFirst());
  const firstIndex = firstJoints.findIndex(Boolean);
  if (firstIndex >= 0)
    return { verdict: firstJoints[firstIndex], index: firstIndex, isSame: false };
  const otherArm = readings.slice(0, MOST_ORDERS).map((reading) => reading.reportDifferences());
  const counts = otherArm.map(countMistakes);
  const fewest = counts.indexOf(Math.min(...counts));
  return { verdict: otherArm[fewest], index: fewest, isSame: false };
}

// Return the tables as which a text may be read, or the error if its matrices are no link matrices.
function readTextOrNoLink(text, options, known) {
  try {
    return readTables(text, options, known);
  } catch (error) {
    if (error instanceof NoLink) return error;
    const filledPart = dropUnfilledEnd(text);
    if (filledPart !== text) return readTextOrNoLink(filledPart, options, known);
    const split = dropOtherColumns(text);
    if (!split.others.length) throw error; // the same text, which takes as long again
    const tables = tryOrNull(() => readTables(split.rest.text, options, known));
    if (!tables) throw error;
    return tables.map((table) => ({
      ...table,
      tokens: addOtherNumbers(table.tokens, split, text),
    }));
  }
}

// Fix the locked rows in tables that cannot say which rows are locked: Link lines, and lists
// without theta.
function fixLockedRows(table, kinds) {
  const { rows, assumptions } = table;
  const isUnlocked = ["taken: links", "taken: no theta"].some((key) =>
    assumptions.includes(formatMessage(key)),
  );
  if (!isUnlocked || rows.length !== kinds.length) return table;
  const fix = (row, k) => (kinds[k] === "fixed" ? { ...row, kind: "fixed", joint: null } : row);
  return { ...table, rows: rows.map(fix) };
}

/** @param {NoLink} error @param {Arm} reference @returns {Verdict} */
function reportNoLink({ message, causes, tokens }, { name }) {
  const findings = [{ what: "cause", where: "", words: `${message}.` }];
  const fields = {
    mine: formatMessage("your table"),
    reference: name,
    cause: uncapitalize(message),
  };
  const headline = formatMessage("table wrong", fields);
  return makeVerdict("table", { name }, WRONG, headline, { findings, causes, tokens });
}

// Find the first row that breaks the order of joint numbers: the next row with a joint number has
// the same number or a smaller one.
function findMisnamedRow(rows) {
  const named = rows.flatMap(({ joint }, k) => (joint ? [{ ...joint, row: k + 1 }] : []));
  const k = named.findIndex(({ number }, i) => number >= named[i + 1]?.number);
  const isAsCounted = named[k]?.number === k + 1; // then the next row has the wrong name
  const misnamed = named[isAsCounted ? k + 1 : k];
  return misnamed ? makeCause("table.names", { row: misnamed.row, name: misnamed.name }) : null;
}

// Count the mistakes that a verdict names as causes or lists as differences.
/** @param {Verdict} verdict */
function countMistakes({ causes, findings }) {
  const named = causes.length ? causes[0].split(" + ").length : 0;
  return named + findings.filter(({ what }) => what !== "cause" && !what.includes(".")).length;
}

// Format the table as it was read, with the wrong cells.
function formatReadTable(typed, { lengthScale, angleScale }, findings) {
  const positions = findings.map(({ where }) => where);
  const trees = typed.rows.map((row) => ENTRIES.map((column) => row.trees?.[column]));
  const cells = typed.rows.map((row, k) =>
    ENTRIES.map((column) => {
      const { kind, numbers, radians, backwards } = row;
      const scale = DEG * (radians.has(column) ? 1 : angleScale);
      const text = isAngleColumn(column)
        ? `${formatNumber(numbers[column] * scale, 6)}°`
        : formatNumber(lengthInMetres(row, column, lengthScale), 6);
      if (column !== jointColumn(kind)) return text;
      const variable = `${backwards ? "-" : ""}q_${k + 1}`;
      return numbers[column]
        ? `${variable} ${text.replace(/^-?/, (sign) => (sign ? "- " : "+ "))}`
        : variable;
    }),
  );
  const wrong = cells.map((_, k) =>
    ENTRIES.map((column) => positions.includes(`row ${k + 1}, ${column}`)),
  );
  return { cells, trees, wrong };
}

/**
 * Make a table of a typed table and its converted rows.
 * @param {import("../reading/table.js").TypedTable} typed
 * @param {import("../reading/table_conversion.js").ConvertedTable} converted
 * @returns {Table}
 */
export function makeTable(typed, { rows, assumptions, length, angle }) {
  const texts = typed.rows.map((row) => row.texts);
  const modified = typed.convention === "craig";
  const { a, alpha } = typed.rows[0].numbers;
  return {
    name: formatMessage("your table"),
    rows,
    texts,
    lengthUnit: findWholeUnit(typed, length) || findFinestUnit(texts, ["a", "d"]) * length,
    angleUnit: findFinestUnit(texts, ["alpha", "theta"]) * angle,
    lengthScale: length,
    angleScale: angle,
    assumptions,
    modified,
    isExchanged: Boolean(typed.isExchanged),
    added: Number(modified && Boolean(a || alpha)),
  };
}

/**
 * Make the table of an arm from Python, in m and rad.
 * @param {{ name: string, rows: TableRow[], texts: Record<string, string>[] }} arm
 * @returns {Table}
 */
const makeTableOfArm = ({ name, rows, texts }) => ({
  name,
  rows,
  texts,
  lengthUnit: findFinestUnit(texts, ["a", "d"]),
  angleUnit: findFinestUnit(texts, ["alpha", "theta"]),
  lengthScale: 1,
  angleScale: 1,
  assumptions: [],
  modified: false,
  isExchanged: false,
  added: 0,
});

/**
 * Replace rounded angles of two decimals or more, such as 1.57, by the right angles near them.
 * @param {Table} table @returns {TableRow[]}
 */
export const snapTypedAngles = (table) =>
  table.rows.map((row, k) => {
    const [alpha, theta] = ["alpha", "theta"].map((column) =>
      snapAngle(row[column], entryUnit(table, k + 1, column)),
    );
    return { ...row, alpha, theta };
  });

/**
 * Make a reading of a table beside the reference.
 * @param {Table} table @param {Arm} reference @param {Options} options
 * @returns {Reading}
 */
function makeReading(table, reference, { tolerance = null, startConfiguration = null }) {
  const [rows, expectedRows] = [snapTypedAngles(table), snapRows(reference.rows)];
  const [axes, expectedAxes] = [describeAxes(rows), describeAxes(expectedRows)];
  const pair = { table, reference, rows, expectedRows, axes, expectedAxes };
  const tolerances = computeTolerances(table, rows, tolerance);
  const { exact, rounded, roundedAngle, mapLength, typedLength } = tolerances;
  const judgeAxes = (comparison, grade) => {
    if (table.isExchanged)
      return reportWrong(table, reference, [makeCause("table.alpha and theta")]);
    const mapped = grade === RIGHT ? EXACT_LENGTH : mapLength;
    return judgeSameArm(pair, comparison, grade, {
      length: rounded,
      mapLength: mapped,
      startConfiguration,
    });
  };
  const judgeSame = () => {
    const comparison = compareAxes(axes, expectedAxes, exact);
    const baseGap = Math.abs(comparison.baseHigher);
    const isRounded = baseGap > exact && baseGap <= rounded;
    if (!comparison.differences.length) return judgeAxes(comparison, isRounded ? ROUNDED : RIGHT);
    const roundedComparison = compareAxes(axes, expectedAxes, rounded, roundedAngle);
    return roundedComparison.differences.length ? null : judgeAxes(roundedComparison, ROUNDED);
  };
  return {
    judgeSame,
    judgeFirst: () => judgeFirstRows(pair, rounded, roundedAngle),
    reportDifferences: () => reportDifferences(pair, Math.max(exact, typedLength)),
  };
}

/**
 * Report a table that does not describe the reference by the fewest mistakes that explain it.
 * @param {import("./table_same.js").TablePair} pair @param {number} length tolerance (m)
 * @returns {Verdict}
 */
function reportDifferences({ table, reference, rows, expectedRows }, length) {
  const hypotheses = findFewestMistakes(rows, reference, expectedRows, table.modified, length);
  const causes = hypotheses.flatMap(({ cause }) => cause ?? []);
  const [hypothesis] = hypotheses;
  const { a, alpha } = table.rows[0];
  const isCraig = causes.some(({ keys }) => keys.includes("table.craig"));
  const typedTable = isCraig
    ? { ...table, modified: true, added: Number(Boolean(a || alpha)) }
    : table;
  const findings = hypothesis.differences.map((difference) =>
    Array.isArray(difference)
      ? describeEntry(typedTable, hypothesis, difference, length)
      : describeDifference(typedTable, difference),
  );
  return reportWrong(table, reference, causes, findings);
}

/**
 * Report a wrong table.
 * @param {Table} table @param {Arm} reference
 * @param {Cause[]} causes each explains the same differences
 * @param {Finding[]} findings differences that the causes leave, all of entries or all of axes;
 *   those of entries are causes too
 * @returns {Verdict}
 */
function reportWrong(table, reference, causes, findings = []) {
  const ownCauses = findings.map(({ what }) => what).filter((what) => what.includes("."));
  const names = causes.length
    ? causes.map((cause) => [causeName(cause), ...ownCauses].join(" + "))
    : ownCauses.length
      ? [ownCauses.join(" + ")]
      : [];
  const fields = { mine: table.name, reference: reference.name };
  const shared = { causes: names, taken: table.assumptions };
  const makeWrong = (headline, list) =>
    makeVerdict("table", reference, WRONG, headline, { ...shared, findings: list });
  if (causes.length) {
    const message = hedgeMessage(joinCauseMessages(causes), findings);
    const rest = findings.length ? formatMessage("and what remains") : "";
    const cause = uncapitalize(message) + rest;
    const finding = { what: "cause", where: "", words: `${message}.` };
    return makeWrong(formatMessage("table wrong", { cause, ...fields }), [finding, ...findings]);
  }
  const [finding] = findings;
  if (findings.length !== 1 || finding.what === "row")
    return makeWrong(formatMessage("table other arm", fields), findings);
  const cause = uncapitalize(finding.words).replace(/\.+$/, "");
  const what = ownCauses.length ? "cause" : finding.what;
  return makeWrong(formatMessage("table wrong", { cause, ...fields }), [{ ...finding, what }]);
}
