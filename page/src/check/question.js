// The question that the form asks: its fields, its link, and its verdict.

import { findRowsFault, makeTypedArm } from "../../../judge/geometry/arm.js";
import { movingRows } from "../../../judge/geometry/kinematics.js";
import { formatEntry, isAngle } from "../text.js";
import { findClosedForm } from "../../../judge/geometry/inverse.js";
import { readConfiguration } from "../../../judge/reading/numbers.js";
import { readOwnTable } from "../../../judge/reading/table.js";
import { readSymbolValues } from "../../../judge/reading/values.js";
import { ArmError, capitalize, tryOrNull } from "../../../judge/sentences.js";
import { applyOwnJoints } from "./own_joints.js";
import { checkJacobian, checkTorques } from "./topics/jacobian.js";
import { checkBranches, checkPose, checkTrace } from "./topics/motion.js";
import { checkTable } from "./topics/table.js";

/** @typedef {import("../../../judge/verdict.js").Verdict} Verdict */
/** @typedef {import("../../../judge/geometry/arm.js").Arm} Arm */
/**
 * An arm of the page's list; `explorer` is its name there, and `locked` the number of its joint
 * that is locked at 0 and that moves there.
 * @typedef {Arm & { key: string, title: string, explorer?: string, locked?: number }} ListedArm
 */
/**
 * Judges an answer; throws ArmError if it cannot be judged. If a page fixes the configuration, no
 * verdict proposes another one.
 * @typedef {(question: Question, arm: Arm, page: { isConfigurationFixed: boolean }) => Verdict}
 *   Checker
 */

/**
 * The kinds of questions. Each has a title, its fields besides arm and answer, a checker, the
 * length of the longest answer if it may be longer than usual, and whether it can be asked of an
 * arm, if it cannot be asked of every arm.
 * @type {Record<string, { title: string, fields: string[], checker: Checker, longest?: number,
 *   canBeAsked?: (arm: Arm) => boolean }>}
 */
export const QUESTIONS = {
  jacobian: {
    title: "Jacobian at a configuration",
    fields: ["q", "unit", "frame", "first", "lengths", "values"],
    checker: checkJacobian,
  },
  torques: {
    title: "Joint torques at a configuration",
    fields: ["q", "unit", "wrench"],
    checker: checkTorques,
  },
  table: {
    title: "Denavit-Hartenberg table",
    fields: ["columns", "lengths", "angles", "convention", "values"],
    checker: checkTable,
  },
  branches: {
    title: "All joint angles for a target",
    fields: ["target", "unit"],
    checker: checkBranches,
    canBeAsked: (arm) => Boolean(findClosedForm(arm)),
  },
  pose: { title: "Joint angles for one pose", fields: ["target", "unit"], checker: checkPose },
  trace: {
    title: "Joints along a circle",
    fields: ["q", "unit", "radius", "plane", "period", "steps", "pace"],
    checker: checkTrace,
    longest: 5_000_000,
  },
};

/** Return whether a question can be asked of an arm. @param {string} ask @param {Arm} arm */
export const canBeAsked = (ask, arm) => QUESTIONS[ask].canBeAsked?.(arm) ?? true;

const MAX_LINK_LENGTH = 12_000; // characters
const MAX_FIELD_LENGTH = {
  table: 2000,
  q: 500,
  wrench: 300,
  values: 500,
  answer: 8000,
  target: 1000,
  joints: 1500,
};
const MAX_ANSWER_LENGTH = 30_000; // characters
const UNNAMED_ARM = "the arm asked about"; // name of an arm that has none
export const OWN_ARM = "own"; // key of the arm whose table is typed
const GUESS_CHOICE = { "": "as it looks" };
const UNITS = { rad: "rad", deg: "deg" };
/**
 * Labels of the values of fields with few values. An empty value means that the judge guesses.
 * @type {Record<string, Record<string, string>>}
 */
export const CHOICES = {
  unit: UNITS,
  first: { v: "v, then ω", omega: "ω, then v" },
  plane: { zy: "towards +y", yz: "towards −y", zx: "towards +x", xz: "towards −x" },
  pace: { even: "even", rest: "from rest to rest" },
  lengths: { ...GUESS_CHOICE, m: "m", cm: "cm", mm: "mm" },
  angles: { ...GUESS_CHOICE, ...UNITS },
  convention: { ...GUESS_CHOICE, standard: "standard", craig: "modified (Craig)" },
};

/**
 * @typedef {object} Question
 * @property {string} ask key in QUESTIONS
 * @property {string} arm key in the page's list, or OWN_ARM
 * @property {string} table typed table of the reader's own arm
 * @property {string} q
 * @property {string} unit of q, and of joint angles in the answer
 * @property {string} frame number of the frame whose axes the rows refer to
 * @property {string} first half of the Jacobian that comes first: "v" or "omega"
 * @property {string} wrench
 * @property {string} values of the reader's own symbols, as in "h = 0.3"
 * @property {string} answer
 * @property {string} columns order of a table's columns; empty to guess, as for the next three
 * @property {string} lengths
 * @property {string} angles
 * @property {string} convention
 * @property {string} target a point or a pose
 * @property {string} radius of the circle below the tip at q
 * @property {string} plane the circle's base axes in order
 * @property {string} period duration of the circle in s
 * @property {string} steps empty: as many as the answer has
 * @property {string} pace "even" or "rest" (from rest to rest)
 * @property {string} joints rows of the student's table in whose joints q and the answer are; empty
 *   for the arm's own
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
  joints: "",
};

/**
 * Return what the page fills in for a question: its example, or the arm's home and no answer.
 * @param {{ ask: string, arm: string, unit: string, joints?: string }} question
 * @returns {Question}
 */
export function makeStartingQuestion({ ask, arm: key, unit, joints = "" }, { arms, examples }) {
  const isPlain = unit === EMPTY.unit && !joints;
  const example = isPlain && examples.find((one) => one.arm === key && one.ask === ask);
  if (example) return { ...EMPTY, ...example };
  const catalogueArm = arms.find((one) => one.key === key);
  const arm = catalogueArm && tryOrNull(() => applyOwnJoints(catalogueArm, { ask, joints }));
  const home = arm
    ? movingRows(arm).map((row, k) => formatEntry(arm.home[k], isAngle(arm.rows[row]), unit))
    : [];
  return { ...EMPTY, ask, arm: key, unit, joints, q: home.join(", ") };
}

/** @param {Question} question */
export function formatQuestionLink(question) {
  const fields = Object.entries(question).filter(
    ([key, text]) => text !== EMPTY[key] || key === "ask" || key === "arm",
  );
  return `#${new URLSearchParams(fields)}`;
}

/**
 * Parse the question of a fragment.
 * @param {string} fragment
 * @param {string[]} arms keys
 * @returns {{ question: Question | null, message: string }} null if there is none, with a message
 *   if the link was refused
 */
export function parseQuestionLink(fragment, arms) {
  const text = fragment.replace(/^#/, "");
  if (!/^ask=/.test(text)) return { question: null, message: "" };
  const refuse = (why) => ({ question: null, message: `The link could not be read: ${why}.` });
  if (text.length > MAX_LINK_LENGTH)
    return refuse(`it has ${text.length} characters; ${MAX_LINK_LENGTH} are the most`);
  const fields = Object.fromEntries(new URLSearchParams(text));
  const tooLong = Object.keys(fields).find(
    (key) => Object.hasOwn(EMPTY, key) && fields[key].length > (MAX_FIELD_LENGTH[key] ?? 40),
  );
  if (tooLong) return refuse(`its ${tooLong} is too long`);
  const question = { ...EMPTY, ...fields };
  const fault = findQuestionFault(question, arms);
  return fault ? refuse(fault) : { question, message: "" };
}

/**
 * Return what is wrong with a question from a link or from the storage; "" if nothing is.
 * @param {Record<string, string>} question
 * @param {string[]} arms keys
 */
export function findQuestionFault(question, arms) {
  const unknown = Object.keys(question).find((key) => !Object.hasOwn(EMPTY, key));
  if (unknown !== undefined) return `it has a field “${unknown.slice(0, 40)}”`;
  if (!Object.values(question).every((value) => typeof value === "string"))
    return "its fields are no texts";
  if (!Object.hasOwn(QUESTIONS, question.ask)) return "it asks what is not judged here";
  if (question.arm !== OWN_ARM && !arms.includes(question.arm))
    return `there is no arm called “${question.arm}” here`;
  const odd = Object.keys(CHOICES).find((key) => !Object.hasOwn(CHOICES[key], question[key]));
  if (odd) return `its ${odd} is none`;
  return /^\d{1,2}$/.test(question.frame) ? "" : "its frame is none";
}

// Return the arm of a question. Throws ArmError if its typed table cannot be read.
export function findArm(question, arms) {
  if (question.arm !== OWN_ARM) return arms.find(({ key }) => key === question.arm);
  if (!question.table.trim())
    throw new ArmError("Type the table of your arm: a row for each joint, a α d θ.");
  const symbols = QUESTIONS[question.ask].fields.includes("values")
    ? readSymbolValues(question.values)
    : [];
  const { rows, reading } = readOwnTable(question.table, symbols);
  const fault = findRowsFault(rows);
  if (fault) throw new ArmError(`${fault}.`);
  return { ...makeTypedArm(rows, { name: "", home: [], rows: [] }), name: UNNAMED_ARM, reading };
}

/** @typedef {import("../../../judge/advice.js").Advice} Advice */
/** @typedef {import("../../../judge/marks.js").Token} Token */
/**
 * Judge an answer: the verdict on it, or why there is none.
 * @typedef {object} Outcome
 * @property {Verdict} [verdict]
 * @property {string} [error] why there is no verdict
 * @property {Advice[]} [advice] settings that the reader may have meant
 * @property {Token[]} [tokens] the numbers of the text with their owners
 * @property {{ firstLine: number, lastLine: number }[]} [answers] where answers that differ stand
 * @property {Arm & { explorer?: string, reading?: string }} [arm] `reading` says how a typed table
 *   was read; no arm if the table could not be read
 * @property {number[]} [q]
 */

/**
 * Judge an answer.
 * @param {Question} question
 * @param {Arm[]} arms
 * @param {{ isConfigurationFixed: boolean }} [page]
 * @returns {Outcome}
 */
export function judgeQuestion(question, arms, page = { isConfigurationFixed: false }) {
  let arm, q;
  try {
    arm = applyOwnJoints(findArm(question, arms), question);
    const missing = findMissingField(question, arm);
    if (missing) return { error: missing, arm };
    q =
      question.q.trim() && hasConfiguration(question)
        ? readConfiguration(question.q, arm, question.unit).values
        : undefined;
    if (!question.answer.trim()) return { error: "Type or paste your answer.", arm, q };
    const { checker, longest = MAX_ANSWER_LENGTH } = QUESTIONS[question.ask];
    if (question.answer.length > longest)
      return { error: `The answer is longer than ${longest} characters.`, arm, q };
    const verdict = checker(question, arm, page);
    return { verdict, arm, q, advice: verdict.advice, tokens: findTokens(verdict) };
  } catch (error) {
    if (!(error instanceof ArmError)) throw error;
    const { advice, answers } = error;
    const tokens = error.text === question.answer ? error.tokens : undefined; // not those of q
    return { error: makeSentence(error.message), arm, q, advice, tokens, answers };
  }
}

const makeSentence = (/** @type {string} */ message) =>
  capitalize(message) + (/[.?!]$/.test(message) ? "" : ".");

const findTokens = (/** @type {Verdict} */ { tokens, typed }) => tokens ?? typed?.tokens;

const hasConfiguration = ({ ask }) => QUESTIONS[ask].fields.includes("q");
// A Jacobian of formulas needs no configuration; the judge asks for that of a numeric one.
const findMissingField = (question, arm) =>
  question.ask !== "jacobian" && hasConfiguration(question) && !question.q.trim()
    ? `Type the configuration: ${movingRows(arm).length} joint values.`
    : null;
