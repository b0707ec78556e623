// Decorations of a number: emphasis, a box, a colour, an approximate sign, an uncertainty, the mark
// of a footnote, a comment. They are taken off; the number keeps its place in the pasted text.

const NUMBER = String.raw`[-+]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][-+]?\d+)?`;
const QUANTITY = String.raw`${NUMBER}(?: ?(?:[kmM]?N ?[·*]?m{0,2}|rad|deg|°|mm?|cm))?`;
const BEFORE = String.raw`(?<=^|[\s|&,;:=[({>])`;
const AFTER = String.raw`(?=$|[\s|&,;:.\])}<])`;
const wrapped = (mark) => new RegExp(`${BEFORE}${mark} ?(${QUANTITY}) ?${mark}${AFTER}`, "gm");

const UNIT =
  String.raw`[kmM]?N\s?[·*.⋅]?\s?m{0,2}|rad(?:ians?)?|deg(?:rees?)?|` +
  String.raw`°|mm?|cm|m\/s|rad\/s`;
const SIUNITX = { newton: "N", metre: "m", meter: "m", radian: "rad", degree: "deg", milli: "m" };
const SUPERSCRIPTS = "⁻⁺⁰¹²³⁴⁵⁶⁷⁸⁹";
const TIMES_TEN = String.raw`(?<=\d)\s*(?:\\times|\\cdot|[×·⋅∙*])\s*10\s*`;

function shortUnit(unit) {
  const letters = unit.replace(/\\([a-z]+)/g, (all, word) => SIUNITX[word] ?? all);
  return letters.replace(/\\cdot|[.\s\\~]/g, "");
}

// x ± u, where u is a few of x's last places; another ± stands for two numbers.
function withoutUncertainty(all, x, uncertainty) {
  if (!/\.\d\d/.test(x)) return all; // 0.3 ± 0.1 may be 0.4 and 0.2
  const place = 10 ** -x.split(".")[1].length;
  return Number(uncertainty) <= 20 * place ? x : all;
}

const FACES = "math(?:bf|sf|it|tt|rm)|bm|boldsymbol|text(?:bf|it|sf|tt)|boxed|underline|num";

/** @type {any[][]} */
const DECORATIONS = [
  [/<sup>\s*[\w*†‡]\s*<\/sup>/gi, ""],
  [/<\/?(?:b|i|u|em|strong|code|span|mark|font|sup|sub|p|div|pre|br)\b[^<>\n]{0,80}>/gi, ""],
  [/\\textcolor\{\w+\}\{([^{}\n]*)\}/g, "$1"],
  [/\{\\color\{\w+\}\s*([^{}\n]*)\}/g, "$1"],
  [/\\(?:SI|qty)\{([^{}\n]*)\}\{([^{}\n]*)\}/g, (_, x, unit) => `${x} ${shortUnit(unit)}`],
  [/\\,\s*\\(?:mathrm|text|si|unit)\{([^{}\n]*)\}/g, (_, unit) => ` ${shortUnit(unit)}`],
  [new RegExp(String.raw`\\(?:${FACES})\{([^{}\n]*)\}`, "g"), "$1"],
  [
    new RegExp(String.raw`${TIMES_TEN}(?:\^|\*\*)\s*[({]?\s*([-+]?\d{1,2})\s*[)}]?(?![\d.])`, "g"),
    "e$1",
  ],
  [
    new RegExp(`${TIMES_TEN}([${SUPERSCRIPTS}]{1,3})`, "g"),
    (_, power) => `e${[...power].map((one) => "-+0123456789"[SUPERSCRIPTS.indexOf(one)]).join("")}`,
  ],
  [/(?<=\d\.\d{3})[\u2009\u202f](?=\d{1,3}(?!\d))/g, ""], // 0.123 456
  [/(?:≈|≃|≅|\\approx(?![a-z])|\\simeq(?![a-z]))\s*(?=[-+−]?[\d.])/g, " "],
  [/(?<=\d\.\d{1,18})\(\d{1,2}\)(?!\s*[*/^])/g, ""], // 0.3768(12)
  [/(?<![\d.])(\d{0,9}\.\d{1,20})\s*(?:±|\\pm(?![a-z])|\+\/-)\s*(\d*\.\d+)/g, withoutUncertainty],
  [/(?<=\d)(?:[†‡§✓✔]|\[\^\w{1,3}\]|\^\{?\(?[a-d]\)?\}?(?!\w)|\^\{\(\d\)\}|[ ]+[✓✔])/g, ""],
  ...["\\*\\*\\*", "\\*\\*", "\\*", "__", "_", "==", "`"].map((mark) => [wrapped(mark), "$1"]),
  [/(?<=\d\.\d{1,18})\*(?=\s*(?:$|[|&;,\]]))/gm, ""], // a star behind
  // A unit behind a name belongs to the name: it is no list.
  [
    new RegExp(String.raw`(?<=[\p{L}\d)}$])[ \t]*[[(]\s*(${UNIT})\s*[\])]`, "gu"),
    (_, unit) => `(${unit.replace(/[\s·*.⋅]/g, "")})`,
  ],
  [/=[ \t]*\d{1,2}[×x]\d{1,2}(?:[ \t]+\w+)?[ \t]*$/gm, "="], // MATLAB's size
];

/**
 * Take decorations off.
 * @param {import("./spans.js").SpannedText} text
 */
export function withoutDecorations(text) {
  const once = (decorated) =>
    DECORATIONS.reduce((rest, [pattern, instead]) => rest.replace(pattern, instead), decorated);
  return once(once(text)); // twice: one within another
}

const NUMBERED = new RegExp(
  String.raw`^([ \t]*)(?:\((\d{1,2})\)|\[(\d{1,2})\]|(\d{1,2})[).]|#(\d{1,2})[.:)]?)` +
    String.raw`[ \t]+(?=[-+−(["'\d.]|np\.)`,
);

/**
 * Write the numbers of numbered lines, (1) 0.5, as labels, 1: 0.5.
 * @param {import("./spans.js").SpannedText} text
 */
export function labelNumberedLines(text) {
  const numbers = text.text.split("\n").flatMap((line) => {
    const match = NUMBERED.exec(line);
    return match ? [Number(match.slice(2).find(Boolean))] : [];
  });
  if (numbers.length < 2 || numbers[0] > 1) return text;
  if (numbers.some((number, k) => number !== numbers[0] + k)) return text;
  const pattern = new RegExp(NUMBERED.source, "gm");
  return text.replace(pattern, (_, blanks, ...groups) => `${blanks}${groups.find(Boolean)}: `);
}

const COMMENTS = [
  /<!--(?:(?!-->)[\s\S]){0,2000}-->/g,
  /~~[^~\n]{1,300}~~/g,
  // A comment with a number; #1 numbers a line, and # q1 q2 q3 may be the column headers.
  /(?:^[ \t]*|(?<=[\d\])},;][ \t]+))(?:#(?!\d)|%|\/\/).*\d[.,]\d.*$/gm,
];

/**
 * Take comments and struck text out; null where there are none.
 * @param {import("./spans.js").SpannedText} text
 */
export function withoutComments(text) {
  const blank = (comment) => comment.replace(/[^\n]/g, " ");
  const rest = COMMENTS.reduce((kept, pattern) => kept.replace(pattern, blank), text);
  return rest === text ? null : rest;
}
