// Finds the answer in a text. The answer is the block of the wanted shape, anywhere in the text,
// with rows and columns in the order of their labels.

import { makeBlockFinders, makePlainText } from "./blocks.js";
import { foldCharacters, linesOf } from "./characters.js";
import { askAboutCommas, mayBeDecimals } from "./commas.js";
import { bareName, chooseColumn, chooseJointColumns } from "./columns.js";
import {
  beginsWithCount,
  countsRows,
  dropCountCells,
  dropCountHeader,
  dropLabels,
  dropNameHeader,
  isJointCount,
} from "./counts.js";
import {
  labelNumberedLines,
  replaceFactorNames,
  withoutComments,
  withoutMargins,
  withoutStruckText,
} from "./decorations.js";
import { flattenFormulas } from "./drawn_formulas.js";
import { hasDecimals } from "./formula.js";
import { joinFrameParts } from "./frames.js";
import { findLabel } from "./labels.js";
import {
  applyOrder,
  isTransposed,
  orderByLabels,
  orderByListedNames,
  transpose,
} from "./ordering.js";
import { hasHalfNumbers, refuseLongText, refuseOdd } from "./odd_texts.js";
import { refuseUnread, tokensOf } from "./owners.js";
import { isCalledOld, namesOtherQuantity, namesOtherTopic } from "./row_names.js";
import { SpannedText } from "./spans.js";
import { findComputation } from "./surroundings.js";
import { refuseTwoUnits } from "./units.js";
import { findUnfilledLabel, findUnfilledLine } from "./unfilled.js";
import { ArmError, joinList, formatMessage, quoteText } from "../sentences.js";

/** Reports that the text has no numbers in the wanted shape, and may be an unfinished answer. */
export class NoFitError extends ArmError {}

const LONGEST = 2_000_000; // characters, enough for a trajectory of 20 000 steps

/**
 * A wanted shape. `rows` and `columns` are null if any number fits. `by` is "row" if labels name
 * rows of a Jacobian, and "joint" if they name joints. `turned` turns the answer into a single row.
 * `largest` takes the largest of several blocks.
 *
 * A question. `what` is the answer in messages, such as "your torques", and `names` matches names
 * of the answer. `given` are numbers of the question, and `wanted` is the shape in words. `which`
 * is the student's choice among several blocks, from 1. `stated` is the order that words beside the
 * answer state. `most` is the largest count of numbers in
 * an answer with any number of rows.
 * @typedef {{ rows: number | null, columns: number | null, by?: string, turned?: boolean,
 *   largest?: boolean }} Want
 * @typedef {{ what: string, wants: Want[], isEntry: (cell: string) => boolean, names?: RegExp,
 *   given?: number[][], which?: number | null, stated?: import("./ordering.js").StatedOrder,
 *   wanted?: string, most?: number }} Question
 */
/** @typedef {import("./lines.js").Cell} Cell */
/** @typedef {import("./blocks.js").Block} Block */
/**
 * The block that is the answer. `taken` has messages on the order of its rows, and `tokens` all
 * numbers of the text with their owners.
 * @typedef {Block & { taken: string[], hasRowNames?: boolean,
 *   tokens: import("./owners.js").Token[] }} Answer
 */

/**
 * Find the answer in a text. Comments and code are read only if nothing fits without them.
 * @param {string} text @param {Question} question @returns {Answer}
 */
export function findAnswer(text, question) {
  if (text.length > LONGEST)
    throw new ArmError(formatMessage("too long", { what: question.what, count: text.length }));
  if (!text.trim()) throw new ArmError(formatMessage("empty", { what: question.what }));
  const { what, wants, wanted = describeWant(wants[0]) } = question;
  refuseLongText(text, largestSizeOf(question), { what, wanted });
  const typed = foldCharacters(new SpannedText(text));
  const pasted = joinFrameParts(withoutMargins(replaceFactorNames(withoutStruckText(typed))));
  const live = withoutComments(pasted);
  const unfilled = findUnfilledLabel(live?.text ?? pasted.text);
  if (unfilled) throw makeUnfilledError(unfilled.quoted, question);
  const texts = live ? [live, pasted] : [pasted];
  let refusal = null; // the first error, for the text without comments
  for (const version of texts) {
    try {
      return findIn(version, text, question);
    } catch (error) {
      if (!(error instanceof ArmError) || error.tokens || error.answers) throw error;
      refusal ??= error;
    }
  }
  throw refusal;
}

/** @param {SpannedText} pasted @param {string} text @param {Question} question @returns {Answer} */
function findIn(pasted, text, question) {
  const { what, wants, isEntry, names, given = [], stated } = question;
  if (wants[0].columns === null) refuseOdd(text, question);
  const plain = labelNumberedLines(makePlainText(flattenFormulas(pasted, what)));
  const { commas } = stated ?? {};
  const blockFinders = makeBlockFinders(plain, { isEntry, names, given, commas });
  const answer = findFirstFit(blockFinders, { ...question, text });
  if (!answer || hasHalfNumbers(text, answer.block))
    throw makeRefusal(text, question, blockFinders);
  const { block, want } = answer;
  const ordered = stated ? applyOrder(block, stated) : orderByListedNames(block, want, text);
  const tokens = tokensOf(text, ordered);
  refuseUnread(text, tokens, what);
  refuseTwoUnits(block, what);
  const computation = findComputation(text, block);
  if (computation) throw new ArmError(formatMessage("computed", { what, text: computation }));
  const refusal = findDoubt(text, question, block, tokens);
  if (refusal) throw refusal;
  // A text without words can only be the answer, even if its numbers count 1, 2, 3.
  if (countsAlone(block, names) && /\p{L}/u.test(text))
    throw makeRefusal(text, question, blockFinders);
  return { ...ordered, tokens };
}

// Return an error for a block that is probably not the answer, or null.
/** @param {string} text @param {Question} question @param {Block} block @param {any[]} tokens */
function findDoubt(text, { what, names, stated }, block, tokens) {
  const { firstLine, sources } = block;
  const makeError = (key) => makeQuotingError(key, text, { firstLine }, { what });
  if (sources.every(isCalledOld)) return makeError("old answer");
  if (isOtherQuantity(block, names)) return makeError("other quantity");
  const isKnown = Boolean(stated?.commas) || sources.every(({ depth }) => depth > 0); // in brackets
  const words = isKnown || !mayBeDecimals(text, block) ? null : askAboutCommas(text, tokens);
  return words && /\p{L}/u.test(text) ? new NoFitError(words) : null;
}

// Make an error for an entry without a number, such as "q_6 = ?".
/** @param {string} text @param {Question} question */
function makeUnfilledError(text, { what, wants, wanted = describeWant(wants[0]) }) {
  const fields = { what, line: quoteText(text.trim()), wanted };
  return new NoFitError(formatMessage("unfilled", fields));
}

// Find the block that fits by the first shape wanted and the first splitting of the text. A block
// that is probably not the answer comes last.
function findFirstFit(blockFinders, question) {
  const { wants, which = null, given = [] } = question;
  const shapes = [false, true].flatMap((unlikely) => wants.map((want) => ({ unlikely, want })));
  for (const { unlikely, want } of shapes)
    for (const keepsGiven of want.rows > 1 && given.length > 0 ? [true, false] : [false])
      for (const makeBlocks of blockFinders) {
        const blocks = makeBlocks(keepsGiven);
        const fits = listFits(blocks, want, question);
        const candidates = unlikely ? fits : fits.filter((fit) => !isUnlikely(fit, question));
        const block = chooseBlock(candidates, question);
        if (block && which === null) refuseRivals(block, blocks, question);
        if (block) return { block, want };
      }
  return null;
}

const NO_NAME = /(?!)/;

// Return whether a block is probably not the answer. It may hold the numbers 1, 2, 3, ... without
// the answer's name, the halves of decimal numbers, or a column that counts its rows. Its name may
// be that of another quantity or of an old answer.
const isUnlikely = (block, { text, names = NO_NAME }) =>
  mayBeDecimals(text, block) ||
  countsAlone(block, names) ||
  countsRows(block) ||
  isOtherQuantity(block, names) ||
  block.sources.every(isCalledOld);

// Return whether a block holds three or more joint numbers in order, such as 1, 2, 4, without the
// answer's name.
const countsAlone = ({ rows, sources, name }, names = NO_NAME) =>
  rows.flat().length > 2 &&
  isJointCount(rows.flat()) &&
  !(sources[0].isAssigned && names.test(bareName(name)));

// The entries of a Jacobian may have names of joints, which are those of its columns.
function isOtherQuantity({ sources }, names = NO_NAME) {
  const holdsName = names.test(bareName(sources[0].words.at(-2)?.text ?? "")); // "tau": {"q1": 0.5
  const isOfTopic = (row) =>
    names === NO_NAME || names.test("J") || holdsName || names.test(bareName(row.name));
  const isOther = (row) => namesOtherQuantity(row) || (!isOfTopic(row) && namesOtherTopic(row));
  const others = sources.filter(isOther).length;
  return others > 0 && 2 * others >= sources.length;
}

// Make an error that quotes the only readable list, which the words before it call old.
function makeQuotingError(key, text, { firstLine }, { what }) {
  const line = quoteText(linesOf(text)[firstLine] ?? "");
  return new ArmError(formatMessage(key, { what, line }));
}

// List the blocks that fit, if possible only those with the answer's name. If any shape is wanted,
// the largest is the answer.
function listFits(blocks, want, { wants, names = NO_NAME }) {
  const candidates =
    want.rows === 1 ? blocks.flatMap((block) => listRowsAlone(block, want)) : blocks;
  const fits = candidates.flatMap((block) => fitBlock(dropNameHeader(block), want, wants, names));
  if (want.largest || (want.columns === null && want.rows === null)) return largestOnly(fits);
  const named = fits.filter(({ name }) => names.test(bareName(name)));
  return named.length ? named : fits;
}

const countEntries = ({ rows }) => rows.reduce((sum, row) => sum + row.length, 0);
const largestOnly = (blocks) =>
  [...blocks].sort((p, q) => countEntries(q) - countEntries(p)).slice(0, 1);
const textsOf = (cells) => cells.map(({ text }) => text);

// Return the only block that fits. If different blocks fit, the student must choose by `which`.
function chooseBlock(fits, { which = null }) {
  const texts = ({ rows }) => JSON.stringify(rows.map(textsOf));
  const all = [...new Map(fits.map((block) => [texts(block), block])).values()];
  const different = withoutRepeated(all);
  if (different.length < 2 || which !== null) return different[(which ?? 1) - 1];
  throw askWhich(different);
}

// Leave out blocks whose rows all repeat rows of a larger block.
function withoutRepeated(blocks) {
  const texts = blocks.map(({ rows }) => rows.map((row) => textsOf(row).join()));
  const repeats = (rows, others) =>
    others.length > rows.length && rows.every((row) => others.includes(row));
  return blocks.filter((_, k) => !texts.some((others) => repeats(texts[k], others)));
}

function askWhich(blocks) {
  const options = blocks.slice(0, MOST_ANSWERS).map(({ rows, firstLine }) => {
    const numbers = quoteText(textsOf(rows.flat().slice(0, MOST_NUMBERS)).join(" "));
    return `line ${firstLine + 1} (${numbers})`;
  });
  const advice = options.map((_, k) => ({ field: "which", value: k + 1 }));
  const error = new ArmError(formatMessage("which", { blocks: joinList(options) }), advice);
  error.answers = blocks
    .slice(0, MOST_ANSWERS)
    .map(({ firstLine, lastLine }) => ({ firstLine, lastLine }));
  return error;
}

const MOST_ANSWERS = 5; // blocks in the message
const MOST_NUMBERS = 8; // quoted numbers of a block

// Words that name an answer in English, German, French and Spanish.
const ANSWER_WORD =
  /(?:^|\s)(?:answer|result|solution|antwort|ergebnis|lösung|réponse|résultat|solución)s?$/i;

// Ask which block is the answer if another block of as many numbers fits, too. It has the answer's
// name, is called an answer, or has no name. Beside a named answer a block without name counts only
// if no word stands before it.
function refuseRivals(block, blocks, { text, wants, names = NO_NAME }) {
  const isAnswer = (name) => names.test(bareName(name)) || ANSWER_WORD.test(name);
  const values = ({ rows }) => textsOf(rows.flat()).map(Number).sort().join();
  const isNamed = block.name && isAnswer(block.name);
  const mayBeAnswer = ({ sources: [{ name, words }] }) =>
    isAnswer(name) || (isNamed ? !words.length : !name || /^\d{1,3}$/.test(name));
  const answers = blocks.filter(({ name }) => ANSWER_WORD.test(name));
  const rivals = wants
    .flatMap((want) => [blocks, answers].flatMap((all) => listFits(all, want, { wants, names })))
    .filter((other) => other.firstLine > block.lastLine || other.lastLine < block.firstLine)
    .filter((other) => countEntries(other) === countEntries(block) && mayBeAnswer(other))
    .filter((other) => values(other) !== values(block))
    .filter(({ rows }) => rows.flat().some(({ text }) => hasDecimals(text)))
    .filter((other) => !isUnlikely(other, { text }));
  if (rivals.length) throw askWhich([block, ...rivals]);
}

// List the ways in which a block fits the wanted shape, after counts are dropped and columns are
// chosen. A row of the wanted length keeps all its numbers.
function fitBlock(block, want, wants, names) {
  const isWholeRow =
    block.rows.length === 1 && wants.some(({ columns }) => columns === block.rows[0].length);
  // Each list has the blocks after a single change. Only headers can give several blocks.
  const alternatives = [
    ...dropCountHeader(block).map((each) => [each]),
    ...(countsRows(block) ? dropLabels(block) : []).map((each) => [each]),
    [block],
    ...dropCountCells(block).map((each) => [each]),
    chooseColumn(block, names),
    chooseJointColumns(block, want, names),
    ...(isWholeRow ? [] : dropLabels(block)).map((each) => [each]),
  ];
  const candidates = alternatives.flat();
  const transposedBlocks = want.by
    ? candidates.filter((candidate) => isTransposed(candidate, want)).map(transpose)
    : [];
  const fits = ({ rows, headers }) =>
    (want.rows === null || rows.length === want.rows) &&
    (want.columns === null || rows[0].length === want.columns) &&
    (want.by !== "joint" || namesColumns(headers, rows[0].length));
  const transposedFit = transposedBlocks.find(fits);
  const blocks = transposedFit
    ? [transposedFit]
    : (alternatives.map((each) => each.filter(fits)).find(({ length }) => length > 0) ?? []);
  return blocks.map((each) => {
    const ordered = orderByLabels(each, want);
    return want.turned ? { ...ordered, rows: [ordered.rows.flat()] } : ordered;
  });
}

// Make a block of each row, for questions about a single row. If a row begins with its count, the
// count becomes a label. If the block has a counted row for each wanted number, it stays whole.
function listRowsAlone(block, { columns }) {
  const isOwn = block.sources.length === block.rows.length;
  const isCounted = block.sources.map((row) => beginsWithCount(row, block.lines.all));
  if (block.rows.length === columns && isCounted.every(Boolean)) return [block];
  const alone = (row, i) => {
    const source = block.sources[i];
    const name = block.labels[i].at(-1)?.text ?? block.name;
    const place = isOwn
      ? { sources: [source], firstLine: source.line, lastLine: source.last }
      : { name };
    const labelled = isCounted[i]
      ? { rows: [row.slice(1)], labels: [[...block.labels[i], row[0]]] }
      : { rows: [row], labels: [block.labels[i]] };
    return { ...block, ...labelled, ...place };
  };
  const rows = block.rows.map(alone);
  return rows.length < 2 ? rows : [block, ...rows];
}

// Return whether the headers may belong to the columns. Either each column has the name of a joint,
// or at most one header or a minority of the words names a joint.
function namesColumns(headers, width) {
  if (width < 2) return true;
  const labels = headers.map(
    ({ label }, k) => label ?? findLabel(headers.slice(Math.max(0, k - 1), k + 1)),
  );
  const joints = new Set(
    labels.flatMap((label) => (label?.kind === "joint" ? [label.number] : [])),
  );
  return joints.size < 2 || joints.size === width || 2 * joints.size < headers.length;
}

// Make an error that says which numbers are there and which are wanted.
function makeRefusal(text, question, blockFinders) {
  const { what, wants, wanted = describeWant(wants[0]) } = question;
  refuseOdd(text, { what, wanted });
  const all = blockFinders.flatMap((make) => make()).filter((block) => countEntries(block) > 1);
  const whole = all.filter((block) => !hasHalfNumbers(text, block));
  const [decimal, split] = [false, true].map((splits) =>
    whole.filter(({ splitsCommas = false }) => splitsCommas === splits),
  );
  const blocks = decimal.length ? decimal : split;
  const unfilled = findUnfilledLine(text);
  if (unfilled) return makeUnfilledError(unfilled, question);
  if (!blocks.length) return new ArmError(formatMessage("no block", { what, wanted }));
  const sorted = [...blocks].sort((p, q) => countEntries(q) - countEntries(p));
  refuseUnread(text, tokensOf(text, sorted[0]), what); // may have broken the block
  const found = describeSize(sorted[0].rows.length, sorted[0].rows[0].length);
  const line = quoteText(linesOf(text)[sorted[0].firstLine] ?? "");
  const typed = sorted[0].rows.flat().map(({ from, to }) => text.slice(from, to));
  const more =
    typed.length > MOST_NUMBERS ? [...typed.slice(0, 4), "…", ...typed.slice(-4)] : typed;
  const numbers = quoteText(more.join(" "));
  const message = formatMessage("no fit", { found, numbers, line, wanted });
  return isFarTooLong(sorted[0], wants) ? new ArmError(message) : new NoFitError(message);
}

const LONGEST_PART = 10; // a list of 10 times the wanted length is no unfinished answer
const isFarTooLong = (block, wants) =>
  wants.every((want) => countEntries(block) > LONGEST_PART * sizeOf(want));

// Return the count of numbers in an answer, or Infinity if any number of rows or columns fits.
const sizeOf = ({ rows, columns }) => (rows ?? Infinity) * (columns ?? Infinity);

/** @param {Question} question */
const largestSizeOf = ({ wants, most }) => most ?? Math.max(...wants.map(sizeOf));

const describeWant = ({ rows, columns }) =>
  columns === null ? "numbers" : describeSize(rows, columns);

// Describe a size in words: "6 numbers", "3 rows of 2 numbers", "rows of 6 numbers".
function describeSize(rows, columns) {
  if (rows === 1) return `${columns} numbers`;
  const each = columns === 1 ? "one number" : `${columns} numbers`;
  return `${rows === null ? "" : `${rows} `}rows of ${each}`;
}
