// Format numbers for reading and typing, and describe motions.

// Format with fixed digits, a true minus sign, and no minus before zero.
export function formatFixed(value, digits) {
  const text = (Math.abs(value) < 0.5 * 10 ** -digits ? 0 : value).toFixed(digits);
  return text.replace("-", "−");
}

// Format a small number as a power of ten, with true minus signs.
export const formatScientific = (value, digits) => value.toExponential(digits).replaceAll("-", "−");

export const formatDegrees = (value, digits) => `${formatFixed((value * 180) / Math.PI, digits)}°`;

// Format with fixed digits for tables, where an exact zero is 0.
export const formatSparse = (value, digits) =>
  Math.abs(value) < 1e-12 ? "0" : formatFixed(value, digits);

export const isAngle = (row) => row.kind !== "prismatic";

// Return the quantity that a joint's field expects.
export const getQuantity = (row) => (isAngle(row) ? "angle" : "length");

// Format a joint value with its unit.
export function formatJointValue(row, value, unit) {
  if (!isAngle(row)) return `${formatFixed(value, 3)} m`;
  return unit === "deg" ? formatDegrees(value, 1) : `${formatFixed(value, 3)} rad`;
}

// Format a joint value for screen readers.
export function formatSpokenValue(row, value, unit) {
  if (!isAngle(row)) return `${formatFixed(value, 3)} metres`;
  const [number, name] =
    unit === "deg"
      ? [formatFixed((value * 180) / Math.PI, 1), "degrees"]
      : [formatFixed(value, 3), "radians"];
  return `${number.replace("−", "minus ")} ${name}`;
}

// Format a joint limit for the small print under a slider.
export const formatLimit = (row, value, unit) =>
  isAngle(row) && unit === "deg"
    ? formatDegrees(value, 0)
    : `${formatShort(value, 2)} ${isAngle(row) ? "rad" : "m"}`;

// Format a value for a text field: as few digits as possible, and fractions of π by name.
export function formatEntry(value, angle, unit) {
  if (!angle) return formatShort(value, 6);
  if (unit === "deg") return formatShort((value * 180) / Math.PI, 4);
  const twelfths = (value * 12) / Math.PI;
  if (value === 0 || Math.abs(twelfths - Math.round(twelfths)) > 1e-9) return formatShort(value, 6);
  const whole = Math.round(twelfths);
  const common = [12, 6, 4, 3, 2, 1].find((n) => whole % n === 0);
  const [over, under] = [whole / common, 12 / common];
  const top = Math.abs(over) === 1 ? `${over < 0 ? "-" : ""}π` : `${over}π`;
  return (under === 1 ? top : `${top}/${under}`).replace("-", "−");
}

export const formatShort = (value, digits) =>
  String(Number(value.toFixed(digits)) + 0).replace("-", "−");

const MOTIONS = ["move along", "turn about"].flatMap((how) =>
  [..."xyz"].map((axis) => `${how} ${axis}`),
);

// Describe a direction (vx, vy, vz, wx, wy, wz).
export function describeMotion(direction) {
  const parts = direction.flatMap((share, i) =>
    Math.abs(share) > 0.02 ? [[share, MOTIONS[i]]] : [],
  );
  if (parts.length === 1) return parts[0][1];
  const sign = Math.sign(parts[0][0]);
  return parts
    .map(
      ([share, name]) =>
        `${formatFixed(sign * share, 2)} ${name.replace("move ", "").replace("turn ", "")}`,
    )
    .join(", ");
}

// Format a table in rad and m with its joint variables; every table reader of the book can read it.
export function formatTable({ rows }) {
  const number = (value) => String(Number(value.toFixed(9)) + 0);
  const angle = (value) => {
    const text = formatEntry(value, true, "rad").replace("−", "-").replace("π", "pi");
    return text.includes("pi") ? text.replace(/(\d)pi/, "$1*pi") : number(value);
  };
  const moved = (i, text) => (text === "0" ? `q${i}` : `q${i} + ${text}`.replace("+ -", "- "));
  const lines = rows.map(({ kind, a, alpha, d, theta }, k) => {
    const [along, about] = [number(d), angle(theta)];
    const entries = [number(a), angle(alpha), along, about];
    if (kind === "prismatic") entries[2] = moved(k + 1, along);
    if (kind === "revolute") entries[3] = moved(k + 1, about);
    return [k + 1, ...entries].join("\t");
  });
  return ["i\ta (m)\talpha (rad)\td (m)\ttheta (rad)", ...lines, ""].join("\n");
}

// Return a copy of a list with one entry replaced.
export const replaceAt = (list, at, value) => list.map((v, i) => (i === at ? value : v));

// Return the name of an arm for display.
export const getDisplayName = (name) => name.replace(" (homework)", ", homework’s lengths");
