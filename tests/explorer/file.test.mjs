// Files that a reader drops: text of any encoding, NumPy's arrays (bytes written by NumPy 2), and what is refused in words.

import assert from "node:assert/strict";
import test from "node:test";
import { textOfFile } from "../../page/src/check/file.js";

const ROWS =
  "k05VTVBZAQB2AHsnZGVzY3InOiAnPGY4JywgJ2ZvcnRyYW5fb3JkZXInOiBGYWxzZSwgJ3NoYXBlJzogKDMsIDIpLCB9ICAgICAg" +
  "ICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgIAoAAAAAAADgPwAAAAAAAPS/AAAAAAAA" +
  "AEBIr7ya8td6PgAAAAAAAAhAAAAAAAAAEEA=";
const COLUMNS =
  "k05VTVBZAQB2AHsnZGVzY3InOiAnPmY0JywgJ2ZvcnRyYW5fb3JkZXInOiBUcnVlLCAnc2hhcGUnOiAoMiwgMyksIH0gICAgICAg" +
  "ICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgIAo/wAAAQIAAAEAAAABAoAAAQEAAAEDA" +
  "AAA=";
const ONE =
  "k05VTVBZAQB2AHsnZGVzY3InOiAnPGk4JywgJ2ZvcnRyYW5fb3JkZXInOiBGYWxzZSwgJ3NoYXBlJzogKDMsKSwgfSAgICAgICAg" +
  "ICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgICAgIAoAAAAAAAAAAAEAAAAAAAAAAgAAAAAA" +
  "AAA=";

const file = (bytes, name = "q.csv") => new File([bytes], name);
const npy = (text, change = (head) => head) => {
  const head = change(Buffer.from(text, "base64").toString("latin1"));
  return file(Buffer.from(head, "latin1"), "q.npy");
};

test("text is read in each encoding that programs write", async () => {
  const text = "t;q1\r\n0,0;−0,5\r\n";
  assert.equal(await textOfFile(file(text)), text);
  assert.equal(await textOfFile(file(`\ufeff${text}`)), text);
  const utf16 = Buffer.from(`\ufeff${text}`, "utf16le");
  assert.equal(await textOfFile(file(utf16)), text);
  assert.equal(await textOfFile(file(Buffer.from(utf16).swap16())), text);
  assert.equal(await textOfFile(file(Buffer.from([0xb0, 0x20, 0x31]))), "° 1");
});

test("NumPy's arrays are read by rows, whatever their type and order", async () => {
  assert.equal(await textOfFile(npy(ROWS)), "0.5,-1.25\n2,1e-7\n3,4");
  assert.equal(await textOfFile(npy(COLUMNS)), "1.5,2,3\n4,5,6");
  assert.equal(await textOfFile(npy(ONE)), "0,1,2");
});

for (const [name, given, words] of [
  ["a picture", file(Buffer.from([0x89, 0x50, 0, 0, 0x1a]), "a.png"), /a\.png is neither text nor/],
  ["an array cut short", npy(ROWS.slice(0, -32)), /neither text nor an array/],
  ["an array of words", npy(ROWS, (head) => head.replace("<f8", "<U1")), /neither text nor an array/],
  ["a cube", npy(ROWS, (head) => head.replace("(3, 2)", "(1,1,6)")), /neither text nor an array/],
  ["nothing", file(" \n"), /is empty/],
  ["too much", { name: "a.csv", size: 5_000_001, arrayBuffer: null }, /5000001 bytes; 5000000 are the most/],
]) {
  test(`${name} is refused in words`, () => assert.rejects(textOfFile(given), { message: words }));
}
