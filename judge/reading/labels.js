// What stands beside numbers: names of joints, of rows, and plain counts. They order an answer.

import { plain } from "./formula.js";

const ROWS = ["vx", "vy", "vz", "wx", "wy", "wz"];
const DOTTED = { ẋ: "vx", ẏ: "vy", ż: "vz" };
const JOINT =
  /^(?:q|th|theta|tau|τ|[tgjalc]|joint|panda_?joint|fr3_?joint|axis|link|row|col(?:umn)?|torque)$/;
const ORDINALS = ["first", "second", "third", "fourth", "fifth", "sixth", "seventh"];
// As the driver of a UR10e and its pendant call them.
const UR = [
  /^(?:shoulder_?pan.*|base)$/,
  /^(?:shoulder_?lift.*|shoulder)$/,
  /^elbow(?:_?joint)?$/,
  /^wrist_?1(?:_?joint)?$/,
  /^wrist_?2(?:_?joint)?$/,
  /^wrist_?3(?:_?joint)?$/,
];

/**
 * What a label says: "row" and which of vx ... wz, "joint" and its number, or "count" and how far.
 * @param {string} text
 * @returns {{ kind: string, at: number } | null}
 */
function labelOf(text) {
  const word = simple(text);
  const row = ROWS.indexOf(word.replace(/^omega/, "w").replace(/[_.]/g, ""));
  if (row >= 0) return { kind: "row", at: row };
  const ur = UR.findIndex((is) => is.test(word));
  if (ur >= 0) return { kind: "joint", at: ur + 1 };
  const ordinal = ORDINALS.findIndex((one) => word.startsWith(`the${one}`) || word.startsWith(one));
  if (ordinal >= 0) return { kind: "joint", at: ordinal + 1 };
  const [, stem, number] = /^([^\d]*?)_?(\d{1,5})(?:_?joint)?$/.exec(word) ?? [];
  if (number === undefined) return null;
  return { kind: JOINT.test(stem) ? "joint" : "count", at: Number(number) };
}

const simple = (text) =>
  plain([...text].map((sign) => DOTTED[sign] ?? sign).join(""))
    .toLowerCase()
    .replace(/\(t\)|[([](?:deg|rad|nm|n m|m|mm|°)[^)\]]*[)\]]|\/(?:s|deg|rad|nm)$/g, "")
    .replace(/[\s"'{}^\\*#:=()[\]|.,&-]/g, "")
    .replace(/deg$/, "");

// The label that words end with, "ωx" of "Émilie: ωx"; null where none does.
export function labelIn(words) {
  for (let from = 0; from < words.length; from++) {
    const found = labelOf(words.slice(from).join(" "));
    if (found) return found;
  }
  return null;
}
