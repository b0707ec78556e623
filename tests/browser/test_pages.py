"""Test every built page without a network: wide and narrow, light and dark."""

from pathlib import Path
from urllib.parse import unquote, urlparse

import pytest

from tests.browser.reader import (
    AXE,
    FIT_ALL_BOXES,
    LIST_AXE_FINDINGS,
    SCROLL_INTO_VIEW,
    SIZES,
    SKIP_DRAWING,
    TWO_FRAMES,
    WINDOWS,
    Reader,
)
from tests.test_book import HTML, NAMES, SHEETS

PAGES = [*NAMES, "search", "genindex"]

LIST_BROKEN_PICTURES = """async () => {
    const pictures = [...document.images];
    pictures.forEach(picture => (picture.loading = "eager")); // those far down too, and those of the other colours
    const loaded = await Promise.allSettled(pictures.map(picture => picture.decode()));
    return pictures.filter((picture, k) => loaded[k].status === "rejected" || !picture.naturalWidth).map(p => p.src);
}"""
# Lists text and elements that overflow the page outside of a box that scrolls visibly and takes focus.
LIST_CUT_CONTENT = """() => {
    const article = document.querySelector("article"), edge = article.getBoundingClientRect().right + 1, found = [];
    const kept = (e) => e.closest(".scrolls.more-right, .scrolls.more-left, .arm-explorer, .arm-judge, .headerlink");
    const letters = document.createTreeWalker(article, NodeFilter.SHOW_ELEMENT | NodeFilter.SHOW_TEXT), range = document.createRange();
    const over = () => range.getBoundingClientRect().right > edge;
    while (letters.nextNode()) {
        const text = letters.currentNode;
        if (!text.data?.trim()) continue;
        range.selectNodeContents(text);
        if (!over() || kept(text.parentElement)) continue;
        for (const { 0: word, index } of text.data.matchAll(/\\S+/g)) { // blanks may hang over the edge: nobody sees them
            range.setStart(text, index);
            range.setEnd(text, index + word.length);
            if (over()) found.push(word);
        }
    }
    for (const e of article.querySelectorAll("td, img"))
        if (e.getBoundingClientRect().right > edge && !kept(e)) found.push(e.outerHTML);
    for (const e of article.querySelectorAll(":not(math, math *)")) {
        if (e.scrollWidth <= e.clientWidth + 1) continue;
        const { overflowX, maskImage } = getComputedStyle(e);
        if (overflowX === "visible" || e.closest(".arm-explorer, .arm-judge")) continue;
        const said = e.matches("pre, .matrix") || e.nextElementSibling?.matches(".hint");
        if (overflowX !== "auto" || !maskImage.includes("gradient") || e.tabIndex !== 0 || !said) found.push(e.outerHTML);
    }
    return found.map((one) => one.slice(0, 100));
}"""
MEASURE_TYPE = """() => {
    const letters = (e) => { // how many of the average letters fit
        const pen = document.createElement("canvas").getContext("2d"), how = getComputedStyle(e);
        pen.font = `${how.fontSize} ${how.fontFamily}`;
        const text = e.textContent.slice(0, 300);
        return e.clientWidth / (pen.measureText(text).width / text.length);
    };
    const size = (e) => parseFloat(getComputedStyle(e).fontSize);
    const paragraphs = [...document.querySelectorAll("article > section p")].filter((p) => p.parentElement.matches("section") && p.textContent.length > 300 && !p.querySelector("math, code"));
    return [paragraphs.map(letters), [...document.querySelectorAll("pre")].map(size)];
}"""
# The letters have come.
FONTS_ARE_LOADED = "() => document.fonts.status === 'loaded'"


@pytest.fixture(scope="module")
def readers(browser):
    looks = [("light", "wide"), ("dark", "phone")]
    readers = [Reader(browser, theme, size, "file:") for theme, size in looks]
    yield readers
    for reader in readers:
        reader.context.close()


@pytest.fixture(scope="module", params=PAGES)
def visit(readers, request):
    """Open each page once for all tests, with every box unfolded.

    Pages are light on a wide screen and dark on a phone in turn. The tests change width and theme.
    """
    dark = PAGES.index(request.param) % 2
    reader = readers[dark]
    reader.page.set_viewport_size(SIZES["phone" if dark else "wide"])
    reader.problems, reader.requested_urls = [], set()
    page = reader.open((HTML / f"{request.param}.html").as_uri())
    page.evaluate("document.querySelectorAll('details').forEach(d => d.open = true)")
    page.evaluate(FIT_ALL_BOXES)
    page.wait_for_function(FONTS_ARE_LOADED, polling=50)
    return reader


def test_page_loads_completely(visit):
    assert visit.page.locator("html").get_attribute("data-theme") == visit.theme
    assert visit.page.evaluate(LIST_BROKEN_PICTURES) == []
    assert visit.problems == []


def resized(page, size):
    """Change the size of the window, and let the page mark what is too wide for it."""
    if page.viewport_size == WINDOWS[size]:
        return
    page.set_viewport_size(WINDOWS[size])
    page.evaluate(FIT_ALL_BOXES)


@pytest.mark.parametrize("size", WINDOWS)
def test_page_fits_screen_or_scrolls(visit, size):
    """Lines have 66 to 75 characters on a wide screen, and code has 14 pixels everywhere."""
    resized(visit.page, size)
    assert visit.page.evaluate("document.documentElement.scrollWidth") == WINDOWS[size]["width"]
    assert visit.page.evaluate(LIST_CUT_CONTENT) == []
    lines, code = visit.page.evaluate(MEASURE_TYPE)
    assert all(size >= 13.99 for size in code)
    assert size != "wide" or all(66 <= letters <= 75 for letters in lines), lines


# One call does it all: between two calls the page may mark the box again.
LIST_CUT_CONTENT_WITHOUT_MARKS = f"""(box) => {{
    box.classList.remove("scrolls", "more-right");
    const found = ({LIST_CUT_CONTENT})();
    box.classList.add("scrolls", "more-right");
    return found;
}}"""


@pytest.mark.parametrize(
    ("visit", "what"),
    [
        ("04_static_torque", ".display"),
        ("02_jacobian", ".matrix"),
        ("check_your_homework", "div.table"),
        ("check_your_homework", "pre"),
    ],
    indirect=["visit"],
)
def test_fit_check_detects_cut_content(visit, what):
    """Without its marks a box that is too wide fails the test above."""
    resized(visit.page, "small")
    assert visit.page.locator(f"{what}.more-right").first.evaluate(LIST_CUT_CONTENT_WITHOUT_MARKS)


STOP_ANIMATIONS = """() => [document.head, ...[...document.querySelectorAll("*")].map(e => e.shadowRoot)].forEach(place => {
    if (!place) return;
    const style = place.appendChild(document.createElement("style"));
    style.textContent = "* { animation: none !important; transition: none !important }";
})"""
# The time of axe grows with the number of elements. Formulas take no focus, and of parts that one
# template makes the first ones show what all are like.
REMOVE_REPEATED_PARTS = """() => {
    const kept = {
        math: 0, pre: 5, "dl.py": 20, ":is(.sections, .ahead) li": 20, "tbody tr:nth-child(n + 7)": 0,
        ".admonition": 8, "div.cell:not(:has(img, .arm-explorer, .arm-judge))": 20,
    };
    for (const [selector, count] of Object.entries(kept))
        for (const part of [...document.querySelectorAll(selector)].slice(count)) part.remove();
}"""
CHECK_ONLY_CONTRAST = (
    "axe.configure({disableOtherRules: true, rules: [{id: 'color-contrast', enabled: true}]})"
)


def list_serious_findings(page):
    """List the serious findings of axe in both themes."""
    page.set_viewport_size(SIZES["wide"])
    page.evaluate(STOP_ANIMATIONS)
    focusable = page.locator("math").locator("a[href], button, input, [tabindex]").count()
    assert focusable == 0, "what is only drawn takes no focus"
    page.evaluate(REMOVE_REPEATED_PARTS)
    page.add_script_tag(path=AXE)
    found = page.evaluate(LIST_AXE_FINDINGS)
    page.evaluate(
        "(d => d.theme = d.theme === 'dark' ? 'light' : 'dark')(document.documentElement.dataset)"
    )
    page.evaluate(CHECK_ONLY_CONTRAST)
    page.evaluate(TWO_FRAMES)
    return found + page.evaluate(LIST_AXE_FINDINGS)


# All answer sheets have the kinds of elements of the first, as test_book.py tests.
AXE_PAGES = [name for name in PAGES if name not in SHEETS[1:]]


@pytest.mark.parametrize("visit", AXE_PAGES, indirect=True)
def test_page_passes_axe_in_both_themes(visit):
    found = list_serious_findings(visit.page)
    assert not found, "\n".join(found)


@pytest.mark.parametrize(("name", "pale"), [("explorer", "pre span"), ("glossary", "article p")])
def test_axe_detects_planted_faults(browser, name, pale):
    """A button without a name and text that is too pale on a dark page fail the test above."""
    reader = Reader(browser, "light", "wide", "file:")
    page = reader.open((HTML / f"{name}.html").as_uri())
    page.evaluate("document.querySelectorAll('details').forEach(d => d.open = true)")
    page.evaluate("document.querySelector('article').append(document.createElement('button'))")
    page.add_style_tag(content=f"[data-theme=dark] {pale} {{ color: #555 !important }}")
    first, *others = list_serious_findings(page)
    assert first.startswith("button-name")
    assert [found.split(":")[0] for found in others] == ["color-contrast"]
    reader.context.close()


def test_page_weighs_under_three_megabytes(visit):
    visit.page.evaluate(SKIP_DRAWING)
    for stub in visit.page.locator(".arm-explorer").all():
        stub.evaluate(SCROLL_INTO_VIEW)
        stub.locator("canvas").wait_for()
    files = {
        Path(unquote(urlparse(url).path)) for url in visit.requested_urls if url.startswith("file:")
    }
    assert sum(file.stat().st_size for file in files) <= 3_000_000
