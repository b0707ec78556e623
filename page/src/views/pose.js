// The tip's pose as a matrix, and fields for a new tip position.

import { updateAttribute, h, makeIndexedSymbol, setText } from "../dom.js";
import { readField, refillField, makeTextField } from "../entry.js";
import { moveTip } from "../pointers.js";
import { frameMatrix as matrixOf, minus, norm } from "../../../judge/geometry/kinematics.js";
import { formatFixed, replaceAt, formatSparse } from "../text.js";
import { describeStop } from "../statements.js";

export const title = "Pose";

const POSE_NOTE =
  "The first three columns are the tip’s axes, the fourth its place, in the base frame and in " +
  "metres.";

export function build(store, { announce }) {
  const matrix = makeMatrix("T", "Pose of the tip, a four by four matrix");
  const goal = makeGoalFields(store, announce);
  const message = h("p.words");
  const root = h("div.pose", {}, matrix.root, h("div", {}, goal.root, goal.error, message));
  const update = (state, { frames }) => {
    const { o } = frames.at(-1);
    matrix.update(`0,${state.arm.rows.length}`, frames.at(-1));
    goal.update(o);
    const [x, y, z] = o.map((v) => formatFixed(1000 * v, 1));
    setText(message, `Tip at (${x}, ${y}, ${z}) mm. ${POSE_NOTE}${describeMark(state.mark, o)}`);
  };
  return { root, update, summary: () => goal.error.textContent };
}

// Make a matrix of numbers after its symbol.
export function makeMatrix(letter, label) {
  const cells = [0, 1, 2, 3].map(() => [0, 1, 2, 3].map(() => h("td")));
  const [symbol, small] = makeIndexedSymbol(letter, "");
  const rows = cells.map((row) => h("tr", {}, row));
  const table = h("table.matrix", { "aria-label": label }, rows);
  const update = (index, frame) => {
    setText(small, index);
    matrixOf(frame).forEach((row, i) =>
      row.forEach((value, j) => {
        setText(cells[i][j], i === 3 ? String(value) : formatSparse(value, 4));
        cells[i][j].classList.toggle("nought", Math.abs(value) < 5e-5);
      }),
    );
  };
  const name = h("span", {}, symbol, small);
  return { root: h("div.equation", {}, name, h("span", {}, "="), table), update };
}

// Make the fields for a new tip position and the message about why it was not reached.
function makeGoalFields(store, announce) {
  const error = h("p.error");
  const tip = () => store.derived.frames.at(-1).o;
  const typed = (i, input, whole) => {
    const { value, message } = readField(input, "length", { whole });
    setText(error, message && `${"xyz"[i]} ${message}.`);
    if (message) announce(() => error.textContent);
    if (!whole) return;
    if (value !== undefined) {
      moveTip(store, replaceAt(tip(), i, value));
      setText(error, describeStop(store.state.tipHold ?? { stops: [], short: 0 }));
    }
    updateAttribute(input, "aria-invalid", "false");
    input.value = formatFixed(tip()[i], 4);
  };
  const fields = ["x", "y", "z"].map((axis, i) =>
    makeTextField(`Tip ${axis}, typed`, (...now) => typed(i, ...now), { class: "small" }),
  );
  const labels = fields.map((field, i) => h("label", {}, h("i", {}, "xyz"[i]), " ", field, " m"));
  const root = h("fieldset.wrench", {}, h("legend", {}, "Bring the tip to"), labels);
  const update = (o) => fields.forEach((field, i) => refillField(field, formatFixed(o[i], 4)));
  return { root, error, update };
}

function describeMark(mark, o) {
  if (!mark) return "";
  const place = mark.map((v) => formatFixed(v, 3)).join(", ");
  return ` It is ${formatFixed(1000 * norm(minus(o, mark)), 2)} mm from the mark at (${place}) m.`;
}
