// Formulas are set a few at a time, always those in view first, so that the page answers while the rest are still being set.
function few(formulas, characters = 100) {
  const ends = formulas.findIndex((formula) => (characters -= formula.textContent.length + 20) < 0);
  return formulas.slice(0, ends < 0 ? formulas.length : Math.max(ends, 1));
}

const pause = () => new Promise((done) => setTimeout(done));
const frame = () => new Promise((due) => (document.hidden ? due() : requestAnimationFrame(due)));

async function setFormulas() {
  const inView = new Set(), left = new Set(document.querySelectorAll("span.math, div.math"));
  const watch = new IntersectionObserver((changes) => changes.forEach(({ isIntersecting, target }) => {
    inView[isIntersecting ? "add" : "delete"](target);
  }));
  left.forEach((formula) => watch.observe(formula));
  await frame(); // by then it is known which are in view
  while (left.size) {
    await pause();
    const next = few([...(inView.size ? inView : left)]);
    next.forEach((formula) => formula.classList.add("set")); // of full size, which MathJax measures
    await MathJax.typesetPromise(next);
    for (const formula of next) {
      watch.unobserve(formula);
      inView.delete(formula);
      left.delete(formula);
    }
  }
  reachable();
}

if (window.MathJax) {
  const parts = MathJax.loader.load;
  MathJax.loader.load = [];
  MathJax.startup = {
    typeset: false,
    pageReady: setFormulas,
    async ready() {
      await frame();
      await pause(); // the text is painted
      await MathJax.loader.load(...parts);
      MathJax.startup.defaultReady();
    },
  };
}

// What is wider than its box can be scrolled from the keyboard too.
function reachable() {
  document.querySelectorAll("div.math, mjx-container[display], .pst-scrollable-table-container, .columns pre, figure").forEach((box) => {
    if (box.scrollWidth <= box.clientWidth) return;
    box.tabIndex = 0;
    if (box.matches("figure")) return; // it has a role and a name of its own
    box.setAttribute("role", "region");
    box.setAttribute("aria-label", "Wide content, scroll sideways");
  });
}
window.addEventListener("load", reachable);

// What the theme leaves undone for readers who do not use a mouse or a screen.
document.addEventListener("DOMContentLoaded", () => {
  const each = (selector, change) => document.querySelectorAll(selector).forEach(change);

  each(".bd-sidebar-secondary", (sidebar) => {
    sidebar.setAttribute("role", "complementary");
    sidebar.setAttribute("aria-label", "On this page");
  });
  each(".bd-sidebar-primary", (sidebar) => {
    sidebar.setAttribute("role", "complementary");
    sidebar.setAttribute("aria-label", "The book's pages");
  });
  // The theme's icons carry a second name that contradicts the button's own.
  each(".theme-switch-button [title]", (icon) => icon.removeAttribute("title"));
  // A visible text is its own name; a different label beside it confuses speech input.
  each("summary[aria-label], .search-button__button[aria-label], .theme-switch-button[aria-label]", (control) => {
    if (control.textContent.trim()) control.removeAttribute("aria-label");
  });
  each("div.citation-list, dl.citation, [role='doc-biblioentry']", (list) => list.removeAttribute("role"));
  each("div.citation-list [role], .citation [role='doc-backlink']", (item) => item.removeAttribute("role"));

  each("div.cell_output", (output) => {
    const texts = [...output.querySelectorAll("pre")].map((pre) => pre.textContent.trim());
    const lines = texts.join("\n").split("\n");
    if (lines.every((line) => line.startsWith("✔"))) output.classList.add("proof");
    else if (/\S {2,}\S.*\n.*\S {2,}\S/.test(texts.join("\n"))) output.classList.add("columns");
  });
});
