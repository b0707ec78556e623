// What tools/pdf.py runs in the pages.
({
// A page as a part of the whole: everything open, what only a screen can do left out (most of it by book.css, as on any paper),
// sections that are only there to be moved left out but for their picture, wide formulas shrunk to the paper, ids and addresses its own;
// its style sheets and its title.
take: async (name) => {
  const part = name.replaceAll("/", "-");
    const article = document.querySelector("article"), all = (what) => article.querySelectorAll(what);
    all("details").forEach((box) => (box.open = true));
    all("script, .tools, .copy, .hint, .headerlink, details.hide").forEach((e) => e.remove());
    all(".picture > .panel").forEach((e) => e.remove());
    all(".arm-explorer").forEach((arm) => arm.prepend(arm.shadowRoot.querySelector(".still").cloneNode(true)));
    all("section:has(> .cell .arm-explorer)").forEach((section) => {
        if (section.querySelectorAll(".cell").length > 1) return;
        section.querySelectorAll(":scope > :is(p, ul, ol), .cell_input").forEach((e) => e.remove());
        const words = document.createElement("p");
        words.textContent = "On the book's pages this arm moves.";
        section.append(words);
    });
    all(".scrolls").forEach((box) => box.classList.remove("scrolls", "more-left", "more-right"));
    all(".display, .matrix").forEach((box) => {
        box.style.removeProperty("--shrunk");
        const room = box.clientWidth / box.scrollWidth;
        if (room < 1) box.style.setProperty("--shrunk", Math.floor(room * 100) / 100);
    });
    all("img").forEach((picture) => { picture.loading = "eager"; picture.src = picture.src; });
    all("a[href]").forEach((link) => {
        const url = new URL(link.href), page = decodeURI(url.pathname).slice(root().length, -5);
        if (url.protocol !== "file:") return;
        if (url.pathname.endsWith(".html")) link.setAttribute("href", `#${page.replaceAll("/", "-")}--${decodeURIComponent(url.hash.slice(1))}`);
        else link.removeAttribute("href");
    });
    function root() { return decodeURI(location.pathname).slice(0, -`${name}.html`.length); }
    // A section begins at its title; its own box may begin at the foot of the page before, and its page number would be that.
    all("section:has(> :is(h1, h2, h3, h4))").forEach((section) => {
        const title = section.querySelector(":scope > :is(h1, h2, h3, h4)"), places = section.querySelectorAll(":scope > span[id]:empty");
        if (section.id) title.prepend(Object.assign(document.createElement("span"), { id: section.id }));
        title.prepend(...places);
        section.removeAttribute("id");
    });
    all("[id]").forEach((e) => (e.id = `${part}--${e.id}`));
    article.id = `${part}--`;
    const styles = [...document.querySelectorAll("style")].map(({ sheet }) => [...sheet.cssRules].map((rule) => rule.cssText).join("\n"));
    return [article.outerHTML, styles, article.querySelector("h1").textContent];
},

// A reference says its page, in room that any number has.
number: (pages) => {
  document.querySelectorAll("a[href^='#']").forEach((link) => {
    const target = decodeURIComponent(link.getAttribute("href").slice(1));
    if (!document.getElementById(target)) return void link.removeAttribute("href");
    if (link.closest("summary, .footnote-reference, aside, .admonition-title, nav")) return;
    let said = link.nextElementSibling?.matches(".page-number") ? link.nextElementSibling : null;
    if (!said) link.after((said = Object.assign(document.createElement("span"), { className: "page-number" })));
    said.textContent = target in pages ? ` (p. ${pages[target]})` : "";
  });
},
})
