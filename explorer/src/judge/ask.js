// What is asked of the judge: its state in a link and back, the call in Python that says the same, and the verdict.

import { rowsFault, typedArm } from "../arm.js";
import { joints } from "../kinematics.js";
import { numbers, pose } from "./door.js";
import { parse, symbols, value } from "./formula.js";
import { cells } from "./grid.js";
import { compareJacobian } from "./jacobian.js";
import { ArmError } from "./say.js";
import { compareTorques } from "./torques.js";

const LONGEST_LINK = 12_000; // characters of a fragment
const LONGEST = { table: 2000, q: 500, wrench: 300, answer: 8000 };
export const LONGEST_ANSWER = 20_000; // characters that are judged while typing
export const OWN = "own"; // the arm whose table is typed
export const UNITS = ["rad", "deg"];
const ORDERS = ["v", "omega"];

/**
 * @typedef {object} Question
 * @property {string} ask "jacobian" or "torques"
 * @property {string} arm its key in the page's list, or OWN
 * @property {string} table what was typed as a table, where the arm is one's own
 * @property {string} q
 * @property {string} unit of q, and of bare angles in the table
 * @property {string} frame the number of the frame in whose axes the rows are
 * @property {string} first the half that stands first: "v" or "omega"
 * @property {string} wrench
 * @property {string} answer
 */

/** @type {Question} */
export const EMPTY = {
  ask: "jacobian", arm: "", table: "", q: "", unit: "rad", frame: "0", first: "v", wrench: "", answer: "",
}; // prettier-ignore

export const ASKED = {
  jacobian: { title: "Jacobian at a pose", fields: ["frame", "first"] },
  torques: { title: "Joint torques at a pose", fields: ["wrench"] },
};

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
  const known = UNITS.includes(question.unit) && ORDERS.includes(question.first);
  if (!known || !/^\d{1,2}$/.test(question.frame)) return refused("its unit, frame or order is none");
  return { question, words: "" };
}

// The arm that is asked about; an error in words where it is none.
export function armOf(question, arms) {
  if (question.arm !== OWN) return arms.find(({ key }) => key === question.arm);
  if (!question.table.trim())
    throw new ArmError("Type the table of your arm: a row for each joint, a α d θ.");
  const rows = cells(question.table)
    .filter((row, i) => i || !row.some((cell) => /^\W*(a|alpha|α|d|theta|θ)(_?\{?i.*)?\W*$/i.test(cell)))
    .map((row, i) => rowOf(row.length === 5 ? row.slice(1) : row, i + 1, question.unit));
  const fault = rowsFault(rows);
  if (fault) throw new ArmError(`${fault}.`);
  return typedArm(rows, { name: "", home: [], rows: [] });
}

const COLUMNS = ["a", "alpha", "d", "theta"];
const JOINT = /^(q|th|theta|phi|d|s|x)_?\{?\d{1,2}\}?$/;

// A row of a α d θ; its joint turns unless a variable stands with d.
function rowOf(entries, row, unit) {
  if (entries.length !== 4) {
    throw new ArmError(`Row ${row} of the table has ${entries.length} entries; expected four: a α d θ.`);
  }
  const trees = entries.map((text, k) => parse(text || "0", `row ${row}, ${COLUMNS[k]}`));
  const names = trees.map((tree) => [...symbols(tree)]);
  const odd = names.flatMap((found, k) => found.filter((name) => k < 2 || !JOINT.test(name)));
  if (odd.length) {
    throw new ArmError(
      `Row ${row} of the table: no value for ${odd[0]}; write numbers, and a variable such as q1.`,
    );
  }
  const [a, alpha, d, theta] = trees.map((tree, k) => {
    const bare = unit === "deg" && k % 2 && !/deg|°|pi|π/.test(entries[k]);
    return value(tree, () => 0) * (bare ? Math.PI / 180 : 1);
  });
  return { kind: names[2].length ? "prismatic" : "revolute", a, alpha, d, theta };
}

/**
 * The verdict on an answer, or why there is none yet.
 * @param {Question} question
 * @returns {{ report?: import("./ranking.js").Report, error?: string, arm?: any, q?: number[] }}
 */
export function judge(question, arms) {
  try {
    const arm = armOf(question, arms);
    if (!question.q.trim()) return { error: `Type the pose: ${joints(arm).length} joint values.`, arm };
    const at = pose(question.q, arm, question.unit);
    if (!question.answer.trim()) return { error: "Type or paste your answer.", arm, q: at.values };
    if (question.answer.length > LONGEST_ANSWER) {
      return { error: `The answer is longer than ${LONGEST_ANSWER} characters.`, arm, q: at.values };
    }
    const report = question.ask === "torques" ? torques(question, arm) : jacobian(question, arm);
    return { report, arm, q: at.values };
  } catch (error) {
    if (error instanceof ArmError) return { error: capital(error.message) };
    throw error;
  }
}

const capital = (text) => text.slice(0, 1).toUpperCase() + text.slice(1);

function jacobian({ answer, q, unit, frame, first }, arm) {
  if (Number(frame) > arm.rows.length) {
    throw new ArmError(`frame is ${frame}; expected a whole number from 0 to ${arm.rows.length}`);
  }
  const options = { angles: unit, frame: Number(frame), angularFirst: first === "omega" };
  return compareJacobian(answer, arm, q, options);
}

const torques = ({ answer, q, unit, wrench }, arm) =>
  compareTorques(answer, arm, q, { angles: unit, wrench: wrenchOf(wrench) });

function wrenchOf(text) {
  if (!text.trim()) return undefined;
  const { values } = numbers(text, "the wrench");
  if (values.length !== 6) {
    throw new ArmError(
      `the wrench has ${values.length} numbers; expected six, three of force and three of moment`,
    );
  }
  return values;
}

// The call in Python that says the same.
export function asPython(question, arms) {
  const arm = armOf(question, arms);
  const [name, imports] = question.arm === OWN ? ["arm", ownArm(arm)] : [arm.python, fromRobots(arm.python)];
  const options = question.unit === "deg" ? ['angles="deg"'] : [];
  const lines = [...imports, "from helpers import checks", ""];
  if (question.arm === OWN) lines.push(...ownRows(arm), "");
  lines.push(`mine = ${quoted(question.answer)}`);
  if (question.ask === "torques") {
    if (question.wrench.trim()) options.unshift(`wrench=(${wrenchOf(question.wrench).join(", ")})`);
  } else {
    if (question.first === "omega") options.push("angular_first=True");
    if (question.frame !== "0") options.push(`frame=${Number(question.frame)}`);
  }
  const given = ["mine", name, quoted(question.q.trim()), ...options].join(", ");
  lines.push(`print(checks.compare_${question.ask}(${given}))`);
  return `${lines.join("\n")}\n`;
}

const fromRobots = (call) => [`from helpers.robots import ${/^\w+/.exec(call)[0]}`];
const KIND = { revolute: "revolute", prismatic: "prismatic", fixed: "fixed" };
const ownArm = (arm) => [
  `from helpers.arm import Arm, ${[...new Set(arm.rows.map(({ kind }) => KIND[kind]))].sort().join(", ")}`,
];
const ownRows = (arm) => [
  "rows = [",
  ...arm.rows.map(
    ({ kind, a, alpha, d, theta }) => `    ${KIND[kind]}(a=${a}, alpha=${alpha}, d=${d}, theta=${theta}),`,
  ),
  "]",
  `arm = Arm("${arm.name}", rows)`,
];

// A text as Python writes it: over several lines where it has them and nothing in it would end it.
function quoted(text) {
  const plain = text.includes("\n") && !/"""|["\\]$/.test(text) && !/[\r\0]/.test(text);
  return plain ? `r"""${text}"""` : JSON.stringify(text);
}
