// Reading from the shape that is asked for: the block of a text that fits, wherever it stands, its
// rows and columns in the order that their labels say.

import { blocksIn } from "./blocks.js";
import { number } from "./formula.js";
import { labelIn } from "./labels.js";
import { linesOf, plainSigns } from "./signs.js";
import { ArmError, joinList, formatMessage, quoteText } from "../sentences.js";

const LONGEST = 2_000_000; // characters of a text: a run of 20 000 steps

/**
 * How many rows and columns are asked for, any number where null; what its rows are named after,
 * "row" or "joint"; whether a column is turned into a row; whether of several the largest is meant.
 * `names` are those of the answer, `given` what the question itself holds, `wanted` the shape in
 * words.
 * @typedef {{ rows: number | null, columns: number | null, by?: string, turned?: boolean,
 *   largest?: boolean }} Want
 * @typedef {{ what: string, wants: Want[], isEntry: (cell: string) => boolean, names?: RegExp,
 *   given?: number[][], which?: number | null, wanted?: string }} Question
 */
/**
 * @typedef {import("./blocks.js").Block & { context: string, left: string[], said: string[] }}
 *   Found
 */

/** @param {string} text @param {Question} question @returns {Found} */
export function find(text, question) {
  const { what, wants, isEntry, names = NONE, given = [] } = question;
  if (text.length > LONGEST)
    throw new ArmError(formatMessage("too long", { what, count: text.length }));
  if (!text.trim()) throw new ArmError(formatMessage("empty", { what }));
  if (wants[0].columns === null) refuseOdd(text, question);
  const own = blocksIn(text, { isEntry, names, given });
  const whole = given.length ? blocksIn(text, { isEntry, names }) : [];
  for (const want of wants)
    for (const blocks of want.rows > 1 ? [...whole, ...own] : own) {
      const one = chosen(fitting(blocks(), want, question), question);
      if (one) return { ...named(one, want, text), ...around(text, one) };
    }
  throw refusal(text, question, own);
}

const NONE = /(?!)/; // no name

// The blocks that fit, those with the answer's name where there are some; of any shape the largest.
function fitting(blocks, want, { wants, names = NONE }) {
  const each = want.rows === 1 ? blocks.flatMap(rowsAlone) : blocks;
  const fits = each.flatMap((block) => fitted(block, want, wants, names));
  if (want.largest || (want.columns === null && want.rows === null)) return largest(fits);
  const called = fits.filter(({ name }) => names.test(bare(name)));
  return called.length ? called : fits;
}

const count = ({ rows }) => rows.flat().length;
const largest = (blocks) => [...blocks].sort((p, q) => count(q) - count(p)).slice(0, 1);

const bare = (name) => name.replace(/^[^\p{L}]+/u, "");

// The one that is meant: the last of equal ones; of several that differ the one that was chosen.
function chosen(fits, { which = null }) {
  const all = [...new Map(fits.map((one) => [JSON.stringify(one.rows), one])).values()];
  const answers = all.filter(({ rows }) => rows.length > 1 || !countsJoints(rows[0]));
  const different = answers.length ? answers : all;
  if (different.length < 2 || which !== null) return different[(which ?? 1) - 1];
  const told = different
    .slice(0, MOST)
    .map(({ rows, from }) => `line ${from + 1} (${quoteText(rows[0].join(" "))})`);
  const advice = told.map((_, k) => ({ field: "which", value: k + 1 }));
  throw new ArmError(formatMessage("which", { blocks: joinList(told) }), advice);
}

const MOST = 5; // answers to choose from

// Whether a row only numbers the joints, as in "for joints 1, 2, 4, 5, 6 and 7".
const countsJoints = (cells) =>
  cells.every((cell, k) => /^\d$/.test(cell) && (!k || cell > cells[k - 1]));

// The block as it is wanted, or nothing. Of a row that is wanted as it stands no number counts it.
function fitted(block, want, wants, names) {
  const whole =
    block.rows.length === 1 && wants.some((one) => one.columns === block.rows[0].length);
  const upright = [block, ...columnOf(block, names), ...(whole ? [] : withoutLabels(block))];
  const lying = want.by ? upright.filter((one) => liesBy(one, want)).map(transposed) : [];
  const is = ({ rows }) =>
    (want.rows === null || rows.length === want.rows) &&
    (want.columns === null || rows[0].length === want.columns);
  const found = lying.find(is) ?? upright.find(is);
  if (!found) return [];
  const one = ordered(found, want);
  return [want.turned ? { ...one, rows: [one.rows.flat()] } : one];
}

// Where one row is wanted, each is tried.
const rowsAlone = (block) =>
  block.rows.length < 2
    ? [block]
    : [
        block,
        ...block.rows.map((row, i) => ({ ...block, rows: [row], labels: [block.labels[i]] })),
      ];

// The labels of rows and of columns, where each has one of its kind and no two are the same.
function labelsOf(words) {
  const found = words.map(labelIn);
  const kind = found[0]?.kind;
  const even = kind && found.every((one) => one?.kind === kind);
  return even && new Set(found.map(({ at }) => at)).size === found.length
    ? { kind, at: found.map(({ at }) => at) }
    : null;
}

const headsOf = ({ heads, rows }) => {
  const extra = heads.length - rows[0].length;
  return extra >= 0 && extra < 3 ? labelsOf(heads.slice(extra).map((one) => [one])) : null;
};

// Whether labels say that rows are what is wanted as columns.
function liesBy(block, { by }) {
  if (by === "row" && TURNED.test(block.name)) return true;
  const [rows, heads] = [labelsOf(block.labels), headsOf(block)];
  if (by === "row") return heads?.kind === "row" || rows?.kind === "joint";
  return rows?.kind === "joint" && block.rows[0].length > 1 && heads?.kind !== "joint";
}

const TURNED = /(?:\.T|\^T|ᵀ|')$/; // behind the name of a transposed matrix

function transposed(block) {
  const { rows, labels, heads } = block;
  const own = heads.slice(heads.length - rows[0].length);
  return {
    ...block,
    rows: rows[0].map((_, k) => rows.map((row) => row[k])),
    labels: rows[0].map((_, k) => (own[k] ? [own[k]] : [])),
    heads: labels.map((words) => words.at(-1) ?? ""),
  };
}

// In the order of names that the text lists apart from the values, as ROS does.
/** @param {any} block @param {Want} want @param {string} text */
function named(block, { by, turned, columns }, text) {
  const [own] = block.rows;
  if (by !== "joint" || (!turned && columns === null) || block.said.length) return block;
  const at = listedIn(text, own.length);
  if (!at || at.every((one, k) => !k || one > at[k - 1])) return block;
  const order = at.map((_, k) => k).sort((p, q) => at[p] - at[q]);
  const rows = block.rows.map((row) => order.map((k) => row[k]));
  return { ...block, rows, said: [formatMessage("taken: by names")] };
}

// The numbers of so many joints whose names stand beside each other, null where none do.
function listedIn(text, count) {
  const words = plainSigns(text).split(/[\s,;:[\]{}"-]+/);
  const labels = words.map((word) => (/\p{L}/u.test(word) ? labelIn([word]) : null));
  const held = [];
  for (const label of [...labels, null]) {
    if (label?.kind === "joint") held.push(label.at);
    else if (held.length === count && new Set(held).size === count) return held;
    else held.length = 0;
  }
  return null;
}

// In the order of the labels.
function ordered(block, { by }) {
  const [rows, heads] = [labelsOf(block.labels), headsOf(block)];
  const order = (label) => label.at.map((_, k) => k).sort((p, q) => label.at[p] - label.at[q]);
  const whole = rows && (by === "row" ? rows.kind === "row" : rows.kind === "joint");
  const down = whole ? order(rows) : block.rows.map((_, i) => i);
  const across = heads?.kind === "joint" ? order(heads) : block.rows[0].map((_, k) => k);
  const moved = [...down, -1, ...across].join() !== [...down.keys(), -1, ...across.keys()].join();
  return {
    ...block,
    rows: down.map((i) => across.map((k) => block.rows[i][k])),
    said: moved ? [formatMessage("taken: by names")] : [],
  };
}

// The column whose head is the answer's name, of several side by side.
function columnOf(block, names) {
  const { heads, rows } = block;
  const extra = heads.length - rows[0].length;
  const at =
    extra < 0 || rows[0].length < 2 ? -1 : heads.findIndex((head) => names.test(bare(head)));
  if (at < Math.max(extra, 0) || headsOf(block)) return [];
  const labels = rows.map((row, i) => [...block.labels[i], row[0]]);
  return [{ ...block, rows: rows.map((row) => [row[at - extra]]), labels, heads: [] }];
}

// The block without a first column that counts its rows or tells the time, or names them, and
// without a first row that counts or names its columns.
function withoutLabels(block) {
  const below = withoutRow(block);
  const once = [block, ...below].flatMap(withoutColumn);
  return [...once, ...below, ...once.flatMap(withoutColumn)];
}

function withoutColumn(block) {
  const { rows, labels } = block;
  const down = rows.map((row) => row[0]);
  if (rows[0].length < 2 || !(isSeries(down) || areNames(down))) return [];
  const words = labels.map((own, i) => [...own, rows[i][0]]);
  return [{ ...block, rows: rows.map((row) => row.slice(1)), labels: words }];
}

function withoutRow(block) {
  const { rows, labels } = block;
  const [first, ...rest] = rows;
  if (!rest.length || first.length < 2 || !(isCount(first) || areNames(first))) return [];
  return [{ ...block, rows: rest, labels: labels.slice(1), heads: first }];
}

const areNames = (cells) => {
  const found = labelsOf(cells.map((cell) => [cell]));
  return found !== null && cells.every((cell) => number(cell) === null);
};

const isCount = (cells) =>
  [0, 1].some((from) => cells.every((cell, k) => Number(cell) === k + from));

// Whether cells count, or grow by as much each, as times do.
function isSeries(cells) {
  const found = cells.map(Number);
  if (isCount(cells)) return true;
  const step = (found.at(-1) - found[0]) / (found.length - 1);
  const unit = Math.max(...cells.map((cell) => 10 ** -(cell.split(".")[1]?.length ?? 0)));
  return (
    found.length > 3 &&
    step > 0 &&
    found.every((x, k) => Math.abs(x - found[0] - k * step) <= unit * 1.01)
  );
}

// The text without the block, and what of it is told to be set aside: its lines that say something,
// and numbers on the block's own lines that name no row.
export function around(text, { from, to, beside, labels, heads }) {
  const lines = linesOf(text);
  const rest = lines.filter((_, i) => i < from || i > to);
  const told = rest.filter((line) => /[\p{L}\d]/u.test(plainSigns(line)));
  const context = [...rest, ...labels.flat(), ...heads].join("\n");
  return { context, left: [...told.map((line) => line.trim()), ...beside()] };
}

/** @type {[string, RegExp][]} */
const SAID = [
  ["no solution", /\bno (?:real )?solution|\bunreachable\b/i],
  ["not finite", /(?<!\p{L})(?:nan|inf(?:inity)?)(?!\p{L})/iu],
  ["doubtful sign", /~\s*[\d.]/],
  ["complex", /\d\s?\*?\s?[ij](?![\p{L}\d])/u],
  ["two signs", /±|\\pm/],
  ["cut print", /\.\.\.(?=[ \t]*,?[ \t]*[-\d[])|^[ \t]*\.\.\.,?[ \t]*$/m],
  ["no text", /[\0-\x08\ufffd]/],
];

// An error for what is no answer in numbers.
function refuseOdd(text, { what, wanted = "numbers" }) {
  const [key] = SAID.find(([, is]) => is.test(text)) ?? [];
  if (key) throw new ArmError(formatMessage(key, { what, wanted }));
}

// Why nothing fits: what was found, and what is wanted.
function refusal(text, { what, wants, wanted = sizeOf(wants[0]) }, ways) {
  refuseOdd(text, { what, wanted });
  const blocks = ways.flatMap((blocks) => blocks()).filter((block) => count(block) > 1);
  if (!blocks.length) return new ArmError(formatMessage("no block", { what, wanted }));
  const sorted = [...blocks].sort((p, q) => count(q) - count(p));
  const sizes = new Set(sorted.map(({ rows }) => `${rows.length}x${rows[0].length}`));
  const found = joinList([...sizes].slice(0, 3));
  const line = quoteText(linesOf(text)[sorted[0].from] ?? "");
  return new ArmError(formatMessage("no fit", { what, found, line, wanted }));
}

const sizeOf = ({ rows, columns }) =>
  columns === null ? "numbers" : rows === null ? `rows of ${columns}` : `${rows}x${columns}`;
