// Refuses an answer that its own text contradicts. Examples are "[0.5, 1] = [28.6°, 60°]", a row
// "vy" above a row "vx", and "in the tool frame" beside numbers in the base frame.

import { number, parse, plain, simple, symbols, value } from "./formula.js";
import { TRANSPOSED } from "./ordering.js";
import { agree } from "./repetitions.js";
import { ArmError, formatMessage, quoteText, tryOrNull } from "../sentences.js";

/** @typedef {import("./block.js").Block} Block */

// The text between two lists: brackets, a unit and "=".
const EQUALS = new RegExp(
  String.raw`^[\s\])}]*(?:\\?(?:text|mathrm)?\{?(?:rad(?:ians?)?|deg(?:rees?)?|°)\}?)?` +
    String.raw`[\s,]*[=≈][\s[({]*(?:np\.array\()?[\s[({]*$`,
);

/**
 * Raise an error if "=" joins a row of the answer to a different row. A row in radians and a row in
 * degrees may be equal.
 * @param {string} text @param {Block} block
 */
export function refuseUnequalLists(text, { sources, lines }) {
  const rowsOfBlock = new Set(sources);
  for (const row of lines.all) {
    if (rowsOfBlock.has(row) || row.cells.length < 2) continue;
    const source = sources.find(
      (joined) => areJoined(text, joined, row) || areJoined(text, row, joined),
    );
    if (!source || areEqual(source, row)) continue;
    const ends = [...source.cells, ...row.cells].flatMap(({ from, to }) => [from, to]);
    const quoted = quoteText(text.slice(Math.min(...ends), Math.max(...ends)));
    throw new ArmError(formatMessage("two units", { text: quoted }));
  }
}

const areJoined = (text, first, second) =>
  first.cells.length === second.cells.length &&
  EQUALS.test(text.slice(first.cells.at(-1).to, second.cells[0].from));

const areEqual = ({ cells }, { cells: others }) =>
  cells.every((cell, k) => {
    const [one, other] = [cell, others[k]].map(({ text }) => text.replace(/ deg$/, ""));
    const [x, y] = [number(one), number(other)];
    const decimals = Math.min(...[one, other].map((text) => text.split(".")[1]?.length ?? 0));
    const areClose = Math.abs(x - y) <= 1.01 * 10 ** -decimals;
    return areClose || agree(String(x), other) || agree(String(y), one);
  });

// The axis at the end of a label, such as y of "vy", "w_y", "ry:" and "theta_y".
const AXIS = /(?:^|[\s_{(vwrωd]|rot|ang|lin|theta|omega)([xyz])[\s})\].:=|,]*$/i;

/**
 * Raise an error if the labels of all rows end with an axis, and the order is not x, y, z.
 * @param {Block} block in the order in which it is judged @param {string} what the answer
 */
export function refuseContraryRows({ labels }, what) {
  const texts = labels.map((words) => words.at(-1)?.text ?? "");
  const axes = texts.map((text) => AXIS.exec(text)?.[1].toLowerCase());
  if (axes.length < 2 || axes.includes(undefined)) return;
  if (axes.every((axis, k) => k % 3 === 0 || axis > axes[k - 1])) return;
  throw new ArmError(formatMessage("contrary rows", { what, names: texts.join(", ") }));
}

// c23 = cos(q2 + q3) and a2 = 0.4, but not a2 = 400 mm.
const DEFINITION = new RegExp(
  String.raw`(?<![\p{L}\d_.])(\p{L}_?\{?\d{1,4}\}?)\s*:?=\s*` +
    String.raw`((?:cos|sin)\s*\([^()\n]{1,40}\)|\d*\.\d+(?!\d|\s*(?:[-+*/^e]|[cm]m\b)))`,
  "gu",
);

/**
 * Raise an error if the text gives a symbol of the answer a value that differs from its value in
 * the question.
 * @param {string} text @param {Map<string, number>} meanings of the symbols in the answer
 * @param {(names: Set<string>) => Map<string, number>} known looks symbols up
 */
export function refuseContraryDefinitions(text, meanings, known) {
  const expected = new Map([...meanings].map(([name, x]) => [simple(name), x]));
  for (const { 0: quoted, 1: name, 2: formula } of text.matchAll(DEFINITION)) {
    const x = expected.get(simple(plain(name)));
    const stated = x === undefined ? null : tryOrNull(() => evaluate(plain(formula), known));
    if (stated === null || Math.abs(stated - x) < ROUND_OFF) continue;
    throw new ArmError(formatMessage("contrary value", { quoted: quoteText(quoted), name }));
  }
}

const ROUND_OFF = 1e-9;

function evaluate(formula, known) {
  const tree = parse(formula);
  const names = new Set();
  symbols(tree, names);
  const meanings = known(names);
  return value(tree, (name) => meanings.get(name));
}

const TIP = "(?:tool|tip|wrist|hand|end[- ]?effector|flange|gripper|last joint)";
const FROM_TIP = new RegExp(
  [
    String.raw`(?:counted|numbered|listed|ordered|starting|beginning|order) from (?:the )?${TIP}`,
    String.raw`${TIP}[\s\d]*(?:->|→|\.{2,}|…)\s*base|last joint first`,
  ].join("|"),
  "iu",
);
// "columns: q3 q2 q1" of a Jacobian
const LISTED_JOINTS = /\b(?:columns?|order|spalten)\b[^\n\d]{0,20}[qθ]_?\d(?:[\s,;|&]+[qθ]_?\d)+/iu;
// "in the tool frame" and "(tool frame, 4 digits)", but not "the velocity of the tool frame"
const TOOL_FRAME = new RegExp(
  String.raw`(?:(?<!\p{L})(?:in|into|to|w\.?r\.?t\.?) (?:the )?|[(,] ?)` +
    String.raw`(?:tool|tip|end[- ]?effector|ee|body|hand|flange)(?:'s)? ` +
    String.raw`(?:frame|axes|coordinates)(?!\p{L})`,
  "iu",
);
const BASE_FRAME = /(?<!\p{L})(?:base|world|space)(?!\p{L})|frame 0/iu;

const LINEAR = String.raw`(?:J_?\{?[vp]\}?|v|(?:linear|translation(?:al)?)(?: part| rows)?)`;
const ANGULAR =
  String.raw`(?:J_?\{?(?:w|ω|\\?omega)\}?|w|ω|\\?omega|` +
  String.raw`(?:angular|rotation(?:al)?)(?: part| rows)?)`;
const HALF = String.raw`(?<![\p{L}\d_\\])(?:(${LINEAR})|(${ANGULAR}))(?![\p{L}\d_])`;
const HALVES = new RegExp(HALF, "giu");
const ORDER_OF_HALVES = new RegExp(
  String.raw`${HALF}\s*(?:above|over|on top of|before|;)\s*(?:the )?${HALF}|` +
    String.raw`[[(]\s*${HALF},\s*${HALF}\s*[\])]`,
  "giu",
);

/**
 * Raise an error if words beside a right answer state an order or a frame that does not fit its
 * numbers.
 * @param {string} text
 * @param {{ topic: string, typed?: import("./numbers.js").Typed }} verdict
 * @param {{ angularFirst?: boolean, frame?: number }} options of a Jacobian
 */
export function refuseContraryWords(text, { topic, typed }, options) {
  const words =
    FROM_TIP.exec(text)?.[0] ??
    (topic === "Jacobian" ? findInJacobian(text, typed, options) : undefined);
  if (words) throw new ArmError(formatMessage("contrary words", { quoted: quoteText(words) }));
}

const findInJacobian = (text, typed, options) =>
  findContraryFrame(text, options) ??
  findContraryHalves(text, typed, options) ??
  findContraryColumns(text, typed) ??
  findContraryTranspose(text, typed);

// Find a line that lists the joints of the columns in a different order. Columns with headers were
// ordered by their headers.
function findContraryColumns(text, { taken }) {
  const words = LISTED_JOINTS.exec(text)?.[0] ?? "";
  const isAscending = [...words.matchAll(/\d/g)].every(([x], k, all) => !k || x > all[k - 1][0]);
  return isAscending || taken.includes(formatMessage("taken: by names")) ? null : words;
}

const TRANSPOSED_NAME = new RegExp(
  String.raw`J(?:_\w+)?${TRANSPOSED}(?:\([^()\n]*\))?(?=\s*[=:])`,
  "u",
);

// Find the name of a transposed matrix before numbers that were taken row by row.
function findContraryTranspose(text, { tokens }) {
  const entries = tokens.filter(({ owner }) => owner === "entry");
  const name = TRANSPOSED_NAME.exec(text.slice(0, entries[0].from))?.[0];
  return name && entries[1].column === 1 ? name : null;
}

// Find words that name the tool's frame, although the rows are those in the base frame.
const findContraryFrame = (text, { frame = 0 }) =>
  frame || BASE_FRAME.test(text) ? null : (TOOL_FRAME.exec(text)?.[0] ?? null);

// Find words or names that exchange the halves of a Jacobian, such as "ω above v", and "J_w" above
// the linear half.
function findContraryHalves(text, { tokens, shape, hasRowNames }, { angularFirst = false }) {
  const [rows, width] = shape;
  if (rows !== 6 || hasRowNames) return null;
  const isContrary = (halves) =>
    halves[0] !== halves[1] && (halves[0] === "angular") !== angularFirst;
  for (const { 0: words } of text.matchAll(ORDER_OF_HALVES))
    if (isContrary(listHalves(words))) return words;
  const startOf = (index) => tokens.find((token) => token.index === index)?.from ?? 0;
  const [start, middle] = [0, 3 * width].map(startOf);
  const gaps = [text.slice(0, start), text.slice(endOf(tokens, 3 * width - 1), middle)];
  const names = gaps.map((words) => words.match(HALVES)?.at(-1));
  return names.every(Boolean) && isContrary(listHalves(names.join(" "))) ? names.join(" … ") : null;
}

const endOf = (tokens, index) => tokens.findLast((token) => token.index === index)?.to ?? 0;

const listHalves = (words) =>
  [...words.matchAll(HALVES)].map(([, linear]) => (linear ? "linear" : "angular"));
