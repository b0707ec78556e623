// The labels beside numbers: names of joints, of rows, and plain counts, which order an answer.

import { hasDecimals, plain } from "./formula.js";
import { readUnits } from "./units.js";

const ROWS = ["vx", "vy", "vz", "wx", "wy", "wz"];
const DOTTED = { ẋ: "vx", ẏ: "vy", ż: "vz" };
const JOINT =
  /^(?:q|d|th(?:eta)?|tau|τ|[tgjalc]|[\p{L}\d]*joint|link|column|angle|torque|axis|motor)$/u;
const ORDINALS = ["first", "second", "third", "fourth", "fifth", "sixth", "seventh"];
// As the driver of a UR10e and its pendant call them.
const UR = new Map(
  [
    ["base", "shoulderpan"],
    ["shoulder", "shoulderlift"],
    ["elbow"],
    ["wrist1"],
    ["wrist2"],
    ["wrist3"],
  ].flatMap((words, k) => words.map((word) => [word, k + 1])),
);

/** @typedef {{ kind: string, number: number }} Label of a row, a joint, or a plain count */

/**
 * Read a label: "row" and which of vx ... wz, "joint" and its number, or "count" and how far.
 * @param {string} text
 * @returns {Label | null}
 */
function labelOf(text) {
  if (hasDecimals(text)) return null;
  const word = simple(text);
  const row = ROWS.indexOf(word.replace("omega", "w").replace(/^([xyz])dot$/, "v$1"));
  if (row >= 0) return { kind: "row", number: row };
  const ur = UR.get(word.replace(/joint$/, ""));
  const ordinal = ORDINALS.findIndex((one) => word.replace(/^the/, "").startsWith(one));
  if (ur || ordinal >= 0) return { kind: "joint", number: ur ?? ordinal + 1 };
  const [, stem, digits] = /^(\D*|[\p{L}\d]*joint)(\d{1,5})$/u.exec(word) ?? [];
  if (digits === undefined) return null;
  return { kind: JOINT.test(stem) ? "joint" : "count", number: Number(digits) };
}

// A label without its unit, brackets and signs.
const simple = (text) =>
  plain([...text.normalize("NFKC")].map((sign) => DOTTED[sign] ?? sign).join(""))
    .toLowerCase()
    .replace(/[([](?:deg|rad|nm|m)[^)\]]*[)\]]|(?:\bm{0,2})?\/(?:s|rad)$/g, "")
    .replace(/[\s"'{}^\\*#:=()[\]|.,&_-]/g, "")
    .replace(/deg$/, "");

const MOST_WORDS = 8; // of a label: "for the first joint"

/**
 * Return the label that words end with, "ωx" of "Émilie: ωx", and "c1", no count, of "Priya: c1";
 * null where none does.
 * @param {{ text: string }[]} words
 */
export function findLabel(words) {
  const texts = words.slice(-MOST_WORDS).map(({ text }) => text);
  const found = texts.flatMap((_, k) => labelOf(texts.slice(k).join(" ")) ?? []);
  return found.find(({ kind }) => kind !== "count") ?? found[0] ?? null;
}

/**
 * Return the label before a value, as in "then q2 = 0.3"; of q1 = atan2(y, x) = 0.3 the first name.
 * @param {import("./lines.js").Row} row
 */
export function findValueLabel({ words, name, isAssigned }) {
  const label = findLabel(words);
  if (!isAssigned || !name || !words.length || (label && label.kind !== "count")) return label;
  return findLabel([{ text: name }]) ?? label;
}

/**
 * Return the words before each row and those above the first. "rows: vx vy vz" above three rows
 * names them.
 * @param {import("./lines.js").Row[]} rows
 */
export function readRowLabels(rows) {
  const [first, ...names] = rows[0].above.filter(({ text }) => !/^(?:order|#+)$/i.test(text));
  const isListOfRows =
    /^rows?$/i.test(first?.text ?? "") &&
    names.length === rows.length &&
    names.every((name) => findLabel([name])?.kind === "row");
  if (isListOfRows) return { labels: names.map((name) => [name]), headers: [] };
  return { labels: rows.map(({ words }) => words), headers: rows[0].above };
}

/**
 * Return whether two lines of words, as "Solutions (deg):", name different units of angles.
 * @param {import("./lines.js").Cell[]} words @param {import("./lines.js").Cell[]} others
 */
export function haveDifferentUnits(words, others) {
  if (words === others) return false;
  const textOf = (cells) => cells.map(({ text }) => text).join(" ");
  const [unit, other] = [words, others].map((cells) => readUnits(textOf(cells)).angles);
  return unit !== null && other !== null && unit !== other;
}
