// Makes the characters of a pasted text plain: all forms of minus, blank and quote become the same
// character. A matrix of LaTeX, HTML or Word is written with brackets, & and row ends. Line ends
// stay.

export const ROW_END = "\u241e"; // the end of a row, \\ in LaTeX and @ in Word
export const CONTINUED = "\v"; // MATLAB's "..." at the end of a line that continues

/**
 * List a pair of each character and the replacement.
 * @param {string} characters @param {string} replacement @returns {[string, string][]}
 */
export const mapEach = (characters, replacement) =>
  [...characters].map((character) => [character, replacement]);

/** @type {Map<string, string>} */
const PLAIN_CHARACTERS = new Map([
  ...mapEach("−–—‐‑‒﹣－", "-"),
  ...mapEach("\u00a0\u2002\u2003\u2007\u2009\u200a\u202f\u3000", " "),
  ...mapEach("\u200b\ufeff\u2061\u2062", ""),
  ...mapEach("“”„‟`‘’‚", '"'),
  ...mapEach("│┃║", "|"),
  ...mapEach("º˚", "°"),
  ...mapEach("⋅∙", "·"),
  ["≅", "≈"],
  ...Object.entries({
    "，": ",",
    "、": ",",
    "；": ";",
    "：": ":",
    "＝": "=",
    "．": ".",
    "。": ".",
    "٫": ".",
    "（": "(",
    "）": ")",
  }),
  ...[..."０１２３４５６７８９"].flatMap((digit, i) => mapEach(digit, `${i}`)), // in Chinese text
  ...[..."٠١٢٣٤٥٦٧٨٩"].flatMap((digit, i) => mapEach(digit, `${i}`)), // in Arabic text
]);
const FOLDED = new RegExp(`[${[...PLAIN_CHARACTERS.keys()].join("")}]`, "g");

// The characters behind names of HTML and LaTeX.
const NAMED_CHARACTERS = {
  ...{ "&pi;": "π", "&theta;": "θ", "&alpha;": "α", "&tau;": "τ", "&omega;": "ω", "&deg;": "°" },
  ...{
    "&minus;": "-",
    "&nbsp;": " ",
    "&times;": "*",
    "&middot;": "·",
    "\\times": "*",
    "\\cdot": "*",
  },
  ...{ "\\pm": "±", "\\approx": "≈", "\\checkmark": "✓", "\\degree": "°", "\\circ": "°" },
  ...{ "\\radian": "rad", "\\newton": "N", "\\metre": "m", "\\meter": "m" },
  ...{ "\\milli": "m", "\\centi": "c", "\\kilo": "k" },
};
const NAMED = /&[a-z]+;|\\[a-z]+/gi;

const SUPERSCRIPTS = "⁻⁺⁰¹²³⁴⁵⁶⁷⁸⁹";
const RAISED = new RegExp(`[⁻⁺]?[${SUPERSCRIPTS.slice(2)}]+`, "g");
const lowered = (raised) =>
  `^${[...raised].map((digit) => "-+0123456789"[SUPERSCRIPTS.indexOf(digit)]).join("")}`;

/**
 * Replace the forms of a character by the plain form, such as "−" by "-".
 * @template {string | import("./spans.js").SpannedText} T @param {T} text @returns {T}
 */
export const foldCharacters = (text) =>
  /** @type {any} */ (text).replace(FOLDED, (character) => PLAIN_CHARACTERS.get(character));

/**
 * Replace names of characters by the characters, "\\cdot" by "*", and superscripts by powers, "²"
 * by "^2".
 * @template {string | import("./spans.js").SpannedText} T @param {T} text @returns {T}
 */
export const foldNames = (text) =>
  /** @type {any} */ (text)
    .replace(/&#8722;|(?<![\p{L}\d)] ?)minus +(?=[.\d])/gu, "-")
    .replace(NAMED, (name) => NAMED_CHARACTERS[name] ?? name)
    .replace(RAISED, lowered);

// Commands of LaTeX that only add space. A ~ before a number stays: it may be a minus.
const SPACING =
  /\\(?:left|right|[bB]ig[lr]?|displaystyle|q?quad)(?![A-Za-z])\.?|\\[[\],;:! ()]|\$|~(?! *[\d.])/g;
export const withoutSpacing = (text) => text.replace(SPACING, " ");

const MATRIX =
  String.raw`\\(begin|end)\{(?:\w*matrix\*?|array|tabular\*?)\}` +
  String.raw`(?:\[[^\]\n]{0,9}\])?(?:\{[lcr|\s]{0,60}\})?`;
// The end of a row in a column vector, which becomes the semicolon of [1; 2; 3].
const END_IN_COLUMN = new RegExp(
  String.raw`${ROW_END}(?<=\[[^[\]&=]{0,200}${ROW_END})(?=[^[\]&=]{0,200}\])`,
  "g",
);
const NOUNS = "wrist|joint|step|column|link|angle|torque|axis|branch|sol(?:ution)?|lösung";
// Join a noun and its number to a single word: "joint 2" becomes "joint_2".
const joinedNoun = (noun) => `${noun.trim()}_`;

// The argument of a LaTeX command, with braces two deep.
const ARGUMENT = String.raw`\{((?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*)\}`;
const BRACE_BELOW = new RegExp(
  String.raw`\\(?:under|over)brace${ARGUMENT}(?:[_^]${ARGUMENT})?`,
  "g",
);

/** @type {[RegExp, string][]} */
const MAPLE_VECTOR = [
  [/<(?<=(?:^|[=:])[ \t]{0,9}<)(?=\S[^<>\n]{0,500}[,|][^<>\n]{0,500}>)/gm, "["],
  [/>(?<=(?:^|[=:])[ \t]{0,9}\[[^<>[\]\n]{1,500}[,|][^<>[\]\n]{1,500}>)/gm, "]"],
];
/** @type {[RegExp, string][]} */
const FORTRAN_ARRAY = [
  [/\(\/(?=[^()]{0,2000}\/\))/g, "["],
  [/\/\)(?<=\[[^()[\]]{0,2000}\/\))/g, "]"],
];

/** @type {[RegExp, any][]} */
const MATRIX_CHARACTERS = [
  [BRACE_BELOW, "$1"],
  [/\r\n?|[\v\f]/g, "\n"],
  [/\+?[⎛-⎭─-╬]+\+?/g, " "],
  [/\b(?:Sin|Cos|Pi)(?![a-z])/g, (name) => name.toLowerCase()], // Mathematica
  [new RegExp(String.raw`\b(?:${NOUNS})[ \t]+(?=\d)`, "gi"), joinedNoun],
  [/(?<=[A-Za-z]\w*\[\d{1,2})\]\[(?=\d{1,2}\])/g, ","], // J[0][1]
  [/(?<=[\p{L}\p{N}_})\]][ \t]+)(?:is|equals)(?=[ \t]+[-+≈~]?[ ]?[.\d])/gu, "="],
  [/\.\.\.[ \t]*\n/g, CONTINUED],
  [/(\.\d{12,15})(?=-\d)/g, "$1 "], // MATLAB's long numbers stick together
  [new RegExp(MATRIX, "g"), (_, end) => (end === "begin" ? "[" : "]")],
  [/\\(?:hline|cline\{[^{}\n]{0,20}\}|[a-z]+rule)/g, " "],
  [/\\\\(?:\[[^\]\n]{0,9}\])?/g, ROW_END],
  [END_IN_COLUMN, ";"],
  [/:=\s*<<[^:]*>>/g, (rows) => rows.replaceAll("<", "[").replaceAll(">", "]")], // Maple's
  [/\bMatrix\(\s*\d{1,2}\s*,\s*\d{1,2}\s*,(?=\s*\[)/g, "("], // its size before its rows
  ...MAPLE_VECTOR, // <a, b, c>
  ...FORTRAN_ARRAY, // (/ a, b, c /)
  [/^[ \t]*(?:(?:In|Out)[ \t]?\[\d{1,4}\]:?|octave:\d{1,4}>)/gm, ""],
  [/(?<=\d)\*\^(?=-?\d)/g, "e"], // Mathematica's powers of ten
  [/(?<!\^)\{([-,*])\}/g, "$1"], // 0{,}5, {-}0.5 and N{\cdot}m
  [/\b(?:Fraction|Rational)\(\s*(-?\d+)\s*,\s*(\d+)\s*\)/g, "$1/$2"],
  [/(?<=\d\.\d{0,20})[dD](?=[-+]?\d{1,3}(?![\d.]))/g, "e"], // Fortran's exponents
  [/(?<=\d\.\d{1,20})f(?:0|32|64)?(?!\w)/g, ""], // types of C, Julia and Rust
];
// A raised decimal point. No product is written as 0·3, so in its text 12·5 is no product either.
const RAISED_POINT = /(?<![\d.·])0·\d/;
const RAISED_POINTS = /(?<=(?<![\d.·])\d{1,20})·(?=\d{1,20}(?![\d.·^]))/g;
const SLASHES = /(?<=\S[ \t])\/(?=[ \t]\S)/g;
const ONE_ENTRY = /^\s*[^\s,;|&]+(?:\s[-+]\s[^\s,;|&]+)*\s*$/;

// Return whether slashes separate entries, as in "0.1 / 0.2 / 0.3 / 0.4". No formula divides three
// times in a row.
function hasSlashedRows(text) {
  const rows = text.split("\n").map((line) => line.split(SLASHES));
  const slashed = rows.filter(({ length }) => length > 1);
  const isRow = (pieces) =>
    pieces.length > 3 && pieces.slice(1).every((piece) => ONE_ENTRY.test(piece));
  return slashed.length > 0 && slashed.every(isRow);
}

const WORD_MATRIX = /■\(([^■]*)\)/g; // Word's linear matrix, a & b @ c & d
// Dashes before a bracket or np.float64(...), or below a name as in YAML, are bullets. Any other
// dash may be a minus.
const DASHES_ARE_BULLETS =
  /^[ \t]*- +(?=[-[{]|np\.float)|^[A-Za-z]\w*:[ \t]*(?:\n- \d[\d.]*[ \t]*){2}/m;
const BULLET = /^[ \t]*- +/gm;

/**
 * Make a folded text plain.
 * @param {import("./spans.js").SpannedText} folded
 */
export function plainCharacters(folded) {
  const replaced = MATRIX_CHARACTERS.reduce(
    (text, [pattern, replacement]) => text.replace(pattern, replacement),
    folded,
  );
  const pointed = RAISED_POINT.test(replaced.text)
    ? replaced.replace(RAISED_POINTS, ".")
    : replaced;
  const separated = hasSlashedRows(pointed.text) ? pointed.replace(SLASHES, "|") : pointed;
  const spaced = withoutSpacing(separated);
  const plain = spaced.replace(WORD_MATRIX, (_, rows) => `(${rows.replaceAll("@", ROW_END)})`);
  return DASHES_ARE_BULLETS.test(plain.text) ? plain.replace(BULLET, "") : plain;
}

// List the lines of a text.
export const linesOf = (text) => text.split(/\r\n?|[\n\v\f]/);

/**
 * List the nearest lines above and below some lines. Lines without letters and digits are skipped.
 * @param {string[]} lines @param {number} first @param {number} last
 */
export function listNextLines(lines, first, last) {
  const hasText = (line) => /[\p{L}\d]/u.test(line);
  const above = lines.findLastIndex((line, k) => k < first && hasText(line));
  const below = lines.findIndex((line, k) => k > last && hasText(line));
  return [above, below].filter((k) => k >= 0);
}
