// The arm shown, for other programs: a table as Python, MATLAB or CSV, the arm as URDF.

import { joints } from "../../judge/geometry/kinematics.js";
import { entryText } from "./text.js";

const plain = (text) => text.replaceAll("−", "-").replaceAll("π", "pi");
const number = (value) => String(Number(value.toFixed(9)) + 0);
const angle = (value) => {
  const text = plain(entryText(value, true, "rad"));
  return text.includes("pi") ? text.replace(/(\d)pi/, "$1*pi") : number(value);
};
const identifier = (name) =>
  name
    .replace(/[^A-Za-z0-9]+/g, "_")
    .replace(/^_|_$/g, "")
    .toLowerCase() || "arm";

export const FORMATS = {
  python: { label: "Python", file: "arm.py" },
  matlab: { label: "MATLAB", file: "arm.m" },
  csv: { label: "CSV", file: "arm.csv" },
  urdf: { label: "URDF", file: "arm.urdf" },
};

const WRITERS = { python, matlab, csv, urdf };

/** @typedef {import("../../judge/geometry/arm.js").Arm} Arm */
/** @param {keyof typeof FORMATS} format @param {{ arm: Arm, q: number[] }} state */
export const exported = (format, { arm, q }) => WRITERS[format](arm, q);

function python(arm, q) {
  const entry = (value) => (value.includes("pi") ? `"${value}"` : value);
  const rows = arm.rows.map(
    (r) =>
      `    ${r.kind}(a=${number(r.a)}, alpha=${entry(angle(r.alpha))}, ` +
      `d=${number(r.d)}, theta=${entry(angle(r.theta))}),`,
  );
  return [
    "from helpers.arm import Arm, fixed, prismatic, revolute",
    "",
    `arm = Arm(${JSON.stringify(arm.name)}, (`,
    ...rows,
    "))",
    `q = [${q.map(number).join(", ")}]`,
    "",
  ].join("\n");
}

function matlab(arm, q) {
  const rows = arm.rows.map(
    (r) => `  ${number(r.a)}  ${angle(r.alpha)}  ${number(r.d)}  ${angle(r.theta)}  % ${r.kind}`,
  );
  const kinds = arm.rows
    .map((r) => ({ revolute: "'R'", prismatic: "'P'", fixed: "'F'" })[r.kind])
    .join(" ");
  return [
    `% ${arm.name}, standard convention: a (m), alpha (rad), d (m), theta (rad)`,
    "DH = [",
    ...rows,
    "];",
    `kind = [${kinds}];  % R turns, P slides, F is fixed`,
    `q = [${q.map(number).join(" ")}];`,
    "",
  ].join("\n");
}

function csv(arm) {
  const rows = arm.rows.map((r) =>
    [r.a, r.alpha, r.d, r.theta].map(number).concat(r.kind).join(","),
  );
  return ["a_m,alpha_rad,d_m,theta_rad,kind", ...rows, ""].join("\n");
}

// Each row is a joint that turns about or slides along z of the frame before it, then a fixed step
// to its own frame.
function urdf(arm) {
  const name = identifier(arm.name);
  const lines = [`<?xml version="1.0"?>`, `<robot name="${name}">`, `  <link name="link_0"/>`];
  const moving = joints(arm);
  arm.rows.forEach((row, i) => {
    const moves = moving.includes(i);
    if (moves) lines.push(...movingJoint(row, i + 1));
    lines.push(...rowStep(row, i + 1, moves ? `moved_${i + 1}` : `link_${i}`));
  });
  return [...lines, "</robot>", ""].join("\n");
}

function joint({ name, type, parent, child, origin }, extra = "") {
  const [xyz, rpy] = [0, 3].map((from) =>
    origin
      .slice(from, from + 3)
      .map(number)
      .join(" "),
  );
  return [
    `  <joint name="${name}" type="${type}">`,
    `    <parent link="${parent}"/>`,
    `    <child link="${child}"/>`,
    `    <origin xyz="${xyz}" rpy="${rpy}"/>\n${extra}  </joint>`,
    `  <link name="${child}"/>`,
  ];
}

function movingJoint(row, i) {
  const known = (row.lower ?? null) !== null && (row.upper ?? null) !== null;
  const [lower, upper] = known ? [row.lower, row.upper] : [-1, 1];
  const type = row.kind !== "revolute" ? "prismatic" : known ? "revolute" : "continuous";
  const range = `lower="${number(lower)}" upper="${number(upper)}" `;
  const most = `effort="${number(row.effort ?? 0)}" velocity="${number(row.speed ?? 0)}"`;
  const limit = `<limit ${type === "continuous" ? "" : range}${most}/>`;
  const [parent, child] = [`link_${i - 1}`, `moved_${i}`];
  return joint(
    { name: `joint_${i}`, type, parent, child, origin: [0, 0, 0, 0, 0, 0] },
    `    <axis xyz="0 0 1"/>\n    ${limit}\n`,
  );
}

// Rz(theta) Tz(d) Tx(a) Rx(alpha): the place is (a cos, a sin, d), the turn alpha about x, then
// theta about z.
function rowStep({ a, alpha, d, theta }, i, parent) {
  const origin = [a * Math.cos(theta), a * Math.sin(theta), d, alpha, 0, theta];
  return joint({ name: `row_${i}`, type: "fixed", parent, child: `link_${i}`, origin });
}
