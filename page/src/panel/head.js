// The line above the picture: which arm, units, and what may be done with the whole instrument.

import { homePose } from "../../../judge/geometry/arm.js";
import { attribute, h, write } from "../dom.js";
import { randomPose } from "../motion.js";
import { called } from "../text.js";

export function makeHead(store, { arms, link, goTo, stage, card, say }) {
  const name = arms.length > 1 ? makeChoice(store, arms, stage) : makeName();
  const units = makeUnits(store);
  const frames = makeFrames(store);
  const steps = makeSteps(store);
  const buttons = [
    frames.root,
    button("Home", "Where this arm stands first", () => goTo(homePose(store.state.arm))),
    button("Random", "Somewhere within its limits", () => goTo(randomPose(store.state.arm))),
    makeFit(stage),
    steps.root,
    ...(link ? [makeCopy(link, say)] : []),
  ];
  card.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z") return;
    if (event.target.matches("input[type=text], textarea") && !event.target.dataset.cell) return;
    event.preventDefault();
    store.dispatch({ type: event.shiftKey ? "redo" : "undo" });
  });
  const group = h("div.buttons", { role: "group", "aria-label": "Settings" }, buttons);
  const parts = [name, units, frames, steps];
  return {
    root: h("header", {}, name.root, units.root, group),
    update: (state) => parts.forEach((part) => part.update(state)),
  };
}

const button = (text, title, onclick) => h("button", { title, onclick }, text);
const press = (one, is) => attribute(one, "aria-pressed", String(is));

function makeName() {
  const root = h("span.name");
  return { root, update: ({ arm }) => write(root, called(arm.name)) };
}

// The list of arms; one that was typed stands in it by its own name.
function makeChoice(store, arms, stage) {
  const choose = (arm) => {
    if (!arm) return;
    store.dispatch({ type: "select", arm });
    stage.fit();
  };
  const root = h("select.name", {
    "aria-label": "Arm",
    onchange: () => choose(arms[root.selectedIndex]),
  });
  let listed = null;
  function list({ arm, base }) {
    const own = arm === base ? null : arm.name;
    if (listed === own && root.options.length) return;
    listed = own;
    const known = arms.map((one) => h("option", { value: one.name }, called(one.name)));
    root.replaceChildren(...known, ...(own ? [h("option", {}, own)] : []));
  }
  function update(state) {
    const { arm, base } = state;
    list(state);
    const index = arm === base ? arms.findIndex((one) => one.name === arm.name) : arms.length;
    if (root.selectedIndex !== index) root.selectedIndex = index;
  }
  return { root, update };
}

function makeUnits(store) {
  const units = Object.entries({ deg: "degrees", rad: "radians" }).map(([unit, title]) => {
    const onclick = () => store.dispatch({ type: "show", unit });
    return h("button", { title, "data-unit": unit, onclick }, unit);
  });
  return {
    root: h("span.pair", { role: "group", "aria-label": "Unit of angles" }, units),
    update: ({ unit }) => units.forEach((one) => press(one, one.dataset.unit === unit)),
  };
}

function makeFrames(store) {
  const title = "Draw the frame of every link, or the first and the last only";
  const other = () => (store.state.frames === "all" ? "ends" : "all");
  const root = button("Frames", title, () => store.dispatch({ type: "show", frames: other() }));
  return { root, update: ({ frames }) => press(root, frames === "all") };
}

function makeSteps(store) {
  const undo = button("↶", "Undo (Ctrl+Z)", () => store.dispatch({ type: "undo" }));
  const redo = button("↷", "Redo (Ctrl+Shift+Z)", () => store.dispatch({ type: "redo" }));
  undo.setAttribute("aria-label", "Undo");
  redo.setAttribute("aria-label", "Redo");
  return {
    root: h("span.pair", { role: "group", "aria-label": "Undo and redo" }, undo, redo),
    update({ past, future }) {
      undo.disabled = !past.length;
      redo.disabled = !future.length;
    },
  };
}

function makeFit(stage) {
  const root = button("Fit", "The whole arm into the picture", () => stage.fit());
  root.className = "spare";
  return root;
}

const makeCopy = (link, say) =>
  button("Copy link", "An address that opens this arm in this place", async ({ target }) => {
    target.textContent = (await link.copy()) ? "Copied" : "In the address bar";
    say(() => target.textContent);
    setTimeout(() => (target.textContent = "Copy link"), 1600);
  });
