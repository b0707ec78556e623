// Files as answers, chosen with a button or dropped. They are read in the page and sent nowhere.

import { h, setText } from "../dom.js";
import { ACCEPTED_TYPES, readTextFile } from "./file.js";
import { ArmError } from "../../../judge/sentences.js";

/**
 * Add the file button and accept dropped files.
 * @param {import("./page.js").AnswerCheck} judge
 * @param {HTMLElement} stub element that accepts drops
 */
export function addFileInput(judge, stub) {
  const { boxes } = judge.made;
  let held = "";
  const take = async (file) => {
    try {
      held = await readTextFile(file);
    } catch (error) {
      if (!(error instanceof ArmError)) throw error;
      judge.say(error.message);
      return;
    }
    judge.say("");
    setText(words, `From ${file.name}, ${held.trim().split("\n").length} lines. `);
    judge.put({ answer: held });
  };
  const { input, button } = makeFileButton(take);
  const close = () => judge.put({ answer: "" });
  const words = h("span");
  const closing = h("button", { onclick: close }, "Close it");
  const name = h("p.file", { hidden: true }, words, closing);
  acceptDrops(stub, take);
  boxes.answer.prepend(h("div.over", {}, boxes.answer.firstChild, input, button));
  boxes.answer.append(name);
  judge.follow(({ answer, ask }) => {
    name.hidden = !held || answer !== held;
    button.hidden = ask !== "trace";
  });
}

function makeFileButton(take) {
  const onchange = () => {
    const [file] = input.files;
    if (file) take(file);
    input.value = "";
  };
  const input = h("input", { type: "file", accept: ACCEPTED_TYPES, hidden: true, onchange });
  const button = h("button", { onclick: () => input.click() }, "Open a file");
  return { input, button };
}

function acceptDrops(stub, take) {
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
