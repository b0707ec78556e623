// The ways to write a table down, each as rows of cells and the heads above them.

import { number } from "./formula.js";
import { headOf } from "./heads.js";
import { ENTRIES } from "./table_rows.js";
import { ArmError, say } from "../sentences.js";

const MOST_ROWS = 32;

// Link(...) and its kin; a = [...] for a column; { ... } or dict(...) for a row; and a_1 = ...
const LETTER = String.raw`[\p{L}\p{N}_]`;

const LINK = new RegExp(
  String.raw`((?<![A-Za-z])(?:DH)?Link|(?:Revolute|Prismatic)${LETTER}*)` +
    String.raw`\s*\(((?:[^()]|\([^()]*\))*)\)`,
  "gu",
);

const LISTS = new RegExp(
  String.raw`(?:^|[{,(])\s*['"]?([A-Za-z_]${LETTER}*|[αθ])['"]?\s*[=:]\s*` +
    String.raw`(?:np\.array|array|sp\.Matrix|Matrix)?\s*\(?\s*(\[[^\]]*\]|\{[^}]*\})`,
  "gmu",
);

const RECORDS = new RegExp(
  String.raw`\{((?:[^{}]|\{[^{}:=,]*\})*)\}|(?<!${LETTER})dict\(((?:[^()]|\([^()]*\))*)\)`,
  "gu",
);

const NAME = String.raw`[A-Za-zαθ]+(?:_(?:deg|rad|mm|cm|m)|_?[({]?\s*i\s*(?:-\s*1)?\s*[)}]?)?`;
const RECORD = new RegExp(
  String.raw`['"]?(?<![A-Za-zαθ])(${NAME})['"]?\s*[:=]\s*((?:(?!\s${NAME}\s*[:=])[^,;[])+)`,
  "g",
);

/**
 * Rows of cells; `parts` of the text that hold them, `entries` as typed where the cells were put
 * together from them.
 * @typedef {{ cells: string[][], heads: string[], said: string[], parts: string[],
 *   entries?: string[], context?: string, left?: string[] }} Cells
 */

/** @returns {Cells} */
const plainly = (cells, parts, heads = ENTRIES) => ({ cells, parts, heads, said: [] });

const unquoted = (text) => text.trim().replace(/^['"]+|['"]+$/g, "");

/**
 * The cells of a table whose entries have names, in the first such notation that the text is
 * written in, and what else stands there; null where there is none.
 * @returns {Cells | null}
 */
export function named(text) {
  const straight = text.replace(/[“”„‟]/g, '"').replace(/[‘’]/g, "'");
  const found = ofLinks(straight) ?? ofRecords(straight) ?? ofLists(straight);
  return found && { ...found, ...outside(straight, found) };
}

// What of a text stands in none of the parts that were read: lines, and decimals within the parts
// or beside them.
function outside(text, { parts, cells, entries = cells.flat() }) {
  let rest = text;
  for (const part of parts) rest = rest.replace(part, (whole) => whole.replace(/[^\n]+/g, READ));
  const lines = rest.split("\n").filter((line) => !line.includes(READ));
  const beside = rest.split("\n").filter((line) => line.includes(READ));
  const held = new Set(entries.join(" ").match(DECIMAL));
  const decimals = (list) => list.flatMap((part) => part.match(DECIMAL) ?? []);
  const lost = decimals(parts).filter((x) => !held.has(x));
  const told = lines.map((line) => line.trim()).filter((line) => /[\p{L}\d]{2}/u.test(line));
  return { context: lines.join("\n"), left: [...told, ...decimals(beside), ...lost] };
}

const READ = "\u0000";
const DECIMAL = /\d*\.\d+/g;

// A dictionary for each row, {'a': 0, 'alpha': pi/2, ...} or dict(a=0, ...), or a line of pairs.
function ofRecords(text) {
  const braced = [...text.matchAll(RECORDS)].map(([part, list, called]) => [part, list || called]);
  const lines = text.split("\n").map((line) => [line, line]);
  const found = (braced.length ? braced : lines).flatMap(([part, body]) => recordOf(part, body));
  if (found.length < 2) return null;
  const heads = ENTRIES.map((entry) => found[0].row.get(entry)?.name ?? entry);
  const rowOf = ({ row }, k) => ENTRIES.map((entry) => row.get(entry)?.x ?? blank(entry, k + 1));
  return plainly(
    found.map(rowOf),
    found.map(({ part }) => part),
    heads,
  );
}

// A row of pairs, by the column that each name is one of.
function recordOf(part, body = "") {
  const pairs = [...body.matchAll(RECORD)];
  const row = new Map(pairs.map(([, name, x]) => [headOf(name), { name, x: unquoted(x) }]));
  return ENTRIES.filter((entry) => row.has(entry)).length >= 3 ? [{ part, row }] : [];
}

const blank = (entry, i) => (entry === "theta" ? `q_${i}` : "0");

// Four parallel lists, or three.
function ofLists(text) {
  const matches = [...text.matchAll(LISTS)];
  /** @type {[string, string][]} */
  const found = matches.map(([, name, body]) => [headOf(name) ?? "", body]);
  if (found.length < 3 || !found.every(([word]) => ENTRIES.includes(word))) return null;
  const named = new Map(found);
  const lists = [...named.values()].map(listIn);
  const counts = [...new Set(lists.map((list) => list.length))].sort((p, q) => p - q);
  if (counts.length !== 1) throw new ArmError(say("uneven lists", { counts: counts.join(", ") }));
  const rows = lists[0].map((_, k) => lists.map((list) => list[k]));
  const parts = matches.map(([part]) => part);
  return plainly(rows, parts, [...named.keys()]);
}

// The entries of a list in brackets; commas part them, else blanks.
const listIn = (body) => {
  const inner = body.slice(1, -1).trim();
  const entries = inner.split(/[,;\n]/.test(inner) ? /[,;\n]+/ : /\s+/);
  return entries.map(unquoted).filter(Boolean);
};

// Link('d', 0.3, 'a', 0, 'alpha', pi/2), Link([theta d a alpha sigma]) and RevoluteDH(d=0.3, ...).
function ofLinks(text) {
  const matches = [...text.matchAll(LINK)];
  const links = matches.map(([, kind, body]) => linkOf(kind, body));
  if (!links.length) return null;
  const cells = links.map(({ row, slides }, k) => {
    const moves = slides ? "d" : "theta";
    const still = number(row[moves]) ? row[moves] : row.offset;
    return ENTRIES.map((entry) => (entry === moves ? `q_${k + 1} + (${still})` : row[entry]));
  });
  const entries = links.flatMap(({ given }) => given);
  const parts = matches.map(([part]) => part);
  return { ...plainly(cells, parts), said: [say("taken: links")], entries };
}

function linkOf(kind, body) {
  const none = { a: "0", alpha: "0", d: "0", theta: "0", offset: "0" };
  if (body.trim().startsWith("[")) {
    const entries = listIn(`${body.trim().split("]")[0]}]`);
    const named = ["theta", "d", "a", "alpha", "sigma", "offset"].slice(0, entries.length);
    const row = { ...none, ...Object.fromEntries(named.map((name, i) => [name, entries[i]])) };
    const given = entries.slice(0, named.length);
    return { row, slides: entries.length > 4 && number(entries[4]) === 1, given };
  }
  const pairs = body.matchAll(
    /['"]?(?<![\p{L}\p{N}_])(a|alpha|d|theta|offset)['"]?\s*[,=]\s*([^,]+)/gu,
  );
  const given = Object.fromEntries([...pairs].map(([, name, x]) => [name, x.trim()]));
  const sigma = /sigma['"]?\s*[,=]\s*[01]/.exec(body) ?? [];
  const slides =
    `${kind}${body}`.toLowerCase().includes("prismatic") ||
    ("theta" in given && !("d" in given)) ||
    sigma.some((said) => said.endsWith("1"));
  return { row: { ...none, ...given }, slides, given: [...Object.values(given), ...sigma] };
}

export function few(count) {
  if (count > MOST_ROWS) throw new ArmError(say("many rows", { count, most: MOST_ROWS }));
}
