// Formulas as people type them: a tree is ["num", x], ["name", n], ["neg", t], ["call", function,
// t] or [sign, left, right]. No text is ever run. helpers/expressions.py reads plain formulas of a
// table without the judge; tests/test_expressions.py holds the two equal.

import { RAD } from "../geometry/angles.js";
import { ArmError, tryOrNull, quoteText } from "../sentences.js";
import { foldCharacters, foldNames, mapEach, withoutSpacing } from "./characters.js";

const LONGEST = 20_000; // characters of one formula
const TEN = 10; // whose powers are meant, 10^0 too
const DEEPEST = 60; // brackets in brackets

const FUNCTIONS = {
  sin: Math.sin,
  cos: Math.cos,
  tan: Math.tan,
  sqrt: Math.sqrt,
  asin: Math.asin,
  acos: Math.acos,
  atan: Math.atan,
  radians: (x) => x * RAD,
  deg2rad: (x) => x * RAD,
  float64: (x) => x, // NumPy 2 prints np.float64(0.5)
};
const SIGNS = {
  "+": (left, right) => left + right,
  "-": (left, right) => left - right,
  "*": (left, right) => left * right,
  "/": (left, right) => (right === 0 ? NaN : left / right),
  "^": raised,
};
const CONSTANTS = { pi: Math.PI, deg: RAD, rad: 1 };
export const isFunction = (word) => Object.hasOwn(FUNCTIONS, word);
const isConstant = (word) => Object.hasOwn(CONSTANTS, word);

function raised(left, right) {
  const power = left ** right;
  return Number.isFinite(power) || !Number.isFinite(left) ? power : NaN;
}

const GREEK = "alpha beta gamma delta theta theta phi phi psi omega lambda theta".split(" ");
/** @type {Map<string, string>} */
const SPELLINGS = new Map([
  ...mapEach("×·∗", "*"),
  ...mapEach("÷∕⁄", "/"),
  ...mapEach("′", "'"),
  ...[..."₀₁₂₃₄₅₆₇₈₉"].flatMap((sign, i) => mapEach(sign, `_${i}`)),
  ...[..."αβγδθϑφϕψωλΘ"].flatMap((sign, i) => mapEach(sign, ` ${GREEK[i]}`)),
  ...mapEach("π𝜋", " pi "),
  ...mapEach("°◦∘", " deg"),
  ["√", " sqrt "],
]);
/** @type {[RegExp, string][]} */
const LATEX = [
  [/\\(?:math(?:rm|bf|it)|text(?:bf|it|rm)?|boldsymbol)\s*\{([^{}]*)\}/g, "$1"],
  [/\^\s*\{?\s*°\s*\}?/g, "°"],
  [/(?<=[\d.)]\s*)deg(?:rees?|s|\.)(?!\s*[\w(])/g, " deg"], // the unit in words: 45 degrees
  [/_\s*\{\s*(\w+)\s*\}/g, "_$1"],
];
/** @type {[RegExp, string][]} */
const INNERMOST = [
  [/\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}/g, "(($1)/($2))"],
  [/(\\(?:sqrt|sin|cos|tan)|\^)\s*\{([^{}]*)\}/g, "$1($2)"],
];
const COUNTED = /(?<![A-Za-z_])(q|theta) *[[(] *([0-9]{1,2}) *[\])]/g;
const NUMERAL = String.raw`\d+(?:\.\d*)?(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?`;
const NAME = String.raw`[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?`;
const TOKEN = new RegExp(String.raw`\s*(?:(${NUMERAL})|(${NAME})|(\*\*|[-+*/^()]))`, "y");
const RUN = /^(?:[acdlsCS]_?(?:\d|\{[\d+-]+\})+){2,}$/; // c_1s_23 and a_2C_2
const SHORT = /[acdlsCS]_?(?:\d|\{[\d+-]+\})+/g;

const NUMBER = /^[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?$/;

// Return whether a text is one number in plain characters, as nearly every cell of a long paste is.
export const isNumber = (text) => NUMBER.test(text);

// Return whether a number with decimals stands in a text.
export const hasDecimals = (text) => /\d[.,]\d/.test(text);

// Write a text in plain characters: Unicode and LaTeX spelled out, prefixes such as np. dropped.
export function plain(text) {
  if (isNumber(text)) return text;
  text = withoutSpacing(foldNames(foldCharacters(text)));
  text = text.replace(/([₀-₉])(?=[A-Za-zα-ω])/g, "$1*"); // a product without a sign
  for (const [pattern, replacement] of LATEX) text = text.replace(pattern, replacement);
  text = [...text].map((character) => SPELLINGS.get(character) ?? character).join("");
  for (let before = ""; before !== text;) {
    before = text;
    for (const [innermost, opened] of INNERMOST) text = text.replace(innermost, opened);
  }
  text = text.replace(/\\([A-Za-z]+)/g, " $1 ");
  text = text.replace(/\b(?:np|math|sp)\./g, "");
  text = text.replace(/\.(?=[*/^])/g, ""); // MATLAB's operators on each entry
  text = text.replace(/(?<=\w)\s*\(t\)/g, "");
  text = text.replace(COUNTED, "$1_$2");
  text = text.replace(/(\b[a-z]+) +_(?=[\w{])/g, "$1_");
  text = text.replace(/(?<![_\w])\{/g, "(");
  text = text.replace(/\{[\w+-]*\}|\}/g, (braces) => (braces === "}" ? ")" : braces));
  return text.replace(/[ \t]+/g, " ").trim();
}

// A name without underscores, braces and primes, in lower case.
export const simple = (name) =>
  plain(name)
    .replace(/[_{}'*^\\\s]/g, "")
    .toLowerCase();

// Parse one formula as a tree; refuse another text with a message that quotes it.
export function parse(text, what = "the formula") {
  if (text.length > LONGEST) {
    throw new ArmError(`${what} has ${text.length} characters; expected at most ${LONGEST}`);
  }
  if (!text.trim()) throw new ArmError(`${what} is empty; expected a number or a formula, or 0`);
  const signs = plain(text);
  const tokens = tokensOf(signs);
  if (!tokens) {
    throw new ArmError(
      `${what} is ${quoteText(text)}; expected numbers, symbols, pi, sin, cos and + - * / ^ ( )`,
    );
  }
  const found = attempted(tokens);
  if (found?.[1] !== tokens.length) {
    throw new ArmError(
      `${what} is ${quoteText(text)}; expected one formula, such as '-pi/2' or 'd_6 + l_pen'`,
    );
  }
  return found[0];
}

class NoFormula extends Error {}

function attempted(tokens) {
  try {
    return sum(tokens, 0, 0);
  } catch (error) {
    if (error instanceof NoFormula) return null;
    throw error;
  }
}

function tokensOf(text) {
  const found = [];
  for (let at = 0; at < text.length; at = TOKEN.lastIndex) {
    TOKEN.lastIndex = at;
    const match = TOKEN.exec(text);
    if (!match) return null;
    const [, number, name, sign] = match;
    if (number !== undefined) found.push(["num", number]);
    else if (sign !== undefined) found.push(["sign", sign === "**" ? "^" : sign]);
    else for (const one of RUN.test(name) ? name.match(SHORT) : [name]) found.push(["name", one]);
  }
  return found;
}

function at(tokens, k) {
  if (k >= tokens.length) throw new NoFormula();
  return tokens[k];
}

function sum(tokens, k, depth) {
  let [left, next] = product(tokens, k, depth);
  while (next < tokens.length && ["+", "-"].includes(tokens[next][1])) {
    const [right, after] = product(tokens, next + 1, depth);
    [left, next] = [[tokens[next][1], left, right], after];
  }
  return [left, next];
}

function product(tokens, k, depth) {
  let [left, next] = signed(tokens, k, depth);
  while (next < tokens.length) {
    const [kind, word] = tokens[next];
    if (word === "*" || word === "/") {
      const [right, after] = signed(tokens, next + 1, depth);
      [left, next] = [[word, left, right], after];
    } else if (word === "(" || kind !== "sign") {
      // 1 234.5 is no product
      if (kind === "num" && tokens[next - 1][0] === "num") throw new NoFormula();
      const [right, after] = power(tokens, next, depth);
      [left, next] = [["*", left, right], after];
    } else break;
  }
  return [left, next];
}

function signed(tokens, k, depth) {
  if (depth > DEEPEST) throw new NoFormula();
  const word = at(tokens, k)[1];
  if (word === "-") {
    const [inner, next] = signed(tokens, k + 1, depth + 1);
    return [["neg", inner], next];
  }
  return word === "+" ? signed(tokens, k + 1, depth + 1) : power(tokens, k, depth);
}

function power(tokens, k, depth) {
  const [base, next] = atom(tokens, k, depth);
  if (next >= tokens.length || tokens[next][1] !== "^") return [base, next];
  const [exponent, after] = signed(tokens, next + 1, depth + 1);
  const none = exponent[0] === "num" && exponent[1] === 0;
  if (base[0] === "num" && base[1] > TEN && none) throw new NoFormula(); // 90^0 is no 1
  return [["^", base, exponent], after];
}

function atom(tokens, k, depth) {
  const [kind, word] = at(tokens, k);
  if (kind === "num") return [["num", Number(word), halfPlace(word)], k + 1];
  if (kind === "name" && isFunction(word) && k + 1 < tokens.length) {
    if (tokens[k + 1][1] === "^") {
      const [exponent, after] = atom(tokens, k + 2, depth + 1); // sin^2 x
      if (exponent[0] !== "num") throw new NoFormula(); // sin^-1 is another function
      const [of, end] = argument(tokens, after, depth + 1);
      return [["^", ["call", word, of], exponent], end];
    }
    const [inner, next] = argument(tokens, k + 1, depth + 1);
    return [["call", word, inner], next];
  }
  if (kind === "name") return [["name", word], k + 1];
  if (word !== "(") throw new NoFormula();
  const [inner, next] = sum(tokens, k + 1, depth + 1);
  if (at(tokens, next)[1] !== ")") throw new NoFormula();
  return [inner, next + 1];
}

// Read the argument of a function: a bracket, or the next factor, as in "sin theta_1".
function argument(tokens, k, depth) {
  if (depth > DEEPEST) throw new NoFormula();
  if (at(tokens, k)[1] !== "-") return atom(tokens, k, depth);
  const [inner, next] = atom(tokens, k + 1, depth);
  return [["neg", inner], next];
}

// The names in a tree that are no constants.
export function symbols(tree, found = new Set()) {
  // A sum may have more terms than functions can call one another.
  for (const parts = [tree]; parts.length;) {
    const [kind, ...of] = parts.pop();
    if (kind === "name" && !isConstant(of[0])) found.add(of[0]);
    parts.push(...of.filter(Array.isArray).reverse());
  }
  return found;
}

// The number of a tree, names looked up by `known`.
export function value(tree, known) {
  const found = valueOf(tree, known);
  if (!Number.isFinite(found)) {
    throw new ArmError("a formula divides by zero or is too large; expected a finite value");
  }
  return found;
}

function valueOf(tree, known) {
  const later = []; // what is left to do from left to right, for a sum may have very many terms
  for (; Object.hasOwn(SIGNS, tree[0]); tree = tree[1]) later.push(tree);
  const first = single(tree, known);
  return later.reduceRight(
    (found, [sign, , right]) => SIGNS[sign](found, valueOf(right, known)),
    first,
  );
}

function single([kind, first, second], known) {
  if (kind === "num") return first;
  if (kind === "neg") return -valueOf(first, known);
  if (kind === "call") return FUNCTIONS[first](valueOf(second, known));
  const found = isConstant(first) ? CONSTANTS[first] : known(first);
  if (found === undefined) throw new ArmError(`no value for ${first}`);
  return found;
}

// Half a unit of the last decimal place of a number as typed; 0 where it has no decimals.
function halfPlace(word) {
  const [mantissa, power = "0"] = word.toLowerCase().split("e");
  const decimals = mantissa.split(".")[1];
  return decimals ? 0.5 * 10 ** (Number(power) - decimals.length) : 0;
}

// Among other numbers, decimals coarser than this half place are exact as typed: 0.5*cos(0.3).
const COARSEST_SLACK = 1e-3;

/**
 * Return how far a formula's value may be off because its decimals were rounded, to first order.
 * Integers, pi and symbols are exact. A formula with a single decimal, as 2.66*10^-2 or 0.68*pi, is
 * that number written otherwise, so its last place counts whatever its size.
 * @param {any[]} tree @param {(name: string) => number | undefined} known
 */
export function formulaSlack(tree, known) {
  const single = countDecimals(tree) === 1 && !symbols(tree).size;
  return slackOf(tree, known, single ? Infinity : COARSEST_SLACK);
}

const countDecimals = (tree) =>
  tree[0] === "num"
    ? Number(Boolean(tree[2]))
    : tree.filter(Array.isArray).reduce((count, part) => count + countDecimals(part), 0);

// The slack of a tree, in which half places of `coarsest` and more count as exact.
function slackOf(tree, known, coarsest) {
  const [kind, first, second] = tree;
  if (kind === "name") return 0;
  if (kind === "num") return typedSlack(tree, coarsest);
  if (kind === "neg") return slackOf(first, known, coarsest);
  if (kind === "call") {
    const slack = slackOf(second, known, coarsest);
    return slack && slack * Math.abs(derivative(FUNCTIONS[first], valueOf(second, known)));
  }
  const limit = kind === "*" && isPowerOfTen(second) ? coarsest / value(second, known) : coarsest;
  const [left, right] = [slackOf(first, known, limit), slackOf(second, known, coarsest)];
  if (!left && !right) return 0;
  return SLACKS[kind](left, right, valueOf(first, known), valueOf(second, known));
}

const typedSlack = ([, , half = 0], coarsest) => (half < coarsest ? half : 0);

// The slack of x with slack dx, an operator, and y with slack dy.
const SLACKS = {
  "+": (dx, dy) => dx + dy,
  "-": (dx, dy) => dx + dy,
  "*": (dx, dy, x, y) => dx * Math.abs(y) + dy * Math.abs(x),
  "/": (dx, dy, x, y) => dx / Math.abs(y) + (dy * Math.abs(x)) / (y * y),
  "^": (dx, _, x, y) => dx * Math.abs(y * x ** (y - 1)),
};

const isPowerOfTen = (tree) => tree[0] === "^" && tree[1][0] === "num" && tree[1][1] === TEN;
const STEP = 1e-6; // of the difference that stands for a derivative
const derivative = (make, x) => (make(x + STEP) - make(x - STEP)) / (2 * STEP);

// The number a text stands for if it holds no symbols, else null.
export const number = (text) => tryOrNull(() => value(parse(text), () => undefined));

// The symbols of a text, null where it is no formula.
export const symbolsIn = (text) => tryOrNull(() => [...symbols(parse(text))]);
