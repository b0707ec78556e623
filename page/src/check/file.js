// A file of numbers that a reader drops on the page, as the text that a paste would be.

import { ArmError } from "../../../judge/sentences.js";

const LARGEST = 5_000_000; // bytes
const NPY = "\x93NUMPY";

// What a button for files offers.
export const ACCEPTED = ".csv,.tsv,.txt,.dat,.md,.npy,text/plain,text/csv";

/**
 * The text of a file, or its numbers row by row where NumPy saved them; an error in words where it
 * is neither.
 * @param {{ name: string, size: number, arrayBuffer: () => Promise<ArrayBuffer> }} file
 */
export async function textOfFile(file) {
  const refused = (why) => new ArmError(`The file ${file.name} ${why}.`);
  if (file.size > LARGEST) throw refused(`has ${file.size} bytes; ${LARGEST} are the most`);
  const bytes = await file.arrayBuffer();
  const text = ofNumpy(bytes) ?? decoded(bytes);
  if (text === null) {
    throw refused(
      "is neither text nor an array of NumPy; save it as CSV, by np.savetxt or writematrix",
    );
  }
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

/** @type {Record<string, [number, (view: DataView, at: number, little: boolean) => number]>} */
const TYPES = {
  f8: [8, (view, at, little) => view.getFloat64(at, little)],
  f4: [4, (view, at, little) => view.getFloat32(at, little)],
  i8: [8, (view, at, little) => Number(view.getBigInt64(at, little))],
  i4: [4, (view, at, little) => view.getInt32(at, little)],
};

// The rows of an array that np.save wrote, or null for another file.
/** @param {ArrayBuffer} bytes */
function ofNumpy(bytes) {
  const view = new DataView(bytes);
  const word = (from, to) => String.fromCharCode(...new Uint8Array(bytes, from, to - from));
  if (bytes.byteLength < 16 || word(0, NPY.length) !== NPY) return null;
  const [start, length] =
    view.getUint8(6) === 1 ? [10, view.getUint16(8, true)] : [12, view.getUint32(8, true)];
  const data = start + length;
  if (data > bytes.byteLength) return null;
  const head = word(start, data);
  const [, order, type] = /'descr':\s*'([<>|=])(\w+)'/.exec(head) ?? [];
  const shape = [...(/'shape':\s*\(([^)]*)\)/.exec(head)?.[1] ?? "").matchAll(/\d+/g)].map(Number);
  if (!TYPES[type] || ![1, 2].includes(shape.length)) return null;
  const [size, get] = TYPES[type];
  if (data + shape.reduce((product, n) => product * n, size) > bytes.byteLength) return null;
  const [rows, width] = shape.length === 1 ? [1, shape[0]] : shape;
  const byColumns = head.includes("'fortran_order': True");
  const entry = (i, k) =>
    get(view, data + size * (byColumns ? k * rows + i : i * width + k), order !== ">");
  const line = (_, i) => Array.from({ length: width }, (__, k) => entry(i, k)).join(",");
  return Array.from({ length: rows }, line).join("\n");
}
