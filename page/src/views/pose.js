// The tip's pose: T0n in numbers, and a place to type where the tip should go.

import { attribute, h, indexed, write } from "../dom.js";
import { entered, refill, textField } from "../entry.js";
import { moveTip } from "../pointers.js";
import { frameMatrix as matrixOf, minus, norm } from "../../../judge/geometry/kinematics.js";
import { fixed, replaced, sparse } from "../text.js";
import { stopVerdict } from "../verdicts.js";

export const title = "Pose";

const PLACE =
  "The first three columns are the tip’s axes, the fourth its place, in the base frame and in " +
  "metres.";

export function build(store, { say }) {
  const matrix = makeMatrix("T", "Pose of the tip, a four by four matrix");
  const goal = makeGoal(store, say);
  const words = h("p.words");
  const root = h("div.pose", {}, matrix.root, h("div", {}, goal.root, goal.error, words));
  const update = (state, { frames }) => {
    const { o } = frames.at(-1);
    matrix.update(`0,${state.arm.rows.length}`, frames.at(-1));
    goal.update(o);
    const [x, y, z] = o.map((v) => fixed(1000 * v, 1));
    write(words, `Tip at (${x}, ${y}, ${z}) mm. ${PLACE}${markWords(state.mark, o)}`);
  };
  return { root, update, summary: () => goal.error.textContent };
}

// A transform in numbers, behind its letter and index.
export function makeMatrix(letter, label) {
  const cells = [0, 1, 2, 3].map(() => [0, 1, 2, 3].map(() => h("td")));
  const [symbol, small] = indexed(letter, "");
  const rows = cells.map((row) => h("tr", {}, row));
  const table = h("table.matrix", { "aria-label": label }, rows);
  const update = (index, frame) => {
    write(small, index);
    matrixOf(frame).forEach((row, i) =>
      row.forEach((value, j) => {
        write(cells[i][j], i === 3 ? String(value) : sparse(value, 4));
        cells[i][j].classList.toggle("nought", Math.abs(value) < 5e-5);
      }),
    );
  };
  const name = h("span", {}, symbol, small);
  return { root: h("div.equation", {}, name, h("span", {}, "="), table), update };
}

// Where the tip should go, and why it did not.
function makeGoal(store, say) {
  const error = h("p.error");
  const tip = () => store.derived.frames.at(-1).o;
  const typed = (i, input, whole) => {
    const { value, words } = entered(input, "length", { whole });
    write(error, words && `${"xyz"[i]} ${words}.`);
    if (words) say(() => error.textContent);
    if (!whole) return;
    if (value !== undefined) {
      moveTip(store, replaced(tip(), i, value));
      write(error, stopVerdict(store.state.hold ?? { stops: [], short: 0 }));
    }
    attribute(input, "aria-invalid", "false");
    input.value = fixed(tip()[i], 4);
  };
  const fields = ["x", "y", "z"].map((axis, i) =>
    textField(`Tip ${axis}, typed`, (...now) => typed(i, ...now), { class: "small" }),
  );
  const labels = fields.map((field, i) => h("label", {}, h("i", {}, "xyz"[i]), " ", field, " m"));
  const root = h("fieldset.wrench", {}, h("legend", {}, "Bring the tip to"), labels);
  const update = (o) => fields.forEach((field, i) => refill(field, fixed(o[i], 4)));
  return { root, error, update };
}

function markWords(mark, o) {
  if (!mark) return "";
  const place = mark.map((v) => fixed(v, 3)).join(", ");
  return ` It is ${fixed(1000 * norm(minus(o, mark)), 2)} mm from the mark at (${place}) m.`;
}
