// Decomposes, solves and reduces small matrices.

/**
 * Return the singular values of a matrix, largest first, and its left singular vectors. One-sided
 * Jacobi on the rows is accurate for small singular values too.
 * @param {number[][]} columns of the matrix
 * @param {number} [rows] number of rows used
 */
export function decomposeSingular(columns, rows = 6) {
  const m = Array.from({ length: rows }, (_, i) => columns.map((column) => column[i]));
  const u = Array.from({ length: rows }, (_, i) =>
    Array.from({ length: rows }, (_, j) => Number(i === j)),
  );
  for (let sweep = 0, hasChanged = true; hasChanged && sweep < 30; sweep++) {
    hasChanged = false;
    for (let i = 0; i < rows; i++)
      for (let j = i + 1; j < rows; j++) hasChanged = orthogonalizeRows(m, u, i, j) || hasChanged;
  }
  const order = m.map((row, i) => [Math.hypot(...row), i]).sort((p, q) => q[0] - p[0]);
  return { values: order.map(([value]) => value), vectors: order.map(([, i]) => u[i]) };
}

// Rotate rows i and j of m, and of u with them, until they are orthogonal in m. Return whether they
// were not orthogonal before: their product exceeded round-off.
function orthogonalizeRows(m, u, i, j) {
  let [a, b, c] = [0, 0, 0]; // |m_i|², |m_j|², m_i · m_j
  for (let k = 0; k < m[i].length; k++) {
    a += m[i][k] * m[i][k];
    b += m[j][k] * m[j][k];
    c += m[i][k] * m[j][k];
  }
  if (Math.abs(c) <= 1e-15 * Math.sqrt(a * b) || c * c < 1e-60) return false;
  const zeta = (b - a) / (2 * c);
  const t = (zeta < 0 ? -1 : 1) / (Math.abs(zeta) + Math.sqrt(1 + zeta * zeta));
  const cos = 1 / Math.sqrt(1 + t * t);
  for (const rows of [m, u]) {
    for (let k = 0; k < rows[i].length; k++) {
      const [p, q] = [rows[i][k], rows[j][k]];
      rows[i][k] = cos * (p - t * q);
      rows[j][k] = cos * (t * p + q);
    }
  }
  return true;
}

/** Return the determinant of a matrix of columns; null if it is not square. */
export function determinant(columns) {
  const n = columns.length;
  if (columns.some((column) => column.length !== n)) return null;
  const m = columns.map((column) => [...column]);
  let det = 1;
  for (let k = 0; k < n; k++) {
    const p = findPivot(m, k, k);
    if (m[p][k] === 0) return 0;
    if (p !== k) [m[p], m[k], det] = [m[k], m[p], -det];
    det *= m[k][k];
    for (let i = k + 1; i < n; i++) eliminate(m[i], m[k], k);
  }
  return det;
}

/** Split a list of numbers into rows. @param {number[]} list @param {number} width */
export const splitIntoRows = (list, width) =>
  Array.from({ length: list.length / width }, (_, i) => list.slice(i * width, (i + 1) * width));

/** Subtract lists of numbers entry by entry. @param {number[]} u @param {number[]} v */
export const subtractEach = (u, v) => u.map((x, i) => x - v[i]);

/** Solve A x = b for a square matrix of rows. @param {number[][]} A @param {number[]} b */
export function solveLinear(A, b) {
  const m = A.map((row, i) => [...row, b[i]]);
  const n = m.length;
  for (let k = 0; k < n; k++) {
    const p = findPivot(m, k, k);
    [m[p], m[k]] = [m[k], m[p]];
    for (let i = 0; i < n; i++) if (i !== k) eliminate(m[i], m[k], k);
  }
  return m.map((row, i) => row[n] / row[i]);
}

/**
 * Return a basis of the same space with as many zeros as elimination gives. Its directions can then
 * be named after coordinates.
 * @param {number[][]} vectors of six components
 */
export function simplifyBasis(vectors) {
  const m = vectors.map((v) => [...v]);
  let k = 0;
  for (let column = 0; column < 6 && k < m.length; column++) {
    const p = findPivot(m, k, column);
    if (Math.abs(m[p][column]) < 1e-6) continue;
    [m[p], m[k]] = [m[k], m[p]];
    for (let i = 0; i < m.length; i++) if (i !== k) eliminate(m[i], m[k], column);
    k++;
  }
  return m.map((v) => v.map((x) => x / Math.hypot(...v)));
}

// Return the row, from `firstRow` on, with the largest entry in a column.
function findPivot(m, firstRow, column) {
  let best = firstRow;
  for (let i = firstRow; i < m.length; i++)
    if (Math.abs(m[i][column]) > Math.abs(m[best][column])) best = i;
  return best;
}

// Subtract the multiple of the pivot row that makes the row's entry in a column 0.
function eliminate(row, pivotRow, column) {
  const factor = row[column] / pivotRow[column];
  for (let j = 0; j < row.length; j++) row[j] -= factor * pivotRow[j];
}

/**
 * Return an orthonormal basis of a matrix's null space. For a Jacobian these are the joint rates
 * that leave the tip at rest.
 * @param {number[][]} columns
 * @param {number} [excluded] index of a joint that stays at rest
 */
export function nullSpace(columns, excluded = -1) {
  const free = columns.map((_, k) => k).filter((k) => k !== excluded);
  if (!free.length) return [];
  const rows = columns[0].map((_, i) => free.map((k) => columns[k][i]));
  const { values, vectors } = decomposeSingular(rows, free.length);
  // Singular values below 1e-5 of the largest count as 0, as for the page's self-motion.
  const tolerance = 1e-5 * Math.max(values[0], 1e-12);
  return vectors
    .filter((_, i) => values[i] <= tolerance)
    .map((v) => columns.map((_, k) => (k === excluded ? 0 : v[free.indexOf(k)])));
}
