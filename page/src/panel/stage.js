// The picture and its controls. A still picture replaces it until it is drawn, without WebGL, and
// on paper.

import { updateAttribute, h, setText } from "../dom.js";
import { listHeldRows } from "../dragging.js";
import { enableGrabbing, moveTipByKey } from "../pointers.js";
import { describeDragLimit } from "../statements.js";
import { movableRows, pick } from "../../../judge/geometry/task_rows.js";
import { movingRows } from "../../../judge/geometry/kinematics.js";
import { nullSpace } from "../../../judge/geometry/linear.js";
import { solvePose } from "../motion.js";
import { ArmPicture } from "../scene.js";
import { makeStillPicture } from "../still.js";
import { formatJointValue } from "../text.js";

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
const SWING_STEP = 0.06; // rad along the null space for one press

/**
 * Make the picture with its controls.
 * @param {import("../state.js").Store} store
 * @param {{ goTo: (q: number[]) => void, id: string, announce?: Function, signal: AbortSignal,
 *   isGrabbable?: boolean, hasTipBar?: boolean, firstFrame?: number }} tools `firstFrame` is the
 *   number of the first frame; `hasTipBar` shows the buttons for the tip
 */
export function makeStage(store, tools) {
  const { goTo, id, announce = () => {}, signal, isGrabbable = true, hasTipBar = true } = tools;
  const handleKey = (event) => {
    if (!live.picture || !moveTipByKey(live.picture, store, event)) return;
    announce(() => describeDragLimit(store.state.tipHold));
  };
  const parts = makeStageParts(id, makeTipBar(store, hasTipBar), handleKey);
  const { paper, grip, tipButtons } = parts;
  const root = h("div.stage", { tabindex: 0, role: "application", "aria-label": HELP });
  root.append(...Object.values({ ...parts, tipButtons: tipButtons.root }));
  const drawStill = () => drawStillPicture(paper, store);
  drawStill();
  const live = makeLivePicture(root, parts, tools.firstFrame ?? 0, drawStill);
  if (live.picture && isGrabbable) enableGrabbing(live.picture, store, { grip, goTo });
  root.addEventListener("dblclick", () => live.picture?.fitView());
  root.addEventListener("keydown", (event) => {
    if (event.target === root && turnViewByKey(live.picture, event.key)) event.preventDefault();
  });
  if (live.picture) addEventListener("beforeprint", drawStill, { signal });
  return {
    root,
    get picture() {
      return live.picture;
    },
    draw(state, derived, theme) {
      if (live.picture) live.picture.draw(state, derived, theme);
      else drawStill();
    },
    update(state) {
      updateParts(parts, state, isGrabbable && Boolean(live.picture));
    },
    fit: () => live.picture?.fitView(),
    dispose: () => live.picture?.dispose(),
  };
}

// Update the handle of the tip, the buttons and the message about a stopped tip.
function updateParts({ tipButtons, grip, why }, state, isGrabbable) {
  tipButtons.update(state);
  // Without a force, the torque view's ball is at the tip, where it replaces the tip's handle.
  const isTipFree = state.view !== "torque" || state.wrench.slice(0, 3).some(Boolean);
  grip.hidden = !isGrabbable || !movingRows(state.arm).length || !isTipFree;
  const message = describeDragLimit(state.tipHold);
  setText(why, message);
  why.hidden = !message;
}

// Make the live picture. The still picture replaces it if WebGL turns out to be missing.
function makeLivePicture(root, parts, firstFrame, drawStill) {
  const onUnavailable = () => {
    live.picture?.dispose();
    live.picture = null;
    parts.grip.hidden = true;
    drawStill();
    showWithoutWebGL(root, parts);
  };
  const live = { picture: makePicture(root, parts, { firstFrame, onUnavailable }) };
  return live;
}

function drawStillPicture(paper, { state, derived }) {
  paper.replaceChildren(makeStillPicture(state, derived, describeStill(state)), h("slot"));
}

const makeStageParts = (id, tipButtons, onkeydown) => ({
  paper: h("div.paper"),
  labels: h("div.labels", { "aria-hidden": "true", hidden: true }),
  legend: makeAxisLegend(),
  grip: h("button.grip", {
    "aria-label": "Tip",
    "aria-describedby": `${id}-grip`,
    onkeydown,
    title: "Drag the tip: the joints follow. Arrow keys move it too.",
  }),
  help: h("span.hidden", { id: `${id}-grip` }, GRIP_HELP),
  tipButtons,
  why: h("p.why", { "aria-hidden": "true" }),
  lost: h("p.lost", { hidden: true }, LOST),
});

// Make the legend of the axes' colours.
const makeAxisLegend = () =>
  h(
    "p.legend",
    { "aria-hidden": "true" },
    [..."xyz"].map((axis) => h(`span.axis-${axis}`, {}, h("i", {}, axis))),
  );

function describeStill({ arm, q, unit }) {
  const at = movingRows(arm).map(
    (row, k) => `q_${row + 1} = ${formatJointValue(arm.rows[row], q[k], unit)}`,
  );
  return `Still picture of the ${arm.name}${at.length ? ` at ${at.join(", ")}` : ""}.`;
}

// Make the live picture, or return null if there is no WebGL.
function makePicture(root, parts, { firstFrame, onUnavailable }) {
  const { labels, grip, tipButtons, lost } = parts;
  try {
    const picture = new ArmPicture(root, labels, {
      firstFrame,
      onUnavailable,
      onContextChange: (isLost) => (lost.hidden = !isLost),
      onPlace: ([x, y]) => (grip.style.transform = `translate(${x}px, ${y}px)`),
      onDrawn: () => root.classList.add("drawn"),
    });
    // 40 px are the disc and the label at the arm's foot.
    picture.figure.getFootHeight = () => tipButtons.root.offsetHeight + 40;
    return picture;
  } catch {
    showWithoutWebGL(root, parts);
    return null;
  }
}

// Turn the stage into a plain drawing.
function showWithoutWebGL(root, { tipButtons, lost }) {
  root.setAttribute("role", "group");
  root.setAttribute("aria-label", "Picture of the arm");
  root.removeAttribute("tabindex");
  tipButtons.root.hidden = true;
  setText(lost, FLAT);
  lost.hidden = !document.defaultView; // while a page is built, its browser is unknown
}

// Turn the view by a key. Returns false for other keys.
function turnViewByKey(picture, key) {
  const view = VIEW_KEYS[key];
  if (key === "0") picture?.fitView();
  else if (view) picture?.figure.turnView(...view);
  return key === "0" || Boolean(view);
}

// Make the buttons below the picture: keep the direction of a dragged tip, and pin the tip so that
// the elbow swings.
function makeTipBar(store, shown) {
  const button = (text, title, onclick) => h("button", { title, onclick }, text);
  const keep = button("Keep direction", "A dragged tip keeps the direction of the tool too", () =>
    store.dispatch({ type: "setFields", keepOrientation: !store.state.keepOrientation }),
  );
  const title = "Hold the tip where it is, and drag the elbow through what is left";
  const pin = button("Pin the tip", title, () => togglePin(store));
  const swing = [-1, 1].map((sense) => {
    const label = `Swing ${sense < 0 ? "one" : "the other"} way`;
    const onclick = () => swingElbowBy(store, sense);
    const attributes = { "aria-label": label, onclick };
    return h("button.swing", attributes, sense < 0 ? "↺" : "↻");
  });
  const root = h("div.tip-buttons", { role: "group", "aria-label": "The tip" }, keep, pin, swing);
  root.hidden = !shown;

  function update({ keepOrientation, tipHold, arm }) {
    const pinned = Boolean(tipHold?.pinned);
    updateAttribute(keep, "aria-pressed", String(keepOrientation));
    keep.hidden = !canTurnFreely(arm);
    updateAttribute(pin, "aria-pressed", String(pinned));
    setText(pin, pinned ? describePin(tipHold) : "Pin the tip");
    swing.forEach((button) => (button.hidden = !pinned || !tipHold.free));
  }
  return { root, update };
}

// Return whether the arm has the joints to hold the tool's direction while the tip moves anywhere.
const canTurnFreely = (arm) => movingRows(arm).length >= 6 && movableRows(arm).length === 6;

function togglePin(store) {
  const { state, derived } = store;
  const turns =
    movingRows(state.arm).length > 6 || (state.keepOrientation && canTurnFreely(state.arm));
  const pinned = { pinned: derived.frames.at(-1), turns, free: countFreedom(store, turns) };
  store.dispatch({ type: "setFields", tipHold: state.tipHold?.pinned ? null : pinned });
}

const describePin = ({ free, turns }) => {
  const what = turns ? "place and direction" : "place";
  return free ? `Tip pinned (${what}): drag the elbow` : `Tip pinned (${what}): nothing is free`;
};

const getPinnedColumns = ({ derived }, turns) =>
  derived.columns.map((column) => pick(column, listHeldRows(turns)));
const countFreedom = (store, turns) => nullSpace(getPinnedColumns(store, turns)).length;

// Move one step through the null space, as dragging the elbow does.
function swingElbowBy(store, sense) {
  const { arm, q, tipHold } = store.state;
  if (!tipHold?.pinned) return;
  const [direction] = nullSpace(getPinnedColumns(store, tipHold.turns));
  if (!direction) return;
  const [lead] = [...direction].sort((u, v) => Math.abs(v) - Math.abs(u));
  const sign = sense * Math.sign(lead);
  const moved = q.map((v, k) => v + sign * SWING_STEP * direction[k]);
  const solution = solvePose(arm, moved, tipHold.pinned, { rows: listHeldRows(tipHold.turns) });
  store.dispatch({ type: "moveJoints", q: solution.q, tipHold, gesture: "swing" });
}
