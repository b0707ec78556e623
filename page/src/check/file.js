// A file of numbers that a reader drops on the page, as the text that a paste would be.

import { ArmError } from "../../../judge/sentences.js";

const LARGEST = 5_000_000; // bytes

// What a button for files offers.
export const ACCEPTED = ".csv,.tsv,.txt,.dat,.md,text/plain,text/csv";

/**
 * The text of a file, of whatever encoding; an error in words where it is none.
 * @param {{ name: string, size: number, arrayBuffer: () => Promise<ArrayBuffer> }} file
 */
export async function textOfFile(file) {
  const refused = (why) => new ArmError(`The file ${file.name} ${why}.`);
  if (file.size > LARGEST) throw refused(`has ${file.size} bytes; ${LARGEST} are the most`);
  const bytes = await file.arrayBuffer();
  const text = decoded(bytes);
  if (text === null) throw refused("is no text; save it as CSV, by np.savetxt or writematrix");
  if (!text.trim()) throw refused("is empty");
  return text;
}

// UTF-16 where its mark stands first, else UTF-8, else Latin letters; null where no text has such
// bytes.
/** @param {ArrayBuffer} bytes */
function decoded(bytes) {
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
