// A formula in MathML, made of the tree that the judge reads: what is set is what was understood.

/**
 * An element before it is made: its tag, its text or its parts, and its attributes.
 * @typedef {[string, string | any[], Record<string, string>?]} Piece
 */

const SPACE = "http://www.w3.org/1998/Math/MathML";
const [SUM, PRODUCT, CALL, ATOM] = [1, 2, 3, 4]; // how tightly the parts of a formula hold together
// that a function is taken or factors multiplied: unseen, read aloud
const [APPLIED, TIMES] = ["\u2061", "\u2062"];
const LETTERS = {
  alpha: "α",
  beta: "β",
  gamma: "γ",
  delta: "δ",
  theta: "θ",
  th: "θ",
  phi: "φ",
  psi: "ψ",
  omega: "ω",
  lambda: "λ",
  pi: "π",
  inf: "∞",
};
const FUNCTIONS = { asin: "arcsin", acos: "arccos", atan: "arctan", sind: "sin", cosd: "cos" };
const UNWRITTEN = /^(?:[Ff]loat|Integer|float64|float32|int64)$/;
const IN_DEGREES = /^(?:radians|deg2rad)$/;

const sign = (text) => /** @type {Piece} */ (["mo", text]);
const row = (pieces) => (pieces.length === 1 ? pieces[0] : ["mrow", pieces]);

const FENCE = { stretchy: "false", lspace: "0", rspace: "0" };
const inBrackets = (pieces, open = "(", close = ")") =>
  row([
    ["mo", open, { form: "prefix", ...FENCE }],
    ...pieces,
    ["mo", close, { form: "postfix", ...FENCE }],
  ]);

/** @returns {Piece} */
export const mathOf = (tree) => ["math", [row(set(tree).pieces)], { displaystyle: "true" }];

/**
 * The elements of a formula.
 * @param {Piece} piece
 * @returns {Element}
 */
export function made([tag, content, attributes = {}]) {
  const element = document.createElementNS(SPACE, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...(typeof content === "string" ? [content] : content.map(made)));
  return element;
}

// Whether a tree is a number and nothing else.
export const isPlain = ([kind, inner]) => kind === "num" || (kind === "neg" && inner[0] === "num");

/** @returns {{ level: number, pieces: Piece[] }} */
function set(tree) {
  const [kind, first, second] = tree;
  if (kind === "num") return numeral(first);
  if (kind === "name") return { level: ATOM, pieces: [named(first)] };
  if (kind === "call") return called(first, second);
  if (kind === "^")
    return { level: CALL, pieces: [["msup", [row(within(first, ATOM)), row(set(second).pieces)]]] };
  if (kind === "/" && first[0] === "neg") return sum(["neg", ["/", first[1], second]]);
  if (kind === "/") {
    const parts = [first, second].map((part) => row(set(part).pieces));
    return { level: PRODUCT, pieces: [["mfrac", parts]] };
  }
  return kind === "*" ? product(tree) : sum(tree);
}

// The pieces of a part, in brackets where it holds together less than is needed.
function within(tree, least) {
  const { level, pieces } = set(tree);
  return level < least ? [inBrackets(pieces)] : pieces;
}

function numeral(x) {
  const [digits, power] = String(Math.abs(x)).split("e");
  /** @type {Piece[]} */
  const pieces = [["mn", digits]];
  if (power) {
    const raised = row([
      ...(power[0] === "-" ? [sign("−")] : []),
      ["mn", power.replace(/^[+-]/, "")],
    ]);
    pieces.push(sign("⋅"), ["msup", [["mn", "10"], raised]]);
  }
  return x < 0
    ? { level: SUM, pieces: [sign("−"), ...pieces] }
    : { level: power ? PRODUCT : ATOM, pieces };
}

/** A letter with its index: q_1, theta1, l_pen, s_{2-3}, q'. @returns {Piece} */
function named(name) {
  const [, word, index, prime] = /^([A-Za-z]+)_?(.*?)('?)$/.exec(name.replace(/[{}]/g, ""));
  if (word === "deg" && !index) return ["mi", "°"];
  const letter = /** @type {Piece} */ (["mi", (LETTERS[word] ?? word) + prime.replace("'", "′")]);
  const parts = index.match(/\d+|[A-Za-z_]+|[+-]/g) ?? [];
  const below = parts.map((part) => [
    /\d/.test(part) ? "mn" : /\w/.test(part) ? "mi" : "mo",
    part.replace("-", "−"),
  ]);
  return below.length ? ["msub", [letter, row(below)]] : letter;
}

function called(name, inner) {
  if (UNWRITTEN.test(name)) return set(inner);
  if (name === "sqrt") return { level: ATOM, pieces: [["msqrt", [row(set(inner).pieces)]]] };
  if (name === "abs") return { level: ATOM, pieces: [inBrackets(set(inner).pieces, "|", "|")] };
  if (IN_DEGREES.test(name))
    return { level: PRODUCT, pieces: [...within(inner, ATOM), ["mi", "°"]] };
  const degrees = name.endsWith("d") ? [["mi", "°"]] : [];
  const taken = within(inner, ATOM);
  const bracketed = taken[0][0] === "mrow";
  const argument = bracketed ? taken : [["mspace", "", { width: "0.17em" }], ...taken];
  return {
    level: CALL,
    pieces: [["mi", FUNCTIONS[name] ?? name], sign(APPLIED), ...argument, ...degrees],
  };
}

function product(tree) {
  const factors = chain(tree, ["*"]).map(([, factor]) => factor);
  const leads = factors[0][0] === "neg" || (factors[0][0] === "num" && factors[0][1] < 0);
  const pieces = leads ? set(factors[0]).pieces : within(factors[0], PRODUCT);
  factors.slice(1).forEach((factor, k) => {
    const degree = factor[0] === "name" && factor[1] === "deg";
    if (!degree) pieces.push(sign(dotted(factors[k], factor) ? "⋅" : TIMES));
    pieces.push(...within(factor, PRODUCT));
  });
  return { level: leads ? SUM : PRODUCT, pieces };
}

// Whether a dot must part two factors: before a digit, and between sin x and what is no part of it.
const dotted = (one, next) =>
  digitFirst(next) ||
  (one[0] === "call" && next[0] !== "call" && one[1] !== "sqrt" && one[1] !== "abs");
const digitFirst = ([kind, first]) =>
  kind === "num" || (["^", "*"].includes(kind) && digitFirst(first));

function sum(tree) {
  const pieces = [];
  for (const [operation, term] of chain(tree, ["+", "-"])) {
    if (operation) pieces.push(sign(operation === "-" ? "−" : "+"));
    if (operation) pieces.push(...within(term, PRODUCT));
    else if (term[0] === "neg") pieces.push(sign("−"), ...within(term[1], PRODUCT));
    else pieces.push(...set(term).pieces);
  }
  return { level: SUM, pieces };
}

// The parts of a sum or a product that leans to the left, in their order, each with the sign before
// it.
function chain(tree, signs) {
  const parts = [];
  while (signs.includes(tree[0])) {
    parts.push([tree[0], tree[2]]);
    tree = tree[1];
  }
  return [["", tree], ...parts.reverse()];
}
