// What stands around the numbers of a paste and says nothing about them: prompts, comments, fences
// and names.
import { ArmError, shown } from "../sentences.js";

const ANONYMOUS = /@\([^()]*\)\s*|\blambda\s[^:\n]*:\s*/g; // MATLAB's and Python's functions
const COUNTED = /^[ \t]*\[\d+,\][ \t]*/gm; // R's rows
const FENCE = /(?<![^\n])[ \t]*```[^\n\r]*/g;
export const PROMPT = String.raw`(?:>>>?|(?:In|Out) ?\[\d*\]:)`;
const BEGUN = String.raw`(?<![^\n])[ \t]*${PROMPT}[ \t]*`;

const ASKED = new RegExp(
  BEGUN +
    String.raw`(?:[A-Za-z_][A-Za-z0-9_]*|(?:print|disp|display)\([A-Za-z0-9_]*\))[ \t]*(?![^\n\r])`,
  "g",
);

const PROMPTED = new RegExp(BEGUN, "g");
const COMMENT = /((?<![^\n])|[;,\]]|\.\.\.|\\\\)[ \t]*(?:%|#(?![A-Z]+[/!?]))[^\n\r]*/g;
const REMARK = /(?<=[0-9.)])[ \t]+[#%][ \t]*[A-Za-z][^\n\r]*/g; // 50 % 20 % is none
const SIGN = /^[ \t\r\n]*=[ \t]*(?=[[({])/; // of a spreadsheet's array
const CELL_SIGN = /(?<=^|[\t,;|\u00a0])[ \t]*=(?=[-+.\d])/gm; // and of its cells

const FACTOR = new RegExp(
  String.raw`^(?:\\(?:[dt]?frac|cdot|times|ast|sqrt|pi|circ|degree)|[-+*/^0-9.,(){}°]` +
    String.raw`|(?<![A-Za-z])[A-Za-z](?:_[0-9A-Za-z])?(?![A-Za-z]))+$`,
);

// A paste without what only stands around it.
export const bare = (text) =>
  straight(text)
    .replace(FENCE, "")
    .replace(ANONYMOUS, "")
    .replace(COUNTED, "")
    .replace(COMMENT, "$1")
    .replace(REMARK, "")
    .replace(ASKED, "")
    .replace(PROMPTED, "")
    .replace(SIGN, "")
    .replace(CELL_SIGN, "");

// A text with the quotes that programs know, and without byte order marks.
export const straight = (text) =>
  text
    .replace(/[“”„‟]/g, '"')
    .replaceAll("\ufeff", "")
    .replace(/‘([^‘’\n]*)’/g, "'$1'");

// An error where a factor stands beside a matrix: it is meant for every entry.
export function alone(stands, factor) {
  if (FACTOR.test(factor)) throw beside(stands);
}

// What is said where something that matters stands beside a matrix.
export const beside = (stands) =>
  new ArmError(`beside the matrix stands ${shown(stands.trim())}; expected entries that hold it`);
