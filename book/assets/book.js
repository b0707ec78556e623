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

// Paper shows every box and every picture.
window.addEventListener("beforeprint", () => {
  for (const picture of document.images) picture.loading = "eager";
  updateBoxes(findWideBoxes());
});
window.addEventListener("load", observeBoxes);
document.fonts.addEventListener("loadingdone", observeBoxes);
let resizeTimer;
window.addEventListener("resize", () => {
  clearTimeout(resizeTimer);
  resizeTimer = setTimeout(observeBoxes, 100);
});

// Keep what a reader sees in its place when something above it changes its height. WebKit does not do
// so by itself.
if (!CSS.supports("overflow-anchor", "auto")) document.addEventListener("DOMContentLoaded", () => {
  const REST_TIME = 200; // ms after the last scroll event; a correction would stop a smooth scroll
  const article = document.querySelector("article");
  let keptPart, keptTop, keptScroll, timer;
  // Remember the first thing below the bar that is no section, and where it stands.
  const remember = () => {
    const { left, width } = article.getBoundingClientRect();
    for (let y = 64; y < innerHeight / 2; y += 16) {
      keptPart = document.elementFromPoint(left + width / 2, y);
      if (keptPart && article.contains(keptPart) && !keptPart.matches("article, section")) break;
    }
    keptTop = keptPart?.getBoundingClientRect().top;
    keptScroll = scrollY;
  };
  // Scroll by the height that changed above. On a busy machine the event of a scroll comes late: such a
  // scroll is the reader's and stays.
  const correct = () => {
    timer = null;
    if (scrollY !== keptScroll || !keptPart?.isConnected) return;
    const moved = keptPart.getBoundingClientRect().top - keptTop;
    if (Math.abs(moved) < 1) return;
    scrollBy({ top: moved, behavior: "instant" });
    remember();
  };
  addEventListener("scroll", () => {
    remember();
    clearTimeout(timer);
    timer = setTimeout(correct, REST_TIME);
  }, { passive: true });
  new ResizeObserver(() => {
    if (!timer) correct();
  }).observe(article);
});

// The address of a part that has left the page leads to its new place.
function followMovedPart() {
  const line = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  const link = line?.matches(".moved > li") ? line.querySelector("a") : document.querySelector("a.moved");
  if (link) location.replace(link.href);
}
document.addEventListener("DOMContentLoaded", followMovedPart);
addEventListener("hashchange", followMovedPart);

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

  each(".ahead details", (contents) => contents.addEventListener("click", ({ target }) => target.closest("a") && !isWide.matches && (contents.open = false)));
  watchSections();
});

const isWide = matchMedia("(min-width: 76rem)"); // the sections stand beside the text
// Mark the current section in the list of the page's sections, keep it in view there, and mark the
// sections that were read.
function watchSections() {
  const lists = [...document.querySelectorAll("#contents, .ahead")];
  const links = Map.groupBy(document.querySelectorAll("#contents .sections a, .ahead li a"), (link) => decodeURIComponent(link.hash.slice(1)));
  const marks = new ReadMarks(lists, [...links.keys()].filter(Boolean));
  const observer = new IntersectionObserver((changes) => {
    for (const { isIntersecting, boundingClientRect: { bottom }, rootBounds, target: { id } } of changes) {
      for (const link of links.get(id)) {
        link.classList.toggle("here", isIntersecting);
        if (isIntersecting && link.isConnected) keepInView(link.closest("nav"), link);
      }
      if (!isIntersecting && bottom < rootBounds?.top) marks.add(id); // its end was passed
    }
  }, { rootMargin: "-20% 0px -70%" });
  for (const section of document.querySelectorAll("article section[id]"))
    if (links.has(section.id)) observer.observe(section);
}

// Scroll a list so that a link of it is visible, unless the pointer is on it.
function keepInView(list, link) {
  const { offsetTop: top, offsetHeight: height } = link;
  if (list.matches(":hover") || (top > list.scrollTop && top + height < list.scrollTop + list.clientHeight)) return;
  list.scrollTop = top - list.clientHeight / 3;
}

// The sections that a reader has read, kept in the browser: by page the ids of its sections, or true
// for the whole page.
class ReadMarks {
  constructor(lists, sections) {
    Object.assign(this, { lists, sections, page: document.documentElement.dataset.page });
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
    for (const link of this.lists.flatMap((list) => [...list.querySelectorAll("li a")])) {
      const id = decodeURIComponent(link.hash.slice(1));
      const page = link.href.split("#")[0].slice(root.length).replace(/\.html$/, "");
      const isRead = id ? here === true || here.includes(id) : read[page] === true;
      link.classList.toggle("read", isRead);
      if (isRead) link.setAttribute("aria-description", "read");
      else link.removeAttribute("aria-description");
    }
    document.querySelector(".forget")?.remove();
    if (!Object.keys(read).length) return;
    const forget = Object.assign(document.createElement("button"), { className: "forget", textContent: "Forget what I have read" });
    forget.onclick = () => {
      delete localStorage.read;
      this.show();
    };
    this.lists[0].append(forget);
  }
}

// A button above a notebook's page hides all code, here and on the next pages, until it is pressed
// again. Outputs and checks stay.
document.addEventListener("DOMContentLoaded", () => {
  const tools = document.querySelector(".tools");
  if (!tools || !document.querySelector("article .cell_input, article details.hide")) return;
  const { dataset } = document.documentElement;
  const button = Object.assign(document.createElement("button"), { className: "screen" });
  const show = (isHidden) => {
    if (isHidden) dataset.code = "hidden";
    else delete dataset.code;
    button.textContent = isHidden ? "Show all code" : "Hide all code";
  };
  button.onclick = () => {
    const isHidden = dataset.code !== "hidden";
    show(isHidden);
    try {
      localStorage.code = isHidden ? "hidden" : "shown";
    } catch { /* a browser that keeps nothing */ }
  };
  show(dataset.code === "hidden");
  tools.append(button);
});

// A link to an equation, a figure, a slip, an exercise or a term shows it beside the link while the
// pointer or the focus is on it. What stands on another page comes from the search index, since a
// page opened from a file may not fetch another one.
class Preview {
  constructor() {
    this.box = Object.assign(document.createElement("div"), { className: "preview", id: "preview", role: "tooltip", hidden: true });
    document.body.append(this.box);
    const article = document.querySelector("article");
    const begin = ({ target }) => this.prepare(target.closest?.("a[href*='#']:not(.headerlink)"));
    if (matchMedia("(hover: hover)").matches) article.addEventListener("mouseover", begin);
    article.addEventListener("focusin", (event) => event.target.matches(":focus-visible") && begin(event));
    for (const type of ["mouseout", "focusout"]) article.addEventListener(type, () => this.hide());
    addEventListener("keydown", ({ key }) => key === "Escape" && this.hide());
    addEventListener("scroll", () => this.hide(), { passive: true });
  }

  prepare(link) {
    this.hide();
    if (link) this.timer = setTimeout(() => this.show(link), PREVIEW_DELAY);
  }

  async show(link) {
    this.link = link;
    const content = link.pathname === location.pathname ? copyTarget(link.hash) : await describeTarget(link);
    if (!content || this.link !== link) return;
    this.box.replaceChildren(content);
    this.box.hidden = false;
    link.setAttribute("aria-describedby", "preview");
    const { left, top, bottom } = link.getBoundingClientRect();
    const { offsetWidth: width, offsetHeight: height } = this.box;
    this.box.style.left = `${Math.max(8, Math.min(left, innerWidth - width - 8))}px`;
    this.box.style.top = `${bottom + 8 + height < innerHeight ? bottom + 8 : Math.max(8, top - height - 8)}px`;
  }

  hide() {
    clearTimeout(this.timer);
    this.link?.removeAttribute("aria-describedby");
    this.link = null;
    this.box.hidden = true;
  }
}

const PREVIEW_DELAY = 250; // ms
const PREVIEWED = "div.math, figure, .admonition, blockquote, dd";

// Copy the equation, figure, box or definition that a link on this page leads to.
function copyTarget(hash) {
  const target = document.getElementById(decodeURIComponent(hash.slice(1)));
  const part = target?.matches("dt") ? target.nextElementSibling : target?.closest(PREVIEWED) ?? target?.querySelector(":scope > figure");
  if (!part?.matches(PREVIEWED)) return null;
  const copy = part.cloneNode(true);
  for (const element of [copy, ...copy.querySelectorAll("*")]) {
    element.removeAttribute("id");
    element.removeAttribute("tabindex");
  }
  copy.querySelectorAll(".headerlink, .hint, button, form, .arm-explorer, .arm-judge").forEach((element) => element.remove());
  for (const picture of copy.querySelectorAll("img")) picture.loading = "eager";
  return copy;
}

// Describe a target on another page by its entry in the search index; null if it has none.
async function describeTarget({ href, hash }) {
  await loadScript("search-entries");
  const page = href.split("#")[0].slice(new URL("..", folder).href.length).replace(/\.html$/, "");
  const entry = ENTRIES.find((other) => other.page === page && `#${other.anchor}` === decodeURIComponent(hash));
  if (!entry?.text) return null;
  const text = document.createElement("p");
  text.append(Object.assign(document.createElement("strong"), { textContent: entry.title }), " ", entry.text.slice(0, 300), entry.text.length > 300 ? "…" : "");
  return text;
}

document.addEventListener("DOMContentLoaded", () => new Preview());

// The search loads its index when a reader first uses a search field.
const scriptsByName = {};
const loadScript = (name) => (scriptsByName[name] ??= new Promise((onload) => {
  const src = new URL(`${name}.js`, folder).href;
  document.head.append(Object.assign(document.createElement("script"), { src, onload, async: false }));
}));
const loadSearch = () => ["vendor/minisearch/minisearch", "search-entries", "search"].forEach(loadScript);

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
