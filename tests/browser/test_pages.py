"""Every page as a reader meets it: from a file, with no network, wide and narrow, light and
dark."""

import re
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from urllib.parse import unquote, urlparse

import pytest

from tests.test_book import HTML, NAMES

SIZES = {
    "wide": {"width": 1280, "height": 900},
    "phone": {"width": 390, "height": 844},
}
WINDOWS = {**SIZES, "small": {"width": 320, "height": 640}}

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
    pictures.forEach(picture => (picture.loading = "eager")); // those far down too, and those of the other colours
    const loaded = await Promise.allSettled(pictures.map(picture => picture.decode()));
    return pictures.filter((picture, k) => loaded[k].status === "rejected" || !picture.naturalWidth).map(p => p.src);
}"""
# What reaches over its box or the screen without a box that scrolls, shows that it does, and can be reached by keys.
CUT = """() => {
    const article = document.querySelector("article"), edge = article.getBoundingClientRect().right + 1, found = [];
    const kept = (e) => e.closest(".scrolls.more-right, .scrolls.more-left, .panel, .arm-explorer, .arm-judge, .headerlink");
    const spoken = (node) => (node.matches?.("mjx-assistive-mml") ? NodeFilter.FILTER_REJECT : NodeFilter.FILTER_ACCEPT);
    const letters = document.createTreeWalker(article, NodeFilter.SHOW_ELEMENT | NodeFilter.SHOW_TEXT, spoken), range = document.createRange();
    while (letters.nextNode()) {
        const text = letters.currentNode;
        if (!text.data?.trim()) continue;
        range.selectNodeContents(text);
        if (range.getBoundingClientRect().right > edge && !kept(text.parentElement)) found.push(text.data);
    }
    for (const e of article.querySelectorAll("mjx-c, td, img"))
        if (e.getBoundingClientRect().right > edge && !kept(e)) found.push(e.outerHTML);
    for (const e of article.querySelectorAll(":not(mjx-container *)")) {
        if (e.scrollWidth <= e.clientWidth + 1) continue;
        const { overflowX, maskImage } = getComputedStyle(e);
        if (overflowX === "visible" || e.closest(".arm-explorer, .arm-judge, .panel")) continue;
        const said = e.matches("pre, span *") || e.nextElementSibling?.matches(".hint");
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
    const paragraphs = [...document.querySelectorAll("article > section p")].filter((p) => p.parentElement.matches("section") && p.textContent.length > 300 && !p.querySelector(".math, code"));
    return [paragraphs.map(letters), [...document.querySelectorAll(".highlight pre")].map(size)];
}"""
# All formulas are set, and the letters have come.
SET = """() => document.fonts.status === "loaded" &&
    ![...document.querySelectorAll("div.math, span.math")].some(m => !m.querySelector("mjx-container"))"""
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
# Axe finds one word of a program like the next of its look, judges no letter that stands alone, and reads no formula's
# glyphs (no text, hidden from it): none of them is left to it ten thousand times, and of each kind of empty formula one.
# What could be focused in a formula is counted here.
THINNED = f"""() => {{
    {LOOK}
    const formulas = [...document.querySelectorAll("mjx-math, mjx-assistive-mml")], seen = new Set();
    const focusable = formulas.filter(m => m.querySelector("a[href], button, input, [tabindex]")).length;
    const again = (e, kind) => (seen.has(kind) ? e.remove() : seen.add(kind));
    formulas.forEach(m => m.replaceChildren());
    for (const set of document.querySelectorAll("mjx-container")) again(set, set.outerHTML.replace(/ style="[^"]*"/, [...set.style]));
    const words = [...document.querySelectorAll("article :is(span, i, b, sub, sup, em):not(a *, button *, summary *, label *, mjx-container *)")];
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
TWO_FRAMES = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
# Formulas are set, and boxes fitted, when the reader comes near; for a printer, all at once.
EVERYTHING = "dispatchEvent(new Event('beforeprint'))"
AXE = Path(__file__).parent / "axe" / "axe.min.js"
BAD = """(part) => axe.run(part ?? document, {resultTypes: ["violations"], selectors: false}).then(found => found.violations
    .filter(v => ["serious", "critical"].includes(v.impact))
    .map(v => `${v.id}: ` + v.nodes.slice(0, 3).map(n => n.html.slice(0, 160)).join(" | ")))"""


# Where only words and numbers are asked for. What a picture shows is drawn by the processor, which costs more than all
# else of its page: the calls come to WebGL, and end there while `undrawn` holds.
UNDRAWN = """window.undrawn = true;
for (const name of ["drawArrays", "drawElements", "drawArraysInstanced", "drawElementsInstanced", "drawRangeElements"]) {
    const own = WebGL2RenderingContext.prototype[name];
    WebGL2RenderingContext.prototype[name] = function (...given) { if (!window.undrawn) own.apply(this, given); };
}"""
# MathJax is there, and never ready: formulas stay as they are written.
UNSET = """{
    let mathjax;
    const startup = { typeset: false, ready() {} };
    Object.defineProperty(window, "MathJax", {
        get: () => mathjax,
        set(given) { mathjax = Object.defineProperty(given, "startup", { value: startup }); },
    });
}"""


# A browser without a window now and then tells a new page of a pointer in its corner, which no reader has moved there.
NOBODY = """addEventListener("pointermove", (e) => e.clientX || e.clientY || e.stopImmediatePropagation(), true);"""


class Reader:
    """One visit to a page, with everything that went wrong on it."""

    def __init__(self, browser, theme, size, allowed, **context):
        self.context = browser.new_context(
            viewport=SIZES[size], offline=allowed == "file:", **context
        )
        self.page, self.theme = self.context.new_page(), theme
        self.troubles, self.asked = [], set()
        self.page.add_init_script(NOBODY + f"localStorage.mode = localStorage.theme = '{theme}'")
        self.page.on("pageerror", lambda error: self.troubles.append(f"error: {error}"))
        self.page.on("console", self._said)
        self.page.on("request", lambda r: self._asked(r.url, allowed))
        self.page.on("requestfailed", self._failed)

    def _said(self, message):
        if (
            "GPU stall due to ReadPixels" in message.text
        ):  # of a machine that draws without a graphics card
            return
        if message.type in ("error", "warning"):
            self.troubles.append(f"{message.type}: {message.text}")

    def _failed(self, request):
        if request.failure != "net::ERR_ABORTED":  # given up by a reader who went on
            self.troubles.append(f"failed: {request.url}")

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
        self.page.evaluate(EVERYTHING)
        self.page.mouse.move(
            1, 1
        )  # a reader is there: live figures come to life, and all is laid out
        return self.page


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
    page.wait_for_function(SET, polling=50)
    return reader


def test_the_page_is_whole(visit):
    assert visit.page.locator("html").get_attribute("data-theme") == visit.theme
    assert visit.page.evaluate(UNRENDERED) == []
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


def test_a_cut_would_be_noticed(visit):
    """The test above means something: without its marks, what is too wide is found."""
    resized(visit.page, "small")
    for what in ("div.math > mjx-container", "div.table", ".highlight pre"):
        cut = visit.page.query_selector(f"{what}:is(.more-right)")
        if cut:
            assert cut.evaluate(UNMARKED), what


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
        stub.scroll_into_view_if_needed()
        stub.locator("section.explorer, figure.live").wait_for()
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
    page = reader.open(f"{address}/04_static_torque.html")
    page.wait_for_load_state("networkidle")
    assert page.evaluate(UNRENDERED) == []
    assert reader.troubles == []
    reader.context.close()
    server.shutdown()


SHIFTS = """window.shifts = 0; new PerformanceObserver(list => {
    for (const shift of list.getEntries()) window.shifts += shift.value;
}).observe({ type: "layout-shift", buffered: true })"""


# The text is on the screen, in its own letters.
READ = "performance.getEntriesByName('first-contentful-paint').length && document.fonts.status === 'loaded'"


def test_lines_hardly_move_when_late_formulas_are_set(browser):
    reader = Reader(browser, "light", "phone", "file:", device_scale_factor=1.75, is_mobile=True)
    reader.page.add_init_script(SHIFTS)

    def late(route):
        reader.page.wait_for_function(READ)
        route.continue_()

    reader.page.route("**/mathjax/startup.js*", late)
    for name in ("03_circle_tracing", "notation"):
        page = reader.open((HTML / f"{name}.html").as_uri())
        assert page.evaluate("window.shifts") < 0.05, name
    reader.context.close()


STATE = """() => {
    const unset = [...document.querySelectorAll("span.math, div.math")].filter(m => !m.querySelector("mjx-container"))
        .filter(m => m.checkVisibility()); // one in a folded solution has a box, but nobody sees it
    const boxes = unset.map(m => m.getBoundingClientRect());
    return [boxes.filter(m => m.bottom > 0 && m.top < innerHeight).length, boxes.filter(m => m.bottom < 0).length, unset.length];
}"""
# On the screen, and wider than its place without saying so.
UNSAID = """() => [...document.querySelectorAll("div.math > mjx-container, div.table, .highlight pre")].filter((box) => {
    const { top, bottom } = box.getBoundingClientRect();
    return box.checkVisibility() && bottom > 0 && top < innerHeight && box.scrollWidth > box.clientWidth + 1 && !box.matches(".scrolls");
})"""


def test_what_the_reader_scrolls_to_is_set_before_what_was_passed_over(browser):
    reader = Reader(browser, "light", "phone", "file:")
    reader.page.goto((HTML / "01_dh_tables.html").as_uri())
    reader.page.wait_for_selector("mjx-container", state="attached")
    reader.page.evaluate("[...document.querySelectorAll('span.math')].at(-1).scrollIntoView()")
    left = f"() => {{ const [near, over] = ({STATE})(); return near === 0 && {{ over }}; }}"
    over = reader.page.wait_for_function(left, polling=20).json_value()["over"]
    assert over > 50, "the formulas between are still to be set"
    reader.context.close()


def test_formulas_and_boxes_are_ready_where_the_reader_scrolls(browser):
    """Without the order to make everything ready at once, which the other tests give."""
    reader = Reader(browser, "light", "phone", "file:")
    page = reader.page
    page.goto((HTML / "05_inverse_kinematics.html").as_uri())
    page.wait_for_selector("mjx-container", state="attached")
    places = page.locator("article > section > section").count()
    assert places > 5
    for k in range(places):
        page.evaluate(
            f"document.querySelectorAll('article > section > section')[{k}].scrollIntoView()"
        )
        page.wait_for_function(f"!({STATE})()[0]", polling=50)
        page.wait_for_function(f"!({UNSAID})().length", polling=50)
    assert page.evaluate(f"({STATE})()[2]") > 0, "formulas that nobody came near are not set"
    assert reader.troubles == []
    reader.context.close()


def test_a_page_is_laid_out_where_it_is_opened(browser):
    """What waits for a reader never moves the place at which a page is opened, or comes back to."""
    reader = Reader(browser, "light", "phone", "file:")
    page, fresh = reader.page, "'fresh' in document.documentElement.dataset"
    page.goto((HTML / "02_jacobian.html").as_uri())
    assert page.evaluate(fresh)
    page.mouse.move(5, 5)
    page.wait_for_function(f"!({fresh})")
    page.goto((HTML / "05_inverse_kinematics.html").as_uri() + "#sec-ur-inverse")
    assert not page.evaluate(fresh)
    page.reload()
    assert not page.evaluate(fresh)
    reader.context.close()


def test_an_arm_comes_to_life_at_the_first_sign_of_a_reader(browser):
    reader = Reader(browser, "light", "wide", "file:")
    page = reader.page
    page.goto((HTML / "intro.html").as_uri(), wait_until="networkidle")
    page.evaluate(TWO_FRAMES)  # by then it is known what is near
    assert not any(url.endswith("explorer.js") for url in reader.asked)
    page.mouse.move(400, 400)
    page.locator("section.explorer").wait_for()
    assert reader.troubles == []
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
    page = reader.open((HTML / "04_static_torque.html").as_uri())
    solution = page.locator("details.solution").first
    answer = solution.locator(".cell_output").first
    assert not answer.is_visible()
    solution.locator("summary").first.click()
    answer.wait_for(state="visible")
    reader.context.close()


GROUND = "getComputedStyle(document.body).backgroundColor"


def drawn(page):
    """The folder of the first figure that is seen."""
    pictures = page.locator("figure img").evaluate_all(
        "all => all.filter(i => i.offsetWidth).map(i => i.src)"
    )
    return pictures[0].rpartition("/")[0].rpartition("/")[2]


def test_colours_follow_the_system_until_the_reader_chooses_and_then_stay(browser):
    context = browser.new_context(offline=True, color_scheme="dark")
    page = context.new_page()
    page.goto((HTML / "robot_data.html").as_uri())
    dark = page.evaluate(GROUND)
    assert drawn(page) == "dark"
    page.emulate_media(color_scheme="light")
    page.wait_for_function(f"{GROUND} !== '{dark}'")
    light = page.evaluate(GROUND)
    assert drawn(page) == "_images"
    button = page.locator("button.colours")
    for name in ("light", "dark"):
        button.click()
        assert button.get_attribute("aria-label") == f"Colours: {name}"
    assert page.evaluate(GROUND) == dark, "chosen, whatever the system prefers"
    for _ in range(20):  # Chromium writes it down in its own time
        page.goto((HTML / "notation.html").as_uri())
        if page.evaluate(GROUND) == dark:
            break
    assert page.evaluate(GROUND) == dark, "remembered on the next page"
    button.click()
    assert page.evaluate(GROUND) == light, "as the system again"
    context.close()


def test_without_scripts_the_page_is_there_in_the_systems_colours(browser):
    context = browser.new_context(
        java_script_enabled=False, color_scheme="dark", viewport=SIZES["wide"]
    )
    page = context.new_page()
    page.goto((HTML / "04_static_torque.html").as_uri())
    assert page.locator(".contents a", has_text="arm explorer").is_visible()
    assert page.locator("figure img").first.is_visible()
    solution = page.locator("details.solution").first
    solution.locator("summary").click()
    assert solution.locator(".cell_output").first.is_visible()
    context.close()


def test_no_page_is_wider_than_a_phone_before_a_script_has_measured_it(browser):
    context = browser.new_context(
        java_script_enabled=False, offline=True, viewport=WINDOWS["small"]
    )
    page = context.new_page()
    for name in NAMES:
        page.goto((HTML / f"{name}.html").as_uri())
        assert page.evaluate("document.documentElement.scrollWidth") == 320, name
    context.close()


def test_the_contents_open_on_a_phone_and_close_after_use(browser):
    reader = Reader(browser, "light", "phone", "file:")
    page = reader.open((HTML / "04_static_torque.html").as_uri())
    contents = page.locator("#contents")
    assert not contents.is_visible()
    page.locator("button.menu").click()
    contents.locator(".sections a", has_text="Exercises").click()
    assert not contents.is_visible()
    assert page.evaluate("location.hash") == "#exercises"
    reader.context.close()
