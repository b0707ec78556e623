// Test that formulas of an answer are typeset with the brackets that their meaning needs.

import assert from "node:assert/strict";
import test from "node:test";

import { parse } from "../../judge/reading/formula.js";
import { typesetFormula } from "../../page/src/check/mathml.js";

// An element that prints its tag and content, with abbreviations for the most common tags.
class FakeElement {
  constructor(tag) {
    this.tag = tag;
    this.children = [];
  }
  append(...children) {
    this.children.push(...children);
  }
  setAttribute() {}
  toString() {
    const content = this.children.join(this.tag === "msub" ? "_" : "");
    if (this.tag === "mspace") return " ";
    if (this.tag === "msqrt") return `sqrt{${content}}`;
    const isPair = ["msup", "mfrac"].includes(this.tag);
    return isPair ? `${this.tag.slice(1)}{${this.children.join("|")}}` : content;
  }
}

const write = (text) => String(typesetFormula(parse(text)));

test.before(() => {
  globalThis.document = /** @type {any} */ ({
    createElementNS: (_, tag) => new FakeElement(tag),
  });
});
test.after(() => {
  delete globalThis.document;
});

for (const [typed, shown] of [
  ["-s_1*(a_2*c_2+a_3*c_23)", "−s_1 (a_2 c_2+a_3 c_23)"],
  ["a_2 - (a_3 - d_1)", "a_2−(a_3−d_1)"],
  ["a_2 - a_3 + d_1", "a_2−a_3+d_1"],
  ["a_2 + (-a_3)", "a_2+(−a_3)"],
  ["a_2*(-a_3)", "a_2 (−a_3)"],
  ["-(a_2 + a_3)", "−(a_2+a_3)"],
  ["(a_2 + a_3)^2", "sup{(a_2+a_3)|2}"],
  ["2*3*a_2", "2·3 a_2"],
  ["(theta_1 + pi)/2", "frac{θ_1+π|2}"],
  ["sqrt(a_2^2 + 1)", "sqrt{sup{a_2|2}+1}"],
  ["sin(q_1 + q_2)", "sin(q_1+q_2)"],
  ["0.3330*c1", "0.3330 c_1"],
  ["d_{pen}", "d_pen"],
  ["90 deg", "90 \u2009deg"],
])
  test(`${typed} is typeset as ${shown}`, () => assert.equal(write(typed), shown));
