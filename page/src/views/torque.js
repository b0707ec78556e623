// Static torques: gravity minus the world's push on the tool, next to each joint's limit.

import { updateAttribute, h, makeIndexedSymbol, makeScrollRegion, setText } from "../dom.js";
import { readField, refillField, makeTextField } from "../entry.js";
import { movingRows } from "../../../judge/geometry/kinematics.js";
import { formatFixed, replaceAt, formatShort } from "../text.js";
import { joinList } from "../../../judge/sentences.js";

export const title = "Static torque";

const WRENCH_PARTS = ["F", "M"].flatMap((letter) =>
  ["x", "y", "z"].map((index) => [letter, index, letter === "F" ? "N" : "N m"]),
);

const SAME = 0.01; // N m or N; smaller differences come from the typed digits
const COLUMN_HEADERS = ["joint", "gravity", "−Jᵀ F", "torque", "share of the limit"];

export function build(store, { point, announce }) {
  const wrench = makeWrenchFields(store, announce);
  const bars = makeTorqueTable(point);
  const verdict = h("p.verdict");
  const height = h("p.words");
  const root = h("div.torque", {}, wrench.root, wrench.error, bars.root, verdict, height);

  function update(state, derived) {
    const { arm } = state;
    wrench.update(state.wrench);
    const over = bars.update(state, derived);
    verdict.classList.toggle("warning", over.length > 0);
    setText(verdict, describeTorques(arm, over, derived.gravityTorques));
    const energy = `${formatFixed(derived.potentialEnergy, 1)} J here.`;
    const weighs = arm.rows.some((row) => row.body);
    setText(height, weighs ? `Gravity’s torques are the slopes of one energy, ${energy}` : "");
  }
  return { root, update, summary: () => verdict.textContent };
}

// Make the fields of the wrench; the last valid one stays.
function makeWrenchFields(store, announce) {
  const error = h("p.error");
  const typed = (i, input, whole) => {
    const { value, message } = readField(input, i < 3 ? "force" : "moment", { whole });
    const [letter, index] = WRENCH_PARTS[i];
    setText(error, message && `${letter}${index} ${message}. The last good wrench stays.`);
    if (message) announce(() => error.textContent);
    if (value !== undefined) push(replaceAt(store.state.wrench, i, value), `wrench ${i}`);
    if (!whole) return;
    updateAttribute(input, "aria-invalid", "false");
    input.value = formatShort(store.state.wrench[i], 2);
  };
  const push = (wrench, gesture) => store.dispatch({ type: "setWrench", wrench, gesture });
  const inputs = WRENCH_PARTS.map(([letter, index, unit], i) =>
    makeTextField(`${letter} ${index}, ${unit}`, (...now) => typed(i, ...now)),
  );
  const none = h("button", { onclick: () => push([0, 0, 0, 0, 0, 0]) }, "No load");
  const labels = WRENCH_PARTS.map(([letter, index], i) =>
    h("label", {}, h("span", {}, makeIndexedSymbol(letter, index)), inputs[i]),
  );
  const legend = h("legend", {}, "Wrench on the tool, by the world, at the tip (N, N m)");
  const update = (wrench) =>
    inputs.forEach((input, i) => refillField(input, formatShort(wrench[i], 2)));
  return { root: h("fieldset.wrench", {}, legend, labels, none), error, update };
}

// Make a row for each joint: its torque in parts, and a bar with the joint's limit.
function makeTorqueTable(point) {
  const body = h("tbody");
  const heads = COLUMN_HEADERS.map((text) => h("th", { scope: "col" }, text));
  const name = { "aria-label": "Static torque of each joint" };
  const typedHead = h("th", { scope: "col", hidden: true }, "typed");
  heads.splice(-1, 0, typedHead);
  const table = h("table.bars", name, h("thead", {}, h("tr", {}, heads)), body);
  let [lines, shownArm] = [[], null];

  // Returns the joints whose torque exceeds their limits.
  function update({ arm, answer }, { gravityTorques, wrenchTorques, torques }) {
    if (shownArm !== arm) {
      shownArm = arm;
      lines = movingRows(arm).map((row) => makeTorqueRow(row, point));
      body.replaceChildren(...lines.map(({ line }) => line));
    }
    const typed = answer?.length === torques.length ? answer : null;
    typedHead.hidden = !typed;
    const largest = Math.max(1e-9, ...torques.map(Math.abs), ...(typed ?? []).map(Math.abs));
    lines.forEach((line, i) => {
      [gravityTorques[i], -wrenchTorques[i], torques[i]].forEach((v, k) =>
        setText(line.cells[k], formatFixed(v, 2)),
      );
      showLimitShare(line, arm.rows[line.row], torques[i], largest);
      showTyped(line, typed?.[i], torques[i], arm.rows[line.row].effort ?? largest);
    });
    const over = lines.filter(({ line }) => line.classList.contains("over"));
    return over.map(({ row }) => `joint ${row + 1}`);
  }
  return { root: makeScrollRegion("Torques", table), update };
}

function makeTorqueRow(row, point) {
  const cells = ["gravity", "push", "total"].map((name) => h(`td.${name}`));
  const [fill, typedFill] = [h("span.fill"), h("span.fill.typed", { hidden: true })];
  const typed = h("td.typed", { hidden: true });
  const [part, limit] = [h("span"), h("span.limit")];
  const track = h("span.track", { "aria-hidden": true }, fill, typedFill);
  const line = h(
    "tr",
    { onpointerenter: () => point(row), onpointerleave: () => point(null) },
    h("th", { scope: "row" }, makeIndexedSymbol("τ", row + 1)),
    cells,
    typed,
    h("td.bar", {}, track, h("span.share", {}, part, limit)),
  );
  return { row, cells, fill, typed, typedFill, part, limit, line };
}

function showLimitShare({ fill, part, limit, line }, { effort, kind }, torque, largest) {
  const unit = kind === "revolute" ? "N m" : "N";
  const share = torque / (effort ?? largest);
  setBar(fill, share);
  line.classList.toggle("over", Boolean(effort) && Math.abs(share) > 1);
  setText(part, effort ? `${formatFixed(100 * Math.abs(share), 0)} %` : "");
  setText(limit, effort ? ` of ${effort} ${unit}` : unit);
}

// Set a bar from the middle to a share from -1 to 1.
export function setBar(fill, share) {
  fill.style.setProperty("--from", `${50 + 50 * Math.max(-1, Math.min(0, share))}%`);
  fill.style.setProperty("--width", `${50 * Math.min(1, Math.abs(share))}%`);
}

// Show the typed torque of a link, if there is one, beside the right one.
function showTyped({ typed, typedFill }, torque, right, full) {
  typed.hidden = typedFill.hidden = torque === undefined;
  if (typed.hidden) return;
  const isWrong = Math.abs(torque - right) > SAME;
  setText(typed, `${formatFixed(torque, 2)}${isWrong ? " ✘" : ""}`);
  setBar(typedFill, torque / full);
}

function describeTorques(arm, over, gravity) {
  if (over.length) return `Too much for ${joinList(over)}.`;
  if (!arm.rows.some((row) => row.body))
    return "No masses are known of this arm, so only the push on the tool shows.";
  const held = arm.rows.every((row) => row.kind === "fixed" || row.effort)
    ? "Every joint can hold this. "
    : "";
  const weightless = gravity.every((g) => g === 0) ? " Gravity asks nothing here." : "";
  return `${held}Drag the ball at the tip to push on the tool.${weightless}`;
}
