// Files as answers, by a button and by drag and drop. They are read here and go nowhere.

import { h, write } from "../dom.js";
import { ACCEPTED, textOfFile } from "./file.js";
import { ArmError } from "../../../judge/sentences.js";

/**
 * @param {import("./page.js").Asked} judge
 * @param {HTMLElement} stub where files can be dropped
 */
export function addFiles(judge, stub) {
  const { boxes } = judge.made;
  let held = "";
  const take = async (file) => {
    try {
      held = await textOfFile(file);
    } catch (error) {
      if (!(error instanceof ArmError)) throw error;
      judge.say(error.message);
      return;
    }
    judge.say("");
    write(words, `From ${file.name}, ${held.trim().split("\n").length} lines. `);
    judge.put({ answer: held });
  };
  const { input, button } = makeButton(take);
  const close = () => judge.put({ answer: "" });
  const words = h("span");
  const closing = h("button", { onclick: close }, "Close it");
  const name = h("p.file", { hidden: true }, words, closing);
  takeDrops(stub, take);
  boxes.answer.prepend(h("div.over", {}, boxes.answer.firstChild, input, button));
  boxes.answer.append(name);
  judge.follow(({ answer, ask }) => {
    name.hidden = !held || answer !== held;
    button.hidden = ask !== "trace";
  });
}

function makeButton(take) {
  const onchange = () => {
    const [file] = input.files;
    if (file) take(file);
    input.value = "";
  };
  const input = h("input", { type: "file", accept: ACCEPTED, hidden: true, onchange });
  const button = h("button", { onclick: () => input.click() }, "Open a file");
  return { input, button };
}

function takeDrops(stub, take) {
  stub.addEventListener("dragover", (event) => {
    if (![...event.dataTransfer.types].includes("Files")) return;
    event.preventDefault();
    stub.classList.add("over-it");
  });
  for (const type of ["dragleave", "drop"])
    stub.addEventListener(type, () => stub.classList.remove("over-it"));
  stub.addEventListener("drop", (event) => {
    const [file] = event.dataTransfer.files;
    if (!file) return;
    event.preventDefault();
    take(file);
  });
}
