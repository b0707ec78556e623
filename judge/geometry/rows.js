// Rows of a table as geometry: which entries are angles, which one a joint changes.

// rad: angles are often written with four decimals
export const ANGLE_TOLERANCE = 1e-4;

export const isAngleColumn = (column) => column === "alpha" || column === "theta";

// The entry that a joint changes.
export const jointColumn = (kind) => ({ revolute: "theta", prismatic: "d" })[kind];

// An angle near a multiple of a right angle is taken as that.
export function snapAngle(angle, unit = 0) {
  const right = (Math.round(angle / (Math.PI / 2)) * Math.PI) / 2;
  return Math.abs(angle - right) < Math.max(ANGLE_TOLERANCE, 0.51 * unit) ? right : angle;
}

export const snapRows = (rows) =>
  rows.map((row) => ({ ...row, alpha: snapAngle(row.alpha), theta: snapAngle(row.theta) }));
