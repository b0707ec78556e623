// A Denavit-Hartenberg table as people type it: rows in any order of columns, parallel lists,
// dictionaries, Link(...) lines, A matrices. What is not said is guessed, and every guess is told.

import { RAD } from "../geometry/angles.js";
import { straight } from "./surroundings.js";
import { number, parse, plain, symbols, value } from "./formula.js";
import { cells as cellsOf } from "./grid.js";
import { apart } from "./lines.js";
import { ArmError, listed, say, shown, size } from "../sentences.js";

export const ENTRIES = ["a", "alpha", "d", "theta"];
const UNITS = { m: 1, cm: 1e-2, mm: 1e-3, in: 0.0254 };
const MILLIMETRES = 10; // a length this large is no number of metres
const MOST_RADIANS = 2 * Math.PI + 0.1; // an angle this large is no number of radians
const EXCHANGED = { alpha: "theta", theta: "alpha" };
const MOST_ROWS = 32;
const KNOWN_ORDERS = [
  "theta d a alpha",
  "a alpha d theta",
  "alpha a d theta",
  "alpha a theta d",
  "a d alpha theta",
  "d theta a alpha",
  "theta alpha a d",
  "a alpha theta d",
  "theta a d alpha",
  "d a alpha theta",
].map((order) => order.split(" "));
const meaning = (words, entry) => words.split(" ").map((word) => [word, entry]);
/** @type {Map<string, string>} */
const WORDS = new Map([
  ...meaning("theta th q jointangle angle tht thetai qi thi", "theta"),
  ...meaning("d offset linkoffset di dm dmm", "d"),
  ...meaning("a r linklength length ai ri", "a"),
  ...meaning("alpha twist linktwist alphai al alp", "alpha"),
  ...meaning("i link joint j n frame row # no linki jointi k", "i"),
]);
const LETTER = String.raw`[\p{L}\p{N}_]`;
const BOX = /^[^\n]*│[^\n]*(?:\n[^\n]*[│├┼╪][^\n]*)*/m; // a table drawn with lines
const LINK = new RegExp(
  String.raw`((?<![A-Za-z])(?:DH)?Link|(?:Revolute|Prismatic)${LETTER}*)\s*\(((?:[^()]|\([^()]*\))*)\)`,
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
const PAIRS = new RegExp(
  String.raw`['"]?(?<!${LETTER})([A-Za-z]+)_?\{?(\d+)\}?['"]?\s*[:=]\s*((?:[^,;\n{}]|\{[^{}]*\})+)`,
  "gu",
);
const JOINT = /^(?:q|th|theta|t|phi)_?\{?\d+\}?'?$/;
const UNIT = /^[(\[]?\s*(?:(mm|cm|m|in|deg|degrees|rad|radians|°)|[-–—]?)\s*[)\]]?$/i;
const VARIABLE = /^(?:inf|nan|var|variable|\*|-|–|—|\?|q|theta|th|θ|d)\*?$/i;

/** @typedef {import("../geometry/axes.js").Numbers} Numbers */

/**
 * A row as it was meant; its numbers as typed, `radians` for entries with pi or a degree sign in
 * them. The kind is "unknown" where no variable stands in it.
 * @typedef {object} TypedRow
 * @property {string} kind
 * @property {Record<string, number>} numbers
 * @property {Record<string, string>} texts
 * @property {boolean} backwards
 * @property {Set<string>} radians
 * @property {Record<string, any>} [trees] the formulas of its entries; none where they were found
 *   by matrices
 */

/**
 * The rows in the units typed, and what was said or guessed of them; null where nothing was.
 * `exchanged` where the heads of alpha and theta stand over one another's entries, as the joints'
 * variables show.
 * @typedef {{ rows: TypedRow[], lengths: string | null, angles: string | null, convention: string |
 *   null,
 *   said: string[], exchanged?: boolean }} TypedTable
 */

/**
 * The readings of a table, the likeliest first: more than one only where the order of the columns
 * had to be guessed. One whose heads of alpha and theta are exchanged is read too.
 * @param {string} text
 * @param {{ columns?: string, lengths?: string, angles?: string, convention?: string }} options
 * @param {[string, number][]} values of its symbols
 * @returns {TypedTable[]}
 */
export function read(text, { columns, lengths, angles, convention } = {}, values = []) {
  const given = {
    lengths: lengths || null,
    angles: angles || null,
    convention: convention || null,
  };
  const typed = ofText(text);
  if (!typed.cells.length) throw new ArmError(say("no rows", { given: shown(text) }));
  const known = new Map(values.map(([name, x]) => [simple(name), x]));
  const found = matrices(typed.cells);
  if (found) {
    few(found.length);
    return [
      {
        ...given,
        rows: found.map((A, k) => fromMatrix(k + 1, A, known)),
        said: [say("taken: matrices")],
      },
    ];
  }
  const { cells, heads } = withoutIndex(typed);
  few(cells.length);
  let order;
  try {
    order = ordered(cells, heads, columns);
  } catch (error) {
    if (!(error instanceof ArmError) || !isEven(text)) throw error;
    return read(apart(text), { columns, ...given }, values);
  }
  const { orders, sure, rows } = order;
  const head = fromHeads(heads);
  const units = {
    lengths: given.lengths ?? head.lengths,
    angles: given.angles ?? head.angles,
    convention: given.convention ?? head.convention,
  };
  const attempts = orders.map((order) => attempted(rows, order, known, sure));
  const tables = attempts.flatMap(({ rows: made, said }) =>
    made ? [{ ...units, rows: made, said: [...typed.said, ...said] }] : [],
  );
  if (tables.length) return tables;
  if (!sure || !variablesInAlpha(rows, orders[0])) throw attempts[0].error;
  const swapped = attempted(
    rows,
    orders[0].map((name) => EXCHANGED[name] ?? name),
    known,
    sure,
  );
  if (!swapped.rows) throw swapped.error;
  return [{ ...units, rows: swapped.rows, said: typed.said, exchanged: true }];
}

function variablesInAlpha(rows, order) {
  const [alphas, thetas] = ["alpha", "theta"].map((name) =>
    rows.map((row) => row[order.indexOf(name)]),
  );
  return alphas.some(isVariable) && !thetas.some(isVariable);
}

// Whether the lengths are taken as millimetres though nobody said so.
export const inMillimetres = ({ lengths, rows }) =>
  lengths === null &&
  rows.some(({ numbers: n }) => Math.max(Math.abs(n.a), Math.abs(n.d)) >= MILLIMETRES);

function few(count) {
  if (count > MOST_ROWS) throw new ArmError(say("many rows", { count, most: MOST_ROWS }));
}

function attempted(cells, order, known, sure) {
  try {
    const rows = cells.map((row, k) => {
      const entries = Object.fromEntries(order.map((name, i) => [name, row[i]]));
      return rowOf(k + 1, entries, known);
    });
    return { rows, said: sure ? [] : [say("taken: columns", { columns: order.join(" ") })] };
  } catch (error) {
    if (error instanceof ArmError) return { error };
    throw error;
  }
}

/**
 * A table as it was meant: standard rows in m and rad, what was guessed, and the sizes of the units
 * typed. `kinds` are taken where no row holds a variable and there are as many; all turn otherwise.
 * @param {TypedTable} table
 * @param {string[]} kinds
 * @returns {{ rows: Numbers[], said: string[], length: number, angle: number }}
 */
export function meant(table, kinds) {
  const said = [...table.said];
  const largest = (list) => list.reduce((top, x) => Math.max(top, Math.abs(x)), 0);
  let { lengths: unit, angles: angle } = table;
  if (inMillimetres(table)) {
    unit = "mm";
    said.push(say("taken: millimetres"));
  }
  const open = ({ numbers, radians }) =>
    ["alpha", "theta"].filter((c) => !radians.has(c)).map((c) => numbers[c]);
  if (angle === null && largest(table.rows.flatMap(open)) > MOST_RADIANS) {
    angle = "deg";
    said.push(say("taken: degrees"));
  }
  const f = UNITS[unit ?? "m"];
  const t = angle === "deg" ? RAD : 1;
  const extra = table.rows.flatMap((_, k) => (k >= kinds.length ? [k + 1] : []));
  if (kinds.length && extra.length && table.rows.every(unknown))
    said.push(say("taken: fixed", { rows: namedRows(extra) }));
  const moving = kindsOf(table, kinds);
  let rows = table.rows.map(({ numbers: n, radians }, k) => {
    const [alpha, theta] = ["alpha", "theta"].map((c) => n[c] * (radians.has(c) ? 1 : t));
    return { kind: moving[k], a: n.a * f, alpha, d: n.d * f, theta };
  });
  if (table.convention === "craig") {
    rows = fromCraig(rows);
    said.push(say("taken: craig"));
  }
  const backwards = table.rows.flatMap((row, k) => (row.backwards ? [k + 1] : []));
  if (backwards.length) said.push(say("taken: backwards", { rows: namedRows(backwards) }));
  return { rows, said, length: f, angle: t };
}

const namedRows = (rows) =>
  rows.length === 1
    ? say("row", { row: rows[0] })
    : say("rows", { rows: listed(rows.map(String)) });

const unknown = ({ kind }) => kind === "unknown";

function kindsOf({ rows }, wanted) {
  const more = rows.length - wanted.length;
  if (rows.every(unknown))
    return wanted.length && more >= 0
      ? [...wanted, ...Array(more).fill("fixed")]
      : rows.map(() => "revolute");
  return rows.map(({ kind }) => (kind === "unknown" ? "fixed" : kind));
}

const EMPTY = { kind: "fixed", a: 0, alpha: 0, d: 0, theta: 0 };
const isEmpty = (row) => row.kind === "fixed" && ENTRIES.every((name) => row[name] === 0);

// Standard rows from modified ones, which begin with a_{i-1}, alpha_{i-1}: a fixed row before them
// takes a_0 and alpha_0; a last one that is left empty goes.
/** @param {Numbers[]} rows @returns {Numbers[]} */
export function fromCraig(rows) {
  const shifted = rows.map((row, k) => {
    const { a, alpha } = rows[k + 1] ?? EMPTY;
    return { ...row, a, alpha };
  });
  if (shifted.length > 1 && isEmpty(shifted.at(-1))) shifted.pop();
  const first = { ...EMPTY, a: rows[0].a, alpha: rows[0].alpha };
  return isEmpty(first) ? shifted : [first, ...shifted];
}

// From text to rows of cells

/** @typedef {{ cells: string[][], heads: string[], said: string[] }} Cells */

/** @returns {Cells} */
const plainly = (cells, heads = ENTRIES) => ({ cells, heads, said: [] });

const unquoted = (text) => text.trim().replace(/^['"]+|['"]+$/g, "");

/** @returns {Cells} */
function ofText(typed) {
  const text = unboxed(straight(typed));
  const links = [...text.matchAll(LINK)].map(([, kind, body]) => ({ kind, body }));
  if (links.length) return ofLinks(links);
  const records = ofRecords(text);
  if (records) return records;
  /** @type {[string, string][]} */
  const named = [...text.matchAll(LISTS)].map(([, name, body]) => [headOf(name) ?? "", body]);
  if (named.length >= 3 && named.every(([word]) => ENTRIES.includes(word)))
    return ofLists(new Map(named));
  const pairs = [...text.matchAll(PAIRS)].map(([, name, i, x]) => [
    name.toLowerCase(),
    Number(i),
    x,
  ]);
  const known = pairs.length >= 6 && pairs.every(([name]) => WORDS.has(name));
  if (known && !text.trimStart().startsWith("|"))
    return ofPairs(pairs.map(([name, i, x]) => [WORDS.get(name), i, unquoted(x)]));
  const rows = cellsOf(text.replace(/^\s*#/, ""));
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

// Whether two blanks and more part the lines of a text into as many cells, and single ones stand in
// some.
function isEven(text) {
  const wide = apart(text);
  return wide !== text && new Set(cellsOf(wide).map((row) => row.length)).size === 1;
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

// A dictionary for each row, {'a': 0, 'alpha': pi/2, ...} or dict(a=0, ...).
function ofRecords(text) {
  const found = [...text.matchAll(RECORDS)].flatMap(([, braced, called]) => {
    const pairs = [
      ...(braced || called || "").matchAll(/['"]?([A-Za-zαθ]+)['"]?\s*[:=]\s*([^,[]+)/g),
    ];
    const row = new Map(pairs.map(([, name, x]) => [headOf(name), unquoted(x)]));
    return ENTRIES.filter((entry) => row.has(entry)).length >= 3 ? [row] : [];
  });
  if (found.length < 2) return null;
  return plainly(
    found.map((row, k) => ENTRIES.map((entry) => row.get(entry) ?? blank(entry, k + 1))),
  );
}

const blank = (entry, i) => (entry === "theta" ? `q_${i}` : "0");

// Four parallel lists.
function ofLists(named) {
  const lists = [...named.values()].map((body) => cellsOf(`[${body.slice(1, -1)}]`)[0]);
  const counts = [...new Set(lists.map((list) => list.length))].sort((p, q) => p - q);
  if (counts.length !== 1) throw new ArmError(say("uneven lists", { counts: counts.join(", ") }));
  return plainly(
    lists[0].map((_, k) => lists.map((list) => list[k])),
    [...named.keys()],
  );
}

// Entries by column and number; a_0 and alpha_0 tell Craig's convention, whose row i has a_{i-1}
// and alpha_{i-1}: a last one with nothing else in it is the tool's.
function ofPairs(entries) {
  const early = (column) => column === "a" || column === "alpha";
  const craig = entries.some(([column, i]) => early(column) && i === 0);
  const row = (column, i) => (craig && early(column) ? i + 1 : i);
  const held = new Map(entries.map(([column, i, text]) => [`${column} ${row(column, i)}`, text]));
  const last = entries.reduce((top, [column, i]) => Math.max(top, row(column, i)), 0);
  few(last);
  const others = entries.flatMap(([column, i]) =>
    column === "d" || column === "theta" ? [i] : [],
  );
  const moving = craig && others.length ? Math.max(...others) : last;
  const missing = (entry, i) => (i > moving ? "0" : blank(entry, i));
  const cells = Array.from({ length: last }, (_, k) =>
    ENTRIES.map((entry) => held.get(`${entry} ${k + 1}`) ?? missing(entry, k + 1)),
  );
  return plainly(cells, craig ? ["a_{i-1}", "alpha_{i-1}", "d", "theta"] : ENTRIES);
}

// Link('d', 0.3, 'a', 0, 'alpha', pi/2), Link([theta d a alpha sigma]) and RevoluteDH(d=0.3,
// alpha=pi/2).
function ofLinks(links) {
  const cells = links.map((link, k) => {
    const { row, slides } = linkOf(link);
    const moves = slides ? "d" : "theta";
    const still = number(row[moves]) ? row[moves] : row.offset;
    row[moves] = `q_${k + 1} + (${still})`;
    return ENTRIES.map((entry) => row[entry]);
  });
  return { ...plainly(cells), said: [say("taken: links")] };
}

function linkOf({ kind, body }) {
  const none = { a: "0", alpha: "0", d: "0", theta: "0", offset: "0" };
  if (body.trim().startsWith("[")) {
    const entries = cellsOf(`${body.split("]")[0]}]`)[0];
    const named = ["theta", "d", "a", "alpha", "sigma", "offset"].slice(0, entries.length);
    const row = { ...none, ...Object.fromEntries(named.map((name, i) => [name, entries[i]])) };
    return { row, slides: entries.length > 4 && number(entries[4]) === 1 };
  }
  const pairs = body.matchAll(
    /['"]?(?<![\p{L}\p{N}_])(a|alpha|d|theta|offset)['"]?\s*[,=]\s*([^,]+)/gu,
  );
  const given = Object.fromEntries([...pairs].map(([, name, x]) => [name, x.trim()]));
  const slides =
    `${kind}${body}`.toLowerCase().includes("prismatic") ||
    ("theta" in given && !("d" in given)) ||
    /sigma['"]?\s*[,=]\s*1/.test(body);
  return { row: { ...none, ...given }, slides };
}

// Heads, columns, rows

const simple = (name) => name.replace(/[_{}\s*'^\\]/g, "").toLowerCase();

// Which entry a head names, or "i" for the rows' numbers.
function headOf(cell) {
  const words = plain(cell.replace(/-\s*1/g, "")).replaceAll("*", "");
  const word = words
    .replace(/\(.*?\)|\[.*?(?:\]|$)|\bin\b.*|[,/].*|_(?:mm|cm|deg|rad)$/g, "")
    .replace(/[\s_{}$\\^'"().]/g, "")
    .toLowerCase();
  return WORDS.get(word) ?? WORDS.get(word.replace(/[ijkn]$/, ""));
}

function fromHeads(heads) {
  const text = heads.join(" ");
  const unit = ["mm", "cm"].find((u) => new RegExp(String.raw`[(\[ /_]${u}\b`).test(text));
  const own =
    ["m", "in"].find((u) =>
      new RegExp(String.raw`[(\[]\s*${u}\s*(?:[)\]]|$)|/${u}\b`).test(text),
    ) ?? null;
  const angles = /deg|°/i.test(text) ? "deg" : /(?:\b|_)rad/.test(text) ? "rad" : null;
  return { lengths: unit ?? own, angles, convention: /-\s*1/.test(text) ? "craig" : null };
}

// The cells without the column that numbers the rows. Where they are not numbered and one short,
// the first head goes alone: nobody typed its column, or it is half of "Joint type".
function withoutIndex({ cells, heads }) {
  const words = heads.map(headOf);
  const first = cells.map((row) => plain(row[0]));
  const label = (i) => new RegExp(String.raw`^(?:link|joint|l|j|i=)?\s*_?${i}\.?$`, "i");
  const fromZero = first.every((text, k) => number(text) === k);
  const counted = fromZero || first.every((text, k) => label(k + 1).test(text));
  const short =
    cells.every((row) => row.length === heads.length - 1) && !ENTRIES.includes(words[0]);
  if (short && !counted) return { cells, heads: heads.slice(1) };
  const at = words.indexOf("i");
  const cut = (row) => row.filter((_, k) => k !== at);
  if (at >= 0) return { cells: cells.map(cut), heads: cut(heads) };
  if (cells.every((row) => row.length > 4) && counted)
    return {
      cells: cells.map((row) => row.slice(1)),
      heads: heads.length > 4 ? heads.slice(1) : heads,
    };
  return { cells, heads };
}

// The orders of the columns that are possible, whether it was said, and the rows in them.
function ordered(cells, heads, columns) {
  if (columns) {
    const order = columns
      .trim()
      .split(/[\s,;|]+/)
      .map(headOf);
    if ([...order].sort().join() !== ENTRIES.join())
      throw new ArmError(say("no columns", { given: shown(columns) }));
    wide(cells);
    return { orders: [order], sure: true, rows: cells };
  }
  const isOffset = (head) => head.toLowerCase().includes("offset");
  const all = heads.map(headOf);
  const twice = all.filter((word) => word === "d").length > 1;
  const words = all.map((word, i) => (twice && isOffset(heads[i]) ? "" : word));
  const keep = ENTRIES.map((entry) => words.indexOf(entry));
  if (!keep.includes(-1) && cells.every((row) => [0, 1].includes(heads.length - row.length))) {
    const added = heads.findIndex((head, i) => isOffset(head) && !keep.includes(i));
    const rows = cells.map((row, k) => {
      const kept = keep.map((i) => row[i] ?? "0");
      const still = row[added] ?? "0";
      const none = number(still.replace(/^[-–— ]+|[-–— ]+$/g, "") || "0") === 0;
      return none ? kept : withOffset(k + 1, kept, still);
    });
    return { orders: [ENTRIES], sure: true, rows };
  }
  wide(cells);
  const looks = cells.map((row) => row.map(lookOf));
  const known = KNOWN_ORDERS.map((order) => order.join());
  const usual = [
    ...KNOWN_ORDERS,
    ...permutations(ENTRIES).filter((order) => !known.includes(order.join())),
  ];
  const strict = usual.filter((order) => possible(looks, order, true));
  const fits = strict.length ? strict : usual.filter((order) => possible(looks, order, false));
  const orders = [
    ...fits.filter((o) => mostTurn(looks, o)),
    ...fits.filter((o) => !mostTurn(looks, o)),
  ];
  return { orders: orders.length ? orders : [KNOWN_ORDERS[0]], sure: false, rows: cells };
}

// A row whose joint's offset, in a column of its own, is added to what moves.
function withOffset(i, row, still) {
  const [d, theta] = [2, 3].map((k) => number(row[k] || "0") === null);
  const at = d && !theta ? 2 : 3;
  const moves = VARIABLE.test(plain(row[at])) ? `q_${i}` : row[at] || "0";
  return row.map((cell, k) => (k === at ? `${moves} + (${still})` : cell));
}

const permutations = (list) =>
  list.length < 2
    ? [list]
    : list.flatMap((one, k) =>
        permutations(list.filter((_, j) => j !== k)).map((more) => [one, ...more]),
      );

function wide(cells) {
  const sorted = [...new Set(cells.map((row) => row.length))].sort((p, q) => p - q);
  const widths = sorted.join(", ");
  if (sorted.length > 1) {
    const row = cells.findIndex((one) => one.length !== 4);
    throw new ArmError(say("row widths", { widths, row: row + 1, count: cells[row].length }));
  }
  if (sorted[0] !== 4) throw new ArmError(say("row width", { widths }));
}

// What a cell looks like, apart from where it stands.
function lookOf(text) {
  return {
    variable: isVariable(text),
    offset: /\bd_?\d/.test(text),
    angular: /pi|deg|°|π/.test(text),
    number: number(text),
  };
}

// Whether the variables stand in theta (or d), and, if strict, no length or angle looks like the
// other; those of an arm with skew axes do.
function possible(looks, order, strict) {
  const [a, alpha, d] = ENTRIES.map((name) => looks.map((row) => row[order.indexOf(name)]));
  if ([...a, ...alpha].some(({ variable, offset }) => variable || offset)) return false;
  const stands = ![...a, ...d].some(({ angular }) => angular);
  if (!strict || !stands) return stands;
  const lengths = [...a, ...d].map((look) => look.number);
  const right = alpha.every((look) => look.number === null || angleLike(look.number));
  const spread = !lengths.every((x) => x === null || (x && angleLike(x))) || !lengths.some(Boolean);
  return right && spread;
}

// Whether no fewer joints would turn than slide, as in most arms.
function mostTurn(looks, order) {
  const count = (name) => looks.filter((row) => row[order.indexOf(name)].variable).length;
  return count("theta") >= count("d");
}

function isVariable(text) {
  const bare = plain(text);
  if (VARIABLE.test(bare.trim())) return true;
  try {
    return [...symbols(parse(bare.replace(/\*+$/, "")))].some((name) => JOINT.test(name));
  } catch (error) {
    if (error instanceof ArmError) return false;
    throw error;
  }
}

function angleLike(x) {
  const parts = x / (Math.PI / 12);
  const inRadians = Math.abs(x) <= 2 * Math.PI + 0.01 && Math.abs(parts - Math.round(parts)) < 0.02;
  return inRadians || (x % 15 === 0 && Math.abs(x) <= 360);
}

/** @returns {TypedRow} */
function rowOf(i, entries, known) {
  const each = (make) => Object.fromEntries(ENTRIES.map((name) => [name, make(name)]));
  const trees = each((name) => {
    const text = plain(entries[name]);
    const free = ["theta", "d"].includes(name) && VARIABLE.test(text) && !known.has(simple(text));
    return parse(free ? `q_${i}` : text.replace(/\*+$/, "") || "0", `${name} in row ${i}`);
  });
  const free = each((name) =>
    [...symbols(trees[name])].filter((one) => !known.has(simple(one))).sort(),
  );
  const mover = free.theta.length ? "theta" : free.d.length ? "d" : null;
  const joint =
    mover && (free[mover].find((one) => /^(?:q|th|t_?\d|x_?\d|phi)/.test(one)) ?? free[mover][0]);
  const stray = ENTRIES.flatMap((name) =>
    free[name].filter((one) => name !== mover || one !== joint),
  );
  if (stray.length) {
    const key = Object.hasOwn(UNITS, stray[0]) ? "row unit" : "row symbol";
    throw new ArmError(say(key, { row: i, name: stray[0] }));
  }
  const at = (name, x) =>
    value(trees[name], (one) => (free[name].includes(one) ? x : known.get(simple(one))));
  let backwards = false;
  const numbers = each((name) => {
    const still = at(name, 0);
    if (name === mover) backwards = slope(at(name, 1) - still, i, name) < 0;
    return still;
  });
  const radians = new Set(
    ENTRIES.filter((name) => /\b(?:pi|deg|rad)\b/.test(plain(entries[name]))),
  );
  const kind = mover ? { theta: "revolute", d: "prismatic" }[mover] : "unknown";
  return { kind, numbers, texts: each((name) => entries[name].trim()), backwards, radians, trees };
}

function slope(rate, row, name) {
  const far = (from) => Math.abs(Math.abs(rate) - from) > 1e-6;
  if (far(1) && far(RAD)) throw new ArmError(say("row slope", { row, name, rate: size(rate) }));
  return rate > 0 ? 1 : -1;
}

// 4 x 4 matrices

// The rows of cells as matrices A_i, where they are such.
function matrices(cells) {
  const last = (row) => row.every((text, k) => number(text) === (k === 3 ? 1 : 0));
  if (cells.length < 8 || cells.length % 4 || !cells.every((row) => row.length === 4)) return null;
  if (!cells.every((row, i) => i % 4 !== 3 || last(row))) return null;
  return Array.from({ length: cells.length / 4 }, (_, k) => cells.slice(4 * k, 4 * k + 4));
}

/** @returns {TypedRow} */
function fromMatrix(i, A, known) {
  const trees = A.map((row) => row.map((text) => parse(plain(text), `A_${i}`)));
  const free = [...symbols(["all", ...trees.flat()])].filter((name) => !known.has(simple(name)));
  const at = (x) => {
    const look = (name) => (free.includes(name) ? short(name, x) : known.get(simple(name)));
    return trees.map((row) => row.map((tree) => value(tree, look)));
  };
  const [zero, one] = [at(0), at(0.5)];
  const [c, s] = [zero[0][0], zero[1][0]];
  const theta = Math.atan2(s, c);
  const alpha = Math.atan2(zero[2][1], zero[2][2]);
  const numbers = { a: zero[0][3] * c + zero[1][3] * s, alpha, d: zero[2][3], theta };
  const slid = one[2][3] - zero[2][3];
  const slides = Math.abs(slid) > 1e-9;
  const turned = Math.sin(Math.atan2(one[1][0], one[0][0]) - theta);
  const texts = Object.fromEntries(ENTRIES.map((name) => [name, size(numbers[name], 6)]));
  const kind = slides ? "prismatic" : free.length ? "revolute" : "unknown";
  const backwards = (slides ? slid : turned) < 0;
  return { kind, numbers, texts, backwards, radians: new Set() };
}

// A joint's value, or its cosine or sine where the name is c_1 or s1.
function short(name, x) {
  const match = /^([cs])(?:theta|th|q)?_?\{?\d+\}?$/i.exec(name);
  if (!match) return x;
  return match[1].toLowerCase() === "c" ? Math.cos(x) : Math.sin(x);
}
