// The picture with what one can do to it. Until it is drawn, where the browser has no WebGL, and on
// paper there is a still one.

import { attribute, h, write } from "../dom.js";
import { makeGrabbable, moveTipByKey } from "../pointers.js";
import { asked, holdVerdict } from "../verdicts.js";
import { movingRows } from "../../../judge/geometry/kinematics.js";
import { nullSpace } from "../../../judge/geometry/linear.js";
import { reach } from "../motion.js";
import { ArmPicture } from "../scene.js";
import { still } from "../still.js";
import { jointText } from "../text.js";

const HELP =
  "Picture of the arm. Arrow keys turn the view, plus and minus bring it nearer and farther, " +
  "0 fits it. The button at the tip moves the tip; the sliders turn the joints.";
const GRIP_HELP = "Arrow keys move the tip across the picture, Page keys to and fro.";
const LOST = "The browser took the picture’s graphics away; it comes back when it can.";
const FLAT = "No WebGL in this browser: a drawing follows.";
const VIEW_KEYS = {
  ArrowLeft: [-0.12, 0],
  ArrowRight: [0.12, 0],
  ArrowUp: [0, -0.1],
  ArrowDown: [0, 0.1],
  "+": [0, 0, 0.9],
  "=": [0, 0, 0.9],
  "-": [0, 0, 1.1],
};
const SWING = 0.06; // rad along the null space for one press

/**
 * @param {import("../state.js").Store} store
 * @param {{ goTo: (q: number[]) => void, id: string, say?: Function, signal: AbortSignal,
 *   held?: boolean, bar?: boolean, first?: number }} tools whether the arm can be `held` by the
 *   hand, whether there is a `bar` for the tip, and the number of the `first` frame
 */
export function makeStage(store, tools) {
  const { goTo, id, say = () => {}, signal, held = true, bar = true, first = 0 } = tools;
  const moved = (event) =>
    picture && moveTipByKey(picture, store, event) && say(() => holdVerdict(store.state.hold));
  const parts = partsOf(id, makeHoldBar(store, bar), moved);
  const { paper, grip, hold, why } = parts;
  const root = h("div.stage", { tabindex: 0, role: "application", "aria-label": HELP });
  root.append(...Object.values({ ...parts, hold: hold.root }));
  const picture = pictureIn(root, parts, first);
  if (picture && held) makeGrabbable(picture, store, { grip, goTo });
  root.addEventListener("dblclick", () => picture?.fit());
  root.addEventListener("keydown", (event) => {
    if (event.target === root && turnedView(picture, event.key)) event.preventDefault();
  });
  const drawStill = () =>
    paper.replaceChildren(still(store.state, store.derived, stillWords(store.state)), h("slot"));
  drawStill();
  if (picture) addEventListener("beforeprint", drawStill, { signal });
  return {
    root,
    picture,
    draw(state, derived, theme) {
      if (picture) picture.draw(state, derived, theme);
      else drawStill();
    },
    update(state) {
      hold.update(state);
      const pushed = state.view !== "torque" || state.wrench.slice(0, 3).some(Boolean);
      grip.hidden = !held || !picture || !movingRows(state.arm).length || !pushed;
      const words = holdVerdict(state.hold);
      write(why, words);
      why.hidden = !words;
    },
    fit: () => picture?.fit(),
    dispose: () => picture?.dispose(),
  };
}

const partsOf = (id, hold, onkeydown) => ({
  paper: h("div.paper"),
  labels: h("div.labels", { "aria-hidden": "true", hidden: true }),
  grip: h("button.grip", {
    "aria-label": "Tip",
    "aria-describedby": `${id}-grip`,
    onkeydown,
    title: "Drag the tip: the joints follow. Arrow keys move it too.",
  }),
  help: h("span.hidden", { id: `${id}-grip` }, GRIP_HELP),
  hold,
  why: h("p.why", { "aria-hidden": "true" }),
  lost: h("p.lost", { hidden: true }, LOST),
});

function stillWords({ arm, q, unit }) {
  const at = movingRows(arm).map(
    (row, k) => `q_${row + 1} = ${jointText(arm.rows[row], q[k], unit)}`,
  );
  return `Still picture of the ${arm.name}${at.length ? ` at ${at.join(", ")}` : ""}.`;
}

// The live picture, or null where there is no WebGL.
function pictureIn(root, { labels, grip, hold, lost }, first) {
  try {
    const picture = new ArmPicture(root, labels, {
      first,
      onLost: (is) => (lost.hidden = !is),
      onPlace: ([x, y]) => {
        grip.style.transform = `translate(${x}px, ${y}px)`;
        root.classList.add("drawn");
      },
    });
    picture.figure.foot = () => hold.root.offsetHeight + 40; // and the foot’s own disc and label
    return picture;
  } catch {
    root.setAttribute("role", "group");
    root.setAttribute("aria-label", "Picture of the arm");
    root.removeAttribute("tabindex");
    hold.root.hidden = true;
    write(lost, FLAT);
    lost.hidden = !document.defaultView; // a page that is being built knows nothing of its browser
    return null;
  }
}

// Turn the view by a key; whether it was one.
function turnedView(picture, key) {
  const view = VIEW_KEYS[key];
  if (key === "0") picture?.fit();
  else if (view) picture?.figure.orbit(...view);
  return key === "0" || Boolean(view);
}

// Below the picture: whether a dragged tip keeps its direction, and whether the tip is pinned so
// that the elbow swings.
function makeHoldBar(store, shown) {
  const button = (text, title, onclick) => h("button", { title, onclick }, text);
  const keep = button("Keep direction", "A dragged tip keeps the direction of the tool too", () =>
    store.dispatch({ type: "show", keepTurn: !store.state.keepTurn }),
  );
  const title = "Hold the tip where it is, and drag the elbow through what is left";
  const pin = button("Pin the tip", title, () => togglePin(store));
  const swing = [-1, 1].map((way) => {
    const label = `Swing ${way < 0 ? "one" : "the other"} way`;
    const onclick = () => swingBy(store, way);
    const attributes = { "aria-label": label, onclick };
    return h("button.swing", attributes, way < 0 ? "↺" : "↻");
  });
  const root = h("div.hold", { role: "group", "aria-label": "The tip" }, keep, pin, swing);
  root.hidden = !shown;

  function update({ keepTurn, hold, arm }) {
    const pinned = Boolean(hold?.pinned);
    attribute(keep, "aria-pressed", String(keepTurn));
    keep.hidden = asked(arm) < 6;
    attribute(pin, "aria-pressed", String(pinned));
    write(pin, pinned ? pinWords(hold) : "Pin the tip");
    swing.forEach((one) => (one.hidden = !pinned || !hold.free));
  }
  return { root, update };
}

function togglePin(store) {
  const { state, derived } = store;
  const turns = movingRows(state.arm).length > 6 || (state.keepTurn && asked(state.arm) === 6);
  const pinned = { pinned: derived.frames.at(-1), turns, free: freedom(store, turns) };
  store.dispatch({ type: "show", hold: state.hold?.pinned ? null : pinned });
}

const pinWords = ({ free, turns }) => {
  const what = turns ? "place and direction" : "place";
  return free ? `Tip pinned (${what}): drag the elbow` : `Tip pinned (${what}): nothing is free`;
};

const stillColumns = ({ derived }, turns) => derived.columns.map((c) => c.slice(0, turns ? 6 : 3));
const freedom = (store, turns) => nullSpace(stillColumns(store, turns)).length;

// A step through the null space, as a drag of the elbow makes it.
function swingBy(store, way) {
  const { arm, q, hold } = store.state;
  if (!hold?.pinned) return;
  const [direction] = nullSpace(stillColumns(store, hold.turns));
  if (!direction) return;
  const [lead] = [...direction].sort((u, v) => Math.abs(v) - Math.abs(u));
  const sign = way * Math.sign(lead);
  const moved = q.map((v, k) => v + sign * SWING * direction[k]);
  const there = reach(arm, moved, hold.pinned, { rows: hold.turns ? 6 : 3 });
  store.dispatch({ type: "move", q: there.q, hold, gesture: "swing" });
}
