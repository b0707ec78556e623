// The fields of a question: what each is called, and how it is filled in. What has a good default
// is folded into one line that tells it.

import { movingRows } from "../../../judge/geometry/kinematics.js";
import { h, write } from "../dom.js";
import { ASKED, CHOICES, OWN } from "./question.js";
import { called } from "../text.js";
import { joinList } from "../../../judge/sentences.js";

/**
 * @typedef {object} Field
 * @property {string} label
 * @property {string} [hint] below it, or in it where it takes several lines
 * @property {string[][]} [choices] values and their words, where CHOICES has none; none yet where
 *   the arm decides
 * @property {number} [rows] of a field that takes several lines
 * @property {string} [told] how it is told in the line, before its value, where it is folded
 * @property {string} [name] in the list of what is guessed where it is empty
 */

const PLAIN = { spellcheck: "false", autocomplete: "off", autocapitalize: "off" };
/** @type {Record<string, Field>} */
const FIELDS = {
  table: {
    label: "Table",
    rows: 5,
    hint:
      "A row for each joint: a, α, d, θ, with θ or d as “q1” or “θ1 + π/2”. " +
      "In m; angles as chosen.",
  },
  q: { label: "Pose q", hint: "" },
  target: {
    label: "Where the tip should be",
    rows: 4,
    hint: "A point x, y, z in m, or a pose: its three or four rows, in base axes.",
  },
  wrench: {
    label: "Wrench on the tool, by the world",
    hint:
      "Fx, Fy, Fz, Mx, My, Mz in N and N m, in base axes; empty for none. " +
      "Gravity is 9.81 m/s² down.",
  },
  unit: { label: "Angles in", told: "angles in" },
  first: { label: "Order of the rows", told: "rows" },
  frame: { label: "Rows in the axes of", told: "in the axes of", choices: [] },
  columns: { label: "Order of the columns", told: "columns", name: "columns" },
  lengths: { label: "Lengths in", told: "lengths in", name: "lengths" },
  angles: { label: "Angles in", told: "angles in", name: "angles" },
  convention: { label: "Convention", told: "convention", name: "convention" },
  radius: { label: "Radius of the circle below the tip, in m", told: "radius in m" },
  plane: { label: "Its plane", told: "first" },
  period: { label: "Time for it, in s", told: "seconds" },
  steps: { label: "Steps", told: "steps", name: "steps" },
  pace: { label: "Pace", told: "pace" },
  values: { label: "Your own symbols, as in “h = 0.333, l = 0.1”, in m and rad", told: "with" },
  answer: { label: "Your answer", rows: 7, hint: "" },
};
const HINTS = {
  jacobian: "Numbers, or formulas in q_1, c_1, s_23, …\nfrom NumPy, MATLAB, LaTeX, a spreadsheet.",
  table: "A row for each link, with heads or without:\nMATLAB, LaTeX, Markdown, Link(…), cells.",
  branches: "A row for each answer, one value for each joint.",
  pose: "One value for each joint, in the joints' order.",
  trace: "A row for each time, one value for each joint:\nCSV, MATLAB, NumPy, a spreadsheet.",
  torques: "One torque for each joint, in N m (N where it slides).",
};
const BEGINS = "Pose q at which the circle begins";
const FOLDED = Object.keys(FIELDS).filter((key) => FIELDS[key].told);

const option = ([value, words]) => h("option", { value }, words);

/** @param {Field} field @param {string} id */
function control({ choices, rows, hint }, id, words) {
  const shared = { id, "aria-describedby": hint === undefined || rows ? undefined : `${id}-hint` };
  const list = choices ?? (words && Object.entries(words));
  if (list) return h("select", shared, list.map(option));
  const placeholder = rows ? hint : undefined;
  return rows
    ? h("textarea", { rows, wrap: "off", placeholder, ...PLAIN, ...shared })
    : h("input", { ...PLAIN, ...shared });
}

function box({ label, hint, rows }, id, made) {
  const below = hint === undefined || rows ? [] : [h("p.about", { id: `${id}-hint` }, hint)];
  return h("div.field", {}, h("label", { for: id }, label), made, ...below);
}

/**
 * The form of a judge: its controls and their boxes, both by field, and the line that tells what
 * is folded.
 * @param {string} id
 * @param {any[]} arms
 * @param {any} given what is not asked, since the page says it
 */
export function buildForm(id, arms, given) {
  const asks = Object.entries(ASKED).map(([key, { title }]) => [key, title]);
  const whose = arms.map((arm) => [arm.key, called(arm.title)]);
  const own = arms.length > 1 && given ? [] : [[OWN, "My own table"]];
  /** @type {Record<string, any>} */
  const all = {
    ask: { label: "Question", choices: asks },
    arm: { label: "Arm", choices: [...whose, ...own] },
    ...FIELDS,
  };
  const entries = Object.entries(all);
  const fields = Object.fromEntries(
    entries.map(([key, one]) => [key, control(one, `${id}-${key}`, CHOICES[key])]),
  );
  const boxes = Object.fromEntries(
    entries.map(([key, one]) => [key, box(one, `${id}-${key}`, fields[key])]),
  );
  for (const key of given ? hiddenBy(given, arms) : []) boxes[key]?.classList.add("given");
  const asked = given ? titleOf(given, arms) : "";
  const told = h("summary");
  const folded = h("details", {}, told, h("div.pairs", {}, ...FOLDED.map((key) => boxes[key])));
  const form = h(
    "form",
    { "aria-label": `Check an answer${asked && `: ${asked}`}` },
    asked ? h("p.asked", {}, "Judged here: ", asked) : [],
    h("div.pairs", {}, boxes.ask, boxes.arm),
    ...["table", "q", "target", "wrench"].map((key) => boxes[key]),
    folded,
    boxes.answer,
  );
  return { form, fields, boxes, told, folded };
}

// What a small judge need not ask, since the chapter says it.
const hiddenBy = (given, arms) => [
  ...Object.keys(given),
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
export function adapt({ fields, boxes, told, folded }, question, arms) {
  const asked = new Set(["ask", "arm", "answer", ...ASKED[question.ask].fields]);
  if (question.arm === OWN) asked.add("table").add("unit");
  for (const [key, one] of Object.entries(boxes)) one.hidden = !asked.has(key);
  fields.answer.placeholder = HINTS[question.ask];
  const arm = arms.find(({ key }) => key === question.arm);
  write(boxes.q.querySelector("label"), question.ask === "trace" ? BEGINS : FIELDS.q.label);
  const hint = arm ? namesOf(arm) : "One value for each joint, in the table's order.";
  write(boxes.q.querySelector(".about"), hint);
  const frames = arm ? arm.rows.length : 16;
  if (fields.frame.options.length !== frames + 1) {
    const all = Array.from({ length: frames + 1 }, (_, k) => option([String(k), frameName(k)]));
    fields.frame.replaceChildren(...all);
    fields.frame.value = question.frame;
  }
  const shown = FOLDED.filter((key) => asked.has(key));
  folded.hidden = !shown.length;
  write(told, toldOf(shown, fields));
}

// What is taken for granted, in a line.
function toldOf(keys, fields) {
  const words = (key) => fields[key].selectedOptions?.[0]?.textContent ?? fields[key].value;
  const said = keys.filter((key) => fields[key].value);
  const guessed = keys.filter((key) => !fields[key].value && FIELDS[key].name);
  const parts = said.map((key) => `${FIELDS[key].told} ${words(key)}`);
  if (guessed.length)
    parts.push(`${joinList(guessed.map((key) => FIELDS[key].name))} as they look`);
  return `Taken: ${parts.join("; ")}`;
}

const frameName = (k) => (k ? `frame ${k}` : "the base");

const namesOf = (arm) => {
  const names = movingRows(arm).map((i) => `q_${i + 1}`);
  const slides = arm.rows.some(({ kind }) => kind === "prismatic");
  return `${names.join(", ")}${slides ? "; m where a joint slides" : ""}`;
};

/**
 * The field that an advice of the judge's sets, and to what.
 * @type {Record<string, (value: any, question: any, arms: any[]) => [string, string | undefined]>}
 */
const SETS = {
  angles: (value, { ask }) => [ask === "table" ? "angles" : "unit", value],
  angularFirst: (value) => ["first", value ? "omega" : "v"],
  frame: (value) => ["frame", String(value)],
  convention: (value) => ["convention", value],
  lengths: (value) => ["lengths", value],
  locked: (value, { arm }) => ["arm", `${arm}.lock(${value})`],
  arm: (value, _, arms) => ["arm", arms.find(({ title }) => title === value)?.key],
  values: (value, { values }) => ["values", [values, `${value} = `].filter(Boolean).join(", ")],
};

/**
 * What an advice sets here, in the words of its field; null where it sets nothing.
 * @param {import("../../../judge/advice.js").Advice} advice
 * @param {import("./question.js").Question} question
 */
export function offerOf({ field, value }, question, arms) {
  const [key, to] = SETS[field]?.(value, question, arms) ?? [];
  const words = key && to !== question[key] && wordsOf(key, to, arms);
  const label = key === "values" ? "Your own symbols" : (FIELDS[key]?.label ?? "Arm");
  return words ? { key, value: to, words: `${label}: ${words}` } : null;
}

function wordsOf(key, to, arms) {
  if (key === "arm") return arms.find((one) => one.key === to)?.title;
  if (key === "frame") return frameName(Number(to));
  return CHOICES[key]?.[to] ?? `${to}…`;
}
