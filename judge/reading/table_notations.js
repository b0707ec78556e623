// Tables whose entries have names: Link(...) and its kin, dictionaries, pairs such as a_1 = 0, and
// lists such as a = [...], each as rows of cells and the heads above them.

import { number } from "./formula.js";
import { headOf } from "./table_columns.js";
import { ENTRIES, isVariable } from "./table_rows.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";

const MOST_ROWS = 32;

/**
 * A bracket of a text: the words before it and between it and its end; `pairs` where it holds some
 * and none within it does.
 * @typedef {{ from: number, to: number, sign: string, before: string, body: string,
 *   pairs: boolean }} Group
 */
/**
 * Rows of cells; `parts` of the text that hold them, from and to, `entries` as typed where the
 * cells were put together from them.
 * @typedef {{ cells: string[][], heads: string[], said: string[], parts: number[][],
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
export function named(typed) {
  const text = typed.replace(/[“”„‟‘’]/g, '"');
  const groups = groupsIn(text);
  const found = ofLinks(groups) ?? ofRecords(text, groups) ?? ofLists(groups);
  return found && { ...found, ...outside(text, found) };
}

const NEAR = 40; // characters before a bracket that may name it

/** @returns {Group[]} */
function groupsIn(text) {
  const [found, open] = [[], []];
  for (let at = 0; at < text.length; at++) {
    const sign = text[at];
    if ("[({".includes(sign)) open.push({ from: at, sign, marked: false, within: false });
    else if ("=:".includes(sign) && open.length) open.at(-1).marked = true;
    else if ("])}".includes(sign) && open.length) {
      const { from, sign, marked, within } = open.pop();
      const before = text.slice(Math.max(0, from - NEAR), from);
      if (open.length && (marked || within)) open.at(-1).within = true;
      const pairs = marked && !within;
      found.push({ from, to: at + 1, sign, before, body: text.slice(from + 1, at), pairs });
    }
  }
  return found.sort((one, other) => one.from - other.from);
}

// List what no part that was read covers: lines, and decimals within the parts
// or beside them.
function outside(text, { parts, cells, entries = cells.flat() }) {
  const hidden = (from, to) => text.slice(from, to).replace(/[^\n]+/g, READ);
  const ends = [0, ...parts.flat(), text.length];
  const rest = ends
    .slice(1)
    .map((to, k) => (k % 2 ? hidden(ends[k], to) : text.slice(ends[k], to)));
  const all = rest.join("").split("\n");
  const lines = all.filter((line) => !line.includes(READ));
  const held = new Set(entries.join(" ").match(DECIMAL));
  const decimals = (list) => list.flatMap((part) => part.match(DECIMAL) ?? []);
  const lost = decimals(parts.map(([from, to]) => text.slice(from, to))).filter(
    (x) => !held.has(x),
  );
  const told = lines.map((line) => line.trim()).filter((line) => /[\p{L}\d]{2}/u.test(line));
  const beside = all.filter((line) => line.includes(READ));
  return { context: lines.join("\n"), left: [...told, ...decimals(beside), ...lost] };
}

const READ = "\u0000";
const DECIMAL = /(?<!\d)\d*\.\d+/g;

const INDEX = String.raw`_?[({]?(?:i(?: ?- ?1)?|(\d{1,2})|deg|rad|mm|cm|m)?[)}]?`;
const PAIR = new RegExp(String.raw`['"]?(?<![A-Za-zαθ])([A-Za-zαθ]+${INDEX})['"]?\s*[:=]\s*`, "g");

// A row for each dictionary, {'a': 0, 'alpha': pi/2, ...} or dict(a=0, ...), and each line of
// pairs; where the names have numbers, a_1 = 0, a row for each number. A dictionary of
// nothing else may leave out what is 0; of other pairs a row has three at least. In a dictionary
// that counts alpha0, a0, d1, ... (Craig) a row is alpha0, a0, d1.
function ofRecords(text, groups) {
  const braced = groups.filter(
    ({ sign, before, pairs }) => pairs && (sign === "{" || before.endsWith("dict")),
  );
  const bodies = braced.length ? braced : linesIn(text);
  const rows = new Map();
  const pairsByBody = bodies.map(({ body }) => pairsIn(body));
  const isCraig = countsTwistsFromZero(pairsByBody.flat());
  bodies.forEach(({ body, from, to }, k) => {
    const pairs = isCraig ? pairsByBody[k].map(countFromOne) : pairsByBody[k];
    const whole = braced.length && body.match(/[:=]/g)?.length === pairs.length;
    for (const { entry, name, i, x } of pairs) {
      const fewest = whole && !i ? 1 : 3;
      const row = rows.get(i ?? bodies[k]) ?? { entries: new Map(), parts: [], fewest };
      rows.set(i ?? bodies[k], row);
      row.entries.set(entry, { name, x });
      row.parts.push([from, to]);
    }
  });
  const found = [...rows.values()].filter(({ entries, fewest }) => entries.size >= fewest);
  if (found.length < 2) return null;
  const heads = ENTRIES.map((entry) => found[0].entries.get(entry)?.name ?? entry);
  const cells = found.map(({ entries }, k) =>
    ENTRIES.map((entry) => entries.get(entry)?.x ?? blank(entry, k + 1)),
  );
  const parts = new Map(found.flatMap((row) => row.parts).map((part) => [part[0], part]));
  const table = plainly(
    cells,
    [...parts.values()].sort(([one], [other]) => one - other),
    heads,
  );
  return isCraig ? { ...table, convention: "craig" } : table;
}

const isTwist = ({ entry }) => entry === "a" || entry === "alpha";

// Return whether the numbers of a and alpha begin with 0 and those of d and theta with 1.
function countsTwistsFromZero(pairs) {
  const least = (list) => Math.min(...list.map(({ i }) => Number(i ?? Infinity)));
  const others = pairs.filter((pair) => !isTwist(pair));
  return least(pairs.filter(isTwist)) === 0 && least(others) === 1;
}

const countFromOne = (pair) =>
  isTwist(pair) && pair.i ? { ...pair, i: String(Number(pair.i) + 1) } : pair;

function linesIn(text) {
  let from = 0;
  return text.split("\n").map((body) => {
    const to = from + body.length;
    const line = { body, from, to };
    from = to + 1;
    return line;
  });
}

// The entries of a table that a text names, a value reaching to the next name.
function pairsIn(text) {
  const names = [...text.matchAll(PAIR)];
  return names.flatMap(({ 0: all, 1: name, 2: i, index }, k) => {
    const value = text.slice(index + all.length, names[k + 1]?.index);
    const x = unquoted(value.split(/[,;[]/)[0]);
    const entry = headOf(i ? name.replace(i, "") : name);
    return ENTRIES.includes(entry) && x ? [{ entry, name: i ? entry : name, i, x }] : [];
  });
}

const blank = (entry, i) => (entry === "theta" ? `q_${i}` : "0");

const LIST = /([\p{L}_][\p{L}\p{N}_]*)['"]?\s*[=:]\s*(?:(?:np\.array|Matrix)?\s*\(\s*)?$/u;

// Four parallel lists, or three.
function ofLists(groups) {
  const found = groups.flatMap(({ sign, before, body, from, to }) => {
    const name = sign === "(" ? null : LIST.exec(before);
    return name ? [{ entry: headOf(name[1]) ?? "", body, part: [from - name[0].length, to] }] : [];
  });
  if (found.length < 3 || !found.every(({ entry }) => ENTRIES.includes(entry))) return null;
  const named = new Map(found.map(({ entry, body }) => [entry, listIn(body)]));
  const lists = [...named.values()];
  const counts = [...new Set(lists.map((list) => list.length))].sort((p, q) => p - q);
  if (counts.length !== 1)
    throw new ArmError(formatMessage("uneven lists", { counts: counts.join(", ") }));
  const rows = lists[0].map((_, k) => lists.map((list) => list[k]));
  const parts = found.map(({ part }) => part);
  const table = plainly(rows, parts, [...named.keys()]);
  return named.size === 3 && !named.has("theta") ? withTheta(table, named.get("d")) : table;
}

// Add the joints' angles to lists of d, a and alpha; a row whose d is a variable slides.
/** @param {Cells} table @param {string[]} distances @returns {Cells} */
function withTheta(table, distances) {
  const angles = distances.map((d, k) => (isVariable(d) ? "0" : `q_${k + 1}`));
  return {
    ...table,
    cells: table.cells.map((row, k) => [...row, angles[k]]),
    heads: [...table.heads, "theta"],
    said: [formatMessage("taken: no theta")],
  };
}

// The entries of a list; commas part them, else blanks.
function listIn(body) {
  const parted = body.trim().split(/[,;\n]+/);
  const entries = parted.length > 1 ? parted : body.trim().split(/\s+/);
  return entries.map(unquoted).filter(Boolean);
}

const LINK = /(?<!\p{L})(?:(?:DH)?Link|(?:Revolute|Prismatic)[\p{L}\d_]*)\s*$/u;

// Link('d', 0.3, 'a', 0, 'alpha', pi/2), Link([theta d a alpha sigma]) and RevoluteDH(d=0.3, ...).
function ofLinks(groups) {
  const links = groups.flatMap(({ sign, before, body, from, to }) => {
    const [kind] = (sign === "(" && LINK.exec(before)) || [""];
    return kind ? [{ ...linkOf(kind, body), part: [from - kind.length, to] }] : [];
  });
  if (!links.length) return null;
  const cells = links.map(({ row, slides }, k) => {
    const moves = slides ? "d" : "theta";
    const still = number(row[moves]) ? row[moves] : row.offset;
    return ENTRIES.map((entry) => (entry === moves ? `q_${k + 1} + (${still})` : row[entry]));
  });
  const entries = links.flatMap(({ given }) => Object.values(given));
  const parts = links.map(({ part }) => part);
  const isModified = links.some(({ calls }) => MODIFIED.test(calls));
  const found = { ...plainly(cells, parts), said: [formatMessage("taken: links")], entries };
  return isModified ? { ...found, convention: "craig" } : found;
}

const MODIFIED = /MDH\b|\bmodified\b|\bmdh\s*=\s*(?:True|1)/;
const LISTED = ["d", "a", "alpha", "offset"]; // arguments of RevoluteDH without names

const PLACES = ["theta", "d", "a", "alpha", "sigma", "offset"]; // of Link([...])
const NAMED = /['"]?(?<![\p{L}\p{N}_])(a|alpha|d|theta|offset|sigma)['"]?\s*[,=]\s*([^,]+)/gu;

function linkOf(kind, body) {
  const none = { a: "0", alpha: "0", d: "0", theta: "0", offset: "0" };
  const list = body.trim().startsWith("[") ? listIn(body.trim().slice(1).split("]")[0]) : [];
  const pairs = list.length
    ? PLACES.slice(0, list.length).map((name, i) => [name, list[i]])
    : (namedPairs(body) ?? listedPairs(kind, body));
  const given = Object.fromEntries(pairs);
  const sigma = number(given.sigma ?? "0");
  if (list.length > PLACES.length || (sigma !== 0 && sigma !== 1))
    throw new ArmError(formatMessage("link sigma", { given: quoteText(`${kind}(${body})`) }));
  const slides =
    `${kind}${body}`.toLowerCase().includes("prismatic") ||
    sigma === 1 ||
    ("theta" in given && !("d" in given));
  return { row: { ...none, ...given }, slides, given, calls: `${kind}(${body})` };
}

function namedPairs(body) {
  const pairs = [...body.matchAll(NAMED)].map(([, name, x]) => [name, x.trim()]);
  return pairs.length || !body.trim() ? pairs : null;
}

// Arguments by their order, which the Robotics Toolbox gives Revolute and Prismatic alone.
function listedPairs(kind, body) {
  const values = listIn(body).filter((value) => !value.includes("="));
  const names = /prismatic/i.test(kind) ? ["theta", ...LISTED.slice(1)] : LISTED;
  if (!/^(?:revolute|prismatic)/i.test(kind) || values.length > names.length)
    throw new ArmError(
      formatMessage("link order", { given: quoteText(`${kind}(${body})`), call: kind.trim() }),
    );
  return values.map((value, k) => [names[k], value]);
}

export function few(count) {
  if (count > MOST_ROWS) throw new ArmError(formatMessage("many rows", { count, most: MOST_ROWS }));
}
