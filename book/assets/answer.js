// The fields below exercises: read the numbers that a reader types and compare them with the answer.
// tools/plain_markdown.py writes the fields; tests/test_answer_fields.py runs judgeAnswer in QuickJS.

const NUMBER = /([-+]?)\s*(?:((?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*(\*?\s*(?:pi|π))?|(pi|π))(?:\s*\/\s*(\d+\.?\d*))?/gi;

/** Return the numbers of a text, and what of it is no number. Signs and pi are read: -pi/2, 0.5*pi. */
function readNumbers(text, unit) {
  let unread = text.replaceAll("−", "-");
  if (unit) unread = unread.replaceAll(new RegExp(`(?<=\\d\\s*)${unit}(?![a-z])`, "g"), " ");
  const numbers = [];
  unread = unread.replace(NUMBER, (_, sign, digits, timesPi, pi, divisor) => {
    numbers.push((sign === "-" ? -1 : 1) * Number(digits ?? 1) * (timesPi || pi ? Math.PI : 1) / Number(divisor ?? 1));
    return " ";
  });
  return { numbers, unread: unread.replace(/[\s,;()[\]{}]+/g, " ").trim() };
}

/**
 * Compare a typed text with the right answer.
 *
 * @param {string} text
 * @param {{answer: string, within: string, unit?: string}} question answer: numbers, alternatives
 *   separated by "|"; within: the largest difference that counts as right
 * @returns {{right: boolean, message: string}}
 */
function judgeAnswer(text, { answer, within, unit = "" }) {
  const rights = answer.split("|").map((part) => part.trim().split(/[\s,]+/).map(Number));
  const { numbers, unread } = readNumbers(text, unit);
  const wanted = rights[0].length === 1 ? "1 number" : `${rights[0].length} numbers`;
  if (unread) return { right: false, message: `I read numbers only, not "${unread}". Expected: ${wanted}${unit && ` in ${unit}`}.` };
  if (numbers.length !== rights[0].length)
    return { right: false, message: `Expected: ${wanted}; you typed ${numbers.length}. A decimal is written with a point.` };
  const wrongEntries = rights.map((right) => right.flatMap((value, k) => (Math.abs(numbers[k] - value) <= Number(within) ? [] : [k + 1])));
  const fewest = wrongEntries.reduce((best, entries) => (entries.length < best.length ? entries : best));
  if (!fewest.length) return { right: true, message: "✔ Right." };
  const which = numbers.length === 1 ? "Not right" : `Not right: number ${fewest.join(", ")}`;
  const slack = Number(within) ? ` Within ${within}${unit && ` ${unit}`} counts as right.` : "";
  return { right: false, message: `✘ ${which}.${slack}` };
}

globalThis.document?.addEventListener("DOMContentLoaded", () => {
  for (const form of document.querySelectorAll("form.answer")) {
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      const { right, message } = judgeAnswer(form.querySelector("input").value, form.dataset);
      form.querySelector("output").textContent = message;
      form.classList.toggle("right", right);
    });
  }
});
