// Typesets a formula, given as a tree of judge/reading/formula.js, as MathML.

const NAMESPACE = "http://www.w3.org/1998/Math/MathML";
export const GREEK = {
  alpha: "α",
  beta: "β",
  gamma: "γ",
  delta: "δ",
  theta: "θ",
  phi: "φ",
  psi: "ψ",
  omega: "ω",
  lambda: "λ",
  pi: "π",
};
const [SUM, PRODUCT, POWER] = [1, 2, 3]; // a part of lower rank stands in brackets
const RANKS = { "+": SUM, "-": SUM, neg: SUM, "*": PRODUCT, "/": PRODUCT, "^": POWER };
const UNIT_NAMES = new Set(["deg", "rad"]);

/**
 * Return a formula as a `math` element.
 * @param {any[]} tree
 */
export const typesetFormula = (tree) => m("math", ...typesetTree(tree));

function m(tag, ...children) {
  const element = document.createElementNS(NAMESPACE, tag);
  element.append(...children);
  return element;
}

const row = (parts) => (parts.length === 1 ? parts[0] : m("mrow", ...parts));

/** @param {any} tree @returns {Element[]} */
function typesetTree([kind, first, second]) {
  switch (kind) {
    case "num":
      return [m("mn", formatTyped(first, second))];
    case "name":
      return [typesetName(first)];
    case "neg":
      return [m("mo", "−"), ...typesetPart(first, PRODUCT)];
    case "call":
      return typesetCall(first, second);
    case "^":
      return [m("msup", row(typesetPart(first, POWER + 1)), row(typesetTree(second)))];
    case "/":
      return [m("mfrac", row(typesetTree(first)), row(typesetTree(second)))];
    case "*":
      return [
        ...(first[0] === "neg" ? typesetTree(first) : typesetPart(first, PRODUCT)),
        beginsWith("num", second) ? m("mo", "·") : m("mspace"),
        ...typesetPart(second, PRODUCT),
      ];
    default: // a sum or a difference
      return [
        ...typesetTree(first),
        m("mo", kind.replace("-", "−")),
        ...(beginsWith("neg", second)
          ? bracket(typesetTree(second))
          : typesetPart(second, kind === "-" ? PRODUCT : SUM)),
      ];
  }
}

// Typeset a part of a formula, in brackets if its rank is lower than `rank`.
function typesetPart(tree, rank) {
  const parts = typesetTree(tree);
  return (RANKS[tree[0]] ?? POWER + 1) >= rank ? parts : bracket(parts);
}

function bracket(parts) {
  const [before, after] = [m("mo", "("), m("mo", ")")];
  before.setAttribute("form", "prefix");
  after.setAttribute("form", "postfix");
  return [before, ...parts, after];
}

function typesetCall(name, argument) {
  const parts = typesetTree(argument);
  return name === "sqrt" ? [m("msqrt", ...parts)] : [m("mi", name), ...bracket(parts)];
}

// A name with an index: theta_1, s_23, d_{pen}, q1.
function typesetName(name) {
  const [, letters, index] = /^([A-Za-z]+)_?\{?(.*?)\}?$/.exec(name) ?? [null, name, ""];
  const symbol = m(
    "mi",
    UNIT_NAMES.has(letters) ? `\u2009${letters}` : (GREEK[letters] ?? letters),
  );
  return index ? m("msub", symbol, m(/^\d+$/.test(index) ? "mn" : "mi", index)) : symbol;
}

// Return whether the first sign of a formula is of a kind: a number or a minus.
function beginsWith(kind, tree) {
  while (["*", "^"].includes(tree[0])) tree = tree[1];
  return tree[0] === kind;
}

// Format a number with its typed decimals. `half` is half a unit of its last decimal place.
function formatTyped(number, half = 0) {
  const decimals = half ? Math.round(-Math.log10(2 * half)) : 0;
  return half && decimals <= 20 && decimals >= 0 && number >= 1e-6
    ? number.toFixed(decimals)
    : String(number);
}
