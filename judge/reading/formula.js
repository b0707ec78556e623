// Parses and evaluates formulas such as "-pi/2 + 0.1*cos(q_1)". A formula becomes a tree: ["num",
// x], ["name", n], ["neg", tree], ["call", function, tree] or [operator, left, right]. Typed text
// is never executed. helpers/expressions.py reads plain formulas in Python, and
// tests/test_expressions.py compares both readers.

import { RAD } from "../geometry/angles.js";
import { ArmError, tryOrNull, quoteText } from "../sentences.js";
import { foldCharacters, foldNames, mapEach, withoutSpacing } from "./characters.js";

const LONGEST = 20_000; // characters of one formula
const DEEPEST = 60; // brackets in brackets
const TEN = 10;

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
const OPERATORS = {
  "+": (left, right) => left + right,
  "-": (left, right) => left - right,
  "*": (left, right) => left * right,
  "/": (left, right) => (right === 0 ? NaN : left / right),
  "^": raise,
};
const CONSTANTS = { pi: Math.PI, deg: RAD, rad: 1 };
// Return whether a word names a function.
export const isFunction = (word) => Object.hasOwn(FUNCTIONS, word);
const isConstant = (word) => Object.hasOwn(CONSTANTS, word);

// Raise a number to a power. Return NaN if the result is too large.
function raise(base, exponent) {
  const power = base ** exponent;
  return Number.isFinite(power) ? power : NaN;
}

const GREEK = "alpha beta gamma delta theta theta phi phi psi omega lambda theta".split(" ");
/** @type {Map<string, string>} */
const SPELLINGS = new Map([
  ...mapEach("×·∗", "*"),
  ...mapEach("÷∕⁄", "/"),
  ...mapEach("′", "'"),
  ...[..."₀₁₂₃₄₅₆₇₈₉"].flatMap((digit, i) => mapEach(digit, `_${i}`)),
  ...[..."αβγδθϑφϕψωλΘ"].flatMap((letter, i) => mapEach(letter, ` ${GREEK[i]}`)),
  ...mapEach("π𝜋", " pi "),
  ...mapEach("°◦∘", " deg"),
  ["√", " sqrt "],
  ["½", "(1/2)"],
  ["¼", "(1/4)"],
  ["¾", "(3/4)"],
]);
/** @type {[RegExp, string][]} */
const LATEX = [
  [/\\var(?=theta|phi)/g, "\\"],
  [/\\(?:boldsymbol|(?:math|text)[a-z]*)\s*\{([^{}]*)\}/g, "$1"],
  [/\^\s*\{?\s*°\s*\}?/g, "°"],
  // The unit of "45 degrees". The first lookahead saves time: without it, the lookbehind would run
  // over each blank of a long run.
  [/(?=deg)(?<=[\d.)]\s*)deg(?:rees?|\.)(?!\s*[\w(])/g, " deg"],
  [/_\s*\{\s*(\w+)\s*\}/g, "_$1"],
];
/** @type {[RegExp, string][]} */
const INNERMOST = [
  [/\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}/g, "(($1)/($2))"],
  [/(\\(?:sqrt|sin|cos|tan)|\^)\s*\{([^{}]*)\}/g, "$1($2)"],
];
const COUNTED = /(?<![A-Za-z_\d])([A-Za-z]+) *[[(] *([0-9]{1,2}) *[\])]/g;
const NUMERAL = String.raw`\d+(?:\.\d*)?(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?`;
const NAME = String.raw`[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?`;
const TOKEN = new RegExp(String.raw`\s*(?:(${NUMERAL})|(${NAME})|(\*\*|[-+*/^()]))`, "y");
const FACTORS = /^(?:[acdlsCS]_?\d+){2,}$/; // c_1s_23 and a_2C_2
const FACTOR = /[acdlsCS]_?\d+/g;

const NUMBER = /^[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?$/;

// Return whether a text is a single number in plain characters.
export const isNumber = (text) => NUMBER.test(text);

const NAME_ALONE = /^(?!\w*P[Ii])[A-Za-z]\w*$/;
// Modules before a name: np.pi, sympy.cos, std::numbers::pi.
const MODULE = /(?<![\w.\\])(?:[A-Za-z_]\w*(?:\.|::))+(?=[A-Za-z])/g;
// The names of pi in C, JavaScript and Mathematica: M_PI, M_PI_2, Math.PI, Pi.
const PI_NAME = /(?<![A-Za-z\d_])(?:M_)?P[Ii](?:_([24]))?(?![A-Za-z\d_])/g;

// Return whether a text holds a number with decimals.
export const hasDecimals = (text) => /\d[.,]\d/.test(text);

const MOST_REMEMBERED = 5000;
const plainTexts = new Map(); // results of `plain`, which meets the same cell in each splitting

// Write a text in plain characters: Unicode and LaTeX spelled out, modules such as np. dropped.
export function plain(text) {
  if (isNumber(text) || NAME_ALONE.test(text)) return text; // the commonest texts
  if (!plainTexts.has(text)) {
    if (plainTexts.size >= MOST_REMEMBERED) plainTexts.clear();
    plainTexts.set(text, spellOut(text));
  }
  return plainTexts.get(text);
}

function spellOut(text) {
  text = withoutSpacing(foldNames(foldCharacters(text)));
  text = text.replace(/([₀-₉])(?=[A-Za-zα-ω])/g, "$1*"); // a product without a sign
  for (const [pattern, replacement] of LATEX) text = text.replace(pattern, replacement);
  text = [...text].map((character) => SPELLINGS.get(character) ?? character).join("");
  for (let before = ""; before !== text;) {
    before = text;
    for (const [pattern, replacement] of INNERMOST) text = text.replace(pattern, replacement);
  }
  text = text.replace(/\\([A-Za-z]+)/g, " $1 ");
  text = text.replace(MODULE, "");
  text = text.replace(PI_NAME, (_, divisor) => (divisor ? `(pi/${divisor})` : "pi"));
  text = text.replace(/\.(?=[*/^])/g, ""); // MATLAB's operators on each entry
  text = text.replace(/(?<=\w)\s*\(t\)/g, "");
  text = text.replace(COUNTED, (all, name, index) =>
    isFunction(name) || isConstant(name) ? all : `${name}_${index}`,
  );
  text = text.replace(/(\b[a-z]+) +_(?=[\w{])/g, "$1_");
  text = text.replace(/(?<![_\w])\{/g, "(");
  text = text.replace(/\{[\w+-]*\}|\}/g, (braces) => (braces === "}" ? ")" : braces));
  return text.replace(/[ \t]+/g, " ").trim();
}

// Write a name without underscores, braces and primes, in lower case.
export const simple = (name) =>
  plain(name)
    .replace(/[_{}'*^\\\s]/g, "")
    .toLowerCase();

/**
 * Parse a formula as a tree.
 * @param {string} text @param {string} [what] its name in messages
 * @returns {any[]}
 * @throws {ArmError} if the text is no formula
 */
export function parse(text, what = "the formula") {
  if (text.length > LONGEST) {
    throw new ArmError(`${what} has ${text.length} characters; expected at most ${LONGEST}`);
  }
  if (!text.trim()) throw new ArmError(`${what} is empty; expected a number or a formula, or 0`);
  const tokens = readTokens(plain(text));
  if (!tokens) {
    throw new ArmError(
      `${what} is ${quoteText(text)}; expected numbers, symbols, pi, sin, cos and + - * / ^ ( )`,
    );
  }
  const [tree, end] = readSum(tokens) ?? [];
  if (end !== tokens.length) {
    throw new ArmError(
      `${what} is ${quoteText(text)}; expected one formula, such as '-pi/2' or 'd_6 + l_pen'`,
    );
  }
  return tree;
}

class NoFormula extends Error {}

// Read a sum from the first token on. Return null if the tokens do not begin with a sum.
function readSum(tokens) {
  try {
    return sum(tokens, 0, 0);
  } catch (error) {
    if (error instanceof NoFormula) return null;
    throw error;
  }
}

// List the numbers, names and operators of a text. Return null if it holds any other character.
function readTokens(text) {
  const tokens = [];
  for (let at = 0; at < text.length; at = TOKEN.lastIndex) {
    TOKEN.lastIndex = at;
    const match = TOKEN.exec(text);
    if (!match) return null;
    const [, number, name, sign] = match;
    if (number !== undefined) tokens.push(["num", number]);
    else if (sign !== undefined) tokens.push(["sign", sign === "**" ? "^" : sign]);
    else tokens.push(...splitName(name).map((factor) => ["name", factor]));
  }
  return tokens;
}

const splitName = (name) => (FACTORS.test(name) ? name.match(FACTOR) : [name]);

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
      // "(1+2)2" is a product, but "1 234.5" and "0 rad 99.125" are not.
      if (kind === "num" && tokens[next - 1][0] !== "sign") throw new NoFormula();
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
  if (base[1] > TEN && exponent[1] === 0) throw new NoFormula(); // 90^0 stands for 90 degrees
  return [["^", base, exponent], after];
}

function atom(tokens, k, depth) {
  const [kind, word] = at(tokens, k);
  if (kind === "num") return [["num", Number(word), halfPlace(word)], k + 1];
  // "0 radians 1" is no formula: this function needs a bracket.
  const isCall = word === "radians" ? tokens[k + 1]?.[1] === "(" : k + 1 < tokens.length;
  if (isFunction(word) && isCall) {
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
  at(tokens, next); // a token behind a sum can only be the closing bracket
  return [inner, next + 1];
}

// Read the argument of a function, as in "sin(theta_1)" and "sin theta_1".
function argument(tokens, k, depth) {
  if (depth > DEEPEST) throw new NoFormula();
  if (at(tokens, k)[1] !== "-") return atom(tokens, k, depth);
  const [inner, next] = atom(tokens, k + 1, depth);
  return [["neg", inner], next];
}

/**
 * Collect the names in a tree, except constants such as pi.
 * @param {any[]} tree @param {Set<string>} [names] to which they are added
 */
export function symbols(tree, names = new Set()) {
  // No recursion: a sum may have more terms than the call stack has room for.
  for (const trees = [tree]; trees.length;) {
    const [kind, ...operands] = trees.pop();
    if (kind === "name" && !isConstant(operands[0])) names.add(operands[0]);
    trees.push(...operands.filter(Array.isArray).reverse());
  }
  return names;
}

/**
 * Evaluate a tree.
 * @param {any[]} tree @param {(name: string) => number | undefined} known the value of a name
 */
export function value(tree, known) {
  const result = evaluate(tree, known);
  if (!Number.isFinite(result)) {
    throw new ArmError("a formula divides by zero or is too large; expected a finite value");
  }
  return result;
}

function evaluate(tree, known) {
  const operations = []; // no recursion to the left: a sum may have very many terms
  for (; Object.hasOwn(OPERATORS, tree[0]); tree = tree[1]) operations.push(tree);
  return operations.reduceRight(
    (left, [sign, , right]) => OPERATORS[sign](left, evaluate(right, known)),
    evaluateTerm(tree, known),
  );
}

function evaluateTerm([kind, first, second], known) {
  if (kind === "num") return first;
  if (kind === "neg") return -evaluate(first, known);
  if (kind === "call") return FUNCTIONS[first](evaluate(second, known));
  const number = isConstant(first) ? CONSTANTS[first] : known(first);
  if (number === undefined) throw new ArmError(`no value for ${first}`);
  return number;
}

// Return half a unit of the last typed decimal place of a number, or 0 if it has no decimals.
function halfPlace(word) {
  const [mantissa, power = "0"] = word.toLowerCase().split("e");
  const decimals = mantissa.split(".")[1];
  return decimals ? 0.5 * 10 ** (Number(power) - decimals.length) : 0;
}

// In a formula with several numbers, coarse decimals count as exact: 0.5*cos(0.3).
const COARSEST_SLACK = 1e-3;

/**
 * Return the round-off of a formula whose decimals were rounded, to first order. Integers, pi and
 * symbols are exact. If the formula has only a single decimal number, as 2.66*10^-2 and 0.68*pi do,
 * this number is never exact, even if it is coarse.
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

// Return the round-off of a tree. Numbers with half places of `coarsest` or more count as exact.
function slackOf(tree, known, coarsest) {
  const [kind, first, second] = tree;
  if (kind === "name") return 0;
  if (kind === "num") return typedSlack(tree, coarsest);
  if (kind === "neg") return slackOf(first, known, coarsest);
  if (kind === "call") {
    const slack = slackOf(second, known, coarsest);
    return slack && slack * Math.abs(derivative(FUNCTIONS[first], evaluate(second, known)));
  }
  const limit = kind === "*" && isPowerOfTen(second) ? coarsest / value(second, known) : coarsest;
  const [left, right] = [slackOf(first, known, limit), slackOf(second, known, coarsest)];
  if (!left && !right) return 0;
  return SLACKS[kind](left, right, evaluate(first, known), evaluate(second, known));
}

const typedSlack = ([, , half = 0], coarsest) => (half < coarsest ? half : 0);

// The round-off of x and y joined by an operator, where dx and dy are the round-off of x and y.
const SLACKS = {
  "+": (dx, dy) => dx + dy,
  "-": (dx, dy) => dx + dy,
  "*": (dx, dy, x, y) => dx * Math.abs(y) + dy * Math.abs(x),
  "/": (dx, dy, x, y) => dx / Math.abs(y) + (dy * Math.abs(x)) / (y * y),
  "^": (dx, _, x, y) => dx * Math.abs(y * x ** (y - 1)),
};

const isPowerOfTen = (tree) => tree[0] === "^" && tree[1][1] === TEN;
const STEP = 1e-6; // step of the difference quotient
const derivative = (make, x) => (make(x + STEP) - make(x - STEP)) / (2 * STEP);

// Evaluate a text without symbols. Return null if it has symbols or is no formula.
export const number = (text) => tryOrNull(() => value(parse(text), () => undefined));

// List the symbols of a text. Return null if it is no formula.
export const symbolsIn = (text) => tryOrNull(() => [...symbols(parse(text))]);
