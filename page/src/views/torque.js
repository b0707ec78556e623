// What holding still takes: gravity less what the world's push on the tool gives back, beside each
// joint's limit.

import { attribute, h, indexed, write } from "../dom.js";
import { readEntry, unfinished } from "../../../judge/reading/entry.js";
import { joints } from "../../../judge/geometry/kinematics.js";
import { fixed, listed, short } from "../text.js";

export const title = "Static torque";

const PARTS = ["F", "M"].flatMap((letter) =>
  ["x", "y", "z"].map((index) => [letter, index, letter === "F" ? "N" : "N m"]),
);

export function build(store, { point, say }) {
  const inputs = PARTS.map(([letter, index, unit], i) =>
    h("input", {
      type: "text",
      "aria-label": `${letter} ${index}, ${unit}`,
      spellcheck: "false",
      oninput: (e) => typed(i, e.target, false),
      onchange: (e) => typed(i, e.target, true),
    }),
  );
  const error = h("p.error");
  const body = h("tbody");
  const verdict = h("p.verdict");
  const height = h("p.words");
  const heads = ["joint", "gravity", "−Jᵀ F", "torque", "share of the limit"];
  const root = h(
    "div.torque",
    {},
    h(
      "fieldset.wrench",
      {},
      h("legend", {}, "Wrench on the tool, by the world, at the tip (N, N m)"),
      PARTS.map(([letter, index], i) =>
        h("label", {}, h("span", {}, indexed(letter, index)), inputs[i]),
      ),
      h(
        "button",
        {
          type: "button",
          onclick: () => store.dispatch({ type: "push", wrench: [0, 0, 0, 0, 0, 0] }),
        },
        "No load",
      ),
    ),
    error,
    h(
      "div.scroll",
      { tabindex: 0, role: "region", "aria-label": "Torques" },
      h(
        "table.bars",
        { "aria-label": "Static torque of each joint" },
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            heads.map((t) => h("th", { scope: "col" }, t)),
          ),
        ),
        body,
      ),
    ),
    verdict,
    height,
  );
  let [lines, arm] = [[], null];

  function typed(i, input, last) {
    const { value, error: fault } = readEntry(input.value, i < 3 ? "force" : "moment");
    const wrong = fault && (last || !unfinished(input.value));
    attribute(input, "aria-invalid", String(Boolean(wrong)));
    error.textContent = wrong
      ? `${PARTS[i][0]}${PARTS[i][1]} ${fault}. The last good wrench stays.`
      : "";
    if (wrong) say(() => error.textContent);
    if (!fault) {
      const wrench = store.state.wrench.map((v, k) => (k === i ? value : v));
      store.dispatch({ type: "push", wrench, gesture: `wrench ${i}` });
    }
    if (!last) return;
    attribute(input, "aria-invalid", "false");
    input.value = short(store.state.wrench[i], 2);
  }

  function lay() {
    arm = store.state.arm;
    lines = joints(arm).map((row) => {
      const cells = ["gravity", "push", "total"].map((name) => h(`td.${name}`));
      const fill = h("span.fill");
      const [part, limit] = [h("span"), h("span.limit")];
      const line = h(
        "tr",
        { onpointerenter: () => point(row), onpointerleave: () => point(null) },
        h("th", { scope: "row" }, indexed("τ", row + 1)),
        cells,
        h(
          "td.bar",
          {},
          h("span.track", { "aria-hidden": true }, fill),
          h("span.share", {}, part, limit),
        ),
      );
      return { row, cells, fill, part, limit, line };
    });
    body.replaceChildren(...lines.map(({ line }) => line));
  }

  function update(state, { gravity, push, torque, energy }) {
    if (arm !== state.arm) lay();
    inputs.forEach((input, i) => {
      if (input.getRootNode().activeElement !== input) input.value = short(state.wrench[i], 2);
    });
    const largest = Math.max(1e-9, ...torque.map(Math.abs));
    lines.forEach(({ row, cells, fill, part, limit, line }, i) => {
      const { effort, kind } = arm.rows[row];
      const unit = kind === "revolute" ? "N m" : "N";
      [gravity[i], -push[i], torque[i]].forEach((v, k) => write(cells[k], fixed(v, 2)));
      const share = torque[i] / (effort ?? largest);
      fill.style.setProperty("--from", `${50 + 50 * Math.max(-1, Math.min(0, share))}%`);
      fill.style.setProperty("--width", `${50 * Math.min(1, Math.abs(share))}%`);
      line.classList.toggle("over", Boolean(effort) && Math.abs(share) > 1);
      const percent = effort ? `${fixed(100 * Math.abs(share), 0)} %` : "";
      write(part, percent);
      write(limit, effort ? ` of ${effort} ${unit}` : unit);
    });
    const over = lines
      .filter(({ line }) => line.classList.contains("over"))
      .map(({ row }) => `joint ${row + 1}`);
    verdict.classList.toggle("warning", over.length > 0);
    write(verdict, verdictText(arm, over, gravity));
    const weighs = arm.rows.some((row) => row.body);
    write(
      height,
      weighs ? `Gravity’s torques are the slopes of one energy, ${fixed(energy, 1)} J here.` : "",
    );
  }
  return { root, update, summary: () => verdict.textContent };
}

function verdictText(arm, over, gravity) {
  if (over.length) return `Too much for ${listed(over)}.`;
  if (!arm.rows.some((row) => row.body))
    return "No masses are known of this arm, so only the push on the tool shows.";
  const held = arm.rows.every((row) => row.kind === "fixed" || row.effort)
    ? "Every joint can hold this. "
    : "";
  const weightless = gravity.every((g) => g === 0) ? " Gravity asks nothing here." : "";
  return `${held}Drag the ball at the tip to push on the tool.${weightless}`;
}
