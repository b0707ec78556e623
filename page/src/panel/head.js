// The bar above the picture: the arm, units, and buttons for the whole explorer.

import { homeConfiguration } from "../../../judge/geometry/arm.js";
import { updateAttribute, h, setText } from "../dom.js";
import { drawRandomConfiguration } from "../motion.js";
import { getDisplayName } from "../text.js";

export function makeHeader(store, { arms, link, goTo, stage, card, announce }) {
  const name = arms.length > 1 ? makeArmChoice(store, arms, stage) : makeArmName();
  const units = makeUnitButtons(store);
  const frames = makeFramesButton(store);
  const steps = makeUndoButtons(store);
  const buttons = [
    frames.root,
    makeButton("Home", "Where this arm stands first", () =>
      goTo(homeConfiguration(store.state.arm)),
    ),
    makeButton("Random", "Somewhere within its limits", () =>
      goTo(drawRandomConfiguration(store.state.arm)),
    ),
    makeFitButton(stage),
    steps.root,
    ...(link ? [makeCopyLinkButton(link, announce)] : []),
  ];
  card.addEventListener("keydown", (event) => {
    const type = getStepOfKey(event);
    if (!type) return;
    if (event.target.matches("input[type=text], textarea") && !event.target.dataset.cell) return;
    event.preventDefault();
    store.dispatch({ type });
    steps.keepFocus();
  });
  const group = h("div.buttons", { role: "group", "aria-label": "Settings" }, buttons);
  const parts = [name, units, frames, steps];
  return {
    root: h("header", {}, name.root, units.root, group),
    update: (state) => parts.forEach((part) => part.update(state)),
  };
}

// Return the event that a key stands for: Ctrl+Z undoes, Ctrl+Shift+Z and Ctrl+Y redo.
export function getStepOfKey({ key, ctrlKey, metaKey, shiftKey }) {
  if (!ctrlKey && !metaKey) return null;
  if (key.toLowerCase() === "y") return "redo";
  if (key.toLowerCase() !== "z") return null;
  return shiftKey ? "redo" : "undo";
}

const makeButton = (text, title, onclick) => h("button", { title, onclick }, text);
const setPressed = (item, is) => updateAttribute(item, "aria-pressed", String(is));

function makeArmName() {
  const root = h("span.name");
  return { root, update: ({ arm }) => setText(root, getDisplayName(arm.name)) };
}

// Make the list of arms; a typed arm is its last entry.
function makeArmChoice(store, arms, stage) {
  const onchange = () => {
    store.dispatch({ type: "selectArm", arm: arms[root.selectedIndex] });
    stage.fit();
  };
  const root = h("select.name", { "aria-label": "Arm", onchange });
  let listedName = null;
  function list({ arm, base }) {
    const typedName = arm === base ? null : arm.name;
    if (listedName === typedName && root.options.length) return;
    listedName = typedName;
    const known = arms.map((item) => h("option", { value: item.name }, getDisplayName(item.name)));
    root.replaceChildren(...known, ...(typedName ? [h("option", {}, typedName)] : []));
  }
  function update(state) {
    const { arm, base } = state;
    list(state);
    const index = arm === base ? arms.findIndex((item) => item.name === arm.name) : arms.length;
    if (root.selectedIndex !== index) root.selectedIndex = index;
  }
  return { root, update };
}

function makeUnitButtons(store) {
  const units = Object.entries({ deg: "degrees", rad: "radians" }).map(([unit, title]) => {
    const onclick = () => store.dispatch({ type: "setFields", unit });
    return h("button", { title, "data-unit": unit, onclick }, unit);
  });
  return {
    root: h("span.pair", { role: "group", "aria-label": "Unit of angles" }, units),
    update: ({ unit }) => units.forEach((item) => setPressed(item, item.dataset.unit === unit)),
  };
}

function makeFramesButton(store) {
  const title = "Draw the frame of every link, or the first and the last only";
  const other = () => (store.state.frames === "all" ? "ends" : "all");
  const root = makeButton("Frames", title, () =>
    store.dispatch({ type: "setFields", frames: other() }),
  );
  return { root, update: ({ frames }) => setPressed(root, frames === "all") };
}

function makeUndoButtons(store) {
  const undo = makeButton("↶", "Undo (Ctrl+Z)", () => store.dispatch({ type: "undo" }));
  const title = "Redo (Ctrl+Y or Ctrl+Shift+Z)";
  const redo = makeButton("↷", title, () => store.dispatch({ type: "redo" }));
  undo.setAttribute("aria-label", "Undo");
  redo.setAttribute("aria-label", "Redo");
  const root = h("span.pair", { role: "group", "aria-label": "Undo and redo" }, undo, redo);
  return {
    root,
    // A disabled button would lose the focus, so the buttons are only described as disabled.
    update({ past, future }) {
      updateAttribute(undo, "aria-disabled", String(!past.length));
      updateAttribute(redo, "aria-disabled", String(!future.length));
    },
    // Take the focus if a step has rebuilt the field that had it.
    keepFocus() {
      const { activeElement } = /** @type {ShadowRoot} */ (root.getRootNode());
      if (!activeElement) undo.focus({ preventScroll: true });
    },
  };
}

function makeFitButton(stage) {
  const root = makeButton("Fit", "The whole arm into the picture", () => stage.fit());
  root.className = "spare";
  return root;
}

const makeCopyLinkButton = (link, announce) =>
  makeButton("Copy link", "An address that opens this arm in this place", async ({ target }) => {
    target.textContent = (await link.copy()) ? "Copied" : "In the address bar";
    announce(() => target.textContent);
    setTimeout(() => (target.textContent = "Copy link"), 1600);
  });
