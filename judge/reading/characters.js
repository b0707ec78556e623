// The characters of a pasted text in plain form: one minus, one blank, one quote; what draws or
// typesets a matrix becomes brackets, & and the end of a row. Line ends stay.

export const ROW_END = "\u241e"; // a row's end, as LaTeX's \\ and Word's @ write it
export const CONTINUED = "\v"; // a blank: MATLAB's line continues in the next one

/** @returns {[string, string][]} */
export const mapEach = (characters, instead) => [...characters].map((one) => [one, instead]);
const DASH_CHARACTERS = "−–—‐‑‒﹣－";
const DASHES = new RegExp(`[${DASH_CHARACTERS}]`, "g");
/** @type {Map<string, string>} */
const SAME = new Map([
  ...mapEach(DASH_CHARACTERS, "-"),
  ...mapEach("\u00a0\u2002\u2003\u2007\u2009\u200a\u202f\u3000", " "),
  ...mapEach("\u200b\ufeff\u2061\u2062", ""),
  ...mapEach("“”„‟`‘’‚", '"'),
  ...mapEach("│┃║", "|"),
  ["，", ","],
  ["（", "("],
  ["）", ")"],
  ...[..."０１２３４５６７８９"].flatMap((one, i) => mapEach(one, `${i}`)), // among Chinese characters
]);
export const FOLDED = new RegExp(`[${[...SAME.keys()].join("")}]`, "g");
const BLANKS = /[\u00a0\u2002\u2003\u2007\u2009\u200a\u202f\u3000]/g;

/**
 * Replace wide and narrow blanks.
 * @param {import("./spans.js").SpannedText} text
 */
export const foldBlanks = (text) => text.replace(BLANKS, " ");
/**
 * Write each dash as a minus and each degree sign as °.
 * @param {import("./spans.js").SpannedText} text
 */
export const foldSymbols = (text) => text.replace(DASHES, "-").replace(/[º˚]/g, "°");
export const foldCharacter = (one) => SAME.get(one);
// LaTeX's, which only set a formula out; a ~ before a number may be a minus.
export const SPACING =
  /\\(?:left|right|[bB]ig[lr]?|displaystyle|q?quad)(?![A-Za-z])\.?|\\[[\],;:! ()]|\$|~(?! *[\d.])/g;

// Replace the characters that formulas and whole texts write in several ways.
export const foldCharacters = (text) => text.replace(FOLDED, foldCharacter);
export const withoutSpacing = (text) => text.replace(SPACING, " ");

// Characters that a page's source names.
const ENTITIES = {
  ...{ pi: "π", theta: "θ", alpha: "α", tau: "τ", omega: "ω", deg: "°" },
  ...{ minus: "-", nbsp: " ", times: "*", plusmn: "±" },
};

const MATRIX =
  String.raw`\\(begin|end)\{(?:\w*matrix\*?|array|tabular\*?)\}` +
  String.raw`(?:\[[^\]\n]{0,9}\])?(?:\{[lcr|\s]{0,60}\})?`;
const NOUNS = "wrist|joint|step|column|link|angle|torque|axis|branch|sol(?:ution)?|lösung";
// A noun and its number in one word.
const joinedNoun = (noun) => `${noun.trim()}_`;

/** @type {[RegExp, any][]} */
export const MATRIX_CHARACTERS = [
  [/\r\n?|[\v\f]/g, "\n"],
  [/\+?[⎛-⎭─-╬]+\+?/g, " "],
  [/\b(?:Sin|Cos|Sqrt|Pi)(?![a-z])/g, (name) => name.toLowerCase()], // Mathematica
  [new RegExp(String.raw`\b(?:${NOUNS})[ \t]+(?=\d)`, "gi"), joinedNoun],
  [/(?<=[A-Za-z]\w*\[\d{1,2})\]\[(?=\d{1,2}\])/g, ","], // J[0][1]
  [/(?<=[\p{L}\p{N}_})\]][ \t]+)(?:is|equals)(?=[ \t]+[-+≈~]?[ ]?[.\d])/gu, "="],
  [/\\pm\b/g, "±"],
  [/\.\.\.[ \t]*\n/g, CONTINUED],
  [/(\.\d{12,15})(?=-\d)/g, "$1 "], // MATLAB's long numbers stick together
  [new RegExp(MATRIX, "g"), (_, end) => (end === "begin" ? "[" : "]")],
  [/\\(?:hline|(?:top|mid|bottom)rule|c(?:line|midrule)\{[^{}\n]{0,20}\})/g, " "],
  [/\\\\(?:\[[^\]\n]{0,9}\])?/g, ROW_END],
  [/:=\s*<<[^:]*>>/g, (rows) => rows.replaceAll("<", "[").replaceAll(">", "]")], // Maple's
  [/&(pi|theta|alpha|tau|deg|minus|nbsp|times|plusmn|omega);/g, (_, name) => ENTITIES[name]],
  [/<\/?(?:table|tr|(t[dh]))\b[^<>\n]{0,60}>/gi, (_, cell) => (cell ? " | " : " ")], // of a page
  [/^[ \t]*(?:In|Out)[ \t]?\[\d{1,4}\]:?/gm, ""],
  [/(?<=\d)\*\^(?=-?\d)/g, "e"], // Mathematica's powers of ten
  [/(?<=\d)\{,\}(?=\d)/g, ","],
];
const WORD_MATRIX = /■\(([^■]*)\)/g; // Word's linear matrix, a & b @ c & d
// Else a dash may be a minus. A name above a list and a dash before each of its numbers is YAML.
const DASHES_ARE_BULLETS =
  /^[ \t]*- +(?=[-[{])|^[A-Za-z]\w*:[ \t]*\n(?:- \d[\d.]*[ \t]*(?:\n|$)){3}/m;
const BULLET = /^[ \t]*- +/gm;

/**
 * Make a text plain.
 * @param {import("./spans.js").SpannedText} pasted
 */
export function plainCharacters(pasted) {
  const folded = pasted.replace(FOLDED, foldCharacter);
  const plain = MATRIX_CHARACTERS.reduce(
    (text, [pattern, instead]) => text.replace(pattern, instead),
    folded,
  ).replace(SPACING, " ");
  const rows = plain.replace(WORD_MATRIX, (_, inner) => `(${inner.replaceAll("@", ROW_END)})`);
  return DASHES_ARE_BULLETS.test(rows.text) ? rows.replace(BULLET, "") : rows;
}

// A text's lines.
export const linesOf = (text) => text.split(/\r\n?|[\n\v\f]/);
