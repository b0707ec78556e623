// Lines of entries as they are typed or printed, with blanks, commas, tabs or semicolons between
// them.

import { topComma } from "./brackets.js";
import { pointedRows, unquotedNumbers } from "./commas.js";
import { isFunction, number } from "./formula.js";
import { split } from "./split.js";
import { lines, stripped, strippedEnd } from "./text.js";
import { ArmError, shown } from "../sentences.js";

// MATLAB's head "1.0e+03 *", and "Columns 1 through 6" above a part of a wide matrix.
const SCALE = /^\s*(1(?:\.0+)?e[+-]?\d+)\s*\*\s*$/m;

const MATLAB_BLOCK = /^\s*Columns?\s+\d+(?:\s+(?:through|to|and)\s+\d+)?\s*:?\s*$/im;
// A line that is only drawn.
const RULE = /^\s*\|?[\s:|+=_-]*[-=_]{2,}[\s:|+=_-]*\|?\s*$/;

const NUMBERED = /^\s*(?:(?:joint|link|row)\s*([0-9]+)\s*[:)=]?|([0-9]+)[:)])\s+/i;
const BULLET = /^\s*[-–—]\s/;
// Two blanks or more within a line.
const GAP = /(?<=[^ \u00a0\t\n])[ \u00a0]{2,}(?=[^ \u00a0\t\n])/g;

// Commas between digits, which may be decimal ones; and numbers beside each other with a blank
// between them.
const TIGHT = /(?<![0-9.,])[0-9]+,[0-9]+(?![0-9.,])/g;

const JUXTAPOSED = /[0-9.]\s+[.0-9]/;

export function typedLines(text) {
  const scale = SCALE.exec(text);
  text = text.replace(new RegExp(SCALE, "gm"), "");
  const tables = text
    .split(MATLAB_BLOCK)
    .map(block)
    .filter((table) => table.length);
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

// a matrix's bracket, line by line; no unit's
const DRAWN = /^\s*[[|⎡⎢⎣⎛⎜⎝]+/;
const DRAWN_END = /(?<!\[[^\]]*)[\]|⎤⎥⎦⎞⎟⎠]+\s*$/;
const NAME_ALONE = /^\s*[\p{L}\p{N}_]+\s*=\s*$/u;

function block(text) {
  const filled = lines(text).filter((line) => line.trim() && !RULE.test(line));
  const kept = unnumbered(filled.filter((line) => !NAME_ALONE.test(line)));
  const separator = ["\t", ";"].find((sign) =>
    kept.some((line) => strippedEnd(line.trim(), ";").includes(sign)),
  );
  return separator ? bySeparator(kept, separator) : byBlanksOrCommas(kept);
}

function bySeparator(kept, separator) {
  const end = (line) => strippedEnd(stripped(line, "\r\n "), separator);
  return pointedRows(kept.map((line) => end(line).split(separator)));
}

// Single blanks part the entries, unless that leaves rows of several lengths, or a function without
// its argument.
function byBlanksOrCommas(kept) {
  const plainly = kept.map((line) => unquotedNumbers(line).replace(/\s*;\s*$/, ""));
  if (plainly.some(topComma)) return byCommas(plainly);
  const inside = plainly.map((line) => line.replace(DRAWN, "").replace(DRAWN_END, ""));
  const rows = inside.map(split);
  const torn = rows.flat().some((cell) => isFunction(cell.replace(/^[-+]+/, "")));
  return (torn || uneven(rows) ? byGaps(inside) : null) ?? rows;
}

const uneven = (rows) => new Set(rows.map((row) => row.length)).size > 1;

// Lines without the numbers "1)", "1:" or "Joint 1:" before them; an error where a dash before each
// may be a minus sign.
function unnumbered(kept) {
  if (kept.length > 1 && kept.every((line) => BULLET.test(line))) {
    const given = shown(kept[0].trim());
    throw new ArmError(`each line begins like ${given}; expected rows without a dash before them`);
  }
  const counted = kept.every((line, k) => {
    const [, labelled, bare] = NUMBERED.exec(line) ?? [];
    return Number(labelled ?? bare) === k + 1;
  });
  return counted ? kept.map((line) => line.replace(NUMBERED, "")) : kept;
}

// Cells that stand two blanks apart or more, which single ones do not part, where each line has as
// many; null where not.
function byGaps(kept) {
  const rows = kept.map((line) => line.trim().split(GAP));
  return rows.length && rows[0].length > 1 && rows.every((row) => row.length === rows[0].length)
    ? rows
    : null;
}

// Commas part cells, unless they are decimal ones: then blanks do. An error where both may be
// meant.
function byCommas(kept) {
  if (kept.length > 1 && kept.every((line) => ALONE.test(line))) return oneColumn(kept);
  const dotted = kept.map((line) => line.replaceAll(",", "."));
  if (kept.every((line) => /^\s*(?:-?\d+(?:,\d+)?(?:\s+|$)){2,}$/.test(line)))
    return dotted.map(split);
  const rows = kept.every(onlyTight) ? byDecimalCommas(kept, dotted) : null;
  return rows ?? kept.map((line) => split(strippedEnd(line, ",")));
}

const ALONE = /^\s*[-+−]?\d+(?:,\d+)?\s*$/;

// Lines of one number each with a decimal comma; an error where two whole numbers may be meant.
function oneColumn(kept) {
  const sizes = kept.map((line) => line.trim().split(",")[1]?.length ?? 0);
  const even = sizes[0] > 2 && sizes.every((size) => size === sizes[0]);
  if (!even && !kept.some((line) => /^[^,]*$|,0\d|,\d{4}|-0,/.test(line.trim())))
    throw undecided(kept[0]);
  return kept.map((line) => [line.trim().replace(",", ".")]);
}

const undecided = (line) =>
  new ArmError(
    `a line is ${shown(line.trim())}; expected decimal points, or a blank after a comma that parts`,
  );

const onlyTight = (line) => (line.match(TIGHT) ?? []).length === line.split(",").length - 1;

// The rows where each comma stands between digits, null where blanks part nothing.
function byDecimalCommas(kept, dotted) {
  const rows = byGaps(dotted);
  if (rows) return rows;
  const byBlank = dotted.map(split);
  if (!byBlank.every((row) => row.length > 1)) return null;
  if (!uneven(byBlank) && kept.some((line) => JUXTAPOSED.test(line))) return byBlank;
  throw undecided(kept.find((line) => line.includes(",")));
}
