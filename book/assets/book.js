const folder = document.currentScript.src; // where the scripts are

// Content wider than its column scrolls in a box of its own, also by keyboard, and shows that it
// does.
const WIDE = ".display, .matrix, div.table, pre";
const MIN_SHRINK = 0.75; // a formula shrinks to this share of its size before it scrolls

const findWideBoxes = () => [...document.querySelectorAll(WIDE)];

// Boxes are measured when they come near the window, so that far ones need not be laid out.
const boxObserver = new IntersectionObserver((changes) => {
  updateBoxes(changes.filter(({ isIntersecting }) => isIntersecting).map(({ target }) => target));
}, { rootMargin: "150% 0px" });

// All boxes are measured before any is changed, so that the page is laid out once.
function updateBoxes(boxes) {
  boxes.forEach((box) => box.style.removeProperty("--shrunk"));
  const shares = boxes.map(measureVisibleShare);
  boxes.forEach((box, k) => {
    const tight = box.matches(".display, .matrix") && shares[k] < 1 && shares[k] > MIN_SHRINK;
    if (tight) box.style.setProperty("--shrunk", 0.985 * shares[k]);
    setScrollable(box, shares[k] < 1 && !tight);
  });
}

// Return the share of a box's content that is visible at once.
function measureVisibleShare(box) {
  return box.scrollWidth > box.clientWidth + 1 ? box.clientWidth / box.scrollWidth : 1;
}

// Mark the checks that hold in an output: each has a line of its own whose continuation is
// indented. A unit stays with its number, an exponent with its minus.
function markChecks(output) {
  for (const text of output.querySelectorAll("pre")) {
    const lines = text.textContent.trimEnd().split("\n");
    text.replaceChildren(...lines.map((line) => {
      const holds = line.startsWith("✔"), span = document.createElement("span");
      if (holds) span.className = "holds";
      const parts = `${holds ? line.replaceAll("N m", "N\u00a0m") : line}\n`.split(/(\d[\d.]*e-\d+)/);
      span.append(...parts.map((part, k) => (k % 2 ? Object.assign(document.createElement("span"), { className: "number", textContent: part }) : part)));
      return span;
    }));
  }
}

function setScrollable(box, wide) {
  if (!wide && !box.matches(".scrolls")) return;
  box.classList.toggle("scrolls", wide);
  if (!wide) {
    box.classList.remove("more-left", "more-right");
    return void box.removeAttribute("tabindex");
  }
  box.tabIndex = 0;
  box.setAttribute("role", "region");
  box.setAttribute("aria-label", "Wide content, scroll sideways");
  addHint(box);
  updateEdges(box);
  if (!box.dataset.told) box.addEventListener("scroll", () => updateEdges(box), { passive: true });
  box.dataset.told = true;
}

function addHint(box) {
  if (box.matches("pre, .matrix") || box.nextElementSibling?.matches(".hint")) return; // the fading edge is hint enough
  const words = Object.assign(document.createElement("span"), { className: "hint", textContent: "scroll sideways →" });
  words.ariaHidden = true;
  box.after(words);
}

function updateEdges(box) {
  const left = box.scrollWidth - box.clientWidth - box.scrollLeft;
  box.classList.toggle("more-right", left > 1);
  box.classList.toggle("more-left", box.scrollLeft > 1);
}

// Measure the boxes near the window, and the others when they come near.
function observeBoxes() {
  boxObserver.disconnect();
  findWideBoxes().forEach((box) => boxObserver.observe(box));
}

// Paper shows every box.
window.addEventListener("beforeprint", () => updateBoxes(findWideBoxes()));
window.addEventListener("load", observeBoxes);
document.fonts.addEventListener("loadingdone", observeBoxes);
let resizeTimer;
window.addEventListener("resize", () => {
  clearTimeout(resizeTimer);
  resizeTimer = setTimeout(observeBoxes, 100);
});

document.addEventListener("DOMContentLoaded", () => {
  const each = (selector, change) => document.querySelectorAll(selector).forEach(change);
  const { dataset } = document.documentElement;

  each(".colours", (button) => {
    const modes = ["auto", "light", "dark"], names = ["as the system", "light", "dark"];
    const name = () => (button.title = button.ariaLabel = `Colours: ${names[modes.indexOf(dataset.mode)]}`);
    button.onclick = () => {
      chooseColours(modes[(modes.indexOf(dataset.mode) + 1) % 3]);
      name();
    };
    name();
  });

  // Sphinx gives lists of references roles that do not fit their children.
  each("div.citation-list, dl.citation, [role='doc-biblioentry']", (list) => list.removeAttribute("role"));
  each("div.citation-list [role], .citation [role='doc-backlink']", (item) => item.removeAttribute("role"));

  each("div.cell_output", (output) => {
    const texts = [...output.querySelectorAll("pre")].map((pre) => pre.textContent.trim());
    const lines = texts.join("\n").split("\n");
    const otherLines = lines.filter((line) => !line.startsWith("✔"));
    if (!otherLines.length) output.classList.add("proof");
    else if (/\S {2,}\S.*\n.*\S {2,}\S/.test(otherLines.join("\n"))) output.classList.add("columns");
    if (otherLines.length < lines.length) markChecks(output);
  });

  each("div.highlight-python", (code) => {
    if (!navigator.clipboard || code.querySelector(".copy")) return;
    const button = Object.assign(document.createElement("button"), { className: "copy", textContent: "Copy" });
    button.onclick = async () => {
      await navigator.clipboard.writeText(code.querySelector("pre").textContent);
      button.textContent = "Copied";
      setTimeout(() => (button.textContent = "Copy"), 1500);
    };
    code.append(button);
  });

  each(".contents", (list) => list.addEventListener("click", ({ target }) => {
    if (target.closest("a") && list.matches(":popover-open")) list.hidePopover();
  }));

  each(".ahead details", (contents) => contents.addEventListener("click", ({ target }) => target.closest("a") && (contents.open = false)));
  watchSections();
});

// Mark the current section in the list of the page's sections, keep it in view there, and mark the
// sections that were read.
function watchSections() {
  const list = document.querySelector("#contents");
  const links = new Map([...list.querySelectorAll(".sections a")].map((link) => [decodeURIComponent(link.hash.slice(1)), link]));
  const marks = new ReadMarks(list, [...links.keys()].filter((id) => links.get(id).checkVisibility()));
  const since = new Map(); // when the reader came to each current section
  const observer = new IntersectionObserver((changes) => {
    for (const { isIntersecting, target: { id } } of changes) {
      const link = links.get(id);
      link.classList.toggle("here", isIntersecting);
      if (isIntersecting) {
        since.set(id, performance.now());
        keepInView(list, link);
      } else if (performance.now() - (since.get(id) ?? Infinity) > READING_TIME) marks.add(id);
    }
  }, { rootMargin: "-20% 0px -70%" });
  for (const section of document.querySelectorAll("article section[id]"))
    if (links.has(section.id)) observer.observe(section);
}

const READING_TIME = 5000; // ms in a section after which it counts as read

// Scroll a list so that a link of it is visible, unless the pointer is on it.
function keepInView(list, link) {
  const { offsetTop: top, offsetHeight: height } = link;
  if (list.matches(":hover") || (top > list.scrollTop && top + height < list.scrollTop + list.clientHeight)) return;
  list.scrollTop = top - list.clientHeight / 3;
}

// The sections that a reader has read, kept in the browser: by page the ids of its sections, or true
// for the whole page.
class ReadMarks {
  constructor(list, sections) {
    Object.assign(this, { list, sections, page: document.documentElement.dataset.page });
    this.show();
  }

  load() {
    try {
      return JSON.parse(localStorage.read ?? "{}");
    } catch {
      return {};
    }
  }

  add(id) {
    const read = this.load();
    const ids = new Set([read[this.page]].flat()).add(id);
    if (read[this.page] === true || !this.sections.includes(id)) return;
    read[this.page] = this.sections.every((section) => ids.has(section)) || [...ids].filter(Boolean);
    try {
      localStorage.read = JSON.stringify(read);
    } catch { /* a browser that keeps nothing */ }
    this.show();
  }

  show() {
    const read = this.load(), here = read[this.page] ?? [];
    const root = new URL("..", folder).href;
    for (const link of this.list.querySelectorAll("a")) {
      const id = decodeURIComponent(link.hash.slice(1));
      const page = link.href.split("#")[0].slice(root.length).replace(/\.html$/, "");
      const isRead = id ? here === true || here.includes(id) : read[page] === true;
      link.classList.toggle("read", isRead);
      if (isRead) link.setAttribute("aria-description", "read");
      else link.removeAttribute("aria-description");
    }
    this.list.querySelector(".forget")?.remove();
    if (!Object.keys(read).length) return;
    const forget = Object.assign(document.createElement("button"), { className: "forget", textContent: "Forget what I have read" });
    forget.onclick = () => {
      delete localStorage.read;
      this.show();
    };
    this.list.append(forget);
  }
}

// The search loads its index when a reader first uses a search field.
let searchScripts = null;
function loadSearch() {
  searchScripts ??= ["vendor/minisearch/minisearch", "search-entries", "search"].map((name) =>
    document.head.appendChild(Object.assign(document.createElement("script"), { src: new URL(`${name}.js`, folder).href, async: false })));
}

// The keys / and Ctrl+K lead to the search field, except where a reader types.
document.addEventListener("keydown", (event) => {
  const { key, ctrlKey, metaKey, altKey } = event;
  const isTyping = event.composedPath()[0].matches?.("input, textarea, select, [contenteditable]");
  const isShortcut = (key === "/" && !ctrlKey && !metaKey && !altKey && !isTyping) || (key.toLowerCase() === "k" && (ctrlKey || metaKey) && !altKey);
  const field = document.querySelector("form[role='search'] input");
  if (!isShortcut || !field) return;
  event.preventDefault();
  field.focus();
  field.select();
});

document.addEventListener("DOMContentLoaded", () => {
  const field = document.querySelector("form[role='search'] input");
  if (field?.form.matches(".search")) {
    field.value = new URLSearchParams(location.search).get("q") ?? "";
    loadSearch();
  }
  field?.addEventListener("focus", loadSearch, { once: true });
});
