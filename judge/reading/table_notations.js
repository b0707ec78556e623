// The ways to write a table down, each as rows of cells and the heads above them.

import { number } from "./formula.js";
import { cells as cellsOf } from "./grid.js";
import { straight } from "./surroundings.js";
import { lines } from "./text.js";
import { columnOf, headOf } from "./heads.js";
import { ENTRIES } from "./table_rows.js";
import { ArmError, say } from "../sentences.js";

const MOST_ROWS = 32;
const LABELLED = /^([ \t|]*)(?:joint|link|axis)[ \t]+(?=\d+\b)/gim;

// Link(...) and its kin; a = [...] for a column; { ... } or dict(...) for a row; and a_1 = ...
const LETTER = String.raw`[\p{L}\p{N}_]`;

const BOX = /^[^\n]*│[^\n]*(?:\n[^\n]*[│├┼╪][^\n]*)*/m; // a table drawn with lines

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

const RECORD = /['"]?([A-Za-zαθ]+)['"]?\s*[:=]\s*((?:(?!\s[A-Za-zαθ]+\s*[:=])[^,;[])+)/g;

const PAIRS = new RegExp(
  String.raw`['"]?(?<!${LETTER})([A-Za-z]+)_?\{?(\d+)\}?['"]?\s*[:=]\s*((?:[^,;\n{}]|\{[^{}]*\})+)`,
  "gu",
);

// A cell below a head that holds only a unit.
const UNIT = /^[(\[]?\s*(?:(mm|cm|m|in|deg|degrees|rad|radians|°)|[-–—]?)\s*[)\]]?$/i;

/**
 * Rows of cells; `entries` as typed where the cells were put together from them.
 * @typedef {{ cells: string[][], heads: string[], said: string[], entries?: string[] }} Cells
 */

/** @returns {Cells} */
const plainly = (cells, heads = ENTRIES) => ({ cells, heads, said: [] });

const unquoted = (text) => text.trim().replace(/^['"]+|['"]+$/g, "");

/**
 * The cells of a table, in the first notation that the text is written in.
 * @returns {Cells}
 */
export function ofText(typed) {
  const text = unboxed(straight(typed));
  return ofLinks(text) ?? ofRecords(text) ?? ofLists(text) ?? ofPairs(text) ?? ofRows(text);
}

/** @returns {Cells} */
function ofRows(text) {
  const rows = cellsOf(text.replace(/^\s*#/, "").replace(LABELLED, "$1"));
  // A caption may stand above the heads.
  const at = rows.slice(0, 3).findIndex(isHeading);
  return at < 0 ? plainly(rows, []) : below(withUnits(rows[at]), rows.slice(at + 1));
}

// The rows below the heads; one of units goes to the heads.
function below(heads, rows) {
  const units = (rows[0] ?? []).map((cell) => UNIT.exec(cell));
  const last = heads.length - units.length; // a spreadsheet's last cell may be empty
  if (![0, 1].includes(last) || !units.every(Boolean) || !units.some((unit) => unit?.[1]))
    return plainly(rows, heads);
  return plainly(
    rows.slice(1),
    heads.map((head, k) => (units[k]?.[1] ? `${head} (${units[k][1]})` : head)),
  );
}

const isHeading = (row) =>
  new Set(row.map(headOf).filter((word) => ENTRIES.includes(word))).size >= 3;

// The heads with a unit that stands apart, as in "a (mm)", joined to its own.
const withUnits = (heads) =>
  heads.reduce(
    (found, head) =>
      found.length && /^[([].*[)\]]$/.test(head)
        ? [...found.slice(0, -1), `${found.at(-1)} ${head}`]
        : [...found, head],
    [],
  );

// The first table drawn with lines, as robotics toolboxes print it, with plain bars.
function unboxed(text) {
  const box = BOX.exec(text);
  if (!box) return text;
  const rows = box[0].split("\n").filter((line) => line.includes("│"));
  return rows.join("\n").replaceAll("│", "|").replaceAll("⍺", "α").replaceAll("ⱼ", "");
}

// A dictionary for each row, {'a': 0, 'alpha': pi/2, ...} or dict(a=0, ...), or a line of pairs.
function ofRecords(text) {
  const braced = [...text.matchAll(RECORDS)].map(([, list, called]) => list || called || "");
  const found = (braced.length ? braced : lines(text)).flatMap(recordOf);
  if (found.length < 2) return null;
  const rowOf = (row, k) => ENTRIES.map((entry) => row.get(entry) ?? blank(entry, k + 1));
  return plainly(found.map(rowOf));
}

function recordOf(body) {
  const pairs = [...body.matchAll(RECORD)];
  const row = new Map(pairs.map(([, name, x]) => [headOf(name), unquoted(x)]));
  return ENTRIES.filter((entry) => row.has(entry)).length >= 3 ? [row] : [];
}

const blank = (entry, i) => (entry === "theta" ? `q_${i}` : "0");

// Four parallel lists, or three.
function ofLists(text) {
  /** @type {[string, string][]} */
  const found = [...text.matchAll(LISTS)].map(([, name, body]) => [headOf(name) ?? "", body]);
  if (found.length < 3 || !found.every(([word]) => ENTRIES.includes(word))) return null;
  const named = new Map(found);
  const lists = [...named.values()].map((body) => cellsOf(`[${body.slice(1, -1)}]`)[0]);
  const counts = [...new Set(lists.map((list) => list.length))].sort((p, q) => p - q);
  if (counts.length !== 1) throw new ArmError(say("uneven lists", { counts: counts.join(", ") }));
  const rows = lists[0].map((_, k) => lists.map((list) => list[k]));
  return plainly(rows, [...named.keys()]);
}

// Entries by column and number, d_1 = 0.333.
function ofPairs(text) {
  const found = [...text.matchAll(PAIRS)].map(([, name, i, x]) => ({
    column: columnOf(name),
    i: Number(i),
    text: unquoted(x),
  }));
  const all = found.length >= 6 && found.every(({ column }) => column !== undefined);
  return all && !text.trimStart().startsWith("|") ? byNumber(found) : null;
}

// a_0 and alpha_0 tell Craig's convention, whose row i has a_{i-1} and alpha_{i-1}: a last one with
// nothing else in it is the tool's.
function byNumber(entries) {
  const early = (column) => column === "a" || column === "alpha";
  const craig = entries.some(({ column, i }) => early(column) && i === 0);
  const row = ({ column, i }) => (craig && early(column) ? i + 1 : i);
  const held = new Map(entries.map((one) => [`${one.column} ${row(one)}`, one.text]));
  const last = Math.max(0, ...entries.map(row));
  few(last);
  const others = entries.filter(({ column }) => column === "d" || column === "theta");
  const moving = craig && others.length ? Math.max(...others.map(({ i }) => i)) : last;
  const missing = (entry, i) => (i > moving ? "0" : blank(entry, i));
  const cells = Array.from({ length: last }, (_, k) =>
    ENTRIES.map((entry) => held.get(`${entry} ${k + 1}`) ?? missing(entry, k + 1)),
  );
  return plainly(cells, craig ? ["a_{i-1}", "alpha_{i-1}", "d", "theta"] : ENTRIES);
}

// Link('d', 0.3, 'a', 0, 'alpha', pi/2), Link([theta d a alpha sigma]) and RevoluteDH(d=0.3, ...).
function ofLinks(text) {
  const links = [...text.matchAll(LINK)].map(([, kind, body]) => linkOf(kind, body));
  if (!links.length) return null;
  const cells = links.map(({ row, slides }, k) => {
    const moves = slides ? "d" : "theta";
    const still = number(row[moves]) ? row[moves] : row.offset;
    return ENTRIES.map((entry) => (entry === moves ? `q_${k + 1} + (${still})` : row[entry]));
  });
  const entries = links.flatMap(({ given }) => given);
  return { ...plainly(cells), said: [say("taken: links")], entries };
}

function linkOf(kind, body) {
  const none = { a: "0", alpha: "0", d: "0", theta: "0", offset: "0" };
  if (body.trim().startsWith("[")) {
    const entries = cellsOf(`${body.split("]")[0]}]`)[0];
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
