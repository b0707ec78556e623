// What heads of a table's columns say.

import { plain } from "./formula.js";

const meaning = (words, entry) => words.split(" ").map((word) => [word, entry]);

/** @type {Map<string, string>} */
const WORDS = new Map([
  ...meaning("theta th q jointangle angle tht thetai qi thi", "theta"),
  ...meaning("d offset linkoffset di dm dmm", "d"),
  ...meaning("a r linklength length ai ri aprev", "a"),
  ...meaning("alpha twist linktwist alphai al alp alphaprev", "alpha"),
  ...meaning("i link joint j n frame row # no linki jointi k", "i"),
]);

// Which entry a head names, or "i" for the rows' numbers.
export function headOf(cell) {
  const words = plain(cell.replace(/-\s*1/g, "")).replaceAll("*", "");
  const word = words
    .replace(/\(.*?\)|\[.*?(?:\]|$)|\bin\b.*|[,/].*|_(?:mm|cm|deg|rad)$/g, "")
    .replace(/[\s_{}$\\^'"().]/g, "")
    .toLowerCase();
  const last = words.split(/\s+/).at(-1).toLowerCase(); // "Link length a"
  return WORDS.get(word) ?? WORDS.get(word.replace(/[ijkn]$/, "")) ?? WORDS.get(last);
}

export function fromHeads(heads) {
  const text = heads.join(" ");
  const unit = ["mm", "cm"].find((u) => new RegExp(String.raw`[(\[ /_]${u}\b`).test(text));
  const own =
    ["m", "in"].find((u) =>
      new RegExp(String.raw`[(\[]\s*${u}\s*(?:[)\]]|$)|/${u}\b`).test(text),
    ) ?? null;
  const angles = /deg|°/i.test(text) ? "deg" : /(?:\b|_)rad/.test(text) ? "rad" : null;
  return { lengths: unit ?? own, angles, convention: /-\s*1|prev/.test(text) ? "craig" : null };
}
