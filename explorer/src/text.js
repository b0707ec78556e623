// Numbers as they are read and typed, and motions in words.

// Fixed digits with a true minus sign, and no minus before a zero.
export function fixed(value, digits) {
  const text = (Math.abs(value) < 0.5 * 10 ** -digits ? 0 : value).toFixed(digits);
  return text.replace("-", "−");
}

// The same for tables, where an exact zero is a plain 0.
export const sparse = (value, digits) => (Math.abs(value) < 1e-12 ? "0" : fixed(value, digits));

export const isAngle = (row) => row.kind !== "prismatic";

// A joint's value with its unit.
export function jointText(row, value, unit) {
  if (!isAngle(row)) return `${fixed(value, 3)} m`;
  return unit === "deg" ? `${fixed((value * 180) / Math.PI, 1)}°` : `${fixed(value, 3)} rad`;
}

// The same in the small print under a slider.
export const limitText = (row, value, unit) =>
  isAngle(row) && unit === "deg" ? `${fixed((value * 180) / Math.PI, 0)}°` : `${short(value, 2)} ${isAngle(row) ? "rad" : "m"}`;

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

const short = (value, digits) => String(Number(value.toFixed(digits)) + 0).replace("-", "−");

const TOKEN = /\s*(?:(\d+\.?\d*(?:e[-+]?\d+)?|\.\d+)|(pi)|([-+*/()]))/iy;

// The number that a short formula such as "-pi/2" or "0.107 + 0.1" stands for, or null.
function formula(text) {
  const tokens = [];
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < text.length) {
    const match = TOKEN.exec(text);
    if (!match) return null;
    tokens.push(match[1] ? Number(match[1]) : match[2] ? Math.PI : match[3]);
  }
  const value = total(tokens);
  return tokens.length === 0 && Number.isFinite(value) ? value : null;
}

function total(tokens) {
  let value = product(tokens);
  while (tokens[0] === "+" || tokens[0] === "-") value += (tokens.shift() === "+" ? 1 : -1) * product(tokens);
  return value;
}

function product(tokens) {
  let value = factor(tokens);
  for (;;) {
    if (tokens[0] === "*") tokens.shift(), (value *= factor(tokens));
    else if (tokens[0] === "/") tokens.shift(), (value /= factor(tokens));
    else if (tokens[0] === Math.PI || tokens[0] === "(") value *= factor(tokens); // 2π, 2(a)
    else return value;
  }
}

function factor(tokens) {
  const token = tokens.shift();
  if (token === "-") return -factor(tokens);
  if (token === "+") return factor(tokens);
  if (token !== "(") return typeof token === "number" ? token : NaN;
  const value = total(tokens);
  return tokens.shift() === ")" ? value : NaN;
}

// What a reader typed, as { value } in rad or m, or { error } in words. A bare angle is in the unit shown; a
// degree sign or a π says its own.
export function readEntry(typed, angle, unit) {
  const plain = typed.trim().replaceAll("−", "-").replaceAll("π", "pi").replaceAll("·", "*").replace(",", ".");
  if (!plain) return { error: "is empty; write 0 for none" };
  const degrees = /(°|deg)\s*$/i.test(plain);
  if (degrees && !angle) return { error: `is “${typed.trim()}”, but a length is asked for, in metres` };
  const bare = plain.replace(angle ? /(°|deg|rad)\s*$/i : /m\s*$/i, "").trim();
  const value = formula(bare);
  if (value === null) return { error: `“${typed.trim()}” is no number; ${angle ? "write 90°, pi/2 or 1.571" : "write metres, as 0.333"}` };
  if (!angle && Math.abs(value) > 100) return { error: `is ${short(value, 3)} m; lengths are in metres, 100 at most` };
  const inDegrees = angle && (degrees || (unit === "deg" && !/pi|rad/i.test(plain)));
  return { value: inDegrees ? (value * Math.PI) / 180 : value };
}

const MOTIONS = ["move along x", "move along y", "move along z", "turn about x", "turn about y", "turn about z"];

// A direction of (vx, vy, vz, wx, wy, wz) in words.
export function motionText(direction) {
  const parts = direction.flatMap((share, i) => (Math.abs(share) > 0.02 ? [[share, MOTIONS[i]]] : []));
  if (parts.length === 1) return parts[0][1];
  const sign = Math.sign(parts[0][0]);
  return parts.map(([share, name]) => `${fixed(sign * share, 2)} ${name.replace("move ", "").replace("turn ", "")}`).join(", ");
}

export function listed(items, last = "and") {
  return items.length < 2 ? items.join("") : `${items.slice(0, -1).join(", ")} ${last} ${items.at(-1)}`;
}
