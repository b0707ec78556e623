// A pasted text as rows of cells, the port of helpers/reading/grid.py: NumPy, SymPy, MATLAB, LaTeX, Markdown, CSV or
// spreadsheet cells.

import { alone, bare as withoutSurroundings, bareLatex } from "./around.js";
import { isNumber, number, plain } from "./formula.js";
import { ArmError } from "./say.js";

const LONGEST = 5_000_000; // characters of a paste: a trace of 20 000 steps

const WORD = String.raw`[\p{L}\p{N}_.]`;
const BEFORE = String.raw`^\s*(?:${WORD}+\s*(?:\([\p{L}\p{N}_]+\))?\s*=\s*)?`;
const MAKERS = "Matrix|array|asarray|matrix|tensor|vpa|simplify|round|double|sym";
const WRAPPER = new RegExp(String.raw`${BEFORE}(?:${WORD}*(?:${MAKERS})\s*\(\s*)+`, "u");
const TAIL = /\)?(?:,\s*(?:dtype\s*=\s*[\p{L}\p{N}_.']+|\d+)\s*)?\)+\s*;?\s*$/u;
const NAMED = /^\s*[\p{L}\p{N}_.]+\s*(?:\([\p{L}\p{N}_]+\))?\s*=\s*(?=[[({\n\d-]|$)/u;
const ENVIRONMENT = /\\begin\{(?:[a-zA-Z]*matrix\*?|array|tabular|aligned)\}(?:\[[^\]]*\])?(?:\{[^{}]*\})?/g;
const LATEX_REST =
  /\\end\{[^{}]*\}(?:_\{[^{}]*\})?(?:\s*\\right\s*[\]).|])?|\\(?:hline|(?:top|mid|bottom)rule|nonumber)(?![A-Za-z])/g;
const STARRED = /(?:^|[\s[(])-?(?:θ|\\?theta|th|q)_?\{?(?:\d+|i)?\}?\^?\*$|^\s*\*$/;
const FACTOR = /^[-+*/^.0-9e \t]+(?=\[)/;
const SCALE = /^\s*(1(?:\.0+)?e[+-]?\d+)\s*\*\s*$/m;
const MATLAB_BLOCK = /^\s*Columns?\s+\d+(?:\s+(?:through|to|and)\s+\d+)?\s*:?\s*$/im;
const RULE = /^\s*\|?[\s:|+=_-]*[-=_]{2,}[\s:|+=_-]*\|?\s*$/;

const lines = (text) => {
  const found = text.split(/\r\n|[\n\r\v\f\x1c-\x1e\x85\u2028\u2029]/);
  if (found.at(-1) === "") found.pop();
  return found;
};
const stripped = (text, signs) => {
  let [from, to] = [0, text.length];
  while (from < to && signs.includes(text[from])) from++;
  while (to > from && signs.includes(text[to - 1])) to--;
  return text.slice(from, to);
};
const strippedEnd = (text, signs) => {
  let to = text.length;
  while (to > 0 && signs.includes(text[to - 1])) to--;
  return text.slice(0, to);
};

// The rows of cells in a text, each cell as typed; an error where it is far too long or empty.
export function cells(text) {
  if (text.length > LONGEST) {
    throw new ArmError(`the text has ${text.length} characters; expected at most ${LONGEST}`);
  }
  const rows = rowsOf(stripped(withoutSurroundings(text).trim(), "`$").trim())
    .filter((row) => row.some((cell) => cell.trim()))
    .map((row) => row.map((cell) => cell.trim()));
  if (!rows.length) throw new ArmError("the text is empty; expected rows of numbers or formulas");
  return rows;
}

function rowsOf(text) {
  if (text.includes("\\begin{") || text.includes("\\\\")) return latex(text);
  if (text.split("|").length > 2 && !/^[^|]*\[[^\]|]*\|/.test(text)) return markdown(text);
  let bare = WRAPPER.test(text) ? text.replace(WRAPPER, "").replace(TAIL, "") : text;
  bare = strippedEnd(bare.replace(NAMED, "").trim(), ";").trim();
  if (bare && "[({".includes(bare[0])) return bracketed(bare);
  const before = FACTOR.exec(bare);
  if (before) alone(before[0], before[0].replace(/[ \t]/g, ""));
  return typedLines(bare);
}

function latex(text) {
  text = bareLatex(text)
    .replace(/\\left\s*[[(.|]\s*(?=\\begin)/g, " ")
    .replace(ENVIRONMENT, " ")
    .replace(LATEX_REST, " ")
    .replace(/^\s*[A-Za-z_][\p{L}\p{N}_]*(?:\([^()]*\))?\s*=/u, "")
    .replace(/\\\\\s*\[[^\]]*\]/g, "\\\\")
    .replaceAll("$", " ")
    .replaceAll("\\[", " ")
    .replaceAll("\\]", " ");
  return text.split(/\\\\|\\cr(?![A-Za-z])/).map((row) => row.split("&"));
}

const markdown = (text) =>
  lines(text)
    .map((line) => line.trim())
    .filter((line) => line.includes("|") && !/^[\s:|+=_-]*[-=_][\s:|+=_-]*$/.test(line))
    .map((line) => line.replace(/^\||\|$/g, "").replaceAll("$", " ").split("|")); // prettier-ignore

// Brackets

// Nested lists, tuples or MATLAB's one bracket with semicolons.
function bracketed(text) {
  const items = itemsOf(text);
  if (items.every(isList)) {
    const inner = items.map(itemsOf);
    if (!inner.some((row) => row.some(isList))) return inner;
    const opened = (cell) => (isList(cell) && itemsOf(cell).length === 1 ? itemsOf(cell)[0] : cell);
    const flat = inner.map((row) => row.map(opened));
    return flat.some((row) => row.some(isList)) ? items.flatMap(bracketed) : flat;
  }
  const body = text.trim().slice(1, -1);
  if (isList(text) && !body.includes("[")) {
    return body.replace(/\.\.\.[^\n]*\n/g, " ").split(/[;\n]/).map(split); // prettier-ignore
  }
  return [items];
}

// Whether a text is one bracket from end to end that holds a list; round ones only where a comma stands in them.
function isList(text) {
  text = text.trim();
  if (!text || !"[({".includes(text[0]) || !closesAtEnd(text)) return false;
  return text[0] !== "(" || topComma(text.slice(1, -1));
}

const deeper = (sign) => ("[({".includes(sign) ? 1 : "])}".includes(sign) ? -1 : 0);

function closesAtEnd(text) {
  let depth = 0;
  for (let k = 0; k < text.length; k++) {
    depth += deeper(text[k]);
    if (!depth) return k === text.length - 1;
  }
  return false;
}

function topComma(text) {
  let depth = 0;
  for (let k = 0; k < text.length; k++) {
    depth += deeper(text[k]);
    if (text[k] === "," && !depth) return true;
  }
  return false;
}

// What a bracket holds, or a text without one, split where it is meant to be.
function itemsOf(text) {
  text = strippedEnd(text.trim(), ",");
  return split(isList(text) ? text.slice(1, -1) : text);
}

// Split at commas outside brackets, or at blanks where there are none, as MATLAB and NumPy print.
function split(text) {
  const words = text.trim().split(/\s+/);
  if (words.every(isNumber)) return words;
  const pieces = [];
  let [depth, piece] = [0, ""];
  const comma = topComma(text);
  for (let k = 0; k < text.length; k++) {
    const sign = text[k];
    depth += deeper(sign);
    const ends = comma ? sign === "," : /\s/.test(sign) && !joins(text, k);
    if (ends && !depth) {
      pieces.push(piece);
      piece = "";
    } else piece += sign;
    if (!comma && !depth && sign === "]") {
      pieces.push(piece);
      piece = "";
    }
  }
  pieces.push(piece);
  return pieces.filter((one) => one.trim()).map((one) => stripped(one.trim(), "'\""));
}

// Whether the blank at k stands beside a sign that joins its neighbours: "a - b" is one cell, "a -b" are two, and so
// are a joint's variable that is marked by a star and what follows it. A star at the end marks a joint's variable, or
// is one.
function joins(text, k) {
  const [before, after] = [text.slice(0, k).trimEnd(), text.slice(k).trim()];
  if (after === "*") return STARRED.test(`${before}*`);
  if (before.endsWith("*") && after && !"*/^)=".includes(after[0]) && STARRED.test(before)) return false;
  if (!before || !after || "+-*/^=(".includes(before.at(-1)) || "*/^)=".includes(after[0])) return true;
  return (
    ("+-".includes(after[0]) && after.length > 1 && /\s/.test(after[1])) ||
    after.startsWith("deg") ||
    after[0] === "°"
  );
}

// Lines

function typedLines(text) {
  const scale = SCALE.exec(text);
  text = text.replace(new RegExp(SCALE, "gm"), "");
  const tables = text.split(MATLAB_BLOCK).map(block).filter((table) => table.length); // prettier-ignore
  const counts = [...new Set(tables.map((table) => table.length))].sort((p, q) => p - q);
  if (counts.length > 1) {
    throw new ArmError(`the blocks of columns have ${counts.join(", ")} rows; expected as many in each`);
  }
  const rows = (tables[0] ?? []).map((_, i) => tables.flatMap((table) => table[i]));
  return scale ? rows.map((row) => row.map((cell) => (number(cell) ? `${cell}*${scale[1]}` : cell))) : rows;
}

function block(text) {
  const kept = lines(text)
    .filter((line) => line.trim() && !RULE.test(line))
    .filter((line) => !/^\s*[\p{L}\p{N}_]+\s*=\s*$/u.test(line));
  const parts = (sign) => kept.some((line) => strippedEnd(line.trim(), ";").includes(sign));
  const separator = ["\t", ";"].find(parts);
  if (separator) {
    const end = (line) => strippedEnd(stripped(line, "\r\n "), separator);
    return kept.map((line) => end(line).split(separator).map(pointed));
  }
  if (kept.some(topComma)) return byCommas(kept);
  return kept.map((line) => split(line.replace(/^\s*[[|⎡⎢⎣]+|[\]|⎤⎥⎦]+\s*$/g, "")));
}

// Commas part cells, unless they are decimal ones: then blanks do.
function byCommas(kept) {
  const decimal = kept.every((line) => /^\s*(?:-?\d+(?:,\d+)?(?:\s+|$)){2,}$/.test(line));
  return kept.map((line) => split(decimal ? line.replaceAll(",", ".") : strippedEnd(line, ",")));
}

// A cell with a decimal comma written with a point, and without a spreadsheet's quotes or sign of equality.
function pointed(cell) {
  const inner = cell.trim();
  if (inner[0] === '"' && inner.at(-1) === '"') cell = inner.slice(1, -1);
  cell = cell.replace(/^[ \t]*=/, "");
  return cell.split(",").length === 2 && !cell.includes("(") ? cell.replace(/(?<=\d),(?=\d)/g, ".") : cell;
}

// Whether every cell is a number without symbols.
const numeric = (rows) => rows.every((row) => row.every((cell) => number(cell) !== null));

// The rows without the first if it is a header: names where numbers follow.
export function withoutHeader(rows) {
  const [first, ...rest] = rows;
  const words = first.map(plain).filter(Boolean);
  const isHeader = rest.length > 0 && words.every((word) => number(word) === null) && numeric(rest);
  return isHeader ? rest : rows;
}
