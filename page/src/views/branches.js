// Inverse kinematics: every way to the same pose, as a list and as ghosts.

import { attribute, h, indexed, write } from "../dom.js";
import { hasLimits, isOutsideLimits } from "../../../judge/geometry/arm.js";
import { latest } from "../jobs.js";
import { movingRows } from "../../../judge/geometry/kinematics.js";
import { isThere } from "../motion.js";
import { branchColour } from "../look.js";
import { leftBehind } from "../state.js";
import { fixed, jointText } from "../text.js";
import { aim, waysVerdict } from "../verdicts.js";

export const title = "IK branches";

const findWords = ({ arm }) => `Find the ways to this ${aim(arm)}`;

export function build(store, { goTo, say }) {
  const words = h("p.verdict");
  const list = h("ol.ways");
  const find = h("button.main", { onclick: search });
  const root = h("div.branches", {}, h("div.row", {}, find), words, list);
  const ask = latest("ways");
  let shown;

  function search() {
    const { arm, q } = store.state;
    find.textContent = "Looking …";
    ask({ arm, q }, (ways) => {
      find.textContent = findWords(store.state);
      store.dispatch({ type: "ways", arm, ways });
      say(() => words.textContent, true);
    });
  }

  function update(state, derived) {
    const { ways, unit, arm } = state;
    if (shown?.ways !== ways || shown.unit !== unit || shown.arm !== arm) {
      const light = (highlighted) => store.dispatch({ type: "show", highlighted });
      const buttons = (ways?.list ?? []).map((way, i) => wayButton(way, i, state, { goTo, light }));
      if (shown?.arm !== arm) find.textContent = findWords(state);
      list.replaceChildren(...buttons.map((button) => h("li", {}, button)));
      shown = { ways, unit, arm, buttons };
    }
    const left = leftBehind(state, derived);
    root.classList.toggle("left", Boolean(left));
    write(words, summary(state, left));
    shown.buttons.forEach((button, i) => {
      attribute(button, "aria-current", String(isThere(ways.list[i].q, state.q)));
    });
  }
  return { root, update, summary: () => words.textContent };
}

function wayButton({ q, label }, i, { arm, unit }, { goTo, light }) {
  const moving = movingRows(arm);
  const past = moving.flatMap((row, k) => (isOutsideLimits(arm.rows[row], q[k]) ? [row + 1] : []));
  const within = hasLimits(arm) ? "within limits" : "";
  const values = moving.map((row, k) =>
    h("span", {}, indexed("q", row + 1), ` ${jointText(arm.rows[row], q[k], unit)}`),
  );
  const [on, off] = [() => light(i), () => light(null)];
  const lights = { onpointerenter: on, onpointerleave: off, onfocus: on, onblur: off };
  return h(
    "button",
    { onclick: () => goTo(q), ...lights },
    h("span.swatch", { style: `background:${branchColour(i)}`, "aria-hidden": "true" }),
    h("span.name", {}, label ? named(label) : `way ${i + 1}`),
    h("span.values", {}, values),
    past.length
      ? h("span.note.past", {}, `past the limit of joint ${past.join(", ")}`)
      : h("span.note", {}, within),
  );
}

// A branch's name as Python writes it, its q_5 and elbow - as they are printed.
const named = (label) =>
  label
    .split(/\b([a-z]_\d+)\b/)
    .map((part, i) =>
      i % 2 ? h("span", {}, indexed(...part.split("_"))) : part.replace(/-$/, "−"),
    );

function summary({ ways, arm }, left) {
  const where = aim(arm);
  if (!ways) {
    const shown = "is shown in a colour of its own; choose one to go there.";
    return `Each way that the same ${where} can be reached ${shown}`;
  }
  const choose = ways.list.length > 1 ? " Choose one, here or in the picture, to go there." : "";
  if (!left) return waysVerdict(arm, ways) + choose;
  const gone =
    left.far > 5e-4 ? `${fixed(1000 * left.far, 0)} mm from there` : "turned away from it";
  const back = `Choose one to go back, or find the ways to this ${where}.`;
  return `These lead to the ${where} where the tip was before; it is now ${gone}. ${back}`;
}
