// A text in plain signs, as far as its rows and cells need it: one minus, one blank, one quote, and
// what draws or sets a matrix as brackets, & and the sign of a row's end. It keeps its lines' ends.

export const ROW = "\u241e"; // a row's end, as LaTeX's \\ and Word's @ write it
export const GOES_ON = "\v"; // a blank: MATLAB's line goes on in the next one

/** @returns {[string, string][]} */
export const each = (signs, instead) => [...signs].map((sign) => [sign, instead]);
/** @type {Map<string, string>} */
const SAME = new Map([
  ...each("−–—‐‑‒﹣－", "-"),
  ...each("\u00a0\u2002\u2003\u2007\u2009\u200a\u202f\u3000", " "),
  ...each("\u200b\ufeff\u2061\u2062", ""),
  ...each("“”„‟`‘’‚", '"'),
  ...each("│┃║", "|"),
  ["，", ","],
  ["（", "("],
  ["）", ")"],
  ...[..."０１２３４５６７８９"].flatMap((sign, i) => each(sign, `${i}`)), // among Chinese signs
]);
const SIGN = new RegExp(`[${[...SAME.keys()].join("")}]`, "g");
// LaTeX's, which only set a formula out; a ~ before a number may be a minus sign.
const SET =
  /\\(?:left|right|[bB]ig[lr]?|displaystyle|q?quad)(?![A-Za-z])\.?|\\[[\],;:! ]|\$|~(?! *[\d.])/g;

// What formulas and whole texts have in common.
export const sameSigns = (text) => text.replace(SIGN, (sign) => SAME.get(sign));
export const unset = (text) => text.replace(SET, " ");

const MATRIX = String.raw`(?:\w*matrix\*?|array|tabular\*?)`;
// A noun and its number in one word.
const counted = (noun) => `${noun.trim()}_`;

/** @type {[RegExp, any][]} */
const SIGNS = [
  [/\r\n?|[\v\f]/g, "\n"],
  [/\+?[⎛-⎭─-╬]+\+?/g, " "],
  [/\b(?:Sin|Cos|Sqrt|Pi)(?![a-z])/g, (name) => name.toLowerCase()], // Mathematica
  [/\b(?:wrist|joint|column|link|sol(?:ution)?|lösung)[ \t]+(?=\d)/gi, counted],
  [/(?<![\p{L}\p{N}])(τ|θ|tau|theta|q)[ \t]+(?=\d[ \t]*=)/gu, "$1_"],
  [/\\pm\b/g, "±"],
  [/\.\.\.[ \t]*\n/g, GOES_ON],
  [/(\.\d{12,15})(?=-\d)/g, "$1 "], // MATLAB's long numbers stick together
  [/\[(?:\d{1,3},|,\d{1,3})\]/g, " "], // R's rows and columns
  [
    new RegExp(String.raw`\\begin\{${MATRIX}\}(?:\[[^\]\n]{0,9}\])?(?:\{[lcr|\s]{0,60}\})?`, "g"),
    "[",
  ],
  [new RegExp(String.raw`\\end\{${MATRIX}\}`, "g"), "]"],
  [/\\(?:begin|end)\{[a-z]{1,20}\*?\}/g, ROW],
  [/\\(?:hline|(?:top|mid|bottom)rule|c(?:line|midrule)\{[^{}\n]{0,20}\})/g, " "],
  [/\\\\(?:\[[^\]\n]{0,9}\])?/g, ROW],
  [/:=\s*<<[^:]*>>/g, (rows) => rows.replaceAll("<", "[").replaceAll(">", "]")], // Maple's
  [/<\/t[dh]>\s*<t[dh][^<>\n]{0,60}>/gi, " | "], // a page's table
  [/<\/?(?:table|tr|t[dh])\b[^<>\n]{0,60}>/gi, " "],
  [/^[ \t]*(?:In|Out)[ \t]?\[\d{1,4}\]:?/gm, ""],
  [/(?<=\d)\*\^(?=-?\d)/g, "e"], // Mathematica's powers of ten
  [/(?<=\d)\{,\}(?=\d)/g, ","],
];
const WORD = /■\(([^■]*)\)/g; // Word's linear matrix, a & b @ c & d
const BULLETS = /^[ \t]*- +(?=[-[{])/m; // a list whose dashes are no minus signs
const BULLET = /^[ \t]*- +/gm;

/** @param {string} text */
export function plainSigns(text) {
  const signs = SIGNS.reduce(
    (rest, [sign, instead]) => rest.replace(sign, instead),
    sameSigns(text),
  );
  const set = unset(signs).replace(WORD, (_, inner) => `(${inner.replaceAll("@", ROW)})`);
  return BULLETS.test(set) ? set.replace(BULLET, "") : set;
}

// A text's lines.
export const linesOf = (text) => text.split(/\r\n?|[\n\v\f]/);
