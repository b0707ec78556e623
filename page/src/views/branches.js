// Inverse kinematics: every way to the same pose, as a list and as ghosts.

import { attribute, h, indexed, write } from "../dom.js";
import { limited, outside } from "../../../judge/geometry/arm.js";
import { latest } from "../jobs.js";
import { joints } from "../../../judge/geometry/kinematics.js";
import { isThere } from "../motion.js";
import { branchColour } from "../scene.js";
import { leftBehind } from "../state.js";
import { fixed, jointText } from "../text.js";
import { waysVerdict } from "../verdicts.js";

export const title = "IK branches";

export function build(store, { goTo, say }) {
  const words = h("p.verdict");
  const list = h("ol.ways");
  const find = h("button.main", { type: "button", onclick: search }, "Find the ways to this pose");
  const root = h("div.branches", {}, h("div.row", {}, find), words, list);
  const ask = latest("ways");
  let shown;

  async function search() {
    const { arm, q } = store.state;
    find.textContent = "Looking …";
    await ask({ arm, q }, (ways) => {
      store.dispatch({ type: "ways", arm, ways });
      say(() => words.textContent, true);
    });
    find.textContent = "Find the ways to this pose";
  }

  function update(state, derived) {
    if (shown?.ways !== state.ways || shown.unit !== state.unit || shown.arm !== state.arm)
      lay(state);
    const left = leftBehind(state, derived);
    root.classList.toggle("left", Boolean(left));
    write(words, summary(state, left));
    shown.buttons.forEach((button, i) => {
      attribute(button, "aria-current", String(isThere(state.ways.list[i].q, state.q)));
    });
  }

  function lay({ ways, arm, unit }) {
    const moving = joints(arm);
    const buttons = (ways?.list ?? []).map(({ q, label }, i) => {
      const past = moving.flatMap((row, k) => (outside(arm.rows[row], q[k]) ? [row + 1] : []));
      const light = (on) => () => store.dispatch({ type: "show", highlighted: on ? i : null });
      const note = past.length
        ? `past the limit of joint ${past.join(", ")}`
        : limited(arm)
          ? "within limits"
          : "";
      const values = moving.map((row, k) =>
        h("span", {}, indexed("q", row + 1), ` ${jointText(arm.rows[row], q[k], unit)}`),
      );
      const lights = {
        onpointerenter: light(true),
        onpointerleave: light(false),
        onfocus: light(true),
        onblur: light(false),
      };
      return h(
        "button",
        { type: "button", onclick: () => goTo(q), ...lights },
        h("span.swatch", { style: `background:${branchColour(i)}`, "aria-hidden": "true" }),
        h("span.name", {}, label ? named(label) : `way ${i + 1}`),
        h("span.values", {}, values),
        h(past.length ? "span.note.past" : "span.note", {}, note),
      );
    });
    list.replaceChildren(...buttons.map((button) => h("li", {}, button)));
    shown = { ways, unit, arm, buttons };
  }
  return { root, update, summary: () => words.textContent };
}

// A branch's name as Python writes it, its q_5 and elbow - as they are printed.
const named = (label) =>
  label
    .split(/\b([a-z]_\d+)\b/)
    .map((part, i) =>
      i % 2 ? h("span", {}, indexed(...part.split("_"))) : part.replace(/-$/, "−"),
    );

function summary({ ways, arm }, left) {
  if (!ways)
    return "Each way that the same pose can be reached is shown in a colour of its own; choose one to go there.";
  const choose = ways.list.length > 1 ? " Choose one, here or in the picture, to go there." : "";
  if (!left) return waysVerdict(arm, ways) + choose;
  const gone =
    left.far > 5e-4 ? `${fixed(1000 * left.far, 0)} mm from there` : "turned away from it";
  const back = "Choose one to go back, or find the ways to this pose.";
  return `These lead to the pose where the tip was before; it is now ${gone}. ${back}`;
}
