// What is wider than its place scrolls in a box of its own, from the keyboard too, and says so.
const WIDE = ".display, .matrix, div.table, pre";
const SMALLEST = 0.75; // of a formula's size, before it scrolls

const all = () => [...document.querySelectorAll(WIDE)];

// Boxes are measured when they come near, so that what is far need not be laid out.
const measure = new IntersectionObserver((changes) => {
  reachable(changes.filter(({ isIntersecting }) => isIntersecting).map(({ target }) => target));
}, { rootMargin: "150% 0px" });

// All are measured before any is changed, so that the page is laid out once.
function reachable(boxes) {
  boxes.forEach((box) => box.style.removeProperty("--shrunk"));
  const shares = boxes.map(share);
  boxes.forEach((box, k) => {
    const tight = box.matches(".display, .matrix") && shares[k] < 1 && shares[k] > SMALLEST;
    if (tight) box.style.setProperty("--shrunk", 0.985 * shares[k]);
    scrollable(box, shares[k] < 1 && !tight);
  });
}

// How much of a box's content it shows at once.
function share(box) {
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
  if (box.matches("pre, .matrix") || box.nextElementSibling?.matches(".hint")) return; // a fading edge says enough there
  const words = Object.assign(document.createElement("span"), { className: "hint", textContent: "scroll sideways →" });
  words.ariaHidden = true;
  box.after(words);
}

function tell(box) {
  const left = box.scrollWidth - box.clientWidth - box.scrollLeft;
  box.classList.toggle("more-right", left > 1);
  box.classList.toggle("more-left", box.scrollLeft > 1);
}

// Whatever is near is told of anew, and the rest when the reader comes near.
function look() {
  measure.disconnect();
  all().forEach((box) => measure.observe(box));
}

// On paper everything is seen.
window.addEventListener("beforeprint", () => reachable(all()));
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
    name();
  });

  // Lists of references carry roles whose children they do not have.
  each("div.citation-list, dl.citation, [role='doc-biblioentry']", (list) => list.removeAttribute("role"));
  each("div.citation-list [role], .citation [role='doc-backlink']", (item) => item.removeAttribute("role"));

  each("div.cell_output", (output) => {
    const texts = [...output.querySelectorAll("pre")].map((pre) => pre.textContent.trim());
    const lines = texts.join("\n").split("\n");
    const told = lines.filter((line) => !line.startsWith("✔"));
    if (!told.length) output.classList.add("proof");
    else if (/\S {2,}\S.*\n.*\S {2,}\S/.test(told.join("\n"))) output.classList.add("columns");
    if (told.length < lines.length) proven(output);
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

  // Where the reader is, in the list of the page's sections.
  const links = new Map([...document.querySelectorAll(".sections a")].map((a) => [decodeURIComponent(a.hash.slice(1)), a]));
  const seen = new IntersectionObserver((changes) => {
    for (const { isIntersecting, target } of changes) links.get(target.id)?.classList.toggle("here", isIntersecting);
  }, { rootMargin: "-20% 0px -70%" });
  each("article section[id]", (section) => links.has(section.id) && seen.observe(section));
});
