// Chooses the columns of a table whose headers have the answer's name, such as "tau". If several
// sets of columns fit, all are returned, and the judge asks the student to choose.

import { isSeries } from "./counts.js";
import { readHeaderLabels, readLabels } from "./ordering.js";
import { agree } from "./repetitions.js";

/** @typedef {import("./block.js").Block} Block */
/** @typedef {import("./lines.js").Cell} Cell */

/**
 * Return a name without the marks before it and without its unit: "T" for "*T_(Nm)".
 * @param {string} name
 */
export const bareName = (name) => name.replace(/^[^\p{L}]+|_\([^()]*\)$/gu, "");

const EXACT_NAME = /^(?:q|th|theta|θ|tau|τ|torques?)(?:_?\{?i\}?)?$/i;
const ANGLE = /^(?:(?:joint )?angles?|deg(?:rees?)?|°|rad(?:ians?)?)$/i; // or the unit alone

/**
 * Return a block for each column below the answer's name. A column "q" is preferred to "q0" and
 * "qd".
 * @param {Block} block @param {RegExp} names of the answer @returns {Block[]}
 */
export function chooseColumn(block, names) {
  if (block.rows[0].length < 2 || readHeaderLabels(block)) return [];
  const columns = listColumns(block);
  const named = columns.filter(({ header }) => names.test(bareName(header.text)));
  const exact = named.filter(({ header }) => EXACT_NAME.test(bareName(header.text)));
  const angles = names.test("q") ? columns.filter(({ header }) => ANGLE.test(header.text)) : [];
  const columnsByName = [exact, named, angles].find(({ length }) => length > 0) ?? [];
  return selectSets(
    block,
    columnsByName.map((column) => [column]),
  );
}

/**
 * Return a block for each set of columns whose headers name all joints. Headers with the answer's
 * name are preferred.
 * @param {Block} block @param {{ by?: string, columns: number | null }} want
 * @param {RegExp} names of the answer @returns {Block[]}
 */
export function chooseJointColumns(block, { by, columns }, names) {
  if (by !== "joint" || columns === null || block.rows[0].length <= columns) return [];
  const joints = listColumns(block)
    .filter(({ header }) => isJointHeader(header))
    .map((joint) => ({ ...joint, number: readLabels([[joint.header]]).numbers[0] }));
  const named = joints.filter(({ header }) => names.test(bareName(header.text)));
  const isSet = (set) => set.length === columns;
  const setsByName = splitAtRepeatedNumbers(named).filter(isSet);
  const sets = setsByName.length ? setsByName : splitAtRepeatedNumbers(joints).filter(isSet);
  return selectSets(block, sets);
}

// List the columns with their headers, or none if headers and columns do not correspond.
function listColumns(block) {
  const offset = offsetOfHeaders(block);
  if (offset === null) return [];
  return block.headers
    .map((header, k) => ({ header, column: k - offset }))
    .filter(({ column }) => column >= 0 && column < block.rows[0].length);
}

// Return the index of the first column's header. It is -1 if the first column counts the rows and
// has no header, and null if headers and columns do not correspond. Words behind the rows have
// headers, too.
function offsetOfHeaders({ headers, rows, sources }) {
  const extra = headers.length - rows[0].length;
  const isCounted = isSeries(rows.map(([cell]) => cell.text));
  if (extra < 0) return extra === -1 && isCounted ? -1 : null;
  const tails = sources.length === rows.length ? sources.map(({ tail }) => tail) : [0];
  const offset = extra - Math.min(extra, ...tails);
  // A first column that counts rows does not belong to a joint. It has no header if the first
  // header names a joint, and the last header then belongs to words behind the rows.
  const mayHaveTail = offset > 0 || Math.max(...tails) > 0 || sources.every(isCountOfNoun);
  return mayHaveTail && isCounted && isJointHeader(headers[offset]) ? offset - 1 : offset;
}

// Return whether a word stands before the first number of a row, as in "Pose 1".
const isCountOfNoun = ({ words, isAssigned }) => words.length > 0 && !isAssigned;

const isJointHeader = (header) => readLabels([[header]])?.kind === "joint";

// Split the columns of joints into sets. A repeated joint number begins the next set.
function splitAtRepeatedNumbers(joints) {
  const sets = [];
  for (const joint of joints) {
    const isRepeated = sets.at(-1)?.some(({ number }) => number === joint.number);
    if (!sets.length || isRepeated) sets.push([]);
    sets.at(-1).push(joint);
  }
  return sets;
}

const IN_DEGREES = /deg|°/i;
const IN_RADIANS = /rad/i;
const areIn = (set, unit) => set.every(({ header }) => unit.test(header.text));

// Make a block of each set of columns. A set in radians that repeats a set in degrees is left out.
function selectSets(block, sets) {
  const degrees = sets.filter((set) => areIn(set, IN_DEGREES));
  const radians = sets.filter((set) => areIn(set, IN_RADIANS));
  const isPair = degrees.length === 1 && radians.length === 1;
  const repeats = isPair && repeatsInDegrees(block, radians[0], degrees[0]);
  return sets
    .filter((set) => !repeats || set !== radians[0])
    .map((set) => selectColumns(block, set, isPair && set === degrees[0]));
}

function selectColumns(block, set, inDegrees) {
  const unit = inDegrees ? " deg" : "";
  const columns = set.map(({ column }) => column);
  const select = (row) => columns.map((k) => ({ ...row[k], text: `${row[k].text}${unit}` }));
  const labelColumns = Math.min(...columns);
  return {
    ...block,
    rows: block.rows.map(select),
    labels: block.labels.map((words, i) => [...words, ...block.rows[i].slice(0, labelColumns)]),
    headers: set.map(({ header }) => header),
  };
}

const repeatsInDegrees = ({ rows }, radians, degrees) =>
  rows.every((row) =>
    radians.every(({ column }, k) => agree(row[column].text, row[degrees[k].column].text)),
  );
