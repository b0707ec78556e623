// What the picture beside an answer shows of it.

import { fits, homeOf } from "../../arm.js";
import { joints, jacobianColumns, linkFrames } from "../../kinematics.js";
import { listed } from "../say.js";
import { matrixOf } from "../shown.js";
import { textsOf } from "./filling.js";

/**
 * @typedef {import("../../more/answer.js").Shown} Shown
 * @typedef {import("../ask.js").Question} Question
 */

const POSED = "The arm at the pose of the question.";
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

function ofTable(_, { arm, report }) {
  const named = report.findings.map(({ where }) => /^row (\d+)/.exec(where)?.[1] ?? 0);
  const links = [...new Set(named.map((number) => number - 1))].filter((row) => arm.rows[row]);
  const words = `${HOME} In red: what row ${listed(links.map((row) => row + 1))} describes.`;
  return links.length ? { links, words } : {};
}

const OF = { jacobian: ofJacobian, torques: ofTorques, table: ofTable };
