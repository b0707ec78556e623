"""Test live parts before their script has loaded, and without scripts: same height, with a picture
or a sentence."""

import re

import pytest
from playwright.sync_api import expect

from tests.browser.reader import WINDOWS
from tests.test_book import HTML, NAMES

LIVE = re.compile(r"_static/(explorer|judge)\.js$")
PARTS = ".arm-explorer, .arm-judge"
PAGES = [  # by name, since the book is built after tests are collected
    *("intro", "explorer", "check_your_homework", "own_arm", "01_dh_tables", "02_jacobian"),
    *("03_circle_tracing", "04_static_torque", "05_inverse_kinematics"),
]
MEASURE_HEIGHTS = """() => [...document.querySelectorAll(".arm-explorer")].map(
    (part) => Math.round(part.getBoundingClientRect().height))"""
# Scroll to each live part until its script has started. The page moves while its formulas are set.
WAKE_PARTS = f"""async () => {{
    const isAsleep = (part) => part.matches(".arm-explorer") ? !part.explorer
        : part.querySelector(":scope > .unscripted");
    const end = Date.now() + 20_000;
    for (const part of document.querySelectorAll("{PARTS}")) {{
        while (isAsleep(part)) {{
            part.scrollIntoView();
            if (Date.now() > end) throw new Error(`${{part.className}} did not start`);
            await new Promise(requestAnimationFrame);
        }}
    }}
}}"""
# For each figure, whether its still picture is visible.
LIST_STILL_VISIBILITY = """() => [...document.querySelectorAll(".arm-explorer")].map(({ shadowRoot }) =>
    shadowRoot.querySelector(".still").checkVisibility({ visibilityProperty: true }))"""


@pytest.fixture(scope="module")
def page(browser):
    page = browser.new_page()
    yield page
    page.close()


@pytest.mark.parametrize("name", PAGES)
def test_live_part_keeps_the_still_height(page, name):
    """The page moves at no width when a figure becomes live; a form grows below what is read."""
    address = (HTML / f"{name}.html").as_uri()
    page.route(LIVE, lambda route: route.abort())
    page.goto(address)
    before, pictures = {}, page.evaluate(LIST_STILL_VISIBILITY)
    assert all(pictures), "a picture is there at once"
    for size, window in WINDOWS.items():
        page.set_viewport_size(window)
        before[size] = page.evaluate(MEASURE_HEIGHTS)
    page.unroute(LIVE)
    page.goto(address)
    page.evaluate(WAKE_PARTS)
    for size, window in WINDOWS.items():
        page.set_viewport_size(window)
        after = page.evaluate(MEASURE_HEIGHTS)
        moved = [abs(p - q) for p, q in zip(before[size], after, strict=True)]
        assert max(moved, default=0) <= 1, (size, before[size], after)
    page.emulate_media(media="print")
    assert all(page.evaluate(LIST_STILL_VISIBILITY)), "on paper the still one"
    page.emulate_media(media="screen")


@pytest.fixture(scope="module")
def tab_without_scripts(browser):
    context = browser.new_context(
        java_script_enabled=False, offline=True, viewport=WINDOWS["small"]
    )
    yield context.new_page()
    context.close()


@pytest.fixture(scope="module", params=NAMES)
def page_without_scripts(tab_without_scripts, request):
    """Open each page once for all tests without scripts."""
    tab_without_scripts.goto((HTML / f"{request.param}.html").as_uri())
    return tab_without_scripts


def test_page_without_scripts_fits_phone(page_without_scripts):
    assert page_without_scripts.evaluate("document.documentElement.scrollWidth") == 320


# Instructions that need a script. The explorer's page has only such instructions.
INSTRUCTIONS = re.compile(
    r"[^.\n]*\b(?:[Dd]rag(?! at)\w*|Point at|[Cc]lick\w*|sliders?|[Pp]ress (?:Play|Draw|Back|Find))\b[^.\n]*"
)


@pytest.mark.parametrize(
    "page_without_scripts", [name for name in NAMES if name != "explorer"], indirect=True
)
def test_page_without_scripts_mentions_no_live_controls(page_without_scripts):
    assert INSTRUCTIONS.findall(page_without_scripts.inner_text("article")) == []


@pytest.mark.parametrize("page_without_scripts", PAGES, indirect=True)
def test_stills_are_visible_without_scripts(page_without_scripts):
    for part in page_without_scripts.locator(".arm-explorer").all():
        expect(part.locator(".still")).to_be_visible()
        expect(part.locator("button, input").locator("visible=true")).to_have_count(0)
    for form in page_without_scripts.locator(".arm-judge").all():
        expect(form.locator(".unscripted")).to_be_visible()
        expect(form.locator("textarea, button, input")).to_have_count(0)


CANVAS = "document.querySelector('.arm-explorer').shadowRoot.querySelector('.stage canvas')"
STORE = "document.querySelector('.arm-explorer').explorer.store"
LINK = f"""() => {{
    const {{ left, top }} = {CANVAS}.getBoundingClientRect();
    const [x, y] = {CANVAS}.figure.projectToPixel({STORE}.derived.frames.at(4).o);
    return [left + x, top + y];
}}"""


def open_intro_at_rest(browser):
    """Open the intro with its figure in view, and return the page and what it asked for."""
    page = browser.new_page(offline=True, viewport=WINDOWS["wide"])
    requests = []
    page.on("request", lambda request: requests.append(request.url))
    page.goto((HTML / "intro.html").as_uri())
    page.wait_for_timeout(3500)
    return page, requests


def test_intro_loads_no_explorer_before_a_hand_comes(browser):
    page, requests = open_intro_at_rest(browser)
    part = page.locator(".arm-explorer")
    expect(part.locator(".still")).to_be_in_viewport()
    assert [url for url in requests if LIVE.search(url)] == []
    part.hover()
    page.locator(".stage.drawn").wait_for()
    x, y = page.evaluate(LINK)
    before = page.evaluate(f"{STORE}.state.q")
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 40, y + 20, steps=4)
    page.mouse.up()
    page.wait_for_function(f"!{STORE}.state.dragging")
    after = page.evaluate(f"{STORE}.state.q")
    assert [k for k in range(7) if abs(after[k] - before[k]) > 1e-3] == [3]
    page.close()


def test_key_on_a_still_control_starts_the_explorer(browser):
    """The control keeps the focus, so that the next key reaches it."""
    page, _ = open_intro_at_rest(browser)
    lever = page.get_by_role("slider", name="Joint 4, angle")
    lever.focus()
    page.locator(".stage.drawn").wait_for()
    expect(lever).to_be_focused()
    before = page.evaluate(f"{STORE}.state.q[3]")
    page.keyboard.press("ArrowRight")
    page.wait_for_function(f"{STORE}.state.q[3] > {before}")
    page.close()
