// What holding still takes: gravity less what the world's push on the tool gives back, beside each joint's limit.

import { h, indexed } from "../dom.js";
import { joints } from "../kinematics.js";
import { fixed, listed, readEntry } from "../text.js";

export const title = "Static torque";

const PARTS = [["F", "x", "N"], ["F", "y", "N"], ["F", "z", "N"], ["M", "x", "N m"], ["M", "y", "N m"], ["M", "z", "N m"]];

export function build(store, { point }) {
  const inputs = PARTS.map(([letter, index, unit], i) => h("input", {
    type: "text", inputmode: "decimal", "aria-label": `${letter} ${index}, ${unit}`, oninput: (e) => typed(i, e.target), onchange: () => update(store.state, store.derived),
  }));
  const error = h("p.error", { role: "alert" });
  const body = h("tbody");
  const verdict = h("p.verdict", { role: "status" });
  const heads = ["joint", "gravity", "−Jᵀ F", "torque", "share of the limit"];
  const root = h("div.torque", {},
    h("fieldset.wrench", {}, h("legend", {}, "Wrench on the tool, by the world, at the tip (N, N m)"),
      PARTS.map(([letter, index], i) => h("label", {}, h("span", {}, indexed(letter, index)), inputs[i])),
      h("button", { type: "button", onclick: () => store.set({ wrench: [0, 0, 0, 0, 0, 0] }) }, "No load")),
    error,
    h("div.scroll", { tabindex: 0, role: "region", "aria-label": "Torques" },
      h("table.bars", { "aria-label": "Static torque of each joint" }, h("thead", {}, h("tr", {}, heads.map((t) => h("th", { scope: "col" }, t)))), body)),
    verdict);
  let [lines, arm] = [[], null];

  function typed(i, input) {
    const { value, error: wrong } = readEntry(input.value, false, "deg");
    input.toggleAttribute("aria-invalid", Boolean(wrong));
    error.textContent = wrong ? `${PARTS[i][0]}${PARTS[i][1]} ${wrong.replace("write metres, as 0.333", `write ${PARTS[i][2]}, as −5`)}; the last good wrench stays.` : "";
    if (!wrong) store.set({ wrench: store.state.wrench.map((v, k) => (k === i ? value : v)) });
  }

  function lay() {
    arm = store.state.arm;
    lines = joints(arm).map((row) => {
      const cells = ["gravity", "push", "total"].map((name) => h(`td.${name}`));
      const fill = h("span.fill");
      const [part, limit] = [h("span"), h("span.limit")];
      const line = h("tr", { onpointerenter: () => point(row), onpointerleave: () => point(null) },
        h("th", { scope: "row" }, indexed("τ", row + 1)), cells, h("td.bar", {}, h("span.track", { "aria-hidden": true }, fill), h("span.share", {}, part, limit)));
      return { row, cells, fill, part, limit, line };
    });
    body.replaceChildren(...lines.map(({ line }) => line));
  }

  function update(state, { gravity, push, torque }) {
    if (arm !== state.arm) lay();
    inputs.forEach((input, i) => {
      if (input.getRootNode().activeElement !== input) input.value = String(Number(state.wrench[i].toFixed(2)) + 0).replace("-", "−");
    });
    const largest = Math.max(1e-9, ...torque.map(Math.abs));
    lines.forEach(({ row, cells, fill, part, limit, line }, i) => {
      const { effort, kind } = arm.rows[row];
      const unit = kind === "revolute" ? "N m" : "N";
      [gravity[i], -push[i], torque[i]].forEach((v, k) => (cells[k].textContent = fixed(v, 2)));
      const share = torque[i] / (effort ?? largest);
      fill.style.setProperty("--from", `${50 + 50 * Math.max(-1, Math.min(0, share))}%`);
      fill.style.setProperty("--width", `${50 * Math.min(1, Math.abs(share))}%`);
      line.classList.toggle("over", Boolean(effort) && Math.abs(share) > 1);
      part.textContent = effort ? `${fixed(100 * Math.abs(share), 0)} %` : "";
      limit.textContent = effort ? ` of ${effort} ${unit}` : unit;
    });
    const over = lines.filter(({ line }) => line.classList.contains("over")).map(({ row }) => `joint ${row + 1}`);
    verdict.classList.toggle("warning", over.length > 0);
    verdict.textContent = verdictText(arm, over, gravity);
  }
  return { root, update };
}

function verdictText(arm, over, gravity) {
  if (over.length) return `Too much for ${listed(over)}.`;
  if (!arm.rows.some((row) => row.body)) return "No masses are given for this arm, so only the push on the tool shows.";
  const known = arm.rows.some((row) => row.effort);
  return `${known ? "Every joint can hold this. " : ""}Drag the ball at the tip to push on the tool.${gravity.every((g) => g === 0) ? " Gravity asks nothing here." : ""}`;
}
