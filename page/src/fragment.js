// Writes numbers and rows of a table into the fragment of a link to the explorer.

/** @param {number[]} values */
export const formatNumbers = (values) => values.map((v) => Number(v.toFixed(6)) + 0).join(",");

/**
 * Format rows, each as its kind's first letter and its four entries.
 * @param {import("../../judge/geometry/arm.js").TableRow[]} rows
 */
export const formatRows = (rows) =>
  rows
    .map(({ kind, a, alpha, d, theta }) => {
      return `${kind[0].toUpperCase()},${formatNumbers([a, alpha, d, theta])}`;
    })
    .join(";");
