// Reads labels of numbers, such as "joint 2", "vx" of a Jacobian's row, and the count "3.". The
// answer is ordered by its labels.

import { hasDecimals, plain } from "./formula.js";

const ROWS = ["vx", "vy", "vz", "wx", "wy", "wz"];
const DOTTED = { ẋ: "vx", ẏ: "vy", ż: "vz" };
const JOINT_STEM =
  /^(?:q|d|th(?:eta)?|tau|τ|[tgjalc]|[\p{L}\d]*joint|link|column|angle|torque|axis|motor)$/u;
const ORDINALS = ["first", "second", "third", "fourth", "fifth", "sixth", "seventh"];
// Names of joints in the driver of a Universal Robot and on its pendant.
const UR_JOINTS = new Map(
  [
    ["base", "shoulderpan"],
    ["shoulder", "shoulderlift"],
    ["elbow"],
    ["wrist1"],
    ["wrist2"],
    ["wrist3"],
  ].flatMap((words, k) => words.map((word) => [word, k + 1])),
);

// J(1,:) is no column of a joint, and q^(1) is all of solution 1.
const NO_JOINT = /[[({]\d{1,2}, ?:[\])}] ?=?$|^\p{L}+\^\{?\(\d{1,2}\)/u;

/**
 * A label of the kind "row", "joint" or "count". Rows count from 0, joints from 1.
 * @typedef {{ kind: string, number: number }} Label
 */

/**
 * Parse a text as a label. Return null if it is no label.
 * @param {string} text
 * @returns {Label | null}
 */
function parseLabel(text) {
  if (hasDecimals(text)) return null;
  const word = simplifyLabel(text);
  const row = ROWS.indexOf(word.replace("omega", "w").replace(/^([xyz])dot$/, "v$1"));
  if (row >= 0) return { kind: "row", number: row };
  const urJoint = UR_JOINTS.get(word.replace(/joint$/, ""));
  const start = word.replace(/^the/, "");
  const ordinal = ORDINALS.findIndex((name) => start.startsWith(name));
  if (urJoint || ordinal >= 0) return { kind: "joint", number: urJoint ?? ordinal + 1 };
  const [, stem, digits] = /^(\D*|[\p{L}\d]*joint)(\d{1,5})$/u.exec(word) ?? [];
  if (digits === undefined) return null;
  const isJoint = JOINT_STEM.test(stem) && !NO_JOINT.test(text);
  return { kind: isJoint ? "joint" : "count", number: Number(digits) };
}

const UNIT_END = /(?:1\/s|(?:deg(?:rees?)?|rad(?:ians?)?|nm|mm?)(?:\/(?:s|rad))?|\/rad)$/;

// Remove brackets, punctuation and the unit of a label.
const simplifyLabel = (text) =>
  plain([...text.normalize("NFKC")].map((character) => DOTTED[character] ?? character).join(""))
    .toLowerCase()
    .replace(/(?<=\p{L}[_{]*\d[\d}]*)\^?\{?\(\d\)\}?$/u, "") // q1^(2) of branch 2
    .replace(/[\s"'{}^\\*#:=()[\]|.,&_-]/g, "")
    .replace(UNIT_END, "");

const MOST_WORDS = 8; // a label such as "for the first joint" has no more words

/**
 * Find the label at the end of words, such as "ωx" of "Émilie: ωx". The name of a joint or a row is
 * preferred to a count. Return null if there is no label.
 * @param {{ text: string }[]} words
 */
export function findLabel(words) {
  const texts = words.slice(-MOST_WORDS).map(({ text }) => text);
  const labels = texts.flatMap((_, k) => parseLabel(texts.slice(k).join(" ")) ?? []);
  return labels.find(({ kind }) => kind !== "count") ?? labels[0] ?? null;
}

/**
 * Find the label before a value, as in "then q2 = 0.3". In "q1 = atan2(y, x) = 0.3" it is q1.
 * @param {import("./lines.js").Row} row
 */
export function findValueLabel({ words, name, isAssigned }) {
  const hasFormula = isAssigned && words.at(-1)?.text !== name; // behind the name
  return findLabel(hasFormula ? [{ text: name }] : words);
}

/**
 * Read the labels before rows, and the headers above the first row. A line "rows: vx vy vz" above
 * three rows gives the labels of these rows.
 * @param {import("./lines.js").Row[]} rows
 */
export function readRowLabels(rows) {
  const names = rows[0].above.filter((name) => findLabel([name])?.kind === "row");
  const isListOfRows =
    names.length === rows.length &&
    rows[0].above.some(({ text }) => /^(?:rows?|order)$/i.test(text));
  if (isListOfRows) return { labels: names.map((name) => [name]), headers: [] };
  return { labels: rows.map(({ words }) => words), headers: rows[0].above };
}
