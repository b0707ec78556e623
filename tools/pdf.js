// Functions that tools/pdf.py runs in the pages.
({
// Return a page's article as HTML, the rules of its style elements, and its title.
// It opens folded boxes, removes what needs a screen (book.css hides the rest on paper), keeps only the picture of sections
// about a live figure, shrinks wide formulas to the paper, and prefixes ids and links with the page's name.
extractArticle: async (name) => {
  const prefix = name.replaceAll("/", "-");
    const article = document.querySelector("article"), all = (selector) => article.querySelectorAll(selector);
    all("details").forEach((box) => (box.open = true));
    all("script, .tools, .copy, .hint, .headerlink, details.hide").forEach((e) => e.remove());
    all(".picture > .panel").forEach((e) => e.remove());
    all(".arm-explorer").forEach((arm) => arm.prepend(arm.shadowRoot.querySelector(".still").cloneNode(true)));
    all("section:has(> .cell .arm-explorer)").forEach((section) => {
        if (section.querySelectorAll(".cell").length > 1) return;
        section.querySelectorAll(":scope > :is(p, ul, ol), .cell_input").forEach((e) => e.remove());
        const note = document.createElement("p");
        note.textContent = "On the book's pages this arm moves.";
        section.append(note);
    });
    all(".scrolls").forEach((box) => box.classList.remove("scrolls", "more-left", "more-right"));
    all(".display, .matrix").forEach((box) => {
        box.style.removeProperty("--shrunk");
        const scale = box.clientWidth / box.scrollWidth;
        if (scale < 1) box.style.setProperty("--shrunk", Math.floor(scale * 100) / 100);
    });
    all("img").forEach((picture) => { picture.loading = "eager"; picture.src = picture.src; });
    all("a[href]").forEach((link) => {
        const url = new URL(link.href), page = decodeURI(url.pathname).slice(rootPath().length, -5);
        if (url.protocol !== "file:") return;
        if (url.pathname.endsWith(".html")) link.setAttribute("href", `#${page.replaceAll("/", "-")}--${decodeURIComponent(url.hash.slice(1))}`);
        else link.removeAttribute("href");
    });
    function rootPath() { return decodeURI(location.pathname).slice(0, -`${name}.html`.length); }
    // Ids move to the titles: a section's box can begin at the foot of the page before its title, and links would name that page.
    all("section:has(> :is(h1, h2, h3, h4))").forEach((section) => {
        const title = section.querySelector(":scope > :is(h1, h2, h3, h4)"), anchors = section.querySelectorAll(":scope > span[id]:empty");
        if (section.id) title.prepend(Object.assign(document.createElement("span"), { id: section.id }));
        title.prepend(...anchors);
        section.removeAttribute("id");
    });
    all("[id]").forEach((e) => (e.id = `${prefix}--${e.id}`));
    article.id = `${prefix}--`;
    const styles = [...document.querySelectorAll("style")].map(({ sheet }) => [...sheet.cssRules].map((rule) => rule.cssText).join("\n"));
    return [article.outerHTML, styles, article.querySelector("h1").textContent];
},

// Write the page number after each reference; its box has the same width for every number.
addPageNumbers: (pages) => {
  document.querySelectorAll("a[href^='#']").forEach((link) => {
    const target = decodeURIComponent(link.getAttribute("href").slice(1));
    if (!document.getElementById(target)) return void link.removeAttribute("href");
    if (link.closest("summary, .footnote-reference, aside, .admonition-title, nav")) return;
    let label = link.nextElementSibling?.matches(".page-number") ? link.nextElementSibling : null;
    if (!label) link.after((label = Object.assign(document.createElement("span"), { className: "page-number" })));
    label.textContent = target in pages ? ` (p. ${pages[target]})` : "";
  });
},
})
