// Dropped files are read if they are text of a common encoding, and refused otherwise.

import assert from "node:assert/strict";
import test from "node:test";
import { readTextFile } from "../../page/src/check/files.js";

const file = (bytes, name = "q.csv") => new File([bytes], name);
test("text files of common encodings are read", async () => {
  const text = "t;q1\r\n0,0;−0,5\r\n";
  assert.equal(await readTextFile(file(text)), text);
  assert.equal(await readTextFile(file(`\ufeff${text}`)), text);
  const utf16 = Buffer.from(`\ufeff${text}`, "utf16le");
  assert.equal(await readTextFile(file(utf16)), text);
  assert.equal(await readTextFile(file(Buffer.from(utf16).swap16())), text);
  assert.equal(await readTextFile(file(Buffer.from([0xb0, 0x20, 0x31]))), "° 1");
});

for (const [name, given, words] of [
  ["a picture", file(Buffer.from([0x89, 0x50, 0, 0, 0x1a]), "a.png"), /a\.png is no text/],
  ["nothing", file(" \n"), /is empty/],
  ["too much", { name: "a.csv", size: 5_000_001, arrayBuffer: null }, /5000001 bytes; 5000000 are the most/],
]) {
  test(`${name} is refused with a message`, () => assert.rejects(readTextFile(given), { message: words }));
}
