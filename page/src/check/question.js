// What is asked of the judge: its state in a link and back, and the verdict.

import { findRowsFault, makeTypedArm } from "../../../judge/geometry/arm.js";
import { movingRows } from "../../../judge/geometry/kinematics.js";
import { entryText, isAngle } from "../text.js";
import { pose as poseOf } from "../../../judge/reading/numbers.js";
import { ownRows } from "../../../judge/reading/table.js";
import { ownValues } from "../../../judge/reading/values.js";
import { ArmError, capitalize } from "../../../judge/sentences.js";
import { jacobian, torques } from "./topics/jacobian.js";
import { branches, pose, trace } from "./topics/motion.js";
import { table } from "./topics/table.js";

/** @typedef {import("../../../judge/report.js").Verdict} Verdict */
/** @typedef {import("../../../judge/geometry/arm.js").Arm} Arm */
/**
 * The verdict on what is typed; throws ArmError.
 * @typedef {(question: Question, arm: Arm) => Verdict} Checker
 */

/**
 * The kinds of questions: what each is called, the fields it has besides arm and answer, its
 * checker, and how many characters of an answer are judged, where they may be more than usual.
 * @type {Record<string, { title: string, fields: string[], checker: Checker, longest?: number }>}
 */
export const ASKED = {
  jacobian: {
    title: "Jacobian at a pose",
    fields: ["q", "unit", "frame", "first", "values"],
    checker: jacobian,
  },
  torques: {
    title: "Joint torques at a pose",
    fields: ["q", "unit", "wrench"],
    checker: torques,
  },
  table: {
    title: "Denavit-Hartenberg table",
    fields: ["columns", "lengths", "angles", "convention", "values"],
    checker: table,
  },
  branches: {
    title: "All joint angles for a target",
    fields: ["target", "unit"],
    checker: branches,
  },
  pose: { title: "Joint angles for one pose", fields: ["target", "unit"], checker: pose },
  trace: {
    title: "Joints along a circle",
    fields: ["q", "unit", "radius", "plane", "period", "steps", "pace"],
    checker: trace,
    longest: 5_000_000,
  },
};

const LONGEST_LINK = 12_000; // characters of a fragment
const LONGEST = { table: 2000, q: 500, wrench: 300, values: 500, answer: 8000, target: 1000 };
const LONGEST_ANSWER = 30_000; // characters that are judged while typing
const HEADS =
  "Write a row with the names of its columns first, such as a, alpha (deg), d (mm), theta";
const ASKED_ABOUT = "the arm asked about"; // an arm that has no name
export const OWN = "own"; // the arm whose table is typed
const GUESSED = { "": "as it looks" };
const UNITS = { rad: "rad", deg: "deg" };
/**
 * The fields with few values, and the values' words; where the empty one is among them, what is not
 * said is guessed.
 * @type {Record<string, Record<string, string>>}
 */
export const CHOICES = {
  unit: UNITS,
  first: { v: "v, then ω", omega: "ω, then v" },
  plane: { zy: "towards +y", yz: "towards −y", zx: "towards +x", xz: "towards −x" },
  pace: { even: "even", rest: "from rest to rest" },
  lengths: { ...GUESSED, m: "m", cm: "cm", mm: "mm" },
  angles: { ...GUESSED, ...UNITS },
  convention: { ...GUESSED, standard: "standard", craig: "modified (Craig)" },
};

/**
 * @typedef {object} Question
 * @property {string} ask its key in ASKED
 * @property {string} arm its key in the page's list, or OWN
 * @property {string} table what was typed as a table, where the arm is one's own
 * @property {string} q
 * @property {string} unit of q, and of bare angles in the table
 * @property {string} frame the number of the frame in whose axes the rows are
 * @property {string} first the half that stands first: "v" or "omega"
 * @property {string} wrench
 * @property {string} values of one's own symbols, as in "h = 0.3"
 * @property {string} answer
 * @property {string} columns of a table: their order, or empty where it is to be guessed; so the
 *   next three
 * @property {string} lengths
 * @property {string} angles
 * @property {string} convention
 * @property {string} target a point or a pose
 * @property {string} radius of the circle that hangs below the tip at q
 * @property {string} plane its base axes in their order
 * @property {string} period the duration of the run
 * @property {string} steps of the run; empty: as many as the answer has
 * @property {string} pace "even" or "rest", from rest to rest
 */

/** @type {Question} */
export const EMPTY = {
  ask: "jacobian",
  arm: "",
  table: "",
  q: "",
  unit: "rad",
  frame: "0",
  first: "v",
  wrench: "",
  values: "",
  answer: "",
  columns: "",
  lengths: "",
  angles: "",
  convention: "",
  target: "",
  radius: "0.1",
  plane: "zy",
  period: "5",
  steps: "",
  pace: "even",
};

/**
 * What the page puts into the fields of a question: its example, or the arm's home and no answer.
 * @returns {Question}
 */
export function startOf({ ask, arm, unit }, { arms, examples }) {
  const example = unit === EMPTY.unit && examples.find((one) => one.arm === arm && one.ask === ask);
  if (example) return { ...EMPTY, ...example };
  const own = arms.find(({ key }) => key === arm);
  const home = own
    ? movingRows(own).map((row, k) => entryText(own.home[k], isAngle(own.rows[row]), unit))
    : [];
  return { ...EMPTY, ask, arm, unit, q: home.join(", ") };
}

/** @param {Question} question */
export function toFragment(question) {
  const fields = Object.entries(question).filter(
    ([key, text]) => text !== EMPTY[key] || key === "ask" || key === "arm",
  );
  return `#${new URLSearchParams(fields)}`;
}

/**
 * The question in a fragment, or null where there is none; what was refused, in words.
 * @param {string} fragment
 * @param {string[]} arms keys
 * @returns {{ question: Question | null, words: string }}
 */
export function fromFragment(fragment, arms) {
  const text = fragment.replace(/^#/, "");
  if (!/^ask=/.test(text)) return { question: null, words: "" };
  const refused = (why) => ({ question: null, words: `The link could not be read: ${why}.` });
  if (text.length > LONGEST_LINK) {
    return refused(`it has ${text.length} characters; ${LONGEST_LINK} are the most`);
  }
  const fields = new URLSearchParams(text);
  const question = { ...EMPTY };
  for (const [key, value] of fields) {
    if (!Object.hasOwn(EMPTY, key)) return refused(`it has a field “${key.slice(0, 40)}”`);
    if (value.length > (LONGEST[key] ?? 40)) return refused(`its ${key} is too long`);
    question[key] = value;
  }
  if (!Object.hasOwn(ASKED, question.ask)) return refused("it asks what is not judged here");
  if (question.arm !== OWN && !arms.includes(question.arm)) {
    return refused(`there is no arm called “${question.arm}” here`);
  }
  const odd = Object.keys(CHOICES).find((key) => !Object.hasOwn(CHOICES[key], question[key]));
  if (odd) return refused(`its ${odd} is none`);
  if (!/^\d{1,2}$/.test(question.frame)) return refused("its frame is none");
  return { question, words: "" };
}

// The arm that is asked about; an error in words where it is none.
export function armOf(question, arms) {
  if (question.arm !== OWN) return arms.find(({ key }) => key === question.arm);
  if (!question.table.trim())
    throw new ArmError("Type the table of your arm: a row for each joint, a α d θ.");
  const symbols = ASKED[question.ask].fields.includes("values") ? ownValues(question.values) : [];
  const { rows, said, guessed } = ownRows(question.table, question.unit, symbols, "m");
  if (guessed) throw new ArmError(`Are these the ${said[0]}? ${HEADS}.`);
  const fault = findRowsFault(rows);
  if (fault) throw new ArmError(`${fault}.`);
  return { ...makeTypedArm(rows, { name: "", home: [], rows: [] }), name: ASKED_ABOUT };
}

/**
 * The verdict on an answer, or why there is none yet.
 * @param {Question} question
 * @typedef {import("../../../judge/advice.js").Advice} Advice
 * @returns {{ report?: Verdict, error?: string, advice?: Advice[], arm?: any, q?: number[] }}
 */
export function judge(question, arms) {
  let arm, q;
  try {
    arm = armOf(question, arms);
    const asked = missing(question, arm);
    if (asked) return { error: asked, arm };
    q = posed(question) ? poseOf(question.q, arm, question.unit).values : undefined;
    if (!question.answer.trim()) return { error: "Type or paste your answer.", arm, q };
    const { checker, longest = LONGEST_ANSWER } = ASKED[question.ask];
    if (question.answer.length > longest) {
      return { error: `The answer is longer than ${longest} characters.`, arm, q };
    }
    const report = checker(question, arm);
    return { report, arm, q, advice: report.advice };
  } catch (error) {
    if (!(error instanceof ArmError)) throw error;
    return { error: capitalize(error.message), arm, q, advice: error.advice };
  }
}

const posed = ({ ask }) => ASKED[ask].fields.includes("q");
const missing = (question, arm) =>
  posed(question) && !question.q.trim()
    ? `Type the pose: ${movingRows(arm).length} joint values.`
    : null;
