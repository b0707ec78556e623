"""Test what readers do in the book: scroll, search, choose a theme, load pages slowly or by HTTP."""

import json
import re
import threading
import time
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer

import pytest
from playwright.sync_api import expect

from tests.browser.reader import (
    ADD_UP_LAYOUT_SHIFTS,
    FIT_ALL_BOXES,
    SIZES,
    TWO_FRAMES,
    Reader,
    find_box,
    keep_first_typeface,
    load_with_storage,
    read_storage,
)
from tests.searches import SEARCHES, STUDENT_SEARCHES, TERM_SEARCHES
from tests.test_book import HTML
from tools.answers import PAGES


def test_page_requests_no_other_host(browser):
    handler = partial(SimpleHTTPRequestHandler, directory=HTML)
    SimpleHTTPRequestHandler.log_message = lambda *_: None
    server = ThreadingHTTPServer(("127.0.0.1", 0), handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    address = f"http://127.0.0.1:{server.server_port}"
    reader = Reader(browser, "light", "wide", address)
    page = reader.open(f"{address}/04_static_torque.html")
    page.wait_for_load_state("networkidle")
    assert reader.problems == []
    reader.context.close()
    server.shutdown()


IS_PAINTED = "performance.getEntriesByName('first-contentful-paint').length"
TEXT_FACES_ARE_LOADED = (
    """["1em Served serif", "600 1em Served serif"].every((face) => document.fonts.check(face))"""
)


@pytest.mark.parametrize("size", SIZES)
def test_late_fonts_shift_no_text(browser, size):
    """The text's typefaces arrive after the first paint; the one of formulas never does."""
    handler = partial(SimpleHTTPRequestHandler, directory=HTML)
    server = ThreadingHTTPServer(("127.0.0.1", 0), handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    page = browser.new_context(viewport=SIZES[size]).new_page()
    page.add_init_script(ADD_UP_LAYOUT_SHIFTS)

    def send_after_first_paint(route):
        page.wait_for_function(IS_PAINTED)
        page.evaluate(TWO_FRAMES)
        route.continue_()

    page.route("**/fonts/*.woff2", send_after_first_paint)
    page.route("**/stix/*.woff2", lambda route: route.abort())
    for name in ("errata", "glossary"):
        page.goto(f"http://127.0.0.1:{server.server_port}/{name}.html")
        page.wait_for_function(TEXT_FACES_ARE_LOADED)
        page.evaluate(TWO_FRAMES)
        assert page.evaluate("window.layoutShift") <= 0.01, name
    page.context.close()
    server.shutdown()


def test_linked_equation_is_shown_beside_its_link(browser):
    """A term of the glossary is shown as well; code can be hidden on all pages."""
    reader = Reader(browser, "light", "wide", "file:")
    page = reader.open((HTML / "02_jacobian.html").as_uri())
    preview = page.locator(".preview")
    for link, shown in (("#eq-duality", "math"), ("glossary.html#term-", "p")):
        place = page.locator(f"article a[href^='{link}']:not(.headerlink)").first
        place.evaluate("(link) => link.scrollIntoView({ block: 'center' })")
        find_box(place)  # a page that still scrolls hides what it shows
        place.hover()
        preview.locator(shown).first.wait_for()
        page.mouse.move(1, 1)
        expect(preview).to_be_hidden()
    page.get_by_role("button", name="Hide all code").click()
    expect(page.locator(".cell_input").locator("visible=true")).to_have_count(0)
    address = (HTML / "01_dh_tables.html").as_uri()
    load_with_storage(page, read_storage(page, "code"), lambda: page.goto(address))
    page.get_by_role("button", name="Show all code").click()
    page.locator(".cell_input").locator("visible=true").first.wait_for()
    assert reader.problems == []
    reader.context.close()


class SlowBarServer(SimpleHTTPRequestHandler):
    """A server that sends the parts of a page's bar a tenth of a second apart."""

    def do_GET(self):
        if not self.path.endswith(".html"):
            return super().do_GET()
        page = (HTML / self.path.lstrip("/")).read_bytes()
        before, bar, after = re.split(rb'(?=<header class="bar")|(?<=</header>)', page, maxsplit=2)
        self.send_response(200)
        self.end_headers()
        for piece in (before, *re.split(rb"(?=\n  <)", bar), after):
            self.wfile.write(piece)
            time.sleep(0.1)


@pytest.mark.parametrize("size", ["wide", "phone"])
def test_slowly_loaded_bar_does_not_shift(browser, size):
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(SlowBarServer, directory=HTML))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    address = f"http://127.0.0.1:{server.server_port}"
    reader = Reader(browser, "light", size, address)
    reader.page.add_init_script(ADD_UP_LAYOUT_SHIFTS)
    keep_first_typeface(reader.page)
    reader.page.goto(f"{address}/glossary.html")
    expect(reader.page.locator(".bar-links")).to_be_visible()
    assert reader.page.evaluate("window.layoutShift") < 0.001
    reader.context.close()
    server.shutdown()


# True once the text is painted in the book's typeface.
TEXT_IS_PAINTED = """performance.getEntriesByName('first-contentful-paint').length &&
    ["1em Source Serif", "600 1em Source Serif"].every((face) => document.fonts.check(face))"""


def test_late_math_font_hardly_shifts_lines(browser):
    reader = Reader(browser, "light", "phone", "file:", device_scale_factor=1.75, is_mobile=True)
    reader.page.add_init_script(ADD_UP_LAYOUT_SHIFTS)

    def late(route):
        reader.page.wait_for_function(TEXT_IS_PAINTED)
        reader.page.evaluate(TWO_FRAMES)
        reader.page.evaluate("window.layoutShift = 0")  # leave out shifts by the text's typeface
        route.continue_()

    reader.page.route("**/stix/*.woff2", late)
    for name in ("03_circle_tracing", "glossary"):
        reader.page.goto((HTML / f"{name}.html").as_uri())
        reader.page.wait_for_function("document.fonts.check('1em STIX Two Math')")
        assert reader.page.evaluate("window.layoutShift") < 0.12, name  # the glossary 0.11
    reader.context.close()


# On the screen, and wider than its place without saying so.
LIST_UNMARKED_WIDE_BOXES = """() => [...document.querySelectorAll(".display, div.table, pre")].filter((box) => {
    const { top, bottom } = box.getBoundingClientRect();
    return box.checkVisibility() && bottom > 0 && top < innerHeight && box.scrollWidth > box.clientWidth + 1 && !box.matches(".scrolls");
})"""


def test_boxes_are_ready_when_scrolled_to(browser):
    """The other tests fit all boxes at once by an event; this one does not."""
    reader = Reader(browser, "light", "phone", "file:")
    page = reader.page
    page.goto((HTML / "05_inverse_kinematics.html").as_uri())
    places = page.locator("article > section > section").count()
    assert places > 5
    for k in range(places):
        page.evaluate(
            f"document.querySelectorAll('article > section > section')[{k}].scrollIntoView()"
        )
        page.wait_for_function(f"!({LIST_UNMARKED_WIDE_BOXES})().length", polling=50)
    assert reader.problems == []
    reader.context.close()


@pytest.mark.parametrize("size", SIZES)
def test_scrollbar_is_true_at_load(browser, size):
    """The page is laid out whole: fitting wide formulas hardly changes its height."""
    reader = Reader(browser, "light", size, "file:")
    page = reader.page
    keep_first_typeface(page)
    page.goto((HTML / "02_jacobian.html").as_uri())
    height = page.evaluate("document.body.scrollHeight")
    page.evaluate(FIT_ALL_BOXES)
    page.evaluate(TWO_FRAMES)
    assert abs(page.evaluate("document.body.scrollHeight") - height) < 0.02 * height
    reader.context.close()


def test_link_and_reload_reach_a_far_section(browser):
    reader = Reader(browser, "light", "phone", "file:")
    page, place = reader.page, "#exercises"
    page.goto((HTML / "05_inverse_kinematics.html").as_uri())
    page.evaluate(f"document.querySelector(`.sections a[href='{place}']`).click()")
    page.evaluate(TWO_FRAMES)
    assert 0 < find_box(page.locator(place))["y"] < 100
    page.reload()
    assert 0 < find_box(page.locator(place))["y"] < 100
    reader.context.close()


def test_end_key_scrolls_to_the_last_line(browser):
    """Chromium may stop 5 px short, where a section is laid out only as it is reached."""
    reader = Reader(browser, "light", "phone", "file:")
    page = reader.page
    page.goto((HTML / "05_inverse_kinematics.html").as_uri() + "#exercises")
    find_box(page.locator("#exercises"))
    page.keyboard.press("End")
    page.wait_for_function("scrollY + innerHeight > document.body.scrollHeight - 8")
    reader.context.close()


# For each search, the places of the first page that are shown.
LIST_FIRST_RESULTS = """async (searches) => {
    await indexing;
    return Object.fromEntries(searches.map((typed) => {
        const [first] = searchBook(typed);
        return [typed, (first?.entries ?? []).slice(0, MAX_SECTIONS).map(({ page, title }) => `${page}: ${title}`)];
    }));
}"""


def test_searches_bring_the_right_page_first(browser):
    """Each search for a term does, and nine of ten others. No excerpt shows a label or TeX."""
    reader = Reader(browser, "light", "wide", "file:")
    page = reader.open((HTML / "search.html").as_uri() + "?q=parallel")
    page.wait_for_selector("#search-results mark")  # of the address
    places = page.evaluate(LIST_FIRST_RESULTS, [*SEARCHES, *STUDENT_SEARCHES, *TERM_SEARCHES])
    for searches, most in ((SEARCHES, 4), (STUDENT_SEARCHES, 4), (TERM_SEARCHES, 0)):
        missed = {
            typed: places[typed]
            for typed, expected in searches.items()
            if not any(re.match(expected, place) for place in places[typed])
        }
        assert len(missed) <= most, missed
    assert not page.evaluate(r"ENTRIES.filter(({ text }) => /\bsec-|\beq-|\0/.test(text))")
    tex = r"ENTRIES.filter(({ kind, text }) => kind === 'chapter' && /\\[a-z]/.test(text))"
    assert not page.evaluate(tex)
    field = page.locator("form.search input")
    field.fill("jacobian")
    sheets = page.locator("#search-results > li.sheets")
    sheets.wait_for()
    expect(sheets.get_by_role("link"), "all answer sheets are one result").to_have_count(len(PAGES))
    field.fill("zzzz")
    page.get_by_text("Nothing in the book has these words.").wait_for()
    expect(page.locator("#search-summary a")).to_have_count(3)
    assert reader.problems == []
    reader.context.close()


def test_search_opens_by_key_and_arrows_choose(browser):
    reader = Reader(browser, "light", "wide", "file:")
    page = reader.open((HTML / "glossary.html").as_uri())
    assert "search-entries.js" not in "".join(reader.requested_urls), "nobody has searched yet"
    page.keyboard.press("/")
    page.keyboard.type("singular")
    results = page.locator(".results")
    results.get_by_role("link").first.wait_for()
    page.keyboard.press("Escape")
    expect(results).to_be_hidden()
    page.keyboard.press("Control+k")
    page.keyboard.type("jacobian")
    results.locator("mark").first.wait_for()
    page.keyboard.press("ArrowDown")
    page.keyboard.press("ArrowDown")
    page.keyboard.press("ArrowUp")
    first = results.get_by_role("link").first
    expect(first).to_be_focused()
    page.keyboard.press("Enter")
    page.wait_for_url("**/02_jacobian.html")
    assert reader.problems == []
    reader.context.close()


def test_contents_mark_the_current_and_the_read_pages(browser):
    """The first page links to the primer, and the list of pages scrolls to the current page."""
    reader = Reader(browser, "light", "wide", "file:")
    page = reader.open((HTML / "intro.html").as_uri())
    expect(page.locator(".turn .after")).to_have_attribute("href", "primer.html")
    read = {"read": json.dumps({"01_dh_tables": True, "judging": ["nothing"]})}
    load_with_storage(page, read, lambda: page.goto((HTML / "judging.html").as_uri()))
    expect(page.locator("#contents a.current[href='#']")).to_be_in_viewport(ratio=1)
    expect(page.locator("#contents .sections")).to_have_count(1)
    marks = page.locator("#contents a.read")
    expect(marks).to_have_text(["1. DH tables: from a picture to the tip’s pose"])
    page.get_by_role("button", name="Forget what I have read").click()
    expect(marks).to_have_count(0)
    reader.context.close()


BACKGROUND = "getComputedStyle(document.body).backgroundColor"


def find_figure_theme(page):
    """Return whether the first visible figure is inverted for a dark page."""
    how = "all => getComputedStyle(all.find((i) => i.offsetWidth)).filter"
    return "dark" if page.locator("figure img").evaluate_all(how) != "none" else "light"


def test_theme_follows_system_until_chosen(browser):
    context = browser.new_context(offline=True, color_scheme="dark")
    page = context.new_page()
    page.goto((HTML / "robot_data.html").as_uri())
    dark = page.evaluate(BACKGROUND)
    assert find_figure_theme(page) == "dark"
    page.emulate_media(color_scheme="light")
    page.wait_for_function(f"{BACKGROUND} !== '{dark}'")
    light = page.evaluate(BACKGROUND)
    assert find_figure_theme(page) == "light"
    button = page.locator("button.colours")
    for name in ("light", "dark"):
        button.click()
        expect(button).to_have_attribute("aria-label", f"Colours: {name}")
    assert page.evaluate(BACKGROUND) == dark, "chosen, whatever the system prefers"
    address = (HTML / "glossary.html").as_uri()
    load_with_storage(page, read_storage(page, "mode"), lambda: page.goto(address))
    assert page.evaluate(BACKGROUND) == dark, "remembered on the next page"
    page.locator("button.colours").click()
    assert page.evaluate(BACKGROUND) == light, "as the system again"
    context.close()


def test_page_without_scripts_follows_system(browser):
    context = browser.new_context(
        java_script_enabled=False, color_scheme="dark", viewport=SIZES["wide"]
    )
    page = context.new_page()
    page.goto((HTML / "04_static_torque.html").as_uri())
    expect(page.locator(".contents a", has_text="arm explorer")).to_be_visible()
    expect(page.locator("figure img").first).to_be_visible()
    solution = page.locator("details.solution").first
    answer = solution.locator(".cell_output").first
    expect(answer).to_be_hidden()
    solution.locator("summary").click()
    expect(answer).to_be_visible()
    page.goto((HTML / "explorer.html").as_uri())
    expect(
        page.get_by_role("img", name=re.compile("Still picture of the Panda")).first
    ).to_be_visible()
    card = page.locator("section.explorer").first
    ink = card.evaluate("(card) => getComputedStyle(card).color")
    assert ink == "rgb(228, 232, 237)", "the dark value of --ink in page/src/common.css"
    context.close()


def test_contents_open_and_close_on_phone(browser):
    reader = Reader(browser, "light", "phone", "file:")
    page = reader.open((HTML / "04_static_torque.html").as_uri())
    contents = page.locator("#contents")
    expect(contents).to_be_hidden()
    page.locator("button.menu").click()
    contents.locator(".sections a", has_text="Exercises").click()
    expect(contents).to_be_hidden()
    page.wait_for_url("**#exercises")
    reader.context.close()
