"""Every page as a reader meets it: from a file, with no network, wide and narrow, light and
dark."""

from pathlib import Path
from urllib.parse import unquote, urlparse

import pytest

from tests.browser.reader import (
    AXE,
    BAD,
    EVERYTHING,
    SIZES,
    THERE,
    TWO_FRAMES,
    UNDRAWN,
    WINDOWS,
    Reader,
)
from tests.test_book import HTML, NAMES

BROKEN = """async () => {
    const pictures = [...document.images];
    pictures.forEach(picture => (picture.loading = "eager")); // those far down too, and those of the other colours
    const loaded = await Promise.allSettled(pictures.map(picture => picture.decode()));
    return pictures.filter((picture, k) => loaded[k].status === "rejected" || !picture.naturalWidth).map(p => p.src);
}"""
# What reaches over its box or the screen without a box that scrolls, shows that it does, and can be reached by keys.
CUT = """() => {
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
TYPE = """() => {
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
LOADED = "() => document.fonts.status === 'loaded'"
# What the contrast of an element's letters depends on: its colours and size, and all that they stand on.
LOOK = """const grounds = new Map([[null, ""]]);
const ground = (e) => {
    if (!grounds.has(e)) {
        const { backgroundColor, backgroundImage, opacity } = getComputedStyle(e);
        const own = [backgroundColor, backgroundImage, opacity].join();
        grounds.set(e, ground(e.parentElement ?? e.getRootNode().host ?? null) + (own === "rgba(0, 0, 0, 0),none,1" ? "" : own));
    }
    return grounds.get(e);
};
const look = (e) => {
    const { color, fontSize, fontWeight, textShadow } = getComputedStyle(e);
    return [color, fontSize, fontWeight, textShadow, ground(e)].join();
};
const own = (e) => [...e.childNodes].map((node) => (node.nodeType === Node.TEXT_NODE ? node.data : "")).join("");
const legible = (e) => /[\\p{L}\\p{N}].*[\\p{L}\\p{N}]/su.test(own(e));"""
# Axe finds one word of a program like the next of its look, and judges no letter that stands alone: none of them is left
# to it ten thousand times, and of the formulas one that is empty.
# What could be focused in a formula is counted here.
THINNED = f"""() => {{
    {LOOK}
    const formulas = [...document.querySelectorAll("math")], seen = new Set();
    const focusable = formulas.filter(m => m.querySelector("a[href], button, input, [tabindex]")).length;
    const again = (e, kind) => (seen.has(kind) ? e.remove() : seen.add(kind));
    formulas.forEach(m => m.replaceChildren());
    for (const part of formulas) again(part, part.tagName);
    const words = [...document.querySelectorAll("article :is(span, i, b, u, sub, sup, em):not(a *, button *, summary *, label *)")];
    const kinds = words.map((word) => [word.tagName, word.className, word.parentElement.tagName, word.parentElement.className, look(word), legible(word)].join());
    for (let k = words.length; k--; )
        if (!words[k].childElementCount && !words[k].matches("[role], [tabindex], [id], [aria-label]")) again(words[k], kinds[k]);
    return focusable;
}}"""
# Contrast costs axe the most, and is the same for all letters of a look: it judges two elements of each, of those that
# are seen and have letters of their own.
MARKED = f"""() => {{
    {LOOK}
    const seen = new Map();
    const within = (place) => [...place.querySelectorAll("*")].flatMap((e) => [e, ...(e.shadowRoot ? within(e.shadowRoot) : [])]);
    const off = (e) => e.matches(":disabled, :disabled *, [aria-disabled=true], [aria-disabled=true] *") || e.closest("label")?.control?.disabled;
    for (const e of within(document)) {{
        delete e.dataset.look;
        if (!own(e).trim() && !e.matches("input, select, textarea")) continue;
        const {{ right, bottom, width, height }} = e.getBoundingClientRect();
        if (width < 2 || height < 2 || right < 0 || bottom + scrollY < 0 || !e.checkVisibility({{ visibilityProperty: true }})) continue;
        const kind = [look(e), legible(e), off(e)].join();
        const times = (seen.get(kind) ?? 0) + 1;
        seen.set(kind, times);
        if (times <= 2) e.dataset.look = times;
    }}
    axe.configure({{ rules: [{{ id: "color-contrast", selector: "[data-look]" }}] }});
}}"""
# By then the browser has laid out what was changed, and told who watches what is near.


@pytest.fixture(scope="module")
def readers(browser):
    looks = [("light", "wide"), ("dark", "phone")]
    readers = [Reader(browser, theme, size, "file:") for theme, size in looks]
    yield readers
    for reader in readers:
        reader.context.close()


@pytest.fixture(scope="module", params=[*NAMES, "search"])
def visit(readers, request):
    """Each page opened once for all tests, everything unfolded: bright on a wide screen or dark on a
    phone, in turn; the tests then see it in every width and in both colours."""
    dark = [*NAMES, "search"].index(request.param) % 2
    reader = readers[dark]
    reader.page.set_viewport_size(SIZES["phone" if dark else "wide"])
    reader.troubles, reader.asked = [], set()
    page = reader.open((HTML / f"{request.param}.html").as_uri())
    page.evaluate("document.querySelectorAll('details').forEach(d => d.open = true)")
    page.evaluate(EVERYTHING)
    page.wait_for_function(LOADED, polling=50)
    return reader


def test_the_page_is_whole(visit):
    assert visit.page.locator("html").get_attribute("data-theme") == visit.theme
    assert visit.page.evaluate(BROKEN) == []
    assert visit.troubles == []


def resized(page, size):
    """The page in another window, once it has looked again at what is too wide."""
    if page.viewport_size == WINDOWS[size]:
        return
    page.set_viewport_size(WINDOWS[size])
    page.evaluate(EVERYTHING)


@pytest.mark.parametrize("size", WINDOWS)
def test_everything_fits_the_screen_or_scrolls_and_says_so(visit, size):
    """And lines have 66 to 75 letters where there is room, and code 14 pixels everywhere."""
    resized(visit.page, size)
    assert visit.page.evaluate("document.documentElement.scrollWidth") == WINDOWS[size]["width"]
    assert visit.page.evaluate(CUT) == []
    lines, code = visit.page.evaluate(TYPE)
    assert all(size >= 13.99 for size in code)
    assert size != "wide" or all(66 <= letters <= 75 for letters in lines), lines


# In one go: between two calls the page may look again at what is too wide, and mark it.
UNMARKED = f"""(box) => {{
    box.classList.remove("scrolls", "more-right");
    const found = ({CUT})();
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
def test_a_cut_would_be_noticed(visit, what):
    """The test above means something: without its marks, what is too wide is found."""
    resized(visit.page, "small")
    assert visit.page.locator(f"{what}.more-right").first.evaluate(UNMARKED)


CALM = """() => [document.head, ...[...document.querySelectorAll("*")].map(e => e.shadowRoot)].forEach(place => {
    if (!place) return;
    const style = place.appendChild(document.createElement("style"));
    style.textContent = "* { animation: none !important; transition: none !important }";
})"""
ONLY_COLOURS = (
    "axe.configure({disableOtherRules: true, rules: [{id: 'color-contrast', enabled: true}]})"
)


def serious(page):
    """What axe finds in the colours that the page has, and what the others spoil."""
    page.set_viewport_size(SIZES["wide"])
    page.evaluate(CALM)
    assert page.evaluate(THINNED) == 0, "what is only drawn takes no focus"
    page.add_script_tag(path=AXE)
    page.evaluate(MARKED)
    found = page.evaluate(BAD)
    page.evaluate(
        "(d => d.theme = d.theme === 'dark' ? 'light' : 'dark')(document.documentElement.dataset)"
    )
    page.evaluate(ONLY_COLOURS)
    page.evaluate(TWO_FRAMES)
    page.evaluate(MARKED)
    return found + page.evaluate(BAD)


def test_axe_finds_nothing_serious_in_either_colours(visit):
    found = serious(visit.page)
    assert not found, "\n".join(found)


@pytest.mark.parametrize(("name", "pale"), [("explorer", "pre span"), ("glossary", "article p")])
def test_axe_would_notice(browser, name, pale):
    """The test above means something: a button without a name is found, and letters too pale on the
    dark page that was opened bright."""
    reader = Reader(browser, "light", "wide", "file:")
    page = reader.open((HTML / f"{name}.html").as_uri())
    page.evaluate("document.querySelectorAll('details').forEach(d => d.open = true)")
    page.evaluate("document.querySelector('article').append(document.createElement('button'))")
    page.add_style_tag(content=f"[data-theme=dark] {pale} {{ color: #555 !important }}")
    first, *others = serious(page)
    assert first.startswith("button-name")
    assert [found.split(":")[0] for found in others] == ["color-contrast"]
    reader.context.close()


def test_it_weighs_no_more_than_three_megabytes(visit):
    visit.page.evaluate(UNDRAWN)
    for stub in visit.page.locator(".arm-explorer").all():
        stub.evaluate(THERE)
        stub.locator("canvas").wait_for()
    files = {Path(unquote(urlparse(url).path)) for url in visit.asked if url.startswith("file:")}
    assert sum(file.stat().st_size for file in files) <= 3_000_000
