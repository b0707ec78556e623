// The tip's pose: T0n in numbers, and a place to type where the tip should go.

import { attribute, h, indexed, write } from "../dom.js";
import { readEntry, unfinished } from "../../../judge/reading/entry.js";
import { moveTip } from "../grab.js";
import { matrix, minus, norm } from "../../../judge/geometry/kinematics.js";
import { fixed, sparse } from "../text.js";
import { stopVerdict } from "../verdicts.js";

export const title = "Pose";

export function build(store, { say }) {
  const entry = (i, j) => h("td", { "data-entry": `${i}${j}` });
  const cells = [0, 1, 2, 3].map((i) => [0, 1, 2, 3].map((j) => entry(i, j)));
  const name = h("span");
  const rows = cells.map((row) => h("tr", {}, row));
  const table = h("table.matrix", { "aria-label": "Pose of the tip, a four by four matrix" }, rows);
  const words = h("p.words");
  const fields = ["x", "y", "z"].map((axis, i) =>
    h("input.small", {
      type: "text",
      spellcheck: "false",
      autocomplete: "off",
      "aria-label": `Tip ${axis}, typed`,
      oninput: (e) => typed(i, e.target, false),
      onchange: (e) => typed(i, e.target, true),
    }),
  );
  const error = h("p.error");
  const labels = fields.map((field, i) => h("label", {}, h("i", {}, "xyz"[i]), " ", field, " m"));
  const asked = h("fieldset.wrench", {}, h("legend", {}, "Bring the tip to"), labels);
  const root = h(
    "div.pose",
    {},
    h("div.equation", {}, name, h("span", {}, "="), table),
    h("div", {}, asked, error, words),
  );

  function typed(i, input, last) {
    const { value, error: fault } = readEntry(input.value, "length");
    const wrong = fault && (last || !unfinished(input.value));
    attribute(input, "aria-invalid", String(Boolean(wrong)));
    error.textContent = wrong ? `${"xyz"[i]} ${fault}.` : "";
    if (wrong) say(() => error.textContent);
    if (!last) return;
    if (!fault) {
      const { o } = store.derived.frames.at(-1);
      moveTip(
        store,
        o.map((v, k) => (k === i ? value : v)),
      );
      error.textContent = stopVerdict(store.state.hold ?? { stops: [], short: 0 });
    }
    attribute(input, "aria-invalid", "false");
    input.value = fixed(store.derived.frames.at(-1).o[i], 4);
  }

  function update(state, { frames }) {
    const index = `0,${state.arm.rows.length}`;
    if (name.dataset.index !== index) name.replaceChildren(...indexed("T", index));
    name.dataset.index = index;
    matrix(frames.at(-1)).forEach((row, i) =>
      row.forEach((value, j) => {
        write(cells[i][j], i === 3 ? String(value) : sparse(value, 4));
        cells[i][j].classList.toggle("nought", Math.abs(value) < 5e-5);
      }),
    );
    const { o } = frames.at(-1);
    fields.forEach((field, i) => {
      if (field.getRootNode().activeElement !== field) field.value = fixed(o[i], 4);
    });
    const [x, y, z] = o.map((v) => fixed(1000 * v, 1));
    const place =
      "The first three columns are the tip’s axes, the fourth its place, in the base frame and in metres.";
    write(words, `Tip at (${x}, ${y}, ${z}) mm. ${place}${markWords(state.mark, o)}`);
  }
  return { root, update, summary: () => error.textContent };
}

function markWords(mark, o) {
  if (!mark) return "";
  const place = mark.map((v) => fixed(v, 3)).join(", ");
  return ` It is ${fixed(1000 * norm(minus(o, mark)), 2)} mm from the mark at (${place}) m.`;
}
