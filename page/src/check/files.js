// Files as answers, chosen with a button or dropped. They are read in the page and sent nowhere.

import { h, setText } from "../dom.js";
import { ACCEPTED_TYPES, readTextFile } from "./file.js";
import { ArmError } from "../../../judge/sentences.js";

/**
 * Add the file button and accept dropped files.
 * @param {import("./page.js").AnswerCheck} check
 * @param {HTMLElement} stub element that accepts drops
 */
export function addFileInput(check, stub) {
  const { boxes } = check.form;
  let fileText = "";
  const readFile = async (file) => {
    try {
      fileText = await readTextFile(file);
    } catch (error) {
      if (!(error instanceof ArmError)) throw error;
      check.notify(error.message);
      return;
    }
    check.notify("");
    setText(description, `From ${file.name}, ${fileText.trim().split("\n").length} lines. `);
    check.editQuestion({ answer: fileText });
  };
  const { input, button } = makeFileButton(readFile);
  button.hidden = check.question.ask !== "trace";
  const close = () => check.editQuestion({ answer: "" });
  const description = h("span");
  const closing = h("button", { onclick: close }, "Close it");
  const name = h("p.file", { hidden: true }, description, closing);
  acceptDrops(stub, readFile);
  boxes.answer.querySelector(".over").append(input, button);
  boxes.answer.append(name);
  check.onVerdict(({ answer, ask }) => {
    name.hidden = !fileText || answer !== fileText;
    button.hidden = ask !== "trace";
  });
}

function makeFileButton(onFile) {
  const onchange = () => {
    const [file] = input.files;
    if (file) onFile(file);
    input.value = "";
  };
  const input = h("input", { type: "file", accept: ACCEPTED_TYPES, hidden: true, onchange });
  const button = h("button", { onclick: () => input.click() }, "Open a file");
  return { input, button };
}

function acceptDrops(stub, onFile) {
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
    onFile(file);
  });
}
