// What the picture beside an answer shows of it.

import { fits, homeOf } from "../../../../judge/geometry/arm.js";
import { joints, jacobianColumns, linkFrames } from "../../../../judge/geometry/kinematics.js";
import { RAD } from "../../../../judge/geometry/angles.js";
import { listed } from "../../../../judge/sentences.js";
import { matrixOf, textsOf } from "../shown.js";

/**
 * @typedef {import("../../more/answer.js").Shown} Shown
 * @typedef {import("../question.js").Question} Question
 */

const POSED = "The arm at the pose of the question.";
const MOST_GHOSTS = 4;
const LONGEST_RUN = 300_000; // characters of a run that is drawn
const STEPS = 200; // of its way
const HOME = "The arm at home.";

/**
 * The picture of a question and what the judge says of its answer; null where there is no arm yet.
 * @param {Question} question
 * @param {any} verdict
 * @returns {Shown | null}
 */
export function pictureOf(question, verdict) {
  const { arm, q, report } = verdict;
  if (!arm) return null;
  const posed = q?.length && fits(arm, q);
  const shown = {
    arm,
    q: posed ? q : homeOf(arm),
    axes: [],
    links: [],
    ghosts: [],
    claims: [],
    points: [],
    words: posed ? POSED : HOME,
  };
  if (question.ask === "torques") Object.assign(shown, { wrench: wrenchOf(question.wrench) });
  if (report?.grade !== "wrong") return shown;
  return { ...shown, ...OF[question.ask]?.(question, verdict) };
}

// Six numbers, or none where the text says something else.
function wrenchOf(text) {
  const found = textsOf(text).flat().map(Number);
  return found.length === 6 && found.every(Number.isFinite) ? found : undefined;
}

// The position in q of the columns with a wrong entry.
function wrongColumns(found) {
  const width = found.shape[1];
  const wrong = new Set(found.wrong.flatMap((is, i) => (is ? [i % width] : [])));
  return [...wrong].sort((a, b) => a - b);
}

function ofJacobian(question, verdict) {
  const { arm, q } = verdict;
  const found = matrixOf(question, verdict);
  if (!q || found?.shape[1] !== q.length) return {};
  const wrong = wrongColumns(found);
  if (!wrong.length) return {};
  const claims = wrong.map((k) => ({ k, twist: twistOf(question, arm, q, found, k) }));
  return { ...inRed(arm, wrong, "column"), claims };
}

// A column as (v, w) in base axes; the half that was not handed in is the true one.
export function twistOf({ first, frame }, arm, q, { typed, shape }, k) {
  const [rows, width] = shape;
  const column = Array.from({ length: rows }, (_, i) => typed.values[i * width + k]);
  const frames = linkFrames(arm, q);
  const right = jacobianColumns(arm, frames)[k];
  const halves = [0, 3].map((at) => column.slice(at, at + 3));
  const [v, w] = rows === 6 && first === "omega" ? halves.reverse() : halves;
  const { x, y, z } = frames[Number(frame)] ?? frames[0];
  const inBase = (u) => [0, 1, 2].map((i) => u[0] * x[i] + u[1] * y[i] + u[2] * z[i]);
  return [...inBase(v), ...(rows === 6 ? inBase(w) : right.slice(3))];
}

function ofTorques(question, verdict) {
  const { arm, q } = verdict;
  const found = matrixOf(question, verdict);
  if (!q || found?.shape[0] !== 1 || found.shape[1] !== q.length) return {};
  return inRed(arm, wrongColumns(found), "torque");
}

// The joints at these positions of q, in red.
function inRed(arm, positions, what) {
  const axes = positions.map((k) => joints(arm)[k]);
  const numbers = axes.map((row) => row + 1);
  const words =
    axes.length > 1
      ? `In red: the axes of joints ${listed(numbers)}, whose ${what}s are wrong.`
      : `In red: the axis of joint ${numbers[0]}, whose ${what} is wrong.`;
  return axes.length ? { axes, words: `${POSED} ${words}` } : {};
}

// The arm of a wrong table as a ghost at the same joint values, and the rows that are named.
function ofTable(_, { arm, report }) {
  const named = report.findings.map(({ where }) => /^row (\d+)/.exec(where)?.[1] ?? 0);
  const links = [...new Set(named.map((number) => number - 1))].filter((row) => arm.rows[row]);
  const mine = { name: "", home: [], rows: report.table?.rows ?? [] };
  const ghosts = fits(mine, homeOf(arm)) ? [{ arm: mine, q: homeOf(arm) }] : [];
  const rows = links.length
    ? ` In full red: what row ${listed(links.map((row) => row + 1))} describes.`
    : "";
  const ghost = ghosts.length
    ? ` The red ghost: the arm of your table, at the same joint values.`
    : "";
  return { links, ghosts, words: `${HOME}${ghost}${rows}` };
}

// The joint vectors of an answer, in rad.
function vectorsOf({ unit }, arm, { values, shape }) {
  const moving = joints(arm);
  const width = moving.length;
  if (values.length % width || (shape.at(-1) !== width && values.length !== width)) return [];
  const factors = moving.map((row) =>
    unit === "deg" && arm.rows[row].kind === "revolute" ? RAD : 1,
  );
  return Array.from({ length: values.length / width }, (_, i) =>
    factors.map((factor, k) => factor * values[i * width + k]),
  );
}

// Where the tip should be: the last column of a pose, or a point.
function pointOf({ target }) {
  const rows = textsOf(target).map((row) => row.map(Number));
  const point = rows.length >= 3 ? rows.slice(0, 3).map((row) => row.at(-1)) : rows.flat();
  return point.length === 3 && point.every(Number.isFinite) ? [point] : [];
}

// The arm as it stands at the first answer that misses, others that miss as ghosts, and the target.
function ofAngles(question, { arm, report }) {
  const all = report.typed ? vectorsOf(question, arm, report.typed) : [];
  const width = joints(arm).length;
  const wrong = all.filter((_, i) => report.wrong?.[i * width] ?? true);
  if (!wrong.length) return {};
  const ghosts = wrong.slice(1, MOST_GHOSTS).map((q) => ({ arm, q }));
  const which = ghosts.length ? "your first wrong answer, others as ghosts" : "your answer";
  const words = `The arm at ${which}.`;
  const points = pointOf(question);
  return {
    q: wrong[0],
    ghosts,
    points,
    words: points.length ? `${words} The red ball: the target.` : words,
  };
}

// The way of the tip along a run.
function ofTrace(question, { arm }) {
  if (question.answer.length > LONGEST_RUN) return {};
  const rows = textsOf(question.answer).map((row) => row.map(Number));
  const flat = rows.flat();
  if (!flat.every(Number.isFinite)) return {};
  const all = vectorsOf(question, arm, { values: flat, shape: [rows.length, rows[0]?.length] });
  const step = Math.max(1, Math.floor(all.length / STEPS));
  const path = all.filter((_, i) => i % step === 0).map((q) => linkFrames(arm, q).at(-1).o);
  return path.length > 1 ? { path, words: `${POSED} In red: the way of the tip in your run.` } : {};
}

const OF = {
  jacobian: ofJacobian,
  torques: ofTorques,
  table: ofTable,
  branches: ofAngles,
  pose: ofAngles,
  trace: ofTrace,
};
