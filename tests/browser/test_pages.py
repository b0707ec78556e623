"""Every page as a reader meets it: from a file, with no network, wide and narrow, light and
dark."""

import re
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from itertools import product
from pathlib import Path
from urllib.parse import unquote, urlparse

import pytest
from fontTools.ttLib import TTFont

from tests.test_book import HTML, NAMES

SIZES = {"wide": {"width": 1280, "height": 900}, "phone": {"width": 390, "height": 844}}

UNRENDERED = """() => {
    const left = [...document.querySelectorAll("div.math, span.math")].filter(m => !m.querySelector("mjx-container"));
    const wrong = [...document.querySelectorAll("mjx-merror, [data-mjx-error], .merror")];
    const walker = document.createTreeWalker(document.querySelector("main"), NodeFilter.SHOW_TEXT);
    const raw = [];
    while (walker.nextNode()) {
        const text = walker.currentNode;
        if (/\\\\\\(|\\\\\\[|\\$\\$/.test(text.data) && !text.parentElement.closest("pre, code, script")) raw.push(text.data);
    }
    return [...left, ...wrong].map(e => e.outerHTML.slice(0, 200)).concat(raw);
}"""
BROKEN = """async () => {
    const pictures = [...document.images];
    pictures.forEach(picture => (picture.loading = "eager")); // those far down too
    const loaded = await Promise.allSettled(pictures.map(picture => picture.decode()));
    return pictures.filter((picture, k) => loaded[k].status === "rejected" || !picture.naturalWidth).map(p => p.src);
}"""
ICONS = """() => [...document.querySelectorAll("*")].flatMap(e => ["::before", "::after"].flatMap(part => {
    const { content, fontFamily } = getComputedStyle(e, part);
    return fontFamily.includes("Awesome 6 Free") ? [...content].filter(c => c > "\\uE000" && c < "\\uF900") : [];
}))"""
WIDTHS = """async (icons) => {
    const font = "900 512px 'Font Awesome 6 Free'", pen = document.createElement("canvas").getContext("2d");
    await document.fonts.load(font, icons.join(""));
    pen.font = font;
    return icons.map(icon => pen.measureText(icon).width);
}"""
COLOURS = """() => [...document.querySelectorAll(".cell_input pre, .highlight-python pre")].map(pre => [
    getComputedStyle(pre).color, getComputedStyle(pre.closest(".highlight")).color])"""
AXE = Path(__file__).parent / "axe" / "axe.min.js"
BAD = """() => axe.run(document, {resultTypes: ["violations"]}).then(found => found.violations
    .filter(v => ["serious", "critical"].includes(v.impact))
    .map(v => `${v.id}: ` + v.nodes.slice(0, 3).map(n => n.html.slice(0, 160)).join(" | ")))"""


class Reader:
    """One visit to a page, with everything that went wrong on it."""

    def __init__(self, browser, theme, size, allowed, **context):
        self.context = browser.new_context(
            viewport=SIZES[size], offline=allowed == "file:", **context
        )
        self.page, self.theme = self.context.new_page(), theme
        self.troubles, self.asked = [], set()
        self.page.add_init_script(f"localStorage.mode = localStorage.theme = '{theme}'")
        self.page.on("pageerror", lambda error: self.troubles.append(f"error: {error}"))
        self.page.on("console", self._said)
        self.page.on("request", lambda r: self._asked(r.url, allowed))
        self.page.on("requestfailed", lambda r: self.troubles.append(f"failed: {r.url}"))

    def _said(self, message):
        if (
            "GPU stall due to ReadPixels" in message.text
        ):  # of a machine that draws without a graphics card
            return
        if message.type in ("error", "warning"):
            self.troubles.append(f"{message.type}: {message.text}")

    def _asked(self, url, allowed):
        self.asked.add(url)
        if not url.startswith((allowed, "data:", "blob:")):
            self.troubles.append(f"asked for {url}")

    def open(self, url):
        self.page.goto(url)
        self.page.wait_for_function(
            "!window.MathJax || (window.MathJax.startup?.promise?.then(() => true) ?? false)",
            polling=100,
        )
        return self.page


@pytest.fixture(
    scope="module",
    params=product([*NAMES, "search"], [("light", "wide"), ("dark", "phone")]),
    ids=lambda visit: "-".join([visit[0], *visit[1]]),
)
def visit(browser, request):
    """Each page twice, opened once for all tests: bright on a wide screen, dark on a phone;
    everything unfolded."""
    name, (theme, size) = request.param
    reader = Reader(browser, theme, size, "file:")
    page = reader.open((HTML / f"{name}.html").as_uri())
    page.evaluate("document.querySelectorAll('details').forEach(d => d.open = true)")
    page.wait_for_load_state("networkidle")
    yield reader
    reader.context.close()


def test_the_page_is_whole(visit):
    assert visit.page.locator("html").get_attribute("data-theme") == visit.theme
    assert visit.page.evaluate(UNRENDERED) == []
    assert visit.page.evaluate(BROKEN) == []
    assert visit.troubles == []


def test_nothing_is_wider_than_the_screen(visit):
    for size in SIZES.values():
        visit.page.set_viewport_size(size)
        found = visit.page.evaluate("document.documentElement.scrollWidth")
        assert found <= size["width"], f"the page is {found} px wide"


def test_icons_are_in_the_book_s_small_font(visit):
    icons = sorted({*visit.page.evaluate(ICONS), *"\uf186\uf042\uf185"})  # themes
    assert len(icons) > (5 if "search" in visit.page.url else 10)
    whole = TTFont(HTML / "_static/vendor/fontawesome/webfonts/fa-solid-900.ttf")
    expected = [whole["hmtx"][whole.getBestCmap()[ord(icon)]][0] for icon in icons]
    assert visit.page.evaluate(WIDTHS, icons) == expected


def test_code_without_a_class_has_the_colour_of_code(visit):
    for bare, coloured in visit.page.evaluate(COLOURS):
        assert bare == coloured


def test_axe_finds_nothing_serious(visit):
    visit.page.set_viewport_size(SIZES["wide"])
    visit.page.add_style_tag(
        content="* { animation: none !important; transition: none !important }"
    )
    visit.page.add_script_tag(path=AXE)
    found = visit.page.evaluate(BAD)
    assert not found, "\n".join(found)


def test_axe_would_notice(browser):
    """The test above means something: a button without a name is found."""
    reader = Reader(browser, "light", "wide", "file:")
    page = reader.open((HTML / "notation.html").as_uri())
    page.evaluate("document.querySelector('article').append(document.createElement('button'))")
    page.add_script_tag(path=AXE)
    assert any(found.startswith("button-name") for found in page.evaluate(BAD))
    reader.context.close()


def test_it_weighs_no_more_than_three_megabytes(visit):
    for stub in visit.page.locator(".arm-explorer").all():
        stub.scroll_into_view_if_needed()
        stub.locator("section.explorer").wait_for()
    visit.page.wait_for_load_state("networkidle")
    files = {Path(unquote(urlparse(url).path)) for url in visit.asked if url.startswith("file:")}
    assert sum(file.stat().st_size for file in files) <= 3_000_000


def test_over_http_nothing_else_is_asked_for(browser):
    handler = partial(SimpleHTTPRequestHandler, directory=HTML)
    handler.log_message = lambda *_: None
    SimpleHTTPRequestHandler.log_message = lambda *_: None
    server = ThreadingHTTPServer(("127.0.0.1", 0), handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    address = f"http://127.0.0.1:{server.server_port}"
    reader = Reader(browser, "light", "wide", address)
    page = reader.open(f"{address}/01_dh_tables.html")
    page.wait_for_load_state("networkidle")
    assert page.evaluate(UNRENDERED) == []
    assert reader.troubles == []
    reader.context.close()
    server.shutdown()


SHIFTS = """window.shifts = 0; new PerformanceObserver(list => {
    for (const shift of list.getEntries()) window.shifts += shift.value;
}).observe({ type: "layout-shift", buffered: true })"""


def test_lines_hardly_move_when_late_formulas_are_set(browser):
    reader = Reader(browser, "light", "phone", "file:", device_scale_factor=1.75, is_mobile=True)
    reader.page.add_init_script(SHIFTS)

    def late(route):
        reader.page.wait_for_timeout(500)
        route.continue_()

    reader.page.route("**/mathjax/startup.js*", late)
    page = reader.open((HTML / "03_circle_tracing.html").as_uri())
    assert page.evaluate("window.shifts") < 0.05
    reader.context.close()


STATE = """() => {
    const unset = [...document.querySelectorAll("span.math, div.math")].filter(m => !m.querySelector("mjx-container"));
    const boxes = unset.map(m => m.getBoundingClientRect());
    return [boxes.filter(m => m.bottom > 0 && m.top < innerHeight).length, boxes.filter(m => m.bottom < 0).length];
}"""


def test_what_the_reader_scrolls_to_is_set_before_what_was_passed_over(browser):
    reader = Reader(browser, "light", "phone", "file:")
    slowly = reader.page.context.new_cdp_session(reader.page)
    slowly.send("Emulation.setCPUThrottlingRate", {"rate": 4})
    reader.page.goto((HTML / "01_dh_tables.html").as_uri())
    reader.page.wait_for_selector("mjx-container", state="attached")
    reader.page.evaluate("[...document.querySelectorAll('span.math')].at(-1).scrollIntoView()")
    reader.page.wait_for_function(f"!({STATE})()[0]", polling=20)
    assert reader.page.evaluate(STATE)[1] > 50, "the formulas between are still to be set"
    reader.context.close()


def test_search_finds_a_word_without_a_network(browser):
    reader = Reader(browser, "light", "wide", "file:")
    page = reader.open((HTML / "search.html").as_uri() + "?q=parallel")
    page.wait_for_selector("#search-results li a")
    titles = page.locator("#search-results li a").all_inner_texts()
    assert any(re.search("table|arm", title, re.I) for title in titles)
    assert reader.troubles == []
    reader.context.close()


def test_solutions_are_folded_and_open(browser):
    reader = Reader(browser, "light", "wide", "file:")
    page = reader.open((HTML / "01_dh_tables.html").as_uri())
    solution = page.locator(".solution.dropdown").first
    answer = solution.locator(".cell_output").first
    assert not answer.is_visible()
    solution.locator("button, summary, .toggle-button").first.click()
    answer.wait_for(state="visible")
    reader.context.close()


def test_the_theme_switch_turns_figures_too(browser):
    reader = Reader(browser, "dark", "wide", "file:")
    page = reader.open((HTML / "01_dh_tables.html").as_uri())
    drawn = page.locator(".cell_output img").first
    assert "invert" in drawn.evaluate("e => getComputedStyle(e).filter")
    # A ground of its own would be turned over with the ink and stand on the page as a grey card.
    assert drawn.evaluate("e => getComputedStyle(e).backgroundColor") == "rgba(0, 0, 0, 0)"
    page.evaluate("document.documentElement.dataset.theme = 'light'")
    assert "invert" not in drawn.evaluate("e => getComputedStyle(e).filter")
    reader.context.close()
