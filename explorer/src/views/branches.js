// Inverse kinematics: every way to the same pose, as a list and as ghosts.

import { h, indexed } from "../dom.js";
import { joints } from "../kinematics.js";
import { branchColour } from "../scene.js";
import { jointText } from "../text.js";
import { isThere, otherWays, outside, spareJoints } from "../motion.js";

export const title = "IK branches";

export function build(store, { goTo }) {
  const words = h("p.verdict", { role: "status" });
  const list = h("ol.ways");
  const find = h("button.main", { type: "button", onclick: search }, "Find the ways to this pose");
  const root = h("div.branches", {}, h("div.row", {}, find), words, list);
  let shown;

  function search() {
    const { arm, q } = store.state;
    store.set({ ways: otherWays(arm, q).map((way) => ({ q: way })), highlighted: null });
  }

  function update(state) {
    if (shown?.ways !== state.ways || shown.unit !== state.unit || shown.arm !== state.arm) lay(state);
    shown.buttons.forEach((button, i) => {
      button.setAttribute("aria-current", String(isThere(state.ways[i].q, state.q)));
    });
  }

  function lay({ ways, arm, unit }) {
    const moving = joints(arm);
    const known = moving.some((row) => arm.rows[row].lower !== null);
    const buttons = (ways ?? []).map(({ q, label }, i) => {
      const past = moving.flatMap((row, k) => (outside(arm.rows[row], q[k]) ? [row + 1] : []));
      const light = (on) => () => store.set({ highlighted: on ? i : null });
      return h("button", { type: "button", onclick: () => goTo(q), onpointerenter: light(true), onpointerleave: light(false), onfocus: light(true), onblur: light(false) },
        h("span.swatch", { style: `background:${branchColour(i)}`, "aria-hidden": true }),
        h("span.name", {}, label ? named(label) : `way ${i + 1}`),
        h("span.values", {}, moving.map((row, k) => h("span", {}, indexed("q", row + 1), ` ${jointText(arm.rows[row], q[k], unit)}`))),
        h(past.length ? "span.note.past" : "span.note", {}, past.length ? `past the limit of joint ${past.join(", ")}` : known ? "within limits" : ""));
    });
    list.replaceChildren(...buttons.map((button) => h("li", {}, button)));
    words.textContent = summary(ways, arm);
    shown = { ways, unit, arm, buttons };
  }
  return { root, update };
}

// A branch's name as Python writes it, its q_5 and elbow - as they are printed.
const named = (label) =>
  label.split(/\b([a-z]_\d+)\b/).map((part, i) => (i % 2 ? h("span", {}, indexed(...part.split("_"))) : part.replace(/-$/, "−")));

function summary(ways, arm) {
  if (!ways) return "Each way that the same pose can be reached is shown as a ghost; choose one to go there.";
  const count = ways.length === 1 ? "One way" : `${ways.length} ways`;
  const pose = joints(arm).length < 6 ? "place, whatever the tool’s direction" : "pose";
  const held = ["", ` with joint ${joints(arm)[2] + 1} held where it is; free, it makes them infinitely many`][spareJoints(arm)] ?? " of infinitely many";
  return `${count} to this ${pose}${held}. Choose one, here or in the picture, to go there.`;
}
