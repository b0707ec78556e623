"""Take the same steps in Firefox and WebKit: play, drag, type, search and follow a link.

Keys and pointer events are real ones, so differences between browsers show here. The other tests of
this folder take these steps in Chromium.
"""

import json
import time

import pytest

from tests.browser import engines
from tests.browser.reader import AXE, FIT_ALL_BOXES, LIST_AXE_FINDINGS
from tests.browser.test_judge import ELBOW
from tests.test_book import HTML, wait_until_built
from tools.browser import NoBrowser

INSTRUMENT = "document.querySelector('.arm-explorer:not([data-figure])')"
ROOT = f"{INSTRUMENT}.shadowRoot"
STATE = f"{INSTRUMENT}.explorer.store.state"
SHARED_LINK = "#arm=Elbow arm&q=0.6,-1.1&view=table&rows=R,0.4,0,0,0;R,0.3,0,0,0"


@pytest.fixture(scope="module", params=[engines.firefox, engines.webkit], ids=["firefox", "webkit"])
def reader(request):
    wait_until_built()
    try:
        with request.param() as engine:
            yield EngineReader(engine)
    except NoBrowser as error:
        pytest.skip(str(error))


class EngineReader:
    """Find, click and fill parts of a page in either engine."""

    def __init__(self, engine):
        self.ask, self.type, self.press, self.drag = (
            engine.ask,
            engine.type,
            engine.press,
            engine.drag,
        )
        self.engine, self.visits = engine, 0

    def open(self, name, fragment=""):
        self.visits += 1  # a fragment alone would open no new page
        self.engine.open(f"{(HTML / name).as_uri()}.html?{self.visits}{fragment}")
        # WebKit goes on too early when the page before changes its address meanwhile.
        self.until(f"location.search === '?{self.visits}'")
        # Nobody touches a blank page. Firefox reports no paint of a page whose list of pages was
        # scrolled before it.
        self.until(
            "performance.getEntriesByType('paint').length"
            " || (navigator.userAgent.includes('Firefox') && document.readyState === 'complete')"
        )

    def until(self, holds):
        """Wait until an expression is true: 600 tries, since a busy machine answers slowly."""
        for _ in range(600):
            if self.ask(f"!!({holds})"):
                return
            time.sleep(0.05)
        raise AssertionError(f"it did not become true: {holds}")

    def at(self, part):
        """Scroll a part into view and return its middle once it stands still for 0.1 s."""
        return self.ask_until_still(
            f"((part) => {{ part.scrollIntoView({{ block: 'center', behavior: 'instant' }});"
            " const { left, top, width, height } = part.getBoundingClientRect();"
            f" return [left + width / 2, top + height / 2]; }})({part})"
        )

    def ask_until_still(self, question):
        """Ask until the answer is the same 0.1 s later, and return it."""
        before = None
        while (answer := self.ask(question)) != before:
            before = answer
            time.sleep(0.1)  # two questions are often answered within one frame
        return answer

    def click(self, part):
        self.until(part)
        place = self.at(part)
        self.drag(place, place)

    def fill(self, field, text):
        self.click(field)
        self.ask(f"{field}.select()")
        self.type(text)

    def explorer(self, fragment="", name="explorer"):
        """Open a page and wait for the picture of its explorer."""
        self.open(name, fragment)
        self.until(INSTRUMENT)
        self.at(INSTRUMENT)
        self.until(f"{INSTRUMENT}.explorer && {ROOT}.querySelector('.stage .labels:not([hidden])')")


def button(words):
    return f"[...{ROOT}.querySelectorAll('button')].find((b) => b.textContent.trim() === '{words}')"


def test_intro_plays_the_circle(reader):
    reader.explorer(name="intro")
    reader.click(button("Play"))
    reader.until(f"{STATE}.progress > 0.01 && {STATE}.playing")
    assert reader.ask(
        f"Math.max(...{STATE}.q.map((v, k) => Math.abs(v - {STATE}.trace[0][k]))) > 0"
    )


def test_links_and_tip_can_be_dragged(reader):
    reader.explorer("#arm=Panda&view=pose&q=0.1,-0.4,0.3,1.6,0.2,1.9,0.4")
    start = reader.ask(f"{STATE}.q")
    for frame, moved in ((4, [3]), (-1, range(7))):
        canvas = f"{ROOT}.querySelector('.stage canvas')"
        reader.at(canvas)
        x, y = reader.ask_until_still(
            f"((c, box) => c.figure.projectToPixel({INSTRUMENT}.explorer.store.derived.frames.at({frame}).o)"
            f".map((v, k) => v + [box.left, box.top][k]))({canvas}, {canvas}.getBoundingClientRect())"
        )
        reader.drag((x, y), (x + 30, y + 15))
        has_turned = f"{STATE}.q.some((angle, k) => Math.abs(angle - {start}[k]) > 1e-6)"
        reader.until(has_turned)
        reader.until(f"!{STATE}.dragging")
        now = reader.ask(f"{STATE}.q")
        turned = [k for k in range(7) if abs(now[k] - start[k]) > 1e-6]
        assert set(turned) <= set(moved)
        start = now


def test_typed_table_moves_the_arm(reader):
    reader.explorer("#arm=Panda&view=table")
    reader.fill(f"{ROOT}.querySelector('[data-cell=\"3-a\"]')", "0.1")
    reader.until(f"{ROOT}.querySelector('.dh .verdict').textContent.includes('17.5 mm')")
    reader.until(f"{STATE}.arm.rows[2].a === 0.1")


def test_typed_jacobian_is_judged(reader):
    reader.open("check_your_homework", "#ask=jacobian&arm=ELBOW&q=0.5, 0.7, -0.4")
    told = "document.querySelector('.arm-judge .verdict')?.textContent"
    answer = "[...document.querySelectorAll('.arm-judge textarea:not([readonly])')].at(-1)"
    reader.until("!document.querySelector('.arm-judge > .unscripted')")
    reader.fill(answer, ELBOW.replace("0.2866", "0.3866"))
    reader.until(f"{told}.includes('olumn 3 (joint 3): check vz.')")
    assert reader.ask("document.querySelectorAll('.arm-judge td.off').length") == 1
    reader.fill(answer, ELBOW)
    reader.until(f"{told}.includes('is right at q = (0.5, 0.7, -0.4), to the digits you gave.')")


def test_search_lists_results(reader):
    reader.open("search")
    reader.fill("document.querySelector('form.search input')", "singularities")
    reader.until(
        "[...document.querySelectorAll('#search-results li li a')].some((a) => /singular/i.test(a.text))"
    )


def test_shared_link_opens_its_arm(reader):
    reader.explorer(SHARED_LINK)
    assert reader.ask(f"[{STATE}.arm.name, {STATE}.q]") == ["Your arm", [0.6, -1.1]]
    assert "Yours has 2 joints" in reader.ask(f"{ROOT}.textContent")


def test_dark_theme_inverts_drawings(reader):
    reader.open("robot_data")
    ground = "getComputedStyle(document.body).backgroundColor"
    drawing = "getComputedStyle(document.querySelector('figure img')).filter"
    chosen = "document.querySelector('.colours')"
    looks = set()
    for _ in range(3):
        reader.click(chosen)
        looks.add(
            (
                reader.ask("document.documentElement.dataset.mode"),
                *reader.ask(f"[{ground}, {drawing}]"),
            )
        )
    looks = {mode: rest for mode, *rest in looks}
    assert looks["light"] == ["rgb(253, 252, 250)", "none"]
    assert looks["dark"] == ["rgb(22, 25, 29)", "invert(0.92) hue-rotate(180deg)"]


def test_small_figure_follows_a_click(reader):
    reader.open("02_jacobian")
    figure = "document.querySelector('[data-figure=columns]')"
    fourth = f"{figure}.shadowRoot?.querySelectorAll('th button')[3]"
    reader.until(figure)
    reader.at(figure)
    reader.until(f"{figure}.explorer")
    reader.click(fourth)
    reader.until(f"{fourth}.ariaPressed === 'true'")


JUDGES_HAVE_STARTED = "[...document.querySelectorAll('.arm-judge')].every((form) => form.querySelector('.verdict')?.textContent)"


@pytest.mark.parametrize(
    ("name", "place", "has_started"),
    [
        ("02_jacobian", "method-2-by-hand", JUDGES_HAVE_STARTED),
        ("04_static_torque", "exercises", f"{INSTRUMENT}.explorer"),
    ],
)
def test_link_target_stays_in_place(reader, name, place, has_started):
    """A judge or an explorer that starts near the target changes the height of the page."""
    reader.open(name)
    reader.click(f"document.querySelector(`.sections a[href='#{place}']`)")
    reader.until(has_started)
    top = f"document.getElementById('{place}').getBoundingClientRect().top"
    reader.until(f"Math.abs({top} - 76) < 10")


def test_end_key_scrolls_to_the_end(reader):
    reader.open("02_jacobian")
    reader.press("End")
    reader.until("scrollY + innerHeight > document.body.scrollHeight - 2")


def test_scroll_with_late_event_stands(reader):
    """On a busy machine the event of a scroll comes late. The page does not undo the scroll meanwhile."""
    reader.open("glossary")
    stop_events = "addEventListener('scroll', (event) => event.stopImmediatePropagation(), true)"
    reader.ask(
        "addEventListener('scroll', () => {"
        f" {stop_events}; scrollTo(0, 600); setTimeout(() => (window.place = scrollY), 500);"
        "}, { once: true }), scrollTo(0, 300)"
    )
    reader.until("window.place !== undefined")
    assert reader.ask("place") == 600


@pytest.mark.parametrize("name", ["intro", "04_static_torque", "explorer", "check_your_homework"])
def test_page_passes_axe(reader, name):
    """Chromium passes axe on all pages in both themes in test_pages.py."""
    if name in {"intro", "explorer"}:
        reader.explorer(name=name)
    else:
        reader.open(name)
        reader.until("!document.querySelector('.arm-judge:not(.small) > .unscripted')")
    reader.ask(FIT_ALL_BOXES)
    reader.ask(f"(0, eval)({json.dumps(AXE.read_text(encoding='utf-8'))}) && false")
    reader.ask(f"(({LIST_AXE_FINDINGS})().then((found) => (window.axeFindings = found)), true)")
    reader.until("window.axeFindings")
    assert reader.ask("axeFindings") == []
