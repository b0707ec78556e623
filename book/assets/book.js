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

  // Mark the current section in the list of the page's sections.
  const links = new Map([...document.querySelectorAll(".sections a")].map((a) => [decodeURIComponent(a.hash.slice(1)), a]));
  const sectionObserver = new IntersectionObserver((changes) => {
    for (const { isIntersecting, target } of changes) links.get(target.id)?.classList.toggle("here", isIntersecting);
  }, { rootMargin: "-20% 0px -70%" });
  each("article section[id]", (section) => links.has(section.id) && sectionObserver.observe(section));
});

// The search loads its index when a reader first uses a search field.
const folder = document.currentScript.src;
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
