// The fields of a question: what each is called, and how it is filled in.

import { joints } from "../../../judge/geometry/kinematics.js";
import { h, write } from "../dom.js";
import { ASKED, OWN, UNITS } from "./question.js";
import { turning } from "../../../judge/reading/numbers.js";

/**
 * @typedef {object} Field
 * @property {string} label
 * @property {string} [hint]
 * @property {[string, string][]} [choices] values and their words; none yet where the arm decides
 * @property {number} [rows] of a field that takes several lines
 * @property {boolean} [whole] as wide as the form
 */

/** @type {(values: string[]) => [string, string][]} */
const guessedOr = (values) => [
  ["", "as it looks"],
  ...values.map((x) => /** @type {[string, string]} */ ([x, x])),
];
const PLAIN = { spellcheck: "false", autocomplete: "off", autocapitalize: "off" };
/** @type {Record<string, Field>} */
const FIELDS = {
  table: {
    label: "Table",
    rows: 6,
    whole: true,
    hint:
      "A row for each joint: a, α, d, θ, with θ or d as “q1” or “θ1 + π/2”. " +
      "In m; angles as chosen.",
  },
  q: { label: "Pose q", hint: "", whole: true },
  unit: { label: "Angles in", choices: UNITS.map((unit) => [unit, unit]) },
  frame: { label: "Rows in the axes of", choices: [] },
  first: {
    label: "Order of the rows",
    choices: [
      ["v", "v, then ω"],
      ["omega", "ω, then v"],
    ],
  },
  wrench: {
    label: "Wrench on the tool, by the world",
    whole: true,
    hint:
      "Fx, Fy, Fz in N, Mx, My, Mz in N m, in base axes; empty for none. " +
      "Gravity is 9.81 m/s² down.",
  },
  columns: {
    label: "Order of the columns",
    hint: "As in “theta d a alpha”; guessed where it is empty.",
  },
  lengths: { label: "Lengths in", choices: guessedOr(["m", "cm", "mm"]) },
  angles: { label: "Angles in", choices: guessedOr(UNITS) },
  convention: {
    label: "Convention",
    choices: [
      ["", "as it looks"],
      ["standard", "standard"],
      ["craig", "modified (Craig)"],
    ],
  },
  target: {
    label: "Where the tip should be",
    rows: 4,
    whole: true,
    hint: "A point x, y, z in m, or a pose: its three or four rows, in base axes.",
  },
  radius: { label: "Radius of the circle below the tip, in m" },
  plane: {
    label: "Its plane",
    choices: [
      ["zy", "towards +y first"],
      ["yz", "towards −y"],
      ["zx", "towards +x"],
      ["xz", "towards −x"],
    ],
  },
  period: { label: "Time for it, in s" },
  steps: { label: "Steps", hint: "Empty: as many as your answer has." },
  pace: {
    label: "Pace",
    choices: [
      ["even", "even"],
      ["rest", "from rest to rest"],
    ],
  },
  values: {
    label: "Your own symbols",
    whole: true,
    hint: "Numbers for those that the arm does not have, in m and rad, as in “h = 0.333, l = 0.1”.",
  },
  answer: { label: "Your answer", hint: "", rows: 8, whole: true },
};
const HINTS = {
  jacobian:
    "Numbers or formulas in q_1, c_1, s_23, …: NumPy, MATLAB, LaTeX, " +
    "Markdown, CSV or spreadsheet cells.",
  table:
    "A row for each link, with heads or without: lists, Link(…) lines, " +
    "MATLAB, LaTeX, Markdown, CSV or cells.",
  branches:
    "A row for each answer, angles in the joints' order; names such as " +
    "theta1 = may stand before them.",
  pose:
    "One value for each joint, in the joints' order; names such as theta1 " +
    "= may stand before them.",
  trace: "A row for each time, one value for each joint, from CSV, MATLAB, NumPy or a spreadsheet.",
  torques:
    "One torque for each joint in N m (N where it slides), from NumPy, " +
    "MATLAB, LaTeX, CSV or a spreadsheet.",
};

const BEGINS = "Pose q at which the circle begins";

// What a small judge leaves to the whole one.
const FURTHER = ["frame", "first", "values", "columns", "lengths", "angles", "convention"];

const option = ([value, words]) => h("option", { value }, words);

/** @param {Field} field @param {string} id @param {string[]} others */
function control({ choices, rows, hint }, id, others) {
  const described =
    hint === undefined ? {} : { "aria-describedby": [`${id}-hint`, ...others].join(" ") };
  const shared = { id, ...described };
  if (choices) return h("select", shared, choices.map(option));
  return rows
    ? h("textarea", { rows, wrap: "off", ...PLAIN, ...shared })
    : h("input", { ...PLAIN, ...shared });
}

function box(field, id, made) {
  const name = h("label", { for: id }, field.label);
  const hint = field.hint === undefined ? [] : [h("p.about", { id: `${id}-hint` }, field.hint)];
  return h(field.whole ? "div.field.whole" : "div.field", {}, name, made, ...hint);
}

/**
 * The form of a judge: its controls and, where one has a place of its own, its box, both by field.
 * @param {string} id
 * @param {any[]} arms
 * @param {any} given what is not asked, since the page says it
 */
export function buildForm(id, arms, given) {
  /** @type {Record<string, any>} */
  const all = {
    ask: {
      label: "Question",
      choices: Object.entries(ASKED).map(([key, { title }]) => [key, title]),
    },
    arm: {
      label: "Arm",
      choices: [
        ...arms.map(({ key, title }) => [key, title]),
        ...(arms.length > 1 && given ? [] : [[OWN, "My own table"]]),
      ],
    },
    ...FIELDS,
  };
  const idOf = (key) => `${id}-${key}`;
  const fields = Object.fromEntries(
    Object.entries(all).map(([key, one]) => [
      key,
      control(one, idOf(key), key === "answer" ? [idOf("private")] : []),
    ]),
  );
  const boxes = Object.fromEntries(
    Object.entries(all).map(([key, one]) => [key, box(one, idOf(key), fields[key])]),
  );
  for (const key of given ? hiddenBy(given, arms) : []) boxes[key]?.classList.add("given");
  const asked = given ? titleOf(given, arms) : "";
  if (given) fields.answer.rows = 6;
  const form = h(
    "form",
    { "aria-label": `Check an answer${asked && `: ${asked}`}` },
    asked ? h("p.asked", {}, "Judged here: ", asked) : [],
    Object.values(boxes),
  );
  return { form, fields, boxes };
}

// What a small judge need not ask, since the chapter says it.
const hiddenBy = (given, arms) => [
  ...Object.keys(given),
  ...FURTHER,
  ...(arms.length < 2 ? ["arm"] : []),
  ...("q" in given ? ["unit"] : []),
];

// What a chapter asks, in a line.
function titleOf({ ask, q, wrench }, arms) {
  const whose = arms.length === 1 ? `, ${arms[0].title}` : "";
  return [`${ASKED[ask].title}${whose}`, q && `q = (${q})`, wrench && `wrench (${wrench})`]
    .filter(Boolean)
    .join(", ");
}

// Show the fields that the question has, and what the arm says about them.
export function adapt({ fields, boxes }, question, arms) {
  const asked = new Set(["ask", "arm", "answer", ...ASKED[question.ask].fields]);
  if (question.arm === OWN) asked.add("table");
  for (const [key, one] of Object.entries(boxes)) one.hidden = !asked.has(key);
  hint(boxes.answer, HINTS[question.ask] ?? "");
  const arm = arms.find(({ key }) => key === question.arm);
  write(boxes.q.querySelector("label"), question.ask === "trace" ? BEGINS : FIELDS.q.label);
  hint(boxes.q, arm ? namesOf(arm) : "One value for each joint, in the table's order.");
  const frames = arm ? arm.rows.length : 16;
  if (fields.frame.options.length !== frames + 1) {
    const name = (k) => (k ? `frame ${k}` : "the base");
    const all = Array.from({ length: frames + 1 }, (_, k) => option([String(k), name(k)]));
    fields.frame.replaceChildren(...all);
    fields.frame.value = question.frame;
  }
}

const hint = (one, words) => write(one.querySelector(".about"), words);

const namesOf = (arm) => {
  const names = joints(arm).map((i) => `q_${i + 1}`);
  return `${names.join(", ")}${turning(arm).includes(false) ? "; m where a joint slides" : ""}`;
};
