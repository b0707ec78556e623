// Formulas as the judge sets them while they are typed: MathML of what was understood.

import assert from "node:assert/strict";
import test from "node:test";
import { parse } from "../../judge/reading/formula.js";
import { isPlain, mathOf } from "../../page/src/check/mathml.js";

const markup = ([tag, content]) =>
  `<${tag}>${typeof content === "string" ? content : content.map(markup).join("")}</${tag}>`;
const set = (text) => markup(mathOf(parse(text)));
// What a reader sees in a line: fractions as a/b in braces, indices after _, powers after ^.
const flat = ([tag, content]) => {
  if (typeof content === "string") return { "\u2061": "", "\u2062": " " }[content] ?? content;
  const parts = content.map(flat);
  const joined = { mfrac: `{${parts.join("/")}}`, msub: parts.join("_"), msup: parts.join("^"), msqrt: `√{${parts.join("")}}` };
  return joined[tag] ?? parts.join("");
}; // prettier-ignore
const seen = (text) => flat(mathOf(parse(text)));

test("an entry of a table is set", () => {
  assert.equal(
    set("q2-pi/2"),
    "<math><mrow><msub><mi>q</mi><mn>2</mn></msub><mo>−</mo><mfrac><mi>π</mi><mn>2</mn></mfrac></mrow></math>",
  );
  assert.equal(set("θ₂ − 90°"), set("theta_2 - 90 deg"));
  assert.equal(set("sqrt(2)/2"), "<math><mfrac><msqrt><mn>2</mn></msqrt><mn>2</mn></mfrac></math>");
});

for (const [typed, wanted] of [
  ["theta_2 - 90 deg", "θ_2−90°"],
  ["-a_3", "−a_3"],
  ["d_6 + l_pen", "d_6+l_pen"],
  ["-(d_6 + l_pen)", "−(d_6+l_pen)"],
  ["a - (b - c)", "a−(b−c)"],
  ["a - b - c", "a−b−c"],
  ["a + -b*c", "a+(−b c)"],
  ["-b*c", "−b c"],
  ["a*(-b)", "a (−b)"],
  ["0.4*c_1*c_2", "0.4 c_1 c_2"],
  ["c_1*0.4", "c_1⋅0.4"],
  ["2*3", "2⋅3"],
  ["s_{2-3}", "s_2−3"],
  ["c_1s_23", "c_1 s_23"],
  ["sin(q1)*d3", "sinq_1⋅d_3"],
  ["d3*sin(q1)*cos(q2)", "d_3 sinq_1 cosq_2"],
  ["cos(theta_2 + theta_3)", "cos(θ_2+θ_3)"],
  ["sin(q_1)^2", "(sinq_1)^2"],
  ["(a+b)^2", "(a+b)^2"],
  ["q_1**2", "q_1^2"],
  ["2^-1", "2^−1"],
  ["-2^2", "−2^2"],
  ["a/(b*c)", "{a/b c}"],
  ["-pi/2", "−{π/2}"],
  ["q1 + -pi/2", "q_1+(−{π/2})"],
  ["a/b/c", "{{a/b}/c}"],
  ["\\frac{\\pi}{2}", "{π/2}"],
  ["\\cos\\theta_{1}", "cosθ_1"],
  ["np.deg2rad(-90)", "(−90)°"],
  ["radians(45)", "45°"],
  ["arcsin(0.5)", "arcsin0.5"],
  ["asin(x)", "arcsinx"],
  ["sind(30)", "sin30°"],
  ["abs(a - b)", "|a−b|"],
  ["float(2)", "2"],
  ["1e-7", "1⋅10^−7"],
  ["1e-7*a", "1⋅10^−7 a"],
  ["q_1'", "q′_1"],
  ["beta_{1}", "β_1"],
]) {
  test(`${typed} is set as ${wanted}`, () => {
    assert.equal(seen(typed), wanted);
  });
}

test("what is no formula is not set, and nothing but text comes of what is", () => {
  const hostile = ["<img src=x>", "a<b", "x&y", 'q"1', "<script>alert(1)</script>", "a_{<b>}", "\\text{<i>}"];
  for (const text of hostile) assert.throws(() => set(text), /expected/, text);
  assert.equal(set("\\text{script}"), "<math><mi>script</mi></math>");
});

test("a long sum is set without deep calls", () => {
  const long = Array.from({ length: 9000 }, () => "a").join("+");
  assert.equal(seen(long), long);
});

test("a number is plain, a fraction is not", () => {
  assert.deepEqual(["1", "-0.5", "1/2", "pi", "q1"].map((text) => isPlain(parse(text))), [true, true, false, false, false]); // prettier-ignore
});
