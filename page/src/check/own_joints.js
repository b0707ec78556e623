// Shows how the joint angles of the student's table differ from the reference's, and offers to use
// them in the next questions.

import { findOwnArm, parseRows } from "../../../judge/geometry/own_joints.js";
import { ArmError, formatMessage } from "../../../judge/sentences.js";
import { h, makeScrollRegion } from "../dom.js";
import { makeRow, typeset } from "./shown.js";

/** @typedef {import("../../../judge/geometry/arm.js").Arm} Arm */
/** @typedef {import("./question.js").Question} Question */
/** @typedef {import("./question.js").Outcome} Outcome */

const CAPTION = "How your joints count";
const USE = "Use my joint angles in the next questions";
const FORGET = "Forget my joint angles";
const IN_USE = "Your joint angles are used: those of your table.";
const OTHER_ARM = "The joint angles of your table belong to another arm: forget them.";

/**
 * Return the arm of a question in the student's joints, if the question is asked in these.
 * @param {Arm} arm
 * @param {{ ask: string, joints: string }} question
 */
export function applyOwnJoints(arm, { ask, joints }) {
  if (!joints || ask === "table") return arm;
  const rows = parseRows(joints);
  const own = rows && findOwnArm(arm, rows, formatMessage("own joints", { arm: arm.name }));
  if (!own) throw new ArmError(OTHER_ARM);
  return own;
}

/**
 * Show the joint map of a right table, and the buttons that use and forget it.
 * @param {HTMLElement} place
 * @param {Question} question
 * @param {Outcome} outcome
 * @param {(joints: string) => void} onChange called with the rows to use, "" for none
 */
export function showOwnJoints(place, { ask, joints }, { verdict }, onChange) {
  const map = verdict?.map;
  place.hidden = !map && !joints;
  if (place.hidden) return place.replaceChildren();
  const table = map ? [makeScrollRegion(CAPTION, makeMapTable(map.table))] : [];
  const offered = ask === "table" ? findOfferedJoints(verdict) : "";
  const makeButton = (text, rows) => h("button", { onclick: () => onChange(rows) }, text);
  const offer =
    offered && offered !== joints ? [makeButton(USE, offered)] : [IN_USE, makeButton(FORGET, "")];
  return place.replaceChildren(...table, h("p.offer", {}, ...offer));
}

// Return the rows of a right table with other zeros or signs of its joints; "" for other answers.
function findOfferedJoints(verdict) {
  const advice = verdict?.advice?.find(({ field }) => field === "ownJoints");
  return String(advice?.value ?? "");
}

function makeMapTable({ headers, rows }) {
  const head = headers.map((name) => h("th", { scope: "col" }, name));
  const body = rows.map(([joint, ...cells]) => {
    const values = cells.map((cell) => h("td", {}, typeset(cell.replaceAll("-", "−"))));
    return makeRow(typeset(joint), values);
  });
  const caption = h("caption", {}, CAPTION);
  return h("table", {}, caption, h("thead", {}, h("tr", {}, head)), h("tbody", {}, body));
}
