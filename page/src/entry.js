// What an entry may look like: one grammar for every field, held against Python's by
// tests/entries.json.
//
//   sum  = term { ("+" | "-") term }        term = factor { ["*" | "/"] factor } [unit]
//   factor = ["+" | "-"] (number | "pi" | "(" sum ")")
//
// A unit after the last of several bare terms is the unit of all of them, where it is the one they
// would have had; otherwise each term says its own. In an angle π counts as radians.

const DEGREE = Math.PI / 180;
const LONGEST_TEXT = 200; // characters, so that no formula is nested too deep to follow

/** What a quantity's units are worth in SI, what a bare number means, and how much is too much. */
export const QUANTITIES = {
  angle: {
    units: { "°": DEGREE, deg: DEGREE, rad: 1 },
    most: 1000,
    of: "an angle",
    such: "90°, pi/2 or 1.571 rad",
  },
  length: {
    units: { m: 1, cm: 0.01, mm: 0.001 },
    bare: "m",
    most: 100,
    of: "a length",
    such: "metres, as 0.333",
  },
  force: { units: { N: 1, kN: 1000 }, bare: "N", most: 1e5, of: "a force", such: "newtons, as −5" },
  moment: {
    units: { "N m": 1, "N mm": 0.001 },
    bare: "N m",
    most: 1e5,
    of: "a moment",
    such: "newton metres, as 0.5",
  },
};

const SAME_SIGN = [
  [/[−–—‐‑﹣－]/g, "-"],
  [/[·×⋅∙]/g, "*"],
  [/÷/g, "/"],
  [/[πΠ𝜋]/gu, " pi "],
  [/[ºd]eg(rees?|s)?\b/gi, "deg"],
  [/º|˚/g, "°"],
  [/rad(ians?|s)?\b/gi, "rad"],
  [/\bN\s*\*?\s*(m{1,2})\b/g, "N $1"],
  [/\b(metres?|meters?)\b/gi, "m"],
  [/\b(newtons?)\b/gi, "N"],
];
const COMMA = /^([^,]*\d|[^,\d]*),(\d+[^,]*)$/;
const TOKEN =
  /\s*(?:(\d+\.?\d*(?:e[-+]?\d+)?|\.\d+(?:e[-+]?\d+)?)|(N mm?|[a-zA-Z]+|°)|([-+*/()]))/y;

const UNITS = new Set(Object.values(QUANTITIES).flatMap(({ units }) => Object.keys(units)));

class Refused extends Error {}

const refuse = (words) => {
  throw new Refused(words);
};

/** A reader of one text: its tokens, and where it is among them. */
class Reader {
  constructor(text, quantity, bare) {
    this.quantity = quantity;
    this.bare = bare;
    this.tokens = tokensOf(text);
    this.place = 0;
  }

  get next() {
    return this.tokens[this.place];
  }

  take(...wanted) {
    return wanted.includes(this.next) ? this.tokens[this.place++] : null;
  }

  sum() {
    const terms = [this.term(1)];
    for (let sign; (sign = this.take("+", "-"));) terms.push(this.term(sign === "+" ? 1 : -1));
    return this.together(terms);
  }

  // One unit for all terms: their own, or the one that a bare number has.
  together(terms) {
    const whole = terms.some((term) => term.unit !== null);
    if (!whole) return { value: terms.reduce((s, t) => s + t.value, 0), unit: null };
    const bare = terms.filter((term) => term.unit === null && term.value !== 0);
    const last = terms.at(-1).unit;
    if (bare.length && last !== this.quantity.units[this.bare]) {
      refuse("mixes numbers with and without a unit; say the unit of each");
    }
    const si = terms.map(({ value, unit }) => value * (unit ?? this.quantity.units[this.bare]));
    return { value: si.reduce((s, v) => s + v, 0), unit: 1 };
  }

  term(sign) {
    let left = this.factor();
    for (;;) {
      const divided = this.take("/");
      if (!divided && !this.take("*") && !this.startsFactor()) break;
      const right = this.factor();
      if (divided && right.unit !== null && !right.pi) refuse("divides by a number with a unit");
      if (left.unit !== null && right.unit !== null && !(left.pi && right.pi))
        refuse("multiplies two units");
      left = {
        value: divided ? left.value / right.value : left.value * right.value,
        unit: divided && right.pi ? left.unit : (left.unit ?? right.unit),
        pi: left.pi || right.pi,
      };
    }
    const unit = this.unit();
    if (unit !== null && left.unit !== null && unit !== left.unit) refuse("has two units");
    return { value: sign * left.value, unit: unit ?? left.unit };
  }

  startsFactor() {
    return this.next === "(" || (this.next === "pi" && this.place > 0);
  }

  unit() {
    const { units } = this.quantity;
    if (typeof this.next !== "string" || /^[-+*/()]|^pi$/.test(this.next)) return null;
    const name = Object.keys(units).find((key) => key === this.next);
    if (!name) refuse(UNITS.has(this.next) ? `has the unit ${this.next}` : "");
    this.place++;
    return units[name];
  }

  factor() {
    const sign = this.take("+", "-");
    if (sign) {
      const { value, ...rest } = this.factor();
      return { value: sign === "-" ? -value : value, ...rest };
    }
    if (this.take("(")) {
      const inner = this.sum();
      if (!this.take(")")) refuse("has a bracket that does not close");
      return inner;
    }
    const token = this.tokens[this.place++];
    if (token === "pi")
      return { value: Math.PI, unit: this.quantity === QUANTITIES.angle ? 1 : null, pi: true };
    if (typeof token !== "number") refuse("");
    return { value: token, unit: null };
  }
}

function tokensOf(text) {
  const tokens = [];
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < text.trimEnd().length) {
    const match = TOKEN.exec(text);
    if (!match) refuse("");
    tokens.push(match[1] ? Number(match[1]) : (match[2] ?? match[3]));
  }
  return tokens;
}

const plain = (typed) => {
  const text = SAME_SIGN.reduce((rest, [sign, ascii]) => rest.replace(sign, ascii), typed.trim());
  return text.includes(".") ? text : text.replace(COMMA, "$1.$2");
};

/**
 * What a reader typed, as { value } in SI, or { error } in words.
 * @param {string} typed
 * @param {keyof typeof QUANTITIES} kind
 * @param {string} [unit] what a bare number is in: deg or rad for an angle
 * @returns {{ value: number, error?: undefined } | { error: string, value?: undefined }}
 */
export function readEntry(typed, kind, unit) {
  const quantity = QUANTITIES[kind];
  const bare = unit && unit in quantity.units ? unit : (quantity.bare ?? "rad");
  const shown = `“${typed.trim().slice(0, 40)}${typed.trim().length > 40 ? "…" : ""}”`;
  if (!typed.trim()) return { error: "is empty; write 0 for none" };
  if (typed.length > LONGEST_TEXT)
    return { error: `has ${typed.length} characters; ${LONGEST_TEXT} are the most` };
  try {
    const reader = new Reader(plain(typed), quantity, bare);
    const { value, unit: own } = reader.sum();
    if (reader.place < reader.tokens.length) refuse("");
    const si = value * (own ?? quantity.units[bare]);
    if (!Number.isFinite(si)) return { error: `${shown} divides by zero or is too large` };
    if (Math.abs(si) > quantity.most)
      return { error: `${shown} is too large for ${quantity.of} here` };
    return { value: si + 0 };
  } catch (fault) {
    if (!(fault instanceof Refused)) throw fault;
    if (fault.message)
      return { error: `${shown} ${fault.message}; ${quantity.of} is asked for: ${quantity.such}` };
    return { error: `${shown} is no number; write ${quantity.such}` };
  }
}

// Whether what is typed so far may still become an entry: no error is said while a reader is in the
// middle of one.
export const unfinished = (typed) =>
  /^\s*$|[-+*/(.,eE−–πp]\s*$/.test(typed) || /^[\s\d.,]*$/.test(typed);
