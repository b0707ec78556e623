// Makes the fields of a question, with labels, hints and controls. Fields with a good default are
// folded into a line that states their values.

import { jointNames, movingRows } from "../../../judge/geometry/kinematics.js";
import { h, setText } from "../dom.js";
import { canBeAsked, CHOICES, OWN_ARM, QUESTIONS } from "./question.js";
import { getDisplayName } from "../text.js";
import { makeNumberGrid } from "./number_grid.js";
import { joinList } from "../../../judge/sentences.js";

/**
 * @typedef {object} Field
 * @property {string} label
 * @property {string} [hint] below the field, or inside it if it has several lines
 * @property {string[][]} [choices] values and their labels, if CHOICES has none; empty if they
 *   depend on the arm
 * @property {number} [rows] of a field with several lines
 * @property {string} [told] label in the folded line, before the value
 * @property {string} [name] label in the folded line while the field is empty and its value is
 *   guessed
 */

/** @typedef {import("./question.js").Question} Question */
/** @typedef {import("./question.js").ListedArm} ListedArm */
/** @typedef {import("../../../judge/advice.js").Advice} Advice */

const NO_CORRECTION = { spellcheck: "false", autocomplete: "off", autocapitalize: "off" };
/** @type {Record<string, Field>} */
const FIELDS = {
  table: {
    label: "Table",
    rows: 5,
    hint:
      "A row for each joint: a, α, d, θ, with θ or d as “q1” or “θ1 + π/2”. " +
      "In m; angles as chosen.",
  },
  q: { label: "Configuration q", hint: "" },
  target: {
    label: "Where the tip should be",
    rows: 4,
    hint: "A point x, y, z in m, or a pose: its three or four rows, in base axes.",
  },
  wrench: {
    label: "Wrench on the tool, by the world",
    hint: "Fx, Fy, Fz, Mx, My, Mz in N and N m, in base axes; empty for none.",
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
const OWN_TABLE = "My own table";
const ANSWER_HINTS = {
  jacobian: "Numbers, or formulas in q_1, c_1, s_23, …\nfrom NumPy, MATLAB, LaTeX, a spreadsheet.",
  table: "A row for each link, with heads or without:\nMATLAB, LaTeX, Markdown, Link(…), cells.",
  branches: "A row for each answer, one value for each joint.",
  pose: "One value for each joint, in the joints' order.",
  trace: "A row for each time, one value for each joint:\nCSV, MATLAB, NumPy, a spreadsheet.",
  torques: "One torque for each joint, in N m (N where it slides).",
};
const STATED_LENGTHS = "m, unless the text says";
const CONTRACT =
  "I judge the numbers of your answer: sentences change none of them, and a number that belongs " +
  "to nothing stops me.";
const GRAVITY_HINT = "Gravity is 9.81 m/s² down.";
const NO_MASSES_HINT = "This arm has no masses here: the wrench alone loads its joints.";
const CIRCLE_START_LABEL = "Configuration q at which the circle begins";
const FOLDED_FIELDS = Object.keys(FIELDS).filter((key) => FIELDS[key].told);

const makeOption = ([value, text]) => h("option", { value }, text);

/** @param {Field} field @param {string} id */
function makeControl({ choices, rows, hint }, id, options) {
  const shared = { id, "aria-describedby": hint === undefined || rows ? undefined : `${id}-hint` };
  const list = choices ?? (options && Object.entries(options));
  if (list) return h("select", shared, list.map(makeOption));
  const placeholder = rows ? hint : undefined;
  return rows
    ? h("textarea", { rows, wrap: "off", placeholder, ...NO_CORRECTION, ...shared })
    : h("input", { ...NO_CORRECTION, ...shared });
}

/** @param {Field} field @param {string} id @param {HTMLElement} control */
function makeBox({ label, hint, rows }, id, control) {
  const below = hint === undefined || rows ? [] : [h("p.about", { id: `${id}-hint` }, hint)];
  return h("div.field", {}, h("label", { for: id }, label), control, ...below);
}

// Make the box of the answer: its label with room for buttons beside it, and below what is judged.
function makeAnswerBox({ label }, id, control) {
  const over = h("div.over", {}, h("label", { for: id }, label));
  return h("div.field", {}, over, control, h("p.about", {}, CONTRACT));
}

/**
 * Build the form: its controls and their boxes, both by field, and the folded line.
 * @param {string} id
 * @param {ListedArm[]} arms
 * @param {Partial<Question>} [given] fields that the chapter fixes; they are not shown
 */
export function buildForm(id, arms, given) {
  const asks = Object.entries(QUESTIONS).map(([key, { title }]) => [key, title]);
  const whose = arms.map((arm) => [arm.key, getDisplayName(arm.title)]);
  const own = arms.length > 1 && given ? [] : [[OWN_ARM, OWN_TABLE]];
  /** @type {Record<string, Field>} */
  const all = {
    ask: { label: "Question", choices: asks },
    arm: { label: "Arm", choices: [...whose, ...own] },
    ...FIELDS,
  };
  const entries = Object.entries(all);
  const fields = Object.fromEntries(
    entries.map(([key, field]) => [key, makeControl(field, `${id}-${key}`, CHOICES[key])]),
  );
  const boxes = Object.fromEntries(
    entries.map(([key, field]) => [
      key,
      (key === "answer" ? makeAnswerBox : makeBox)(field, `${id}-${key}`, fields[key]),
    ]),
  );
  boxes.table.append(h("p.about.reading", { role: "status" }));
  const grids = addGrids(boxes);
  for (const key of given ? listGivenFields(given, arms) : [])
    boxes[key]?.classList.add("fixed-field");
  const asked = given ? describeQuestion(given, arms) : "";
  const told = h("summary");
  const folded = h(
    "details",
    {},
    told,
    h("div.pairs", {}, ...FOLDED_FIELDS.map((key) => boxes[key])),
  );
  const form = h(
    "form",
    { "aria-label": `Check an answer${asked && `: ${asked}`}` },
    asked ? h("p.asked", {}, "Judged here: ", asked) : [],
    h("div.pairs", {}, boxes.ask, boxes.arm),
    boxes.table,
    h("div.pairs", {}, boxes.q, boxes.target, boxes.wrench),
    folded,
    boxes.answer,
  );
  return { form, fields, boxes, grids, told, folded };
}

const EXAMPLE_WRENCH = "This wrench is the example's: write yours, or empty the field. ";

/**
 * Say below the wrench whether the page filled it in for an example, and what else loads the arm.
 * @param {HTMLElement} box
 * @param {boolean} isExample
 * @param {ListedArm} [arm] undefined for the reader's own table, which has no masses
 */
export function showWrenchHint(box, isExample, arm) {
  const hasMasses = arm?.rows.every(({ body }) => body);
  const hint = `${FIELDS.wrench.hint} ${hasMasses ? GRAVITY_HINT : NO_MASSES_HINT}`;
  setText(box.querySelector(".about"), (isExample ? EXAMPLE_WRENCH : "") + hint);
}

/**
 * Say below the reader's own table how it was read, or why it cannot be.
 * @param {ReturnType<typeof buildForm>} form
 * @param {import("./question.js").Outcome} outcome
 */
export function showTableReading({ fields, boxes }, { arm, error = "" }) {
  const isRefused = !arm && Boolean(fields.table.value.trim());
  fields.table.setAttribute("aria-invalid", String(isRefused));
  const count = arm ? movingRows(arm).length : 0;
  const joints = count === 1 ? "1 joint" : `${count} joints`;
  const reading = arm?.reading ? `Read as ${joints}, with ${arm.reading}.` : "";
  setText(boxes.table.querySelector("p.reading"), isRefused ? error : reading);
}

// Add a grid of numbers to the fields that may hold a short list.
function addGrids(boxes) {
  const grids = {
    q: makeNumberGrid("Joint values one by one", false),
    answer: makeNumberGrid("Numbers one by one", true),
  };
  for (const [key, grid] of Object.entries(grids)) boxes[key].append(grid.root);
  return grids;
}

// List the fields that a chapter fixes.
const listGivenFields = (given, arms) => [
  ...Object.keys(given),
  ...(arms.length < 2 ? ["arm"] : []),
  ...("q" in given ? ["unit"] : []),
];

/**
 * Name a question and its arm.
 * @param {Question} question
 * @param {ListedArm[]} arms
 */
export const nameQuestion = ({ ask, arm: key }, arms) =>
  `${QUESTIONS[ask].title}, ${arms.find((arm) => arm.key === key)?.title ?? OWN_TABLE}`;

/**
 * Describe a chapter's question in one line.
 * @param {Partial<Question>} question
 * @param {ListedArm[]} arms
 */
function describeQuestion({ ask, q, wrench }, arms) {
  const whose = arms.length === 1 ? `, ${arms[0].title}` : "";
  return [`${QUESTIONS[ask].title}${whose}`, q && `q = (${q})`, wrench && `wrench (${wrench})`]
    .filter(Boolean)
    .join(", ");
}

// Offer the arms of which the question can be asked.
function offerArms(list, { ask, arm: chosen }, arms) {
  for (const option of list.options) {
    const arm = arms.find(({ key }) => key === option.value);
    option.hidden = Boolean(arm) && !canBeAsked(ask, arm);
    option.disabled = option.hidden;
  }
  list.value = chosen;
}

// Show the fields of the question, with the hints for its arm.
export function adaptForm({ fields, boxes, told, folded }, question, arms) {
  const asked = new Set(["ask", "arm", "answer", ...QUESTIONS[question.ask].fields]);
  if (question.arm === OWN_ARM) asked.add("table");
  for (const [key, box] of Object.entries(boxes)) box.hidden = !asked.has(key);
  offerArms(fields.arm, question, arms);
  fields.answer.placeholder = ANSWER_HINTS[question.ask];
  const arm = arms.find(({ key }) => key === question.arm);
  setText(
    boxes.q.querySelector("label"),
    question.ask === "trace" ? CIRCLE_START_LABEL : FIELDS.q.label,
  );
  const hint = arm ? listJointNames(arm) : "One value for each joint, in the table's order.";
  setText(boxes.q.querySelector(".about"), hint);
  const frames = arm ? arm.rows.length : 16;
  if (fields.frame.options.length !== frames + 1) {
    const all = Array.from({ length: frames + 1 }, (_, k) =>
      makeOption([String(k), getFrameName(k)]),
    );
    fields.frame.replaceChildren(...all);
    fields.frame.value = question.frame;
  }
  const unset = question.ask === "jacobian" ? STATED_LENGTHS : CHOICES.lengths[""];
  setText(fields.lengths.options[0], unset);
  const shown = FOLDED_FIELDS.filter((key) => asked.has(key));
  folded.hidden = !shown.length;
  setText(told, describeFolded(shown, fields));
}

/**
 * List the names of the numbers that a field's grid has; empty for a field without one.
 * @param {string} key
 * @param {Question} question
 * @param {ListedArm[]} arms
 */
export function listNumberNames(key, { ask, arm: armKey }, arms) {
  const arm = arms.find((listed) => listed.key === armKey);
  const letter = key === "q" || ask === "pose" ? "q" : "τ";
  const hasGrid = key === "q" || ask === "pose" || ask === "torques";
  return arm && hasGrid ? movingRows(arm).map((row) => `${letter}_${row + 1}`) : [];
}

// Describe the folded fields in one line.
function describeFolded(keys, fields) {
  const getText = (key) => getFieldText(fields[key]);
  const isGuessed = (key) => FIELDS[key].name && getText(key) !== STATED_LENGTHS;
  const filled = keys.filter((key) => fields[key].value);
  const guessed = keys.filter((key) => !fields[key].value && isGuessed(key));
  const parts = filled.map((key) => `${FIELDS[key].told} ${getText(key)}`);
  if (guessed.length)
    parts.push(`${joinList(guessed.map((key) => FIELDS[key].name))} as they look`);
  return `Taken: ${parts.join("; ")}`;
}

/** Return a field's text as the reader sees it. @param {import("./page.js").Control} field */
export const getFieldText = (field) =>
  "selectedOptions" in field ? field.selectedOptions[0].textContent : field.value;

const getFrameName = (k) => (k ? `frame ${k}` : "the base");

const listJointNames = (arm) => {
  const slides = arm.rows.some(({ kind }) => kind === "prismatic");
  return `${jointNames(arm).join(", ")}${slides ? "; m where a joint slides" : ""}`;
};

/**
 * The field that an advice of the judge sets, and its new value; undefined if the page has none.
 * @typedef {(value: Advice["value"], question: Question, arms: ListedArm[]) =>
 *   [string, string | undefined]} FieldSetter
 */
/** @type {Record<string, FieldSetter>} */
const FIELD_SETTERS = {
  angles: (value, { ask }) => [ask === "table" ? "angles" : "unit", String(value)],
  angularFirst: (value) => ["first", value ? "omega" : "v"],
  frame: (value) => ["frame", String(value)],
  convention: (value) => ["convention", String(value)],
  lengths: (value) => ["lengths", String(value)],
  locked: (value, { arm }) => ["arm", `${arm}.lock(${value})`],
  arm: (value, _, arms) => ["arm", arms.find(({ title }) => title === value)?.key],
  values: (value, { values }) => ["values", [values, `${value} = `].filter(Boolean).join(", ")],
};

/**
 * Turn an advice of the judge into a button's text and action; null if it changes nothing here.
 * @param {Advice} advice
 * @param {Question} question
 * @param {ListedArm[]} arms
 */
export function makeOffer({ field, value }, question, arms) {
  const [key, to] = FIELD_SETTERS[field]?.(value, question, arms) ?? [];
  const setting = key && to !== question[key] && describeSetting(key, to, arms);
  const label = key === "values" ? "Your own symbols" : (FIELDS[key]?.label ?? "Arm");
  return setting ? { key, value: to, text: `${label}: ${setting}` } : null;
}

function describeSetting(key, to, arms) {
  if (key === "arm") return arms.find((arm) => arm.key === to)?.title;
  if (key === "frame") return getFrameName(Number(to));
  return CHOICES[key]?.[to] ?? `${to}…`;
}
