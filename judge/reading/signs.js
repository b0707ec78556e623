// A text in plain signs, as far as its rows and cells need it: one minus, one blank, one quote, and
// what draws or sets a matrix as brackets, & and the sign of a row's end. It keeps its lines' ends.

export const ROW = "\u241e"; // a row's end, as LaTeX's \\ and Word's @ write it
export const GOES_ON = "\v"; // a blank: MATLAB's line goes on in the next one

const MATRIX = String.raw`(?:\w*matrix\*?|array|tabular\*?)`;
// A noun and its number in one word.
const counted = (noun) => `${noun.trim()}_`;

/** @type {[RegExp, any][]} */
const SIGNS = [
  [/\r\n?|[\v\f\x1c-\x1e\x85\u2028\u2029]/g, "\n"],
  [/[\u2212\u2013\u2014\u2010\u2011\u2012\ufe63\uff0d]/g, "-"],
  [/[\u00a0\u2000-\u200a\u202f\u3000]/g, " "],
  [/[\u200b\ufeff\u2061\u2062]/g, ""],
  [/[“”„‟"`‘’‚]/g, '"'],
  [/，/g, ","],
  [/（/g, "("],
  [/）/g, ")"],
  [/[│┃║]/g, "|"],
  [/[⎛-⎭─-╬+]*[⎛-⎭─-╬]/g, " "],
  [/\b(?:(?:Arc)?(?:Sin|Cos|Tan)|Sqrt|Pi)(?![a-z])/g, (name) => name.toLowerCase()], // Mathematica
  [/\b(?:wrist|joint|axis|column|link|sol(?:ution)?|lösung|answer|case)[ \t]+(?=\d)/gi, counted],
  [/(?<![\p{L}\p{N}])(τ|θ|tau|theta|q)[ \t]+(?=\d[ \t]*=)/gu, "$1_"],
  [/\.\.\.[ \t]*\n/g, GOES_ON],
  [/(\.\d{12,15})(?=-\d)/g, "$1 "], // MATLAB's long numbers stick together
  [/\[(?:\d{1,3},|,\d{1,3})\]/g, " "], // R's rows and columns
  [/\\(?:left|right|big[lr]?|Big[lr]?)(?![A-Za-z])\.?/g, " "],
  [
    new RegExp(String.raw`\\begin\{${MATRIX}\}(?:\[[^\]\n]{0,9}\])?(?:\{[lcr|\s]{0,60}\})?`, "g"),
    "[",
  ],
  [new RegExp(String.raw`\\end\{${MATRIX}\}`, "g"), "]"],
  [/\\(?:begin|end)\{[a-z]{1,20}\*?\}/g, ROW],
  [/\\(?:hline|toprule|midrule|bottomrule|nonumber)(?![A-Za-z])/g, " "],
  [/\\c(?:line|midrule)\{[^{}\n]{0,20}\}/g, " "],
  [/\\\\(?:\[[^\]\n]{0,9}\])?/g, ROW],
  [/:=\s*<</g, ":= [["], // Maple's rows
  [/>[ \t]*;\s*<(?=[^<])/g, "]; ["],
  [/(?<=[^\s>])>>(?!>)/g, "]]"],
  [/<\/t[dh]>[ \t]*<t[dh][^<>\n]{0,60}>/gi, " | "], // a page's table
  [/<\/?(?:table|thead|tbody|tr|t[dh]|br)\b[^<>\n]{0,60}>/gi, " "],
  [/\$(?=[-+])|(?<=[-+])\$/g, ""], // within one entry, $90^\circ$+q_1
  [/\\[[\]$]|\$|\\(?:displaystyle|q?quad)(?![A-Za-z])/g, " "],
  [/\\pm(?![A-Za-z])/g, "±"],
  [/(^|[\t;,|])[ \t]*=(?=[-+.\d])/gm, "$1"], // a spreadsheet's cells
  [/\\[hv]?phantom\{[^{}\n]{0,9}\}|\\[,;:!]/g, " "],
  [/\\num\{([^{}\n]{0,30})\}/g, "$1"],
  [/\\cr(?![A-Za-z])/g, ROW],
  [/~(?![ \t]*[\d.])/g, " "], // LaTeX's blank; before a number it may be a minus sign
  [/\{([-+])\}/g, "$1"],
  [/^[ \t]*(?:In|Out)[ \t]?\[\d{1,4}\]:?/gm, ""],
  [/(?<=\d)\*\^(?=-?\d)/g, "e"], // Mathematica's powers of ten
  [/(?<=\d)\{,\}(?=\d)/g, ","],
];
const WORD = /■\(([^■]*)\)/g; // Word's linear matrix, a & b @ c & d
const BULLETS = /^[ \t]*- +(?=[-[{])/m; // a list whose dashes are no minus signs
const BULLET = /^[ \t]*- +/gm;

/** @param {string} text */
export function plainSigns(text) {
  const signs = SIGNS.reduce((rest, [sign, instead]) => rest.replace(sign, instead), text);
  const set = signs.replace(WORD, (_, inner) => `(${inner.replaceAll("@", ROW)})`);
  return BULLETS.test(set) ? set.replace(BULLET, "") : set;
}
