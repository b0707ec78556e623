// Finds what a text states of its table besides the entries: the order of the columns, the
// convention and the units. A statement is applied whole, or there is no verdict.

import { replaceSubscripts, findEntry } from "./table_columns.js";
import { ENTRIES } from "./table_rows.js";
import { LENGTH_UNIT } from "./units.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";

/** @typedef {import("./table.js").TypedTable} TypedTable */

// Order of the columns

const isOrder = (names) => [...names].sort().join() === ENTRIES.join();
const isPart = (names) =>
  names.length === 3 && new Set(names).size === 3 && names.every((name) => ENTRIES.includes(name));
const GROUPS = /[[(]([^[\]()\n]*)[\])]|"([^"\n]*)"/g;
const NAME_SEPARATORS = [/[,|&;\t]/, /\s+/];

/**
 * Find the headers of the four columns in words such as "(theta, d, a, alpha)". If a bracket,
 * quotes or the whole line names exactly three columns, return these.
 * @param {string} line @returns {string[] | null}
 */
export function findColumnNames(line) {
  const groups = [...line.matchAll(GROUPS)].map(([, bracket, quote]) => bracket ?? quote);
  let part = null;
  for (const words of [...groups, line.replace(/^[^:]*:/, ""), line])
    for (const separator of NAME_SEPARATORS) {
      const cells = words.split(separator).map((cell) => cell.trim());
      const names = cells.filter(Boolean).map(findEntry);
      const at = names.findIndex((_, k) => isOrder(names.slice(k, k + 4)));
      if (at >= 0) return cells.filter(Boolean).slice(at, at + 4);
      if (isPart(names)) part ??= cells.filter(Boolean);
    }
  return part;
}

const COMMENT = /(?:#(?!\d)|%|\/\/)(.*)/;
const CODE = /^\s*(?:def|function)\s/; // names the arguments of a function
const NAMES_ORDER = /\b(?:columns?|order|spalten|reihenfolge)\b/i;

// List the orders that comments and lines state. A line of prose counts only if a table fits it.
function listStatedOrders(text) {
  return text.split("\n").flatMap((line) => {
    if (CODE.test(line)) return [];
    const [, comment] = COMMENT.exec(line) ?? [];
    const headers = findColumnNames(comment ?? line);
    const isFirm = comment !== undefined || NAMES_ORDER.test(line);
    return headers ? [{ line: line.trim(), order: headers.map(findEntry), headers, isFirm }] : [];
  });
}

/**
 * Keep the tables whose order of columns is the order that the text states. Refuse the text if it
 * states a different order, or names three columns only.
 * @param {TypedTable[]} tables @param {string} text as it was pasted
 * @returns {TypedTable[]}
 */
export function applyStatedOrder(tables, text) {
  if (!tables.every(({ isOrderGuessed }) => isOrderGuessed)) return tables;
  for (const { line, order, headers, isFirm } of listStatedOrders(text)) {
    const kept = tables.filter((table) => table.order.join() === order.join());
    const { convention } = readHeaders(headers);
    if (kept.length)
      return kept.map((table) => ({
        ...table,
        isOrderGuessed: false,
        convention: table.convention ?? convention,
        assumptions: table.assumptions.filter((phrase) => phrase !== describeOrder(table)),
      }));
    if (!isFirm) continue;
    const key = isOrder(order) ? "contrary order" : "half order";
    const message = formatMessage(key, { quoted: quoteText(line) });
    throw new ArmError(message, [], tables[0].tokens, text);
  }
  return tables;
}

/** Describe the guessed order of a table. @param {TypedTable} table */
const describeOrder = ({ order }) => formatMessage("taken: columns", { columns: order.join(" ") });

// Units and convention of the headers

const UNIT_BEHIND = new RegExp(String.raw`[[(/_]\s?(${LENGTH_UNIT})(?!\w)`, "g"); // a_mm, a (mm)
const UNIT_APART = new RegExp(String.raw`[[(/_ ]\s?(${LENGTH_UNIT})(?!\w)`); // a mm
const PREVIOUS = /-\s*1|prev/i;
const OWN_INDEX = /[_{(]\s*[ijkn]|(?<=^\W*(?:a|alpha|α))[ijkn](?![\p{L}])/u; // of a_i, ai and αi

/**
 * Read the units and the convention that headers state.
 * @param {string[]} typed
 */
function readHeaders(typed) {
  const headers = typed.map(replaceSubscripts);
  const text = headers.join(" ");
  const lengths = new Set([...text.matchAll(UNIT_BEHIND)].map(([, unit]) => unit));
  refuseTwo("units of length", lengths);
  const angles = [
    ...(/deg|°/i.test(text) ? ["deg"] : []),
    ...(/(?:\b|_)rad/.test(text) ? ["rad"] : []),
  ];
  refuseTwo("units of angles", new Set(angles));
  const twists = headers.filter((header) => ["a", "alpha"].includes(findEntry(header)));
  const isOwn = (header) => OWN_INDEX.test(header) && !PREVIOUS.test(header);
  if (twists.some(isOwn) && twists.some((header) => PREVIOUS.test(header)))
    throw new ArmError(formatMessage("half craig", { headers: quoteText(twists.join(", ")) }));
  return {
    lengths: UNIT_APART.exec(text)?.[1] ?? null,
    angles: angles[0] ?? null,
    convention: PREVIOUS.test(text) ? "craig" : null,
  };
}

// Refuse two statements of the same thing.
function refuseTwo(what, statements) {
  const given = [...statements].join(", ");
  if (statements.size > 1) throw new ArmError(formatMessage("two statements", { what, given }));
}

// Units and convention of the text beside the table

// "Lengths in cm" or "(cm, deg)". A unit behind a number does not count: it belongs to the number.
const LENGTHS_IN = new RegExp(
  String.raw`\b(?:lengths?|distances?|dimensions)(?: (?:are|all|given|measured|taken))*` +
    String.raw`(?: in|:| \() ?(${LENGTH_UNIT}|milli|centi|met)(?:met)?(?:ers?|res?)?\b`,
  "gi",
);
const UNITS_ALONE = new RegExp(
  String.raw`(?:\bunits?(?: are| in|:) ?|\bin |^[ \t]*[[(])(${LENGTH_UNIT})` +
    String.raw`(?:, ?| and )(?:deg|rad|°)`,
  "gim",
);
const ANGLES_IN = new RegExp(
  String.raw`\bangles?(?: (?:are|all|given|measured|taken))*(?: in|:| \() ?` +
    "(?:(rad)(?:ians?)?|deg(?:rees)?|°)",
  "i",
);
const UNIT_NAMES = { milli: "mm", centi: "cm", met: "m" };

// Read the units that a text beside a table states.
function readStatedUnits(context) {
  const matches = [LENGTHS_IN, UNITS_ALONE].flatMap((pattern) => [...context.matchAll(pattern)]);
  const names = matches.map(([, unit]) => unit.toLowerCase());
  const lengths = new Set(names.map((name) => UNIT_NAMES[name] ?? name));
  refuseTwo("units of length", lengths);
  const angles = ANGLES_IN.exec(context);
  return { lengths: [...lengths][0] ?? null, angles: angles && (angles[1] ? "rad" : "deg") };
}

// Find the convention that the text around a table names.
function readStatedConvention(context) {
  if (/\bstandard\b|\bspong\b/i.test(context)) return "standard";
  return /\b(?:craig|modified|m-?dh|khalil)\b|\bmod\./i.test(context) ? "craig" : null;
}

/**
 * Choose the units and the convention. The student's settings come before the column headers, and
 * these before the text beside the table.
 * @param {{ headers: string[], context: string, convention?: string }} block `convention` is that
 *   of its notation
 * @param {import("./table.js").Options} options
 */
export function chooseStatements({ headers, context, convention }, options) {
  const [typed, beside] = [readHeaders(headers), readStatedUnits(context)];
  const named = readStatedConvention(context);
  const inTable = convention ?? typed.convention;
  if (!options.convention && named && inTable)
    refuseTwo("conventions", new Set([named, inTable].map((name) => CONVENTION_NAMES[name])));
  return {
    lengths: options.lengths || (typed.lengths ?? beside.lengths),
    angles: options.angles || (typed.angles ?? beside.angles),
    convention: options.convention || (inTable ?? (named === "craig" ? named : null)),
  };
}

const CONVENTION_NAMES = { craig: "Craig's convention", standard: "the standard convention" };

// A unit in brackets or in capitals of its own, neither behind a number nor in a unit of moments.
const UNIT_ALONE = /(?<![\d.]\s?|[\p{L}\d_\\]|N[ ·.*-]?)cm(?![\p{L}\d])|[[(,]\s?m\s?[\]),]/gu;
const UNIT_OF_ENTRY = new RegExp(String.raw`^ ?(${LENGTH_UNIT})(?![\p{L}\p{N}])`, "u");

/**
 * Find a unit of lengths other than mm in a text: alone, or behind an entry.
 * @param {import("./owners.js").Token[]} tokens @param {string} text
 * @returns {string | undefined}
 */
export function findOtherLengthUnit(tokens, text) {
  const alone = text.match(UNIT_ALONE) ?? [];
  const behind = tokens
    .filter(({ owner }) => owner === "entry")
    .map(({ to }) => UNIT_OF_ENTRY.exec(text.slice(to, to + 5))?.[1]);
  return [...alone, ...behind].find((unit) => unit && unit !== "mm")?.replace(/[^cm]/g, "");
}
