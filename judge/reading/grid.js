// A pasted text as rows of cells: NumPy, SymPy, MATLAB, LaTeX, Markdown, CSV or spreadsheet cells.

import { beginsACell, bracketed, endOf, ofNumbers, opened, untouched } from "./brackets.js";
import { decimal } from "./commas.js";
import { isNumber } from "./formula.js";
import { latexRows } from "./latex.js";
import { typedLines } from "./lines.js";
import { split } from "./split.js";
import { alone, bare as withoutSurroundings } from "./surroundings.js";
import { lines, stripped, strippedEnd } from "./text.js";
import { ArmError, say, shown } from "../sentences.js";

const LONGEST = 5_000_000; // characters of a paste: a trace of 20 000 steps
const IN_DEGREES = /^.*[0-9.]\s*(?:°|º|deg(?:rees?)?)$/;
// NumPy's print of a large array, where MATLAB ends a line so.
const CUT = /\.\.\.(?=[ \t]*,?[ \t]*[-\d[])|^[ \t]*\.\.\.,?[ \t]*$/m;
const TURN = 6.3; // a number beyond is no angle in radians

// The rows of cells in a text, each cell as typed; an error where it is far too long or empty.
export function cells(text) {
  if (text.length > LONGEST) {
    throw new ArmError(`the text has ${text.length} characters; expected at most ${LONGEST}`);
  }
  if (CUT.test(text)) throw new ArmError(say("cut print"));
  if (/±|\\pm(?![A-Za-z])/.test(text)) throw new ArmError(say("two signs"));
  const rows = rowsOf(stripped(withoutSurroundings(text).trim(), "`$").trim())
    .filter((row) => row.some((cell) => cell.trim()))
    .map((row) => row.map((cell) => stripped(cell.trim(), `'"`).trim()));
  if (!rows.length) throw new ArmError("the text is empty; expected rows of numbers or formulas");
  if (rows.length === 1) eachInDegrees(rows[0]);
  return rows;
}

// An error where the last of many angles alone has a sign that may be meant for all.
function eachInDegrees(row) {
  const [others, last] = [row.slice(0, -1), row[row.length - 1]];
  const meant = IN_DEGREES.test(last) && others.every(isNumber);
  if (meant && others.some((x) => Math.abs(Number(x)) > TURN))
    throw new ArmError(`only ${shown(last)} is in degrees; expected the sign beside each angle`);
}

// The rows of a text in the first notation that it is written in.
function rowsOf(text) {
  if (text.includes("\\begin{") || text.includes("\\\\")) return latexRows(text);
  const inner = withoutBars(text);
  if (inner.includes("|") && !/^[^|]*\[[^\]|]*\|/.test(inner)) return markdownRows(inner);
  return listedRows(inner);
}

// The bars that a matrix may stand between.
function withoutBars(text) {
  const two = text.split("|").length === 3 && text[0] === "|" && text.at(-1) === "|";
  return two && text.includes("\n") ? text.slice(1, -1).trim() : text;
}

// What stands before a list: J = and J(q) = np.array( and what closes it again, as in ,
// dtype=float).
const WORD = String.raw`[\p{L}\p{N}_.]`;

const BEFORE = String.raw`^\s*(?:${WORD}+\s*(?:\([\p{L}\p{N}_]+\))?\s*(?:[:=]?=|:)\s*)?`;
const MAKERS = "Matrix|array|asarray|matrix|tensor|vpa|simplify|round|double|sym";
const WRAPPER = new RegExp(String.raw`${BEFORE}(?:${WORD}*(?:${MAKERS})\s*\(\s*)+`, "u");
const TAIL = /\)?(?:,\s*(?:dtype\s*=\s*[\p{L}\p{N}_.']+|\d+)\s*)?\)+\s*[;.,]?\s*$/u;
const NAMED =
  /^\s*[\p{L}_][\p{L}\p{N}_.]*\s*(?:\([\p{L}\p{N}_]+\))?\s*(?:[:=]?=|<<|:)\s*(?=[[({\n\d-]|$)/u;
// A comma or full stop behind the last bracket, and a factor before the first.
const ENDED = /(?<=[\])}])\s*[.,;]+$/;

const FACTOR = /^[-+*/^.0-9e \t]+(?=\[)/;

// What a call is given, without what closes it; a round bracket that opens there is a list's.
function withoutTail(text) {
  const end = text[0] === "(" ? endOf(text) + 1 : 0;
  return text.slice(0, end) + text.slice(end).replace(TAIL, "");
}

// Lists in brackets, else lines, without a name and a call such as np.array(...) about them.
function listedRows(text) {
  const called = WRAPPER.test(text) ? withoutTail(text.replace(WRAPPER, "")) : text;
  const unnamed = strippedEnd(called.replace(NAMED, "").trim(), ";").trim();
  const inner = opened(unnamed.replace(ENDED, ""));
  if (inner[0] === "[") untouched(inner);
  if (inner && "[({".includes(inner[0]) && !beginsACell(inner)) return bracketed(inner);
  const before = FACTOR.exec(inner);
  if (before) alone(before[0], before[0].replace(/[ \t]/g, ""));
  return typedLines(inner);
}

function markdownRows(text) {
  const rows = lines(text)
    .map((line) => line.trim())
    .filter((line) => line.includes("|") && !/^[\s:|+=_-]*[-=_][\s:|+=_-]*$/.test(line))
    .map((line) =>
      line
        .replace(/^\||\|$/g, "")
        .replaceAll("$", " ")
        .split("|"),
    );
  const bars = rows.every((row) => row.length === 1 && ofNumbers(row[0])); // on each line
  return rows.map((row) => (bars ? split(row[0]) : row.map(decimal)));
}
