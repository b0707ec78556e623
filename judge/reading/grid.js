// A pasted text as rows of cells: NumPy, SymPy, MATLAB, LaTeX, Markdown, CSV or spreadsheet cells.

import { alone, bare as withoutSurroundings, bareLatex, beside } from "./surroundings.js";
import { isFunction, isNumber, number, parse, plain } from "./formula.js";
import { ArmError, shown } from "../sentences.js";

const LONGEST = 5_000_000; // characters of a paste: a trace of 20 000 steps

const WORD = String.raw`[\p{L}\p{N}_.]`;
const BEFORE = String.raw`^\s*(?:${WORD}+\s*(?:\([\p{L}\p{N}_]+\))?\s*=\s*)?`;
const MAKERS = "Matrix|array|asarray|matrix|tensor|vpa|simplify|round|double|sym";
const WRAPPER = new RegExp(String.raw`${BEFORE}(?:${WORD}*(?:${MAKERS})\s*\(\s*)+`, "u");
const TAIL = /\)?(?:,\s*(?:dtype\s*=\s*[\p{L}\p{N}_.']+|\d+)\s*)?\)+\s*[;.,]?\s*$/u;
const TURNED = new RegExp(
  String.raw`^\s*(?:${WORD}+\s*=\s*)?(?:[\p{L}\p{N}_]+\.)?(deg2rad|radians|rad2deg|degrees)\s*` +
    String.raw`(?=\(\s*(?:${WORD}*array\()?\s*\[)`,
  "u",
);
const ENDED = /(?<=[\])}])\s*[.,;]+$/;
const TAKEN = /^\s*\)*\s*(?:[-+*/^']|\.[*/^'T])/; // what changes the matrix before it
const CONTINUED = /^(?:\s*[-+*/^]\s|.*[-+*/^]\s*$)/;
const NAMED = /^\s*[\p{L}\p{N}_.]+\s*(?:\([\p{L}\p{N}_]+\))?\s*=\s*(?=[[({\n\d-]|$)/u;
const ENVIRONMENT =
  /\\begin\{(?:[a-zA-Z]*matrix\*?|array|tabular|aligned)\}(?:\[[^\]]*\])?(?:\{[^{}]*\})?/g;
const LATEX_REST = new RegExp(
  String.raw`\\end\{[^{}]*\}(?:_\{[^{}]*\})?(?:\s*\\right\s*[\]).|])?` +
    String.raw`|\\c(?:line|midrule)(?:\([^()]*\))?\{[^{}]*\}` +
    String.raw`|\\(?:hline|(?:top|mid|bottom)rule|nonumber)(?![A-Za-z])`,
  "g",
);
const STARRED = /(?:^|[\s[(])-?(?:θ|\\?theta|th|q)_?\{?(?:\d+|i)?\}?\^?\*$|^\s*\*$/;
const SLIDING = /(?:^|[\s[(+-])d_?\{?(?:\d+|i)?\}?\^?\*$/;
const FACTOR = /^[-+*/^.0-9e \t]+(?=\[)/;
const SCALE = /^\s*(1(?:\.0+)?e[+-]?\d+)\s*\*\s*$/m;
const MATLAB_BLOCK = /^\s*Columns?\s+\d+(?:\s+(?:through|to|and)\s+\d+)?\s*:?\s*$/im;
const RULE = /^\s*\|?[\s:|+=_-]*[-=_]{2,}[\s:|+=_-]*\|?\s*$/;
const GAP = /(?<=[^ \u00a0\t\n])[ \u00a0]{2,}(?=[^ \u00a0\t\n])/g;
const TIGHT = /(?<![0-9.,])[0-9]+,[0-9]+(?![0-9.,])/g;
const DECIMAL = /^\s*[-+−]?(?![1-9][0-9]{0,2},[0-9]{3}\s*$)[0-9]+,[0-9]+\s*$/;
const THOUSANDS = /^[-+−]?[0-9]{1,3}(?:,[0-9]{3})+\.[0-9]+$/;
const DOTTED_THOUSANDS = /^[-+−]?[0-9]{1,3}(?:\.[0-9]{3})+,[0-9]+$/;
const EITHER = /^[-+−]?[1-9][0-9]{0,2},[0-9]{3}$/; // a decimal comma, or one of thousands
const DEGREES = /^(?:°|deg(?:rees?)?(?![A-Za-z0-9_]|\s*\())/;
const RADIANS = /^rad(?:ian)?s?(?![A-Za-z0-9_]|\s*\()/;
const NO_HEAD = /^(?:[≈~]? ?[-+]?[.,0-9][-+.,%0-9 eEdD]*|[-+]?[0-9]{2,}.*)$/;
const NUMBERED = /^\s*(?:(?:joint|link|row)\s*)?([0-9]+)[:)]\s+/i;
const BULLET = /^\s*[-–—]\s/;
const IN_DEGREES = /^.*[0-9.]\s*(?:°|º|deg(?:rees?)?)$/;
const TURN = 6.3; // a number beyond is no angle in radians
const QUOTED = /"[^"\n]*,[^"\n]*"/g;
const JUXTAPOSED = /[0-9.]\s+[.0-9]/;

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

function rowsOf(text) {
  if (text.includes("\\begin{") || text.includes("\\\\")) return latex(text);
  if (text.split("|").length === 3 && text.includes("\n") && text[0] === "|" && text.at(-1) === "|")
    text = text.slice(1, -1).trim(); // the bars of a matrix
  if (text.split("|").length > 2 && !/^[^|]*\[[^\]|]*\|/.test(text)) return markdown(text);
  const turned = TURNED.exec(text);
  if (turned) {
    const inner = strippedEnd(text.slice(turned[0].length), " ;.,");
    if (closesAtEnd(inner))
      return rowsOf(inner.slice(1, -1).trim()).map((row) =>
        row.map((cell) => `${turned[1]}(${cell})`),
      );
  }
  let bare = WRAPPER.test(text) ? text.replace(WRAPPER, "").replace(TAIL, "") : text;
  bare = strippedEnd(bare.replace(NAMED, "").trim(), ";").trim();
  bare = opened(bare.replace(ENDED, ""));
  if (bare[0] === "[") untouched(bare);
  if (bare && "[({".includes(bare[0]) && !beginsACell(bare)) return bracketed(bare);
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
  return text.split(/\\\\|\\cr(?![A-Za-z])/).map((row) => row.split("&").map(decimal));
}

function markdown(text) {
  const rows = lines(text)
    .map((line) => line.trim())
    .filter((line) => line.includes("|") && !/^[\s:|+=_-]*[-=_][\s:|+=_-]*$/.test(line))
    .map((line) => line.replace(/^\||\|$/g, "").replaceAll("$", " ").split("|")); // prettier-ignore
  const bars = rows.every((row) => row.length === 1 && ofNumbers(row[0])); // on each line
  return rows.map((row) => (bars ? split(row[0]) : row.map(decimal)));
}

const words = (line) => line.trim().split(/\s+/).filter(Boolean);
const ofNumbers = (line) => words(line).every((word) => isNumber(plain(word)));

// A number with a decimal comma with a point; as it is where the comma may part thousands.
const decimal = (cell) => (DECIMAL.test(cell) ? cell.replace(",", ".") : cell);

// Brackets

// Rows on lines in one pair of round brackets, or each in its own, and a list in one, without them; any other text as
// it is.
function opened(text) {
  const inner = text.slice(1, -1).trim();
  if (text[0] === "(" && closesAtEnd(text)) {
    if (inner[0] === "[" && closesAtEnd(inner)) return inner;
    return areRows(lines(inner)) ? inner : text;
  }
  const each = lines(text).map((line) => line.trim());
  if (!each.length || !each.every((line) => line[0] === "(" && closesAtEnd(line))) return text;
  const inside = each.map((line) => line.slice(1, -1).trim());
  return inside[0].includes(" ") && areRows(inside) ? inside.join("\n") : text;
}

// Whether the round bracket that a text begins with is a part of its first entry.
function beginsACell(text) {
  const end = endOf(text);
  const inner = text.slice(1, Math.max(end, 1));
  return text[0] === "(" && end < text.length - 1 && !/[,;\n]/.test(inner);
}

// Whether lines of entries without commas are the rows of a matrix, not a formula's.
function areRows(given) {
  const kept = given.filter((line) => line.trim());
  if (kept.some((line) => line.includes(",") || line.includes(";") || CONTINUED.test(line)))
    return false;
  const rows = kept.map(split);
  if (new Set(rows.map((row) => row.length)).size !== 1) return false;
  if (rows.length === 1 && rows[0].length === 1) return false;
  return kept.every(ofNumbers) || (rows.length > 1 && rows[0].length > 1);
}

// An error where something is done to a list after it is closed.
function untouched(text) {
  const end = endOf(text);
  const after = text.slice(end + 1);
  if (/[0-9][\s,;\]]/.test(text.slice(0, end)) && TAKEN.test(after))
    throw beside(after.replace(/^[ )]+/, ""));
}

// Nested lists, tuples or MATLAB's one bracket with semicolons.
function bracketed(text) {
  const items = itemsOf(text);
  if (items.every(isList)) {
    const inner = items.map(itemsOf);
    if (!inner.some((row) => row.some(isList))) return inner;
    const single = (cell) => (isList(cell) && itemsOf(cell).length === 1 ? itemsOf(cell)[0] : cell);
    const flat = inner.map((row) => row.map(single));
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

// Where the bracket that a text begins with is closed, -1 where it is not.
function endOf(text) {
  let depth = 0;
  for (let k = 0; k < text.length; k++) {
    depth += deeper(text[k]);
    if (!depth) return k;
  }
  return -1;
}

const closesAtEnd = (text) => text !== "" && endOf(text) === text.length - 1;

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
  const numerals = text.trim().split(/\s+/);
  if (numerals.every(isNumber)) return numerals;
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
  if (piece.trim()) pieces.push(piece);
  return pieces.filter((one) => comma || one.trim()).map((one) => stripped(one.trim(), "'\""));
}

// Whether the blank at k stands beside a sign that joins its neighbours: "a - b" is one cell, "a -b" are two, and so
// are a joint's variable that is marked by a star and what follows it. A star at the end marks a joint's variable, or
// is one.
function joins(text, k) {
  const [before, after] = [text.slice(0, k).trimEnd(), text.slice(k).trim()];
  if (after === "*") return STARRED.test(`${before}*`);
  if (before.endsWith("*") && after && !"*/^)=".includes(after[0])) {
    if (SLIDING.test(before) && number(after.split(/\s/)[0]) !== null) return false;
    if (STARRED.test(before)) return false;
  }
  if (!before || !after || "+-*/^=(".includes(before.at(-1)) || "*/^)=".includes(after[0]))
    return true;
  return (
    ("+-".includes(after[0]) && after.length > 1 && /\s/.test(after[1])) ||
    DEGREES.test(after) ||
    ("0123456789.)".includes(before.at(-1)) && RADIANS.test(after))
  );
}

// Lines

function typedLines(text) {
  const scale = SCALE.exec(text);
  text = text.replace(new RegExp(SCALE, "gm"), "");
  const tables = text.split(MATLAB_BLOCK).map(block).filter((table) => table.length); // prettier-ignore
  const counts = [...new Set(tables.map((table) => table.length))].sort((p, q) => p - q);
  if (counts.length > 1) {
    throw new ArmError(
      `the blocks of columns have ${counts.join(", ")} rows; expected as many in each`,
    );
  }
  const rows = (tables[0] ?? []).map((_, i) => tables.flatMap((table) => table[i]));
  return scale
    ? rows.map((row) => row.map((cell) => (number(cell) ? `${cell}*${scale[1]}` : cell)))
    : rows;
}

function block(text) {
  const kept = unnumbered(
    lines(text)
      .filter((line) => line.trim() && !RULE.test(line))
      .filter((line) => !/^\s*[\p{L}\p{N}_]+\s*=\s*$/u.test(line)),
  );
  const parts = (sign) => kept.some((line) => strippedEnd(line.trim(), ";").includes(sign));
  const separator = ["\t", ";"].find(parts);
  if (separator) {
    const end = (line) => strippedEnd(stripped(line, "\r\n "), separator);
    return pointedRows(kept.map((line) => end(line).split(separator)));
  }
  const plainly = kept.map((line) => line.replace(QUOTED, ofQuotes).replace(/\s*;\s*$/, ""));
  if (plainly.some(topComma)) return byCommas(plainly);
  const inside = plainly.map((line) => line.replace(/^\s*[[|⎡⎢⎣⎛⎜⎝]+|[\]|⎤⎥⎦⎞⎟⎠]+\s*$/g, ""));
  const rows = inside.map(split);
  const uneven = new Set(rows.map((row) => row.length)).size > 1;
  const torn = rows.some((row) => row.some((cell) => isFunction(cell.replace(/^[-+]+/, ""))));
  return (uneven || torn ? byGaps(inside) : null) ?? rows;
}

// Lines without the numbers "1)", "1:" or "Joint 1:" before them; an error where a dash before each may be a minus
// sign.
function unnumbered(kept) {
  if (kept.length > 1 && kept.every((line) => BULLET.test(line))) {
    const given = shown(kept[0].trim());
    throw new ArmError(`each line begins like ${given}; expected rows without a dash before them`);
  }
  const counted = kept.every((line, k) => Number(NUMBERED.exec(line)?.[1]) === k + 1);
  return counted ? kept.map((line) => line.replace(NUMBERED, "")) : kept;
}

// A number in quotes with a point for its decimal comma.
function ofQuotes(quoted) {
  const inner = quoted.slice(1, -1).trim();
  if (EITHER.test(inner)) throw eitherOf(inner, shown(inner));
  const found = pointed(inner);
  return isNumber(found) ? found : quoted;
}

// Cells that stand two blanks apart or more, which single ones do not part, where each line has as many; null where
// not.
function byGaps(kept) {
  const rows = kept.map((line) => apart(line.trim()).split("\t"));
  return rows.length && rows[0].length > 1 && rows.every((row) => row.length === rows[0].length)
    ? rows
    : null;
}

// A text with a tab for each run of blanks within a line.
export const apart = (text) => text.replace(GAP, "\t");

// Commas part cells, unless they are decimal ones: then blanks do. An error where both may be meant.
function byCommas(kept) {
  const dotted = kept.map((line) => line.replaceAll(",", "."));
  const byBlank = dotted.map(split);
  if (kept.every((line) => /^\s*(?:-?\d+(?:,\d+)?(?:\s+|$)){2,}$/.test(line))) return byBlank;
  if (kept.every((line) => (line.match(TIGHT) ?? []).length === line.split(",").length - 1)) {
    const rows = byGaps(dotted);
    if (rows) return rows;
    const even = new Set(byBlank.map((row) => row.length)).size === 1;
    if (byBlank.every((row) => row.length > 1)) {
      if (even && kept.some((line) => JUXTAPOSED.test(line))) return byBlank;
      const given = shown(kept.find((line) => line.includes(",")).trim());
      throw new ArmError(`a line is ${given}; expected decimal points, or commas between entries`);
    }
  }
  return kept.map((line) => split(strippedEnd(line, ",")));
}

// Cells with points for decimal commas; an error where a comma may part thousands.
function pointedRows(rows) {
  const found = rows.map((row) => row.map(pointed));
  const texts = rows.flat().map((cell) => stripped(cell.trim(), '"'));
  const either = texts.find((text) => EITHER.test(text));
  const point = texts.find((text) => /[0-9]\.[0-9]/.test(text));
  if (either && point && !DOTTED_THOUSANDS.test(point))
    throw eitherOf(either, `${shown(either)} beside ${shown(point)}`);
  return found;
}

// What is said of a comma that may be a decimal one or part thousands.
const eitherOf = (cell, given) =>
  new ArmError(
    `a cell is ${given}; expected ${cell.replace(",", ".")} or ${cell.replace(",", "")}`,
  );

// A cell with a decimal comma written with a point, and without a spreadsheet's quotes or sign of equality.
function pointed(cell) {
  const inner = cell.trim();
  if (inner[0] === '"' && inner.at(-1) === '"') cell = inner.slice(1, -1);
  cell = cell.replace(/^[ \t]*=/, "");
  if (/^\s*[-+−]?,[0-9]+\s*$/.test(cell)) return cell.replace(",", ".");
  if (THOUSANDS.test(cell.trim())) return cell.replaceAll(",", "");
  if (DOTTED_THOUSANDS.test(cell.trim())) return cell.replaceAll(".", "").replace(",", ".");
  return cell.split(",").length === 2 && !cell.includes("(")
    ? cell.replace(/(?<=\d),(?=\d)/g, ".")
    : cell;
}

// Whether every cell is a number without symbols.
const numeric = (rows) => rows.every((row) => row.every((cell) => number(cell) !== null));

// The rows without the first if it is a header: names where numbers follow.
export function withoutHeader(rows) {
  const [first, ...rest] = rows;
  const heads = first.map(plain).filter(Boolean);
  if (!rest.length || heads.some(isEntry)) return rows;
  const unnamed = rest.map((row) => row.slice(1));
  if (!first[0] && heads.length === first.length - 1 && labelRows(rest) && numeric(unnamed))
    return unnamed;
  return numeric(rest) ? rest : rows;
}

// Whether a word is a number, looks like one, or is a formula that no column is named by.
function isEntry(word) {
  if (number(word) !== null || NO_HEAD.test(word) || isFunction(word.replace(/^[-+]+/, "")))
    return true;
  const parts = [];
  try {
    parts.push(parse(word));
  } catch (error) {
    if (error instanceof ArmError) return false;
    throw error;
  }
  if (parts[0][0] === "neg") return true;
  for (const part of parts) parts.push(...part.filter(Array.isArray)); // grows by its own parts
  return parts.some((part) => part[0] === "call");
}

// Whether the first cells are different names, or count the rows.
function labelRows(rows) {
  const labels = rows.map((row) => row[0]);
  if (
    labels.every((label, k) => label === `${k}`) ||
    labels.every((label, k) => label === `${k + 1}`)
  )
    return true;
  return (
    new Set(labels).size === labels.length &&
    labels.every((label) => label && number(label) === null)
  );
}
