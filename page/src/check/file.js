// Read a dropped file of numbers as text, as if it were pasted.

import { ArmError } from "../../../judge/sentences.js";

const MAX_BYTES = 5_000_000;

// File types offered by the file button.
export const ACCEPTED_TYPES = ".csv,.tsv,.txt,.dat,.md,text/plain,text/csv";

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
