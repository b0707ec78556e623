// The search: MiniSearch over the entries of tools/search.py, in the reader's browser, also from a
// file. book.js loads this script when a reader first uses a search field.

const BOOK = globalThis.document && new URL("..", document.currentScript.src).href;

// Groups of words that find each other. What readers call a whole section is in search_names.yml.
const SYNONYMS = [
  ["ik", "inverse"],
  ["dh", "denavit", "table"],
  ["solution", "branch"],
  ["8", "eight"],
  ["com", "mass"],
  ["center", "centre"],
  ["singularity", "singular", "det"],
  ["pinv", "pseudo"],
  ["robot", "arm"],
  ["error", "wrong", "mistake", "slip", "correct"],
  ["prismatic", "slide"],
  ["franka", "panda"],
  ["effector", "tip"],
  ["delete", "remove", "lose"],
  ["arctan", "atan", "atan2"],
  ["acos", "arccos", "cosine"],
  ["speed", "velocity", "rate"],
  ["limit", "bound", "range"],
];
const STOP_WORDS = new Set(
  `a an and are as at be between by calculate can compute could do does find for from get give has have help homework how i if in
   is it its many me mean meaning means much my need no not of on or out please question should so the there this to use using versus vs want was way what
   when where which who why will with without you your`.split(/\s+/),
);
const GREEK = { α: "alpha", β: "beta", γ: "gamma", δ: "delta", θ: "theta", ϑ: "theta", λ: "lambda", ξ: "xi", π: "pi", σ: "sigma", τ: "tau", φ: "phi", ϕ: "phi", ψ: "psi", ω: "omega", "∂": "d" };

// Robots that the book does not have; their names lead to the page about an arm of one's own.
const OTHER_ROBOTS = /^(ur(3|5|7|8|12|15|16|18|20|30)e?|kuka|iiwa|lbr|kr\d+|puma|abb|irb\d*|fanuc|xarm\d?|kinova|gen3|jaco|sawyer|baxter|yaskawa|motoman|staubli|stäubli|dobot|denso|widowx|viperx|scorbot|doosan|techman|niryo)$/;
const OWN_ARM_PAGE = "own_arm";

const IRREGULAR_STEMS = { axes: "axis", matrices: "matrix", radii: "radius", indices: "index" };
const ENDINGS = /(?<=^.{3,})(?:ations?|ances?|ences?|ating|ated|ates?|ings?|ies|ity|ed|es|e|y|s)$/;

// Return a word without its ending: "closing" finds "close", and "singularities" finds "singular".
function stem(word) {
  if (word.length < 4 || /\d|_/.test(word) || /(ss|is|us)$/.test(word)) return word;
  if (word in IRREGULAR_STEMS) return IRREGULAR_STEMS[word];
  const bare = word.replace(/(?<=.{3})it(y|ies)$/, "").replace(ENDINGS, "");
  return /[aeiouy]/.test(bare) ? bare.replace(/([bdgmnprt])\1$/, "$1") : word;
}

// Split text into words. Symbols are joined with their index, as z0; a name with underscores counts
// as a whole and in parts, so that compare_jacobian is found by jacobian too.
function split(text) {
  const plain = text.normalize("NFKC").toLowerCase()
    .replace(/[α-ωϑϕ∂]/g, (letter) => GREEK[letter] ?? letter)
    .replace(/(\d)\s*[×x*]\s*(?=\d)/g, "$1x")
    .replace(/(?<![\p{L}\d])(?:(\d)_?t_?(\d)|t_?(\d)[\^_]?(\d))(?!\d)/gu, "t$1$2$3$4"); // 0T_7, T_0^7, T07
  return (plain.match(/\d+\.\d+|[\p{L}\p{N}_]+/gu) ?? []).flatMap(splitName);
}

function splitName(word) {
  if (!word.includes("_")) return word;
  const joined = word.replaceAll("_", "");
  return /^\p{L}+_\w{1,2}$/u.test(word) ? joined : [word, ...word.split("_")].filter(Boolean);
}

const LIST_WEIGHT = 0.1; // lists name what sections explain
const LESSER_WEIGHT = 0.5; // so does a page's introduction; an exercise or a slip applies it
const TEXT_WEIGHT = 0.02; // for an entry whose names have no word of the query
const SYNONYM_WEIGHT = 1 / 3;
const NAMED_BOOST = 1000; // for the chapter or the term that the query names
const GLOSSARY = "glossary";
const BOX = /^(Exercise|Slip) /;

const index = new MiniSearch({
  idField: "id",
  fields: ["title", "also", "of", "about", "text"],
  tokenize: split,
  processTerm: (word) => (STOP_WORDS.has(word) ? null : stem(word)),
  searchOptions: { tokenize: (word) => [word], processTerm: (word) => word }, // a query has stems already
});
// A word of the page's title counts once: it makes no difference among the page's sections. The index
// is built in chunks so that the page stays responsive.
const indexing = index.addAllAsync(ENTRIES.map((entry, id) => ({ ...entry, title: omitWords(entry.title, entry.of), id })), { chunkSize: 25 });

function omitWords(text, others) {
  const omitted = new Set(split(others).map(stem));
  return split(text).filter((word) => !omitted.has(stem(word))).join(" ");
}

function findSynonyms(word) {
  const groups = SYNONYMS.map((group) => group.map(stem)).filter((group) => group.includes(word));
  return [...new Set(groups.flat())].filter((other) => other !== word);
}

// Return the stems of what was typed. A query of stop words alone keeps them, and a name with
// underscores stands for itself alone.
function readQuery(typed) {
  const all = split(typed);
  const names = all.filter((word) => word.includes("_"));
  const words = names.length ? names : all;
  const asked = words.filter((word) => !STOP_WORDS.has(word));
  return [...new Set(asked.length ? asked : words)].map(stem);
}

// Find the entries that have the words, best first.
function findEntries(typed) {
  const words = readQuery(typed);
  const synonyms = new Map(words.map((word) => [word, findSynonyms(word)]));
  const queries = words.map((word, k) => ({
    combineWith: "OR",
    queries: [
      { queries: [word], prefix: k === words.length - 1 && word.length > 1, fuzzy: word.length > 4 ? 0.2 : false },
      ...synonyms.get(word).map((other) => ({ queries: [other], fuzzy: false, prefix: false, boostTerm: () => SYNONYM_WEIGHT })),
    ],
  }));
  const hits = index.search({ combineWith: "OR", queries });
  const isNamed = findNamed(joinStems(words));
  const isCovered = (word, found) => [word, ...synonyms.get(word)].some((other) => found.includes(other));
  const rate = ({ id, score, queryTerms, terms }) => {
    const entry = ENTRIES[id], { title, of, kind } = entry;
    if (kind === "list" && words.some((word) => word.includes("_"))) return score; // a function by its name
    if (isNamed(entry)) return NAMED_BOOST * score;
    const covered = sumRarities(words.filter((word) => isCovered(word, queryTerms))) / sumRarities(words);
    const likeness = Math.max(...listNames(entry).map((name) => compareName(name, words, terms)));
    const weight = ["list", "sheet"].includes(kind) ? LIST_WEIGHT : title === of || BOX.test(title) ? LESSER_WEIGHT : 1;
    return score * covered ** 2 * (TEXT_WEIGHT + likeness) * weight;
  };
  return hits
    .map((hit) => ({ ...ENTRIES[hit.id], terms: hit.terms, score: rate(hit) }))
    .sort((one, other) => other.score - one.score);
}

// Return how much of the query is in a name and of the name in the query, 1 if they are the same.
// `terms` are the words of the entry that the query found, synonyms and misspelt ones too.
function compareName(name, words, terms) {
  const shared = sumRarities(name.filter((word) => terms.includes(word)));
  return shared && Math.sqrt(Math.min(1, shared / sumRarities(words)) * (shared / sumRarities(name)));
}

// A rare word of the book tells more than a common one.
const rarities = new Map();
function getRarity(word) {
  if (!rarities.has(word)) rarities.set(word, Math.log(1 + ENTRIES.length / (1 + index.search(word).length)));
  return rarities.get(word);
}
const sumRarities = (words) => words.reduce((sum, word) => sum + getRarity(word), 0);

const joinStems = (stems) => ` ${stems.join(" ")} `;
const stemsOf = (text) => split(text).filter((word) => !STOP_WORDS.has(word)).map(stem);
const listNames = ({ title, also }) => [title, ...(also?.split(", ") ?? [])].map(stemsOf);

// Return a test for entries that the words name: chapters whose titles begin with them, else terms.
function findNamed(phrase) {
  const isChapter = ({ title, of, kind }) => kind === "chapter" && title === of && joinStems(stemsOf(title)).startsWith(phrase);
  const isTerm = (entry) => entry.page === GLOSSARY && listNames(entry).some((name) => joinStems(name) === phrase);
  return ENTRIES.some(isChapter) ? isChapter : isTerm;
}

// Find the pages that have the words, best first, each with its entries. All answer sheets are one
// page with a link to each. The name of a robot that the book does not have puts the page about an
// arm of one's own first.
function searchBook(typed) {
  const groups = new Map();
  for (const entry of findEntries(typed)) {
    const key = entry.kind === "sheet" ? "sheets" : entry.page;
    if (!groups.has(key)) groups.set(key, { key, kind: entry.kind, title: entry.kind === "sheet" ? "Answer sheets" : entry.of, page: entry.page, entries: [] });
    groups.get(key).entries.push(entry);
  }
  const found = [...groups.values()];
  const robot = split(typed).find((word) => OTHER_ROBOTS.test(word));
  return robot ? [makeOwnArmGroup(robot), ...found.filter(({ key }) => key !== OWN_ARM_PAGE)] : found;
}

function makeOwnArmGroup(robot) {
  const entry = ENTRIES.find(({ page }) => page === OWN_ARM_PAGE);
  const text = `The book has no ${robot.toUpperCase()}. With its DH table or its URDF you get everything that the chapters do.`;
  return { key: OWN_ARM_PAGE, kind: entry.kind, title: entry.of, page: OWN_ARM_PAGE, entries: [{ ...entry, text, terms: [] }] };
}

const MAX_PAGES = 12;
const MAX_SECTIONS = 3; // shown of a page
const WAYS_ON = { "check_your_homework.html#symptoms": "what you see, by symptom", "where.html": "the homework line by line", "genindex.html": "the index" };

const make = (name, attributes = {}, ...children) => {
  const element = Object.assign(document.createElement(name), attributes);
  element.append(...children);
  return element;
};
const makeLink = ({ page, anchor }, text) => make("a", { href: `${BOOK}${page}.html${anchor ? `#${anchor}` : ""}` }, text);

// Make an excerpt around the first hits, with the hits marked.
function makeExcerpt({ text, terms }) {
  const hits = [...text.matchAll(/[\p{L}\p{N}_]+/gu)].filter(([word]) => split(word).some((part) => terms.includes(stem(part))));
  const start = Math.max(0, (hits[0]?.index ?? 0) - 60), from = start && text.indexOf(" ", start) + 1;
  const excerpt = make("p");
  let at = from;
  for (const { 0: word, index: place } of hits.filter(({ index: place }) => place >= from && place < from + 160)) {
    excerpt.append(text.slice(at, place), make("mark", {}, word));
    at = place + word.length;
  }
  const end = text.indexOf(" ", Math.max(at, from + 180));
  excerpt.prepend(from ? "… " : "");
  excerpt.append(end < 0 ? text.slice(at) : `${text.slice(at, end)} …`);
  return excerpt;
}

// Make the results of one page: its title, and its best sections with excerpts.
function makePageResult({ kind, title, page, entries }) {
  if (kind === "sheet") return makeSheetsResult(entries);
  const sections = entries.slice(0, MAX_SECTIONS).map((entry) =>
    make("li", {}, ...(entry.title === title ? [] : [makeLink(entry, entry.title)]), makeExcerpt(entry)));
  return make("li", {}, makeLink({ page }, title), make("ul", {}, ...sections));
}

// Make one result of all answer sheets: a link to the best place of each.
function makeSheetsResult(entries) {
  const best = new Map();
  for (const entry of entries) if (!best.has(entry.page)) best.set(entry.page, entry);
  const links = [...best.values()].map((entry) => makeLink(entry, entry.of));
  return make("li", { className: "sheets" }, "Answer sheets: ", ...links.flatMap((link, k) => (k ? [" · ", link] : [link])));
}

function describeResults(typed, found) {
  if (!typed.trim()) return [];
  if (found.length) {
    const places = found.reduce((sum, { entries }) => sum + entries.length, 0);
    return [`${places === 1 ? "1 place" : `${places} places`} on ${found.length === 1 ? "1 page" : `${found.length} pages`}`];
  }
  const ways = Object.entries(WAYS_ON).map(([href, text]) => make("a", { href: BOOK + href }, text));
  return ["Nothing in the book has these words. Three ways on: ", ways[0], ", ", ways[1], ", or ", ways[2], "."];
}

// Show results as the reader types. Arrow keys lead from the field through the links and back.
function attachResults(form) {
  const field = form.querySelector("input");
  const summary = document.querySelector("#search-summary") ?? make("p", { role: "status" });
  const list = document.querySelector("#search-results") ?? make("ol");
  const isPage = list.isConnected;
  const box = isPage ? list : make("div", { className: "results", hidden: true }, summary, list);
  if (!isPage) form.append(box);
  const show = async () => {
    await indexing;
    const typed = field.value, found = typed.trim() ? searchBook(typed) : [];
    list.replaceChildren(...found.slice(0, MAX_PAGES).map(makePageResult));
    summary.replaceChildren(...describeResults(typed, found));
    if (isPage) history.replaceState(null, "", `?q=${encodeURIComponent(typed)}`);
    else box.hidden = !typed.trim() || !form.contains(document.activeElement);
  };
  field.addEventListener("input", show);
  field.addEventListener("focus", show);
  (isPage ? document : form).addEventListener("keydown", (event) => {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    const links = [...list.querySelectorAll("a")], at = links.indexOf(document.activeElement);
    if (event.key === "Escape" && !isPage) {
      box.hidden = true;
      field.focus();
      box.hidden = true;
    }
    if (!step || !links.length || (at < 0 && document.activeElement !== field)) return;
    event.preventDefault();
    (links[Math.min(at + step, links.length - 1)] ?? field).focus();
  });
  if (!isPage) form.addEventListener("focusout", ({ relatedTarget }) => form.contains(relatedTarget) || (box.hidden = true));
  if (!isPage) list.addEventListener("click", ({ target }) => target.closest("a") && (box.hidden = true));
  show();
}

if (globalThis.document) document.querySelectorAll("form[role='search']").forEach(attachResults);
