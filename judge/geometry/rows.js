// Rows of a table as geometry: which entries are angles, which one a joint changes.

// rad: angles are often written with four decimals
export const ANGLE = 1e-4;

export const angular = (column) => column === "alpha" || column === "theta";

// The entry that a joint changes.
export const variableOf = (kind) => ({ revolute: "theta", prismatic: "d" })[kind];

// An angle near a multiple of a right angle is taken as that.
export function square(angle, unit = 0) {
  const right = (Math.round(angle / (Math.PI / 2)) * Math.PI) / 2;
  return Math.abs(angle - right) < Math.max(ANGLE, 0.51 * unit) ? right : angle;
}

export const squared = (rows) =>
  rows.map((row) => ({ ...row, alpha: square(row.alpha), theta: square(row.theta) }));
