// Numbers as they are read and typed, and motions in words.

// Fixed digits with a true minus sign, and no minus before a zero.
export function fixed(value, digits) {
  const text = (Math.abs(value) < 0.5 * 10 ** -digits ? 0 : value).toFixed(digits);
  return text.replace("-", "−");
}

// A small number by its power of ten, with true minus signs.
export const powered = (value, digits) => value.toExponential(digits).replaceAll("-", "−");

export const degrees = (value, digits) => `${fixed((value * 180) / Math.PI, digits)}°`;

// Fixed digits for tables, where an exact zero is a plain 0.
export const sparse = (value, digits) => (Math.abs(value) < 1e-12 ? "0" : fixed(value, digits));

export const isAngle = (row) => row.kind !== "prismatic";

// What an entry field of a joint, or of a table's column, asks for.
export const quantityOf = (row) => (isAngle(row) ? "angle" : "length");

// A joint's value with its unit.
export function jointText(row, value, unit) {
  if (!isAngle(row)) return `${fixed(value, 3)} m`;
  return unit === "deg" ? degrees(value, 1) : `${fixed(value, 3)} rad`;
}

// The same as it is spoken.
export function spokenJoint(row, value, unit) {
  if (!isAngle(row)) return `${fixed(value, 3)} metres`;
  const [number, name] =
    unit === "deg" ? [fixed((value * 180) / Math.PI, 1), "degrees"] : [fixed(value, 3), "radians"];
  return `${number.replace("−", "minus ")} ${name}`;
}

// The same in the small print under a slider.
export const limitText = (row, value, unit) =>
  isAngle(row) && unit === "deg"
    ? degrees(value, 0)
    : `${short(value, 2)} ${isAngle(row) ? "rad" : "m"}`;

// What stands in an entry field: as few digits as say the number, quarter turns by name.
export function entryText(value, angle, unit) {
  if (!angle) return short(value, 6);
  if (unit === "deg") return short((value * 180) / Math.PI, 4);
  const twelfths = (value * 12) / Math.PI;
  if (value === 0 || Math.abs(twelfths - Math.round(twelfths)) > 1e-9) return short(value, 6);
  const whole = Math.round(twelfths);
  const common = [12, 6, 4, 3, 2, 1].find((n) => whole % n === 0);
  const [over, under] = [whole / common, 12 / common];
  const top = Math.abs(over) === 1 ? `${over < 0 ? "-" : ""}π` : `${over}π`;
  return (under === 1 ? top : `${top}/${under}`).replace("-", "−");
}

export const short = (value, digits) => String(Number(value.toFixed(digits)) + 0).replace("-", "−");

const MOTIONS = ["move along", "turn about"].flatMap((how) =>
  [..."xyz"].map((axis) => `${how} ${axis}`),
);

// A direction of (vx, vy, vz, wx, wy, wz) in words.
export function motionText(direction) {
  const parts = direction.flatMap((share, i) =>
    Math.abs(share) > 0.02 ? [[share, MOTIONS[i]]] : [],
  );
  if (parts.length === 1) return parts[0][1];
  const sign = Math.sign(parts[0][0]);
  return parts
    .map(
      ([share, name]) =>
        `${fixed(sign * share, 2)} ${name.replace("move ", "").replace("turn ", "")}`,
    )
    .join(", ");
}

// A table in rad and m, its joints by their variables, as every reader of tables takes it back.
export function tableText({ rows }) {
  const number = (value) => String(Number(value.toFixed(9)) + 0);
  const angle = (value) => {
    const text = entryText(value, true, "rad").replace("−", "-").replace("π", "pi");
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

// A list with another value in one place.
export const replaced = (list, at, value) => list.map((v, i) => (i === at ? value : v));

// An arm of the book as a person calls it.
export const called = (name) => name.replace(" (homework)", ", homework’s lengths");
