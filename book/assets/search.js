// The search page: MiniSearch over the entries of tools/search.py, in the reader's browser, also
// from a file.

// Groups of words that find each other: readers' words and the book's.
const SYNONYMS = [
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
// Expansions of an abbreviation that is the whole query.
const EXPANSIONS = { ik: "inverse kinematics", fk: "forward kinematics" };
const STOP_WORDS = new Set("a an and are at by can do does for from get how i in is it my of on or out the there to was what when where which why with you your".split(" "));

// Return a word without its ending: "poses" finds "pose", and "singularities" finds "singular".
const stem = (word) => (word.length > 3 ? word.replace(/ies$/, "y").replace(/(?<=....)ity$/, "").replace(/(?<![su])s$/, "").replace(/(?<=ch|sh|x)e$/, "") : word);

// Split text into words. A name with underscores counts as a whole and in parts: compare_jacobian
// is found by jacobian too.
const split = (text) => (text.normalize("NFKC").toLowerCase().match(/[\p{L}\p{N}_]+/gu) ?? []).flatMap((word) => (word.includes("_") ? [word, ...word.split("_")].filter(Boolean) : word));

// Boost for numbers and names of arms, for titles that contain the whole query, and for symptoms if
// the query has several words.
const BOOST = 3;
const BOOSTED_TERM = /^(\d+|panda|ur10e?|stanford|elbow)$/;

// Pages that list what other pages explain rank lower.
const PAGE_WEIGHTS = { api: 0.3, where: 0.3, glossary: 0.8 };

const index = new MiniSearch({
  idField: "id",
  fields: ["title", "of", "text"],
  tokenize: split,
  processTerm: (word) => (STOP_WORDS.has(word) ? null : stem(word)),
});
// The title of a page's first section is the page's title, which counts once. The index is built in
// chunks so that the page stays responsive.
const indexing = index.addAllAsync(ENTRIES.map((entry, id) => ({ ...entry, of: entry.of === entry.title ? "" : entry.of, id })), { chunkSize: 25 });

const findSynonyms = (word) => [...new Set(SYNONYMS.filter((words) => words.includes(word)).flat())].filter((other) => other !== word);

function search(typed) {
  const text = EXPANSIONS[typed.trim().toLowerCase()] ?? typed;
  const words = split(text.trim()).filter((word) => !STOP_WORDS.has(word)).map(stem);
  const queries = words.map((word, k) => ({
    combineWith: "OR",
    queries: [
      { queries: [word], prefix: k === words.length - 1, fuzzy: word.length > 4 ? 0.2 : false, boostTerm: (term) => (BOOSTED_TERM.test(term) ? BOOST : 1) },
      ...findSynonyms(word).map((other) => ({ queries: [other], fuzzy: false, prefix: false, boostTerm: () => 1 / BOOST })),
    ],
  }));
  const options = { bm25: { k: 1.2, b: 0.3, d: 0.5 }, boost: { title: 6, of: 6 } };
  const all = index.search({ combineWith: "AND", queries }, options);
  const hits = all.length ? all : index.search({ combineWith: "OR", queries }, options);
  const joined = (text) => ` ${split(text).join(" ")} `;
  const phrase = joined(text);
  const weight = ({ title, page, symptom }) =>
    (joined(title).includes(phrase) ? BOOST : 1) * (symptom && words.length > 1 ? BOOST : (PAGE_WEIGHTS[page] ?? 1));
  return hits.map((hit) => ({ ...hit, score: hit.score * weight(ENTRIES[hit.id]) })).sort((one, other) => other.score - one.score);
}

// Make an excerpt around the first hits, with the hits marked.
function makeExcerpt({ text }, terms) {
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

function makeResult(hit) {
  const { page, anchor, title, of } = ENTRIES[hit.id];
  const link = Object.assign(document.createElement("a"), { href: `${page}.html#${anchor}`, textContent: title });
  const item = document.createElement("li");
  item.append(link, ...(title === of ? [] : [Object.assign(document.createElement("span"), { textContent: of })]));
  item.append(makeExcerpt(ENTRIES[hit.id], hit.terms));
  return item;
}

const MAX_RESULTS = 30;

if (globalThis.document) {
  const results = document.querySelector("#search-results"), summary = document.querySelector("#search-told");
  const fields = [...document.querySelectorAll("input[name=q]")];
  const showResults = async (text) => {
    await indexing;
    const hits = text.trim() ? search(text) : [];
    results.replaceChildren(...hits.slice(0, MAX_RESULTS).map(makeResult));
    const more = hits.length > MAX_RESULTS ? `, the first ${MAX_RESULTS} of ${hits.length}` : "";
    summary.textContent = !text.trim() ? "" : hits.length ? `${Math.min(hits.length, MAX_RESULTS)} places${more}` : "Nothing in the book has these words.";
  };
  for (const field of fields)
    field.addEventListener("input", () => {
      fields.filter((other) => other !== field).forEach((other) => (other.value = field.value));
      history.replaceState(null, "", `?q=${encodeURIComponent(field.value)}`);
      showResults(field.value);
    });
  const asked = new URLSearchParams(location.search).get("q") ?? "";
  fields.forEach((field) => (field.value = asked));
  showResults(asked);
}
