// Write the explorer's state into the fragment of a link, and read it back.

import {
  isJointVector,
  homeConfiguration,
  ROW_KINDS,
  MAX_LENGTH,
  findRowsFault,
  makeTypedArm,
} from "../../judge/geometry/arm.js";
import { movingRows } from "../../judge/geometry/kinematics.js";
import { blendTables, haveSameKinds } from "./blend.js";
import { copyToClipboard } from "./dom.js";
import { formatNumbers, formatRows } from "./fragment.js";
import { parseRun, formatRun } from "./homework_run.js";

const MAX_FRAGMENT_LENGTH = 4000; // characters
const KIND_BY_LETTER = Object.fromEntries(ROW_KINDS.map((kind) => [kind[0].toUpperCase(), kind]));
const MAX_FORCE = 1e5; // N or N m
const MAX_RUNS = 8; // of the homework's circle

const parseNumbers = (text) =>
  text ? text.split(",").map((part) => (part.trim() ? Number(part) : NaN)) : [];

/** @param {import("./state.js").State} state */
export function formatFragment(state) {
  const { arm, base, q, wrench, unit, view, frames, mark, answer, blended } = state;
  const fields = { arm: base.name, q: formatNumbers(q), view, unit, frames };
  if (wrench.some(Boolean)) fields.wrench = formatNumbers(wrench);
  if (blended || arm !== base) fields.rows = formatRows((blended ?? arm).rows);
  if (blended) fields.blend = formatNumbers([blended.share]);
  if (mark) fields.mark = formatNumbers(mark);
  if (answer) fields.answer = formatNumbers(answer);
  if (view === "homework") Object.assign(fields, formatHomework(state));
  return `#${new URLSearchParams(fields)}`;
}

// Format the runs of the homework, the number of the one that is played, and where they begin.
function formatHomework({ q, runs, chosenRun, runStart }) {
  const fields = {};
  if (runs.length) fields.runs = runs.map(formatRun).join(";");
  if (chosenRun) fields.run = String(chosenRun + 1);
  if (runStart && formatNumbers(runStart) !== formatNumbers(q))
    fields.start = formatNumbers(runStart);
  return fields;
}

/**
 * Parse a fragment.
 * @param {string} fragment
 * @param {import("../../judge/geometry/arm.js").Arm[]} arms
 * @param {string[]} views
 * @returns {{ patch: Partial<import("./state.js").State>, message: string }} fields of
 *   the state, and a message about what was refused
 */
export function parseFragment(fragment, arms, views) {
  const text = fragment.replace(/^#/, "");
  if (!text || !/(^|&)arm=/.test(text)) return { patch: {}, message: "" };
  if (text.length > MAX_FRAGMENT_LENGTH)
    return refuse(`it has ${text.length} characters; ${MAX_FRAGMENT_LENGTH} are the most`);
  const fields = new URLSearchParams(text);
  const base = arms.find((arm) => arm.name === fields.get("arm"));
  if (!base) return refuse(`there is no arm called “${fields.get("arm").slice(0, 40)}” here`);
  const rows = parseRows(fields.get("rows"));
  const fault = rows && findRowsFault(rows);
  const arm = rows && !fault ? makeTypedArm(rows, base) : base;
  const parts = [
    { patch: { arm, base, reference: base }, fault },
    parseJoints(fields, arm, Boolean(fault)),
    parseWrench(fields),
    parseBlend(fields, arm, base),
    parseMark(fields),
    parseAnswer(fields, arm),
    parseRuns(fields),
    parseRunStart(fields, arm),
    { patch: parseChoices(fields, views) },
  ];
  const patch = Object.assign({}, ...parts.map((part) => part.patch));
  const faults = parts.flatMap((part) => part.fault || []);
  return faults.length ? { ...refuse(faults.join("; ")), patch } : { patch, message: "" };
}

// Each parser returns a patch of the state, a fault, or both.

// Parse the joint values. If the rows were refused, a different arm is shown, so that a wrong count
// of joint values is no further fault.
function parseJoints(fields, arm, areRowsRefused) {
  const q = parseNumbers(fields.get("q"));
  if (isJointVector(arm, q)) return { patch: { q } };
  const isWrong = fields.has("q") && !areRowsRefused;
  const fault = isWrong && `${arm.name} has ${movingRows(arm).length} joint values`;
  return { patch: { q: homeConfiguration(arm) }, fault };
}

function parseWrench(fields) {
  if (!fields.has("wrench")) return {};
  const wrench = parseNumbers(fields.get("wrench"));
  const isValid = wrench.length === 6 && wrench.every((v) => Math.abs(v) <= MAX_FORCE);
  return isValid ? { patch: { wrench } } : { fault: "its wrench is not six numbers in N and N m" };
}

function parseBlend(fields, typed, base) {
  if (!fields.has("blend")) return { patch: { blended: null } };
  const [share] = parseNumbers(fields.get("blend"));
  const isValid = haveSameKinds(typed, base) && share >= 0 && share <= 1;
  if (isValid) return { patch: blendTables({ base, reference: base }, typed.rows, share) };
  return { patch: { blended: null }, fault: "its tables have no arm between them at its blend" };
}

function parseMark(fields) {
  if (!fields.has("mark")) return { patch: { mark: null } };
  const mark = parseNumbers(fields.get("mark"));
  const isValid = mark.length === 3 && mark.every((v) => Math.abs(v) <= MAX_LENGTH);
  const fault = !isValid && "its mark is not three coordinates in metres";
  return { patch: { mark: isValid ? mark : null }, fault };
}

function parseAnswer(fields, arm) {
  if (!fields.has("answer")) return { patch: { answer: null } };
  const answer = parseNumbers(fields.get("answer"));
  const dof = movingRows(arm).length;
  const isValid = [dof, 6 * dof].includes(answer.length) && answer.every(Number.isFinite);
  const fault =
    !isValid && `its answer is neither ${dof} torques nor a Jacobian of 6x${dof} numbers`;
  return { patch: { answer: isValid ? answer : null }, fault };
}

function parseRuns(fields) {
  if (!fields.has("runs")) return {};
  const runs = fields.get("runs").split(";").map(parseRun);
  const areValid = runs.length <= MAX_RUNS && !runs.includes(null);
  if (!areValid) return { fault: "its runs cannot come from the homework" };
  const chosenRun = Number(fields.get("run") ?? 1) - 1;
  if (runs[chosenRun]) return { patch: { runs, chosenRun } };
  return { patch: { runs, chosenRun: 0 }, fault: "it plays a run that it does not have" };
}

function parseRunStart(fields, arm) {
  if (!fields.has("start")) return {};
  const runStart = parseNumbers(fields.get("start"));
  if (isJointVector(arm, runStart)) return { patch: { runStart } };
  return { fault: `its runs begin at joint values that the ${arm.name} does not have` };
}

function parseChoices(fields, views) {
  const choices = { view: views, unit: ["deg", "rad"], frames: ["all", "ends"] };
  const keys = Object.keys(choices).filter((key) => choices[key].includes(fields.get(key)));
  return Object.fromEntries(keys.map((key) => [key, fields.get(key)]));
}

const refuse = (reason) => ({ patch: {}, message: `Part of the link was left out: ${reason}.` });

// Parse rows without checking them; null if the link has none.
function parseRows(text) {
  if (text === null) return null;
  return text.split(";").map((line) => {
    const [letter, ...entries] = line.split(",");
    const [a, alpha, d, theta] = entries.length === 4 ? parseNumbers(entries.join(",")) : [];
    return {
      kind: Object.hasOwn(KIND_BY_LETTER, letter) ? KIND_BY_LETTER[letter] : null,
      a,
      alpha,
      d,
      theta,
    };
  });
}

// Keep the page's address and the state equal.
export function syncWithAddress(store, arms, views, notify, signal) {
  const read = () => {
    const { patch, message } = parseFragment(location.hash, arms, views);
    store.dispatch({ type: "replaceState", ...patch }, "link");
    notify(message);
  };
  let timer;
  read();
  store.dispatch({ type: "setFields", past: [] }, "link"); // opening the page is no step to undo
  addEventListener("hashchange", read, { signal });
  store.listen((_, source) => {
    if (store.state.dragging) return;
    clearTimeout(timer);
    if (source !== "link")
      timer = setTimeout(() => history.replaceState(null, "", formatFragment(store.state)), 400);
  }, signal);
  signal.addEventListener("abort", () => clearTimeout(timer));
  return {
    // Copy the link. Returns false if the clipboard is not available; the address bar has the link
    // in any case.
    copy() {
      history.replaceState(null, "", formatFragment(store.state));
      return copyToClipboard(location.href);
    },
  };
}
