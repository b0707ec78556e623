// Reads a table from link matrices A_1 ... A_n. Each matrix gives one row.

import { number, parse, simple, symbols, value } from "./formula.js";
import { ENTRIES } from "./table_rows.js";
import { ArmError, formatMessage, formatNumber } from "../sentences.js";

// Split rows of cells into matrices of four rows. Return null unless each ends with 0 0 0 1.
export function splitMatrices(cells) {
  const last = (row) => row.every((text, k) => number(text) === (k === 3 ? 1 : 0));
  if (cells.length % 4 > 0 || !cells.every((row, i) => i % 4 !== 3 || last(row))) return null;
  return Array.from({ length: cells.length / 4 }, (_, k) => cells.slice(4 * k, 4 * k + 4));
}

/**
 * Read one row of the table from its link matrix.
 * @param {number} i the number of the row, from 1
 * @param {string[][]} A the matrix @param {Map<string, number>} known symbols that have numbers
 * @returns {import("./table.js").TypedRow}
 */
export function readLinkMatrix(i, A, known) {
  const trees = A.map((row) => row.map((text) => parse(text, `A_${i}`)));
  const free = [...symbols(["all", ...trees.flat()])].filter((name) => !known.has(simple(name)));
  const at = (x) => {
    const look = (name) => (free.includes(name) ? evaluateName(name, x) : known.get(simple(name)));
    return trees.map((row) => row.map((tree) => value(tree, look)));
  };
  const [zero, one] = [at(0), at(0.5)];
  const numbers = computeEntries(zero);
  const slid = one[2][3] - zero[2][3];
  const slides = Math.abs(slid) > 1e-9;
  const turned = Math.sin(Math.atan2(one[1][0], one[0][0]) - numbers.theta);
  const texts = Object.fromEntries(ENTRIES.map((name) => [name, formatNumber(numbers[name], 6)]));
  requireLinkMatrix(i, zero, numbers);
  requireLinkMatrix(i, one, numbers);
  const kind = slides ? "prismatic" : free.length ? "revolute" : "unknown";
  const backwards = slid + turned < 0; // one of the two is 0
  return { kind, numbers, texts, backwards, radians: new Set(), metres: new Set() };
}

// Return the joint value x, or its cosine for a name such as c_1, or its sine for s1.
function evaluateName(name, x) {
  const match = /^([cs])_?\d+$/i.exec(name);
  if (!match) return x;
  return match[1].toLowerCase() === "c" ? Math.cos(x) : Math.sin(x);
}

const OFF = 2e-2; // error of a matrix whose sines and cosines were rounded to two digits

// Compute the entries of a row from its link matrix A.
const computeEntries = (A) => ({
  a: A[0][3] * A[0][0] + A[1][3] * A[1][0],
  alpha: Math.atan2(A[2][1], A[2][2]),
  d: A[2][3],
  theta: Math.atan2(A[1][0], A[0][0]),
});

const READ_ENTRIES = [
  ["theta", "", "", "a"],
  ["theta", "", "", "a"],
  ["", "alpha", "alpha", "d"],
];

/**
 * Return the entry of the table that a position of a link matrix gives.
 * @param {number[]} position row and column, from 0
 * @returns {string} empty if the number at this position only serves as a check
 */
export const findReadEntry = ([row, column]) => READ_ENTRIES[row]?.[column] ?? "";

/** Reports a matrix that is no link matrix. The key of a known mistake is also its cause. */
export class NoLink extends ArmError {
  constructor(key, fields = {}) {
    super(formatMessage(key, fields));
    this.causes = key.includes(".") ? [key] : [];
  }
}

// Refuse a matrix of numbers that is no product Rot_z Trans_z Trans_x Rot_x.
function requireLinkMatrix(i, A, numbers) {
  const off = findMisfit(A, numbers);
  if (!off) return;
  const turned = A.map((row, k) => row.map((x, n) => (n < 3 ? A[n][k] : x)));
  const key = findMisfit(turned, computeEntries(turned)) ? "no link matrix" : "table.transposed";
  throw new NoLink(key, { i, row: off[0], column: off[1] });
}

// Find the row and column, from 1, of the first number that differs from the link matrix of the
// computed entries.
function findMisfit(A, { a, alpha }) {
  const { d, theta } = computeEntries(A);
  const [c, s, ca, sa] = [theta, alpha].flatMap((x) => [Math.cos(x), Math.sin(x)]);
  const link = [
    [c, -s * ca, s * sa, a * c],
    [s, c * ca, -c * sa, a * s],
    [0, sa, ca, d],
  ];
  const unit = Math.max(1, Math.abs(a));
  for (const [row, entries] of link.entries())
    for (const [k, x] of entries.entries())
      if (Math.abs(A[row][k] - x) > OFF * unit) return [row + 1, k + 1];
  return null;
}
