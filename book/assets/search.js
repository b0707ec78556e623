// The search page: MiniSearch over the entries of tools/search.py, in the reader's browser, from a file too.

// What a reader calls a thing, and what the book calls it; each counts as the other.
const ALIKE = [
  ["ik", "inverse"],
  ["fk", "forward"],
  ["dh", "denavit", "table"],
  ["solution", "way", "branch", "eight"],
  ["8", "eight"],
  ["com", "mass"],
  ["reach", "unreachable", "workspace"],
  ["singularity", "singular"],
  ["pinv", "pseudo"],
  ["robot", "arm"],
  ["error", "wrong", "mistake", "slip"],
  ["prismatic", "slide"],
  ["craig", "modified"],
];
// And where it is all that is asked.
const ALONE = { ik: "inverse kinematics", fk: "forward kinematics" };
const SMALL = new Set("a an and are at by can do does for from get how i in is it my of on or out the there to was what when where which why with you your".split(" "));

// A word without its ending: "poses" finds "pose", "singularities" what "singularity" does.
const stem = (word) => (word.length > 3 ? word.replace(/ies$/, "y").replace(/(?<![su])s$/, "").replace(/(?<=ch|sh|x)e$/, "") : word);

// Signs that are one word in the book's language stay together: compare_jacobian is found by jacobian, and by its whole name.
const split = (text) => (text.normalize("NFKC").toLowerCase().match(/[\p{L}\p{N}_]+/gu) ?? []).flatMap((word) => (word.includes("_") ? [word, ...word.split("_")].filter(Boolean) : word));

// So many times more counts a number or an arm's name among the words, a title that has the words as they were typed,
// and, where a reader asks in words, a row of the table of symptoms.
const MORE = 3;
const OWN = /^(\d+|panda|ur10e?|stanford|elbow)$/;

// Pages that list what others explain come after them.
const LISTS = { api: 0.3, where: 0.3, glossary: 0.8 };

const index = new MiniSearch({
  idField: "id",
  fields: ["title", "of", "text"],
  tokenize: split,
  processTerm: (word) => (SMALL.has(word) ? null : stem(word)),
});
// A page's first section has the page's title, which counts once. In pieces, so that nothing else on the page waits.
const built = index.addAllAsync(ENTRIES.map((entry, id) => ({ ...entry, of: entry.of === entry.title ? "" : entry.of, id })), { chunkSize: 25 });

const others = (word) => [...new Set(ALIKE.filter((words) => words.includes(word)).flat())].filter((other) => other !== word);

function find(typed) {
  const text = ALONE[typed.trim().toLowerCase()] ?? typed;
  const words = split(text.trim()).filter((word) => !SMALL.has(word)).map(stem);
  const queries = words.map((word, k) => ({
    combineWith: "OR",
    queries: [
      { queries: [word], prefix: k === words.length - 1, fuzzy: word.length > 4 ? 0.2 : false, boostTerm: (term) => (OWN.test(term) ? MORE : 1) },
      ...others(word).map((other) => ({ queries: [other], fuzzy: false, prefix: false, boostTerm: () => 1 / MORE })),
    ],
  }));
  const how = { bm25: { k: 1.2, b: 0.3, d: 0.5 }, boost: { title: 6, of: 6 } };
  const all = index.search({ combineWith: "AND", queries }, how);
  const hits = all.length ? all : index.search({ combineWith: "OR", queries }, how);
  const joined = (text) => ` ${split(text).join(" ")} `;
  const phrase = joined(text);
  const weight = ({ title, page, symptom }) =>
    (joined(title).includes(phrase) ? MORE : 1) * (symptom && words.length > 1 ? MORE : (LISTS[page] ?? 1));
  return hits.map((hit) => ({ ...hit, score: hit.score * weight(ENTRIES[hit.id]) })).sort((one, other) => other.score - one.score);
}

// The words around the first hits, the hits marked.
function excerpt({ text }, terms) {
  const hits = text.matchAll(/[\p{L}\p{N}_]+/gu);
  const places = [...hits].filter(([word]) => split(word).some((part) => terms.includes(stem(part))));
  const start = Math.max(0, (places[0]?.index ?? 0) - 60), from = start && text.indexOf(" ", start) + 1;
  const shown = document.createElement("p");
  let at = from;
  for (const { 0: word, index: place } of places.filter(({ index: place }) => place >= from && place < from + 200)) {
    shown.append(text.slice(at, place), Object.assign(document.createElement("mark"), { textContent: word }));
    at = place + word.length;
  }
  const end = text.indexOf(" ", Math.max(at, from + 220));
  shown.prepend(from ? "… " : "");
  shown.append(end < 0 ? text.slice(at) : `${text.slice(at, end)} …`);
  return shown;
}

function shown(hit) {
  const { page, anchor, title, of } = ENTRIES[hit.id];
  const link = Object.assign(document.createElement("a"), { href: `${page}.html#${anchor}`, textContent: title });
  const item = document.createElement("li");
  item.append(link, ...(title === of ? [] : [Object.assign(document.createElement("span"), { textContent: of })]));
  item.append(excerpt(ENTRIES[hit.id], hit.terms));
  return item;
}

const MOST = 30;

if (globalThis.document) {
  const results = document.querySelector("#search-results"), told = document.querySelector("#search-told");
  const fields = [...document.querySelectorAll("input[name=q]")];
  const answer = async (text) => {
    await built;
    const hits = text.trim() ? find(text) : [];
    results.replaceChildren(...hits.slice(0, MOST).map(shown));
    const more = hits.length > MOST ? `, the first ${MOST} of ${hits.length}` : "";
    told.textContent = !text.trim() ? "" : hits.length ? `${Math.min(hits.length, MOST)} places${more}` : "Nothing in the book has these words.";
  };
  for (const field of fields)
    field.addEventListener("input", () => {
      fields.filter((other) => other !== field).forEach((other) => (other.value = field.value));
      history.replaceState(null, "", `?q=${encodeURIComponent(field.value)}`);
      answer(field.value);
    });
  const asked = new URLSearchParams(location.search).get("q") ?? "";
  fields.forEach((field) => (field.value = asked));
  answer(asked);
}
