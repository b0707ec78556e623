// Formulas are set when the reader comes near them, a few at a time so that the page answers meanwhile, the nearest first.
const unset = new Set(), near = new Map(); // near: how far from the middle of the screen they were
let setting;

// Before anybody reads, the page must stay quick; who reads on waits for formulas.
function few(formulas) {
  let characters = "fresh" in document.documentElement.dataset ? 40 : 120;
  const ends = formulas.findIndex((formula) => (characters -= formula.textContent.length + 20) < 0);
  return formulas.slice(0, ends < 0 ? formulas.length : Math.max(ends, 1));
}

const pause = () => new Promise((done) => setTimeout(done));
const frame = () => new Promise((due) => (document.hidden ? due() : requestAnimationFrame(due)));

// The text is on the screen; in a tab that is not shown it never will be, until it is.
const painted = () => new Promise((done) => {
  if (document.hidden || !PerformanceObserver.supportedEntryTypes.includes("paint")) return done();
  new PerformanceObserver(() => done()).observe({ type: "paint", buffered: true });
  setTimeout(done, 3000);
});

const watch = new IntersectionObserver((changes) => {
  for (const { isIntersecting, target, boundingClientRect: box } of changes) {
    if (isIntersecting && unset.has(target)) near.set(target, Math.abs(box.top + box.bottom - innerHeight));
    else near.delete(target);
  }
  if (near.size && setting === null) setting = setNear();
}, { rootMargin: "150% 0px" });

// The formulas are of full size from here on, which MathJax measures.
function taken(formulas) {
  for (const formula of formulas) {
    formula.classList.add("set");
    watch.unobserve(formula);
    near.delete(formula);
    unset.delete(formula);
  }
  return formulas;
}

async function setNear() {
  const done = [];
  await pause(); // the observer has told what is near
  while (near.size) {
    const next = taken(few([...near.keys()].sort((one, other) => near.get(one) - near.get(other))));
    await MathJax.typesetPromise(next);
    done.push(...next);
    await pause();
  }
  setting = null;
  done.forEach((formula) => formula.querySelectorAll(WIDE).forEach((box) => measure.observe(box)));
}

async function setFormulas() {
  for (const formula of document.querySelectorAll("span.math, div.math")) {
    unset.add(formula);
    watch.observe(formula);
  }
  await Promise.all([frame(), document.fonts.ready]); // by then it is known which are near, and how large letters are
  // The letters of formulas come before the first of them: until then others stand there, of other heights.
  await MathJax.typesetPromise([]); // says where they are
  await Promise.allSettled(["MJXZERO", "MJXTEX", "MJXTEX-I"].map((face) => document.fonts.load(`1em ${face}`)));
  await (setting = setNear());
}

// On paper everything is seen.
window.addEventListener("beforeprint", () => {
  if (setting !== undefined && unset.size) MathJax.typeset(taken([...unset]));
  reachable(all());
});

if (window.MathJax) {
  const parts = MathJax.loader.load;
  MathJax.loader.load = [];
  MathJax.startup = {
    typeset: false,
    pageReady: setFormulas,
    async ready() {
      await painted();
      await MathJax.loader.load(...parts);
      MathJax.startup.defaultReady();
    },
  };
}

// What is wider than its place scrolls in a box of its own, from the keyboard too, and says so.
const WIDE = "div.math > mjx-container, span.math > mjx-container, div.table, .highlight pre";
const SMALLEST = 0.8; // of a formula's size, before it scrolls

const all = () => [...document.querySelectorAll(WIDE)];

// Boxes are measured when they come near, so that what is far need not be laid out.
const measure = new IntersectionObserver((changes) => {
  reachable(changes.filter(({ isIntersecting }) => isIntersecting).map(({ target }) => target));
}, { rootMargin: "150% 0px" });

// All are measured before any is changed, so that the page is laid out once.
function reachable(boxes) {
  boxes.filter((box) => box.dataset.size).forEach((box) => (box.style.fontSize = box.dataset.size));
  const shares = boxes.map(share);
  const tight = boxes.filter((box, k) => shares[k] < 1 && shares[k] > SMALLEST && box.matches("div.math > *"));
  for (const box of tight) {
    box.dataset.size ??= box.style.fontSize;
    box.style.fontSize = `${parseFloat(box.dataset.size) * shares[boxes.indexOf(box)] * 0.985}%`;
  }
  boxes.forEach((box, k) => scrollable(box, shares[k] < 1 && !tight.includes(box)));
}

// How much of a box's content it shows at once; an inline formula grows with what is in it, so its text's column counts.
function share(box) {
  if (box.matches("span.math > *")) return box.closest("p, li, td, dd, div").clientWidth / Math.max(box.offsetWidth, box.scrollWidth);
  return box.scrollWidth > box.clientWidth + 1 ? box.clientWidth / box.scrollWidth : 1;
}

// Checks that hold stand out, among other lines too: each begins at the edge, and what does not fit its line goes on
// further in. A unit stays with its number, an exponent with its minus.
function proven(output) {
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

function scrollable(box, wide) {
  if (!wide && !box.matches(".scrolls")) return;
  box.classList.toggle("scrolls", wide);
  if (!wide) {
    box.classList.remove("more-left", "more-right");
    return void box.removeAttribute("tabindex");
  }
  box.tabIndex = 0;
  box.setAttribute("role", "region");
  box.setAttribute("aria-label", "Wide content, scroll sideways");
  hint(box);
  tell(box);
  if (!box.dataset.told) box.addEventListener("scroll", () => tell(box), { passive: true });
  box.dataset.told = true;
}

function hint(box) {
  if (box.matches("pre, span *") || box.nextElementSibling?.matches(".hint")) return; // a fading edge says enough there
  const words = Object.assign(document.createElement("span"), { className: "hint", textContent: "scroll sideways →" });
  words.ariaHidden = true;
  box.after(words);
}

function tell(box) {
  const left = box.scrollWidth - box.clientWidth - box.scrollLeft;
  box.classList.toggle("more-right", left > 2);
  box.classList.toggle("more-left", box.scrollLeft > 2);
}

// Whatever is near is told of anew, and the rest when the reader comes near.
function look() {
  measure.disconnect();
  all().forEach((box) => measure.observe(box));
}

window.addEventListener("load", look);
document.fonts.addEventListener("loadingdone", look);
let later;
window.addEventListener("resize", () => {
  clearTimeout(later);
  later = setTimeout(look, 100);
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
    button.hidden = false;
    name();
  });

  // Lists of references carry roles whose children they do not have.
  each("div.citation-list, dl.citation, [role='doc-biblioentry']", (list) => list.removeAttribute("role"));
  each("div.citation-list [role], .citation [role='doc-backlink']", (item) => item.removeAttribute("role"));
  // A visible text is its own name; a different label beside it confuses speech input.
  each("summary[aria-label]", (control) => control.removeAttribute("aria-label"));

  each("div.cell_output", (output) => {
    const texts = [...output.querySelectorAll("pre")].map((pre) => pre.textContent.trim());
    const lines = texts.join("\n").split("\n");
    const told = lines.filter((line) => !line.startsWith("✔"));
    if (!told.length) output.classList.add("proof");
    else if (/\S {2,}\S.*\n.*\S {2,}\S/.test(told.join("\n"))) output.classList.add("columns");
    if (told.length < lines.length) proven(output);
  });

  each("div.cell_input .highlight, div[class*='highlight-python'] > .highlight", (code) => {
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

  // Where the reader is, in the list of the page's sections.
  const links = new Map([...document.querySelectorAll(".sections a")].map((a) => [decodeURIComponent(a.hash.slice(1)), a]));
  const seen = new IntersectionObserver((changes) => {
    for (const { isIntersecting, target } of changes) links.get(target.id)?.classList.toggle("here", isIntersecting);
  }, { rootMargin: "-20% 0px -70%" });
  each("article section[id]", (section) => links.has(section.id) && seen.observe(section));
});
