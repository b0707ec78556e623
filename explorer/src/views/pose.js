// The tip's pose: T0n in numbers.

import { h, indexed } from "../dom.js";
import { matrix } from "../kinematics.js";
import { fixed, sparse } from "../text.js";

export const title = "Pose";

export function build() {
  const cells = Array.from({ length: 4 }, (_, i) => Array.from({ length: 4 }, (_, j) => h("td", { "data-entry": `${i}${j}` })));
  const name = h("span");
  const table = h("table.matrix", { "aria-label": "Pose of the tip, a four by four matrix" }, cells.map((row) => h("tr", {}, row)));
  const words = h("p.words");
  const root = h("div.pose", {}, h("div.equation", {}, name, h("span", {}, "="), table), words);

  function update(state, { frames }) {
    name.replaceChildren(...indexed("T", `0,${state.arm.rows.length}`));
    matrix(frames.at(-1)).forEach((row, i) => row.forEach((entry, j) => {
      cells[i][j].textContent = i === 3 ? String(entry) : sparse(entry, 4);
      cells[i][j].classList.toggle("nought", Math.abs(entry) < 5e-5);
    }));
    const [x, y, z] = frames.at(-1).o.map((v) => fixed(1000 * v, 1));
    words.replaceChildren(
      h("span", {}, "Tip at ", h("b", {}, `(${x}, ${y}, ${z}) mm`), ". "),
      "The first three columns are the tip’s axes, the fourth its place, in the base frame and in metres.",
    );
  }
  return { root, update };
}
