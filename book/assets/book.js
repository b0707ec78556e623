// What the theme leaves undone for readers who do not use a mouse or a screen.
document.addEventListener("DOMContentLoaded", () => {
  const each = (selector, change) => document.querySelectorAll(selector).forEach(change);

  each(".bd-sidebar-secondary", (sidebar) => {
    sidebar.setAttribute("role", "complementary");
    sidebar.setAttribute("aria-label", "On this page");
  });
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
  });

  const reachable = () =>
    each("div.math, .pst-scrollable-table-container", (box) => {
      if (box.scrollWidth <= box.clientWidth) return;
      box.tabIndex = 0;
      box.setAttribute("role", "region");
      box.setAttribute("aria-label", "Wide content, scroll sideways");
    });
  window.MathJax?.startup?.promise?.then(reachable) ?? window.addEventListener("load", reachable);
});
