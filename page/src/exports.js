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
  const joint = (title, type, parent, child, origin, extra = "") =>
    `  <joint name="${title}" type="${type}">\n    <parent link="${parent}"/>\n    <child link="${child}"/>\n` +
    `    <origin xyz="${origin.slice(0, 3).map(number).join(" ")}" ` +
    `rpy="${origin.slice(3).map(number).join(" ")}"/>\n${extra}  </joint>`;
  arm.rows.forEach((row, i) => {
    let parent = `link_${i}`;
    if (moving.includes(i)) {
      const turns = row.kind === "revolute";
      const known =
        row.lower !== null &&
        row.lower !== undefined &&
        row.upper !== null &&
        row.upper !== undefined;
      const [lower, upper] = known ? [row.lower, row.upper] : [-1, 1];
      const type = turns ? (known ? "revolute" : "continuous") : "prismatic";
      const limits = `lower="${number(lower)}" upper="${number(upper)}" `;
      const rest = `effort="${number(row.effort ?? 0)}" velocity="${number(row.speed ?? 0)}"`;
      const extra = `    <axis xyz="0 0 1"/>\n    <limit ${type === "continuous" ? "" : limits}${rest}/>\n`;
      lines.push(
        joint(`joint_${i + 1}`, type, parent, `moved_${i + 1}`, [0, 0, 0, 0, 0, 0], extra),
      );
      lines.push(`  <link name="moved_${i + 1}"/>`);
      parent = `moved_${i + 1}`;
    }
    // Rz(theta) Tz(d) Tx(a) Rx(alpha): the place is (a cos, a sin, d), the turn alpha about x, then
    // theta about z.
    const place = [row.a * Math.cos(row.theta), row.a * Math.sin(row.theta), row.d];
    lines.push(
      joint(`row_${i + 1}`, "fixed", parent, `link_${i + 1}`, [...place, row.alpha, 0, row.theta]),
    );
    lines.push(`  <link name="link_${i + 1}"/>`);
  });
  return [...lines, "</robot>", ""].join("\n");
}
