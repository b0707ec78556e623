// Reads tables whose rows are calls of the Robotics Toolbox, such as RevoluteDH(d=0.3, a=0).

import { number, plain } from "./formula.js";
import { listEntries, makeEntry, makeUntyped } from "./table_named_entries.js";
import { ENTRIES, isVariable, VARIABLE } from "./table_rows.js";
import { ArmError, formatMessage, quoteText } from "../sentences.js";

/** @typedef {import("./spans.js").Span} Span */
/** @typedef {import("./table_named_entries.js").Bracket} Bracket */
/** @typedef {import("./table_named_entries.js").Entry} Entry */
/** @typedef {import("./table_named_entries.js").EntryRows} EntryRows */

const LINK = /(?<!\p{L})(?:(?:DH)?Link|DHParam|(?:Revolute|Prismatic)[\p{L}\d_]*)\s*$/u;

/**
 * Read a row from each call. Calls have the forms Link('d', 0.3, 'a', 0, 'alpha', pi/2),
 * Link([theta d a alpha sigma]) and RevoluteDH(d=0.3).
 * @param {string} text @param {Bracket[]} brackets @returns {EntryRows | null}
 */
export function readLinks(text, brackets) {
  const links = brackets.flatMap((bracket) => {
    const call = bracket.open === "(" ? LINK.exec(bracket.before) : null;
    return call ? [readLink(call[0], bracket)] : [];
  });
  if (!links.length) return null;
  const table = {
    rows: links.map(({ values, slides }, k) => {
      const moving = slides ? "d" : "theta";
      const variable = makeVariable(k + 1, moving, values[moving], values.offset);
      return ENTRIES.map((name) =>
        name === moving ? variable : (values[name] ?? makeUntyped("0")),
      );
    }),
    headers: ENTRIES,
    parts: links.map(({ part }) => part),
    assumptions: [formatMessage("taken: links")],
    unread: links.map(({ unread }) => unread).find(Boolean),
  };
  return links.some(({ call }) => MODIFIED.test(call)) ? { ...table, convention: "craig" } : table;
}

/**
 * Make the entry of a joint variable, such as "q_2 + (pi/2)". A typed number other than 0 is the
 * offset: theta=pi/2 in row 2 means q_2 + pi/2. Refuse such a number beside a second offset.
 * @param {number} row @param {string} name of the column @param {Entry} [typed]
 * @param {Entry} [offset]
 */
function makeVariable(row, name, typed = makeUntyped("0"), offset = makeUntyped("0")) {
  const spans = [...typed.spans, ...offset.spans];
  if (hasJointSymbol(typed.text)) return { text: `${typed.text} + (${offset.text})`, spans };
  if (!number(typed.text)) return { text: `q_${row} + (${offset.text})`, spans };
  if (number(offset.text) !== 0) {
    const [one, other] = [typed, offset].map(({ text }) => quoteText(text));
    throw new ArmError(formatMessage("row two values", { row, name, one, other }));
  }
  return { text: `q_${row} + (${typed.text})`, spans };
}

const hasJointSymbol = (text) => isVariable(text) && !VARIABLE.test(plain(text));

const MODIFIED = /MDH\b|\bmodified\b|\bmdh['"]?\s*[=,]\s*[T1]/;
const LISTED = ["d", "a", "alpha", "offset"]; // the order of RevoluteDH(0.3, 0, pi/2)

const POSITIONS = ["theta", "d", "a", "alpha", "sigma", "offset"]; // the order of Link([...])
const NAMED = /['"]?(?<![\p{L}\p{N}_])(a|alpha|d|theta|offset|sigma)['"]?\s*[,=]\s*([^,]+)/gu;

/** Read the values of a call. @param {string} name @param {Bracket} bracket its arguments */
function readLink(name, { body, start, from, to }) {
  const call = `${name}(${body})`;
  const inputs =
    listVector(body, start) ?? listNamedValues(body, start) ?? listUnnamedValues(name, body, start);
  /** @type {Record<string, Entry>} */
  const values = Object.fromEntries(inputs.map((input) => [input.name, input.entry]));
  const sigma = number(values.sigma?.text ?? "0");
  if ("" in values || (sigma !== 0 && sigma !== 1))
    throw new ArmError(formatMessage("link sigma", { given: quoteText(call) }));
  const isPrismatic = call.toLowerCase().includes("prismatic") || sigma === 1;
  return {
    values,
    slides: isPrismatic || Boolean(values.theta && !values.d),
    call,
    part: { from: from - name.length, to },
    unread: body.search(NAMED) < 0 ? undefined : findUnknownArgument(body, start),
  };
}

// Arguments that change no entry: the body of a link, its motor and its limits.
const OTHER_ARGUMENT = new RegExp(
  String.raw`['"]?(?<![\p{L}\d_])(?:[mrIGB]|Jm|Tc|qlim|name|mdh|joint_?type)['"]?\s*[,=]\s*` +
    String.raw`(?:\[[^\]]*\]|[^,]+)|` +
    String.raw`['"]?(?<![\p{L}\d_])(?:revolute|prismatic|standard|modified)(?![\p{L}\d_])['"]?`,
  "giu",
);

// Find an argument of unknown name, such as flip=True and the misspelt 'alhpa'.
/** @param {string} body @param {number} start @returns {Span | undefined} */
function findUnknownArgument(body, start) {
  const blank = (known) => " ".repeat(known.length);
  const rest = body.replace(NAMED, blank).replace(OTHER_ARGUMENT, blank);
  const [words] = /[^\s,][^,]*[\p{L}\d][^,]*/u.exec(rest) ?? [];
  const from = start + rest.indexOf(words ?? "");
  return words === undefined ? undefined : { from, to: from + words.length };
}

/** Make an input of a call. @param {string} name @param {Entry} entry */
const makeInput = (name, entry) => ({ name, entry });

// List the values of Link([...]). Values beyond the last position get an empty name.
function listVector(body, start) {
  const [, vector] = /^\s*\[([^\]]*)/.exec(body) ?? [];
  const entries = vector ? listEntries(vector, start + body.indexOf(vector)) : [];
  return entries.length ? entries.map((entry, k) => makeInput(POSITIONS[k] ?? "", entry)) : null;
}

// List the values of Link('d', 0.3, 'a', 0) and RevoluteDH(d=0.3).
function listNamedValues(body, start) {
  const pairs = [...body.matchAll(NAMED)].map(({ 0: all, 1: name, 2: value, index }) => {
    const to = start + index + all.length;
    return makeInput(name, makeEntry(value, to - value.length));
  });
  return pairs.length > 0 ? pairs : null;
}

// List the values of RevoluteDH(0.3, 0, pi/2). Refuse other calls without names, which have no
// fixed order.
function listUnnamedValues(name, body, start) {
  const entries = listEntries(body, start).filter(({ text }) => !text.includes("="));
  const names = /prismatic/i.test(name) ? ["theta", ...LISTED.slice(1)] : LISTED;
  if (!/^(?:revolute|prismatic)/i.test(name) || entries.length > names.length)
    throw new ArmError(
      formatMessage("link order", { given: quoteText(`${name}(${body})`), call: name.trim() }),
    );
  return entries.map((entry, k) => makeInput(names[k], entry));
}
