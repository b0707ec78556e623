// Tables whose entries have names: Link(...) lines and their kin, dictionaries, pairs such as
// a_1 = 0, and lists such as a = [...]. Each becomes rows of entries below column headers.

import { number } from "./formula.js";
import { listLines } from "./spans.js";
import { findEntry } from "./table_columns.js";
import { ENTRIES, isVariable } from "./table_rows.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";

const MOST_ROWS = 32;

/** @typedef {import("./spans.js").Span} Span */
/**
 * A bracket of a text: its character, the text before it and inside it; `hasPairs` if it holds
 * pairs of names and values and no bracket inside it does. `start` is where `body` begins.
 * @typedef {{ from: number, to: number, open: string, before: string, body: string, start: number,
 *   hasPairs: boolean }} Bracket
 */
/** An entry, with the stretches of the text it was typed in; none if it was left out.
 * @typedef {{ text: string, spans: Span[] }} Entry
 */
/**
 * Rows of entries below their headers; `parts` are the stretches of the text that hold them.
 * @typedef {{ rows: Entry[][], headers: string[], parts: Span[], assumptions?: string[],
 *   convention?: string }} EntryRows
 */
/**
 * A table whose entries have names: `sources` says where each entry stands in the text, `context`
 * is the text around the table, and `unusedLines` lists what was not used.
 * @typedef {{ cells: string[][], headers: string[], assumptions: string[], convention?: string,
 *   sources: Source[], parts: Span[], context: string, unusedLines: string[] }} NamedTable
 */
/** @typedef {Span & { row: number, column: number }} Source `column` in the order of ENTRIES */

/**
 * Read a table whose entries have names, in the first notation that fits.
 * @param {string} typedText
 * @returns {NamedTable | null} null if the text is in no such notation
 */
export function readNamedTable(typedText) {
  const text = typedText.replace(/[“”„‟‘’]/g, '"');
  const brackets = listBrackets(text);
  const table = readLinks(brackets) ?? readDictionaries(text, brackets) ?? readLists(brackets);
  if (!table) return null;
  const { rows, headers, parts, assumptions = [], convention } = table;
  refuseManyRows(rows.length);
  const sources = rows.flatMap((entries, row) =>
    entries.flatMap(({ spans }, k) => {
      const column = ENTRIES.indexOf(findEntry(headers[k]));
      return spans.map((span) => ({ ...span, row, column }));
    }),
  );
  const cells = rows.map((entries) => entries.map((entry) => entry.text));
  const named = { cells, headers, assumptions, sources, parts };
  return { ...named, ...(convention && { convention }), ...listUnused(text, parts, sources) };
}

const NEAR = 40; // characters before a bracket that may name it

/** List the brackets of a text. @param {string} text @returns {Bracket[]} */
function listBrackets(text) {
  const [brackets, unclosed] = [[], []];
  for (let at = 0; at < text.length; at++) {
    const character = text[at];
    if ("[({".includes(character))
      unclosed.push({ from: at, open: character, hasSign: false, isOuter: false });
    else if ("=:".includes(character) && unclosed.length) unclosed.at(-1).hasSign = true;
    else if ("])}".includes(character) && unclosed.length) {
      const { from, open, hasSign, isOuter } = unclosed.pop();
      const before = text.slice(Math.max(0, from - NEAR), from);
      if (unclosed.length && (hasSign || isOuter)) unclosed.at(-1).isOuter = true;
      const [start, body] = [from + 1, text.slice(from + 1, at)];
      brackets.push({ from, to: at + 1, open, before, body, start, hasPairs: hasSign && !isOuter });
    }
  }
  return brackets.sort((left, right) => left.from - right.from);
}

/**
 * List what was not used: lines outside the table, and decimals on its lines.
 * @param {string} text @param {Span[]} parts @param {Span[]} sources
 */
function listUnused(text, parts, sources) {
  const isInside = (/** @type {Span} */ { from, to }) =>
    parts.some((part) => part.from < to && part.to > from);
  const [ownLines, otherLines] = [[], []];
  for (const line of listLines(text)) (isInside(line) ? ownLines : otherLines).push(line);
  const isUsed = (from) => sources.some((source) => source.from <= from && from < source.to);
  const decimals = ownLines.flatMap(({ text: line, from }) =>
    [...line.matchAll(DECIMAL)].filter(({ index }) => !isUsed(from + index)).map(([x]) => x),
  );
  const trimmed = otherLines.map((line) => line.text.trim());
  const told = trimmed.filter((line) => /[\p{L}\d]{2}/u.test(line));
  return { context: trimmed.join("\n"), unusedLines: [...told, ...decimals] };
}

const DECIMAL = /(?<!\d)\d*\.\d+/g;

/**
 * Make an entry of a stretch of a text, without blanks and quotes around it.
 * @param {string} text of the stretch @param {number} from where it begins
 * @returns {Entry}
 */
function makeEntry(text, from) {
  const inner = text.trim().replace(/^['"]+|['"]+$/g, "");
  const start = from + text.indexOf(inner);
  return { text: inner, spans: inner ? [{ from: start, to: start + inner.length }] : [] };
}

/** Make an entry that the text leaves out. @param {string} text @returns {Entry} */
const makeUntyped = (text) => ({ text, spans: [] });

const INDEX = String.raw`_?[({]?(?:i(?: ?- ?1)?|(\d{1,2})|deg|rad|mm|cm|m)?[)}]?`;
const PAIR = new RegExp(String.raw`['"]?(?<![A-Za-zαθ])([A-Za-zαθ]+${INDEX})['"]?\s*[:=]\s*`, "g");

/**
 * Read a row from each dictionary, {'a': 0, 'alpha': pi/2, ...} or dict(a=0, ...), or from each
 * line of pairs. If the names have numbers, a_1 = 0, each number is a row. A dictionary may leave
 * out what is 0; other pairs make a row if there are three. A dictionary that counts alpha0, a0,
 * d1, ... follows Craig: its rows are alpha0, a0, d1.
 * @param {string} text @param {Bracket[]} brackets @returns {EntryRows | null}
 */
function readDictionaries(text, brackets) {
  const braced = brackets.filter(
    ({ open, before, hasPairs }) => hasPairs && (open === "{" || before.endsWith("dict")),
  );
  const lines = listLines(text).map((line) => ({ ...line, body: line.text, start: line.from }));
  const bodies = braced.length ? braced : lines;
  const pairsByBody = bodies.map(listPairs);
  const isCraig = countsTwistsFromZero(pairsByBody.flat());
  const rows = new Map();
  bodies.forEach(({ body, from, to }, k) => {
    const pairs = isCraig ? pairsByBody[k].map(countFromOne) : pairsByBody[k];
    const isWhole = braced.length && body.match(/[:=]/g)?.length === pairs.length;
    for (const { column, name, index, entry } of pairs) {
      const fewest = isWhole && !index ? 1 : 3;
      const row = rows.get(index ?? k) ?? { columns: new Map(), parts: [], fewest };
      rows.set(index ?? k, row);
      row.columns.set(column, { name, entry });
      row.parts.push({ from, to });
    }
  });
  const kept = [...rows.values()].filter(({ columns, fewest }) => columns.size >= fewest);
  if (kept.length < 2) return null;
  const table = {
    rows: kept.map(({ columns }, k) =>
      ENTRIES.map((name) => columns.get(name)?.entry ?? makeOmitted(name, k + 1)),
    ),
    headers: ENTRIES.map((name) => kept[0].columns.get(name)?.name ?? name),
    parts: kept.flatMap(({ parts }) => parts),
  };
  return isCraig ? { ...table, convention: "craig" } : table;
}

const isTwist = ({ column }) => column === "a" || column === "alpha";

// Return whether the numbers of a and alpha begin with 0 and those of d and theta with 1.
function countsTwistsFromZero(pairs) {
  const least = (list) => Math.min(...list.map(({ index }) => Number(index ?? Infinity)));
  const others = pairs.filter((pair) => !isTwist(pair));
  return least(pairs.filter(isTwist)) === 0 && least(others) === 1;
}

const countFromOne = (pair) =>
  isTwist(pair) && pair.index ? { ...pair, index: String(Number(pair.index) + 1) } : pair;

// List the entries that a text names; a value reaches to the next name.
function listPairs({ body, start }) {
  const names = [...body.matchAll(PAIR)];
  return names.flatMap(({ 0: all, 1: name, 2: index, index: at }, k) => {
    const from = at + all.length;
    const [value] = body.slice(from, names[k + 1]?.index).split(/[,;[]/);
    const entry = makeEntry(value, start + from);
    const column = findEntry(index ? name.replace(index, "") : name);
    if (!ENTRIES.includes(column) || !entry.text) return [];
    return [{ column, name: index ? column : name, index, entry }];
  });
}

const makeOmitted = (column, row) => makeUntyped(column === "theta" ? `q_${row}` : "0");

const LIST = /([\p{L}_][\p{L}\p{N}_]*)['"]?\s*[=:]\s*(?:(?:np\.array|Matrix)?\s*\(\s*)?$/u;

/**
 * Read a table from four parallel lists, or from those of a, alpha and d.
 * @param {Bracket[]} brackets @returns {EntryRows | null}
 */
function readLists(brackets) {
  const lists = brackets.flatMap(({ open, before, body, start, from, to }) => {
    const name = open === "(" ? null : LIST.exec(before);
    if (!name) return [];
    const part = { from: from - name[0].length, to };
    return [{ column: findEntry(name[1]) ?? "", entries: listEntries(body, start), part }];
  });
  if (lists.length < 3 || !lists.every(({ column }) => ENTRIES.includes(column))) return null;
  const columns = new Map(lists.map(({ column, entries }) => [column, entries]));
  const counts = [...new Set([...columns.values()].map(({ length }) => length))];
  if (counts.length !== 1)
    throw new ArmError(
      formatMessage("uneven lists", { counts: counts.sort((p, q) => p - q).join(", ") }),
    );
  const table = {
    rows: Array.from({ length: counts[0] }, (_, k) => [...columns.values()].map((list) => list[k])),
    headers: [...columns.keys()],
    parts: lists.map(({ part }) => part),
  };
  return columns.size === 3 && !columns.has("theta") ? addTheta(table, columns.get("d")) : table;
}

// Add the joints' angles to lists of d, a and alpha; a row whose d is a variable slides.
/** @param {EntryRows} table @param {Entry[]} distances @returns {EntryRows} */
function addTheta(table, distances) {
  const angles = distances.map(({ text }, k) => makeUntyped(isVariable(text) ? "0" : `q_${k + 1}`));
  return {
    ...table,
    rows: table.rows.map((row, k) => [...row, angles[k]]),
    headers: [...table.headers, "theta"],
    assumptions: [formatMessage("taken: no theta")],
  };
}

/** List the entries between commas, else between blanks. @returns {Entry[]} */
function listEntries(body, start) {
  const pattern = /[,;\n]/.test(body.trim()) ? /[^,;\n]+/g : /\S+/g;
  return [...body.matchAll(pattern)]
    .map(({ 0: text, index }) => makeEntry(text, start + index))
    .filter(({ text }) => text);
}

const LINK = /(?<!\p{L})(?:(?:DH)?Link|(?:Revolute|Prismatic)[\p{L}\d_]*)\s*$/u;

/**
 * Read Link('d', 0.3, 'a', 0, 'alpha', pi/2), Link([theta d a alpha sigma]), RevoluteDH(d=0.3).
 * @param {Bracket[]} brackets @returns {EntryRows | null}
 */
function readLinks(brackets) {
  const links = brackets.flatMap((bracket) => {
    const [call] = (bracket.open === "(" && LINK.exec(bracket.before)) || [""];
    return call
      ? [{ ...readLink(call, bracket), part: { from: bracket.from - call.length, to: bracket.to } }]
      : [];
  });
  if (!links.length) return null;
  const table = {
    rows: links.map(({ values, slides }, k) => {
      const moving = slides ? "d" : "theta";
      const variable = makeVariable(k + 1, values[moving], values.offset);
      return ENTRIES.map((name) =>
        name === moving ? variable : (values[name] ?? makeUntyped("0")),
      );
    }),
    headers: ENTRIES,
    parts: links.map(({ part }) => part),
    assumptions: [formatMessage("taken: links")],
  };
  return links.some(({ call }) => MODIFIED.test(call)) ? { ...table, convention: "craig" } : table;
}

/**
 * Make the entry of a joint's variable from what stands in its place and its offset. A number in
 * its place is the offset; another text in its place, as q1 or 0, only says that it moves.
 * @param {number} row @param {Entry} [typed] @param {Entry} [offset]
 */
function makeVariable(row, typed = makeUntyped("0"), offset = makeUntyped("0")) {
  const still = number(typed.text) ? typed : offset;
  const spans = still === typed ? typed.spans : [...typed.spans, ...offset.spans];
  return { text: `q_${row} + (${still.text})`, spans };
}

const MODIFIED = /MDH\b|\bmodified\b|\bmdh\s*=\s*(?:True|1)/;
const LISTED = ["d", "a", "alpha", "offset"]; // arguments of RevoluteDH without names

const POSITIONS = ["theta", "d", "a", "alpha", "sigma", "offset"]; // of Link([...])
const NAMED = /['"]?(?<![\p{L}\p{N}_])(a|alpha|d|theta|offset|sigma)['"]?\s*[,=]\s*([^,]+)/gu;

/** Read the values of one Link(...). @param {string} name @param {Bracket} bracket */
function readLink(name, { body, start }) {
  const call = `${name}(${body})`;
  const pairs =
    listVector(body, start) ?? listNamedValues(body, start) ?? listUnnamedValues(name, body, start);
  /** @type {Record<string, Entry>} */
  const values = Object.fromEntries(pairs);
  const sigma = number(values.sigma?.text ?? "0");
  if ("" in values || (sigma !== 0 && sigma !== 1))
    throw new ArmError(formatMessage("link sigma", { given: quoteText(call) }));
  const isPrismatic = call.toLowerCase().includes("prismatic") || sigma === 1;
  return { values, slides: isPrismatic || Boolean(values.theta && !values.d), call };
}

// List the values of Link([...]); a name is empty if there are too many.
function listVector(body, start) {
  const [, vector] = /^\s*\[([^\]]*)/.exec(body) ?? [];
  const entries = vector ? listEntries(vector, start + body.indexOf(vector)) : [];
  return entries.length ? entries.map((entry, k) => [POSITIONS[k] ?? "", entry]) : null;
}

function listNamedValues(body, start) {
  const pairs = [...body.matchAll(NAMED)].map(({ 0: all, 1: name, 2: value, index }) => [
    name,
    makeEntry(value, start + index + all.length - value.length),
  ]);
  return pairs.length || !body.trim() ? pairs : null;
}

// List arguments by their order, which only Revolute and Prismatic of the Robotics Toolbox fix.
function listUnnamedValues(name, body, start) {
  const entries = listEntries(body, start).filter(({ text }) => !text.includes("="));
  const names = /prismatic/i.test(name) ? ["theta", ...LISTED.slice(1)] : LISTED;
  if (!/^(?:revolute|prismatic)/i.test(name) || entries.length > names.length)
    throw new ArmError(
      formatMessage("link order", { given: quoteText(`${name}(${body})`), call: name.trim() }),
    );
  return entries.map((entry, k) => [names[k], entry]);
}

/** Refuse a table of too many rows. @param {number} count */
export function refuseManyRows(count) {
  if (count > MOST_ROWS) throw new ArmError(formatMessage("many rows", { count, most: MOST_ROWS }));
}
