// Files as answers, chosen with a button or dropped. They are read in the page and sent nowhere.

import { h, setText } from "../dom.js";
import { ArmError } from "../../../judge/sentences.js";

const MAX_BYTES = 5_000_000;

// File types offered by the file button.
const ACCEPTED_TYPES = ".csv,.tsv,.txt,.dat,.md,text/plain,text/csv";

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

/**
 * Read the text of a file in any common encoding. Throws ArmError if it is not text.
 * @param {{ name: string, size: number, arrayBuffer: () => Promise<ArrayBuffer> }} file
 */
export async function readTextFile(file) {
  const refused = (why) => new ArmError(`The file ${file.name} ${why}.`);
  if (file.size > MAX_BYTES) throw refused(`has ${file.size} bytes; ${MAX_BYTES} are the most`);
  const bytes = await file.arrayBuffer();
  const text = decodeText(bytes);
  if (text === null) throw refused("is no text; save it as CSV, by np.savetxt or writematrix");
  if (!text.trim()) throw refused("is empty");
  return text;
}

// Decode UTF-16 if a byte order mark says so, else UTF-8, else Windows-1252. Returns null for bytes
// that no text contains.
/** @param {ArrayBuffer} bytes */
function decodeText(bytes) {
  const [first, second] = new Uint8Array(bytes, 0, Math.min(2, bytes.byteLength));
  const marked = { 0xfeff: "utf-16be", 0xfffe: "utf-16le" }[(first << 8) | second];
  const read = (encoding) => {
    try {
      return new TextDecoder(encoding, { fatal: true }).decode(bytes);
    } catch {
      return null;
    }
  };
  const text = read(marked ?? "utf-8") ?? read("windows-1252");
  return text?.includes("\0") ? null : text;
}
