"""Open pages of the built book with a window size and a theme, and record what goes wrong."""

import json
from pathlib import Path

SIZES = {
    "wide": {"width": 1280, "height": 900},
    "phone": {"width": 390, "height": 844},
}
WINDOWS = {**SIZES, "small": {"width": 320, "height": 640}}

WAIT_FOR_FRAMES = (
    "(n) => new Promise((done) => (function on() { n-- ? requestAnimationFrame(on) : done(); })())"
)
TWO_FRAMES = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
# Boxes are fitted when the reader comes near; for a printer, all at once.
FIT_ALL_BOXES = "dispatchEvent(new Event('beforeprint'))"
# Scrolls to an element as a link does.
SCROLL_INTO_VIEW = "(place) => place.scrollIntoView()"
AXE = Path(__file__).parent / "axe" / "axe.min.js"
LIST_AXE_FINDINGS = """(part) => axe.run(part ?? document, {resultTypes: ["violations"], selectors: false}).then(found => found.violations
    .filter(v => ["serious", "critical"].includes(v.impact))
    .map(v => `${v.id}: ` + v.nodes.slice(0, 3).map(n => n.html.slice(0, 160)).join(" | ")))"""


# Skips the drawing calls of WebGL while `skipsDrawing` is true, for tests that read only text and numbers. Without a graphics
# card the processor draws each picture, which takes longer than the rest of the page.
SKIP_DRAWING = """window.skipsDrawing = true;
for (const name of ["drawArrays", "drawElements", "drawArraysInstanced", "drawElementsInstanced", "drawRangeElements"]) {
    const own = WebGL2RenderingContext.prototype[name];
    WebGL2RenderingContext.prototype[name] = function (...given) { if (!window.skipsDrawing) own.apply(this, given); };
}"""

# Adds up the layout shifts of the text and its figures without any input. The list of pages beside the text is left out,
# since it unfolds during reading.
ADD_UP_LAYOUT_SHIFTS = """window.layoutShift = 0;
const beside = ({ node }) => node?.parentElement?.closest(".contents, .ahead");
new PerformanceObserver((list) => list.getEntries().forEach(({ value, sources }) => {
    if (!sources.every(beside)) layoutShift += value;
})).observe({ type: "layout-shift", buffered: true });"""


# Stops the pointer event at (0, 0) that a headless browser sometimes sends to a new page.
STOP_STRAY_POINTER = """addEventListener("pointermove", (e) => e.clientX || e.clientY || e.stopImmediatePropagation(), true);"""


def keep_first_typeface(page):
    """Show all text in the fonts of the system: a typeface that arrives late would move lines."""
    page.route("**/*.woff2", lambda route: route.abort())


def until(page, holds):
    """Wait up to 900 frames until a condition holds; a busy machine draws fewer frames a second."""
    for _ in range(150):
        if holds():
            return
        page.evaluate(WAIT_FOR_FRAMES, 6)
    raise AssertionError("the condition did not hold within 900 frames")


def find_box(locator):
    """Return the box of an element once six frames leave it unchanged.

    An element that the page has just replaced has none, and a page goes on scrolling after a swipe.
    """
    boxes = []

    def is_still():
        boxes.append(locator.bounding_box())
        return len(boxes) > 1 and boxes[-1] and boxes[-1] == boxes[-2]

    until(locator.page, is_still)
    return boxes[-1]


class Reader:
    """A browser page that records its errors, warnings and requests."""

    def __init__(self, browser, theme, size, allowed, **context):
        self.context = browser.new_context(
            viewport=SIZES[size], offline=allowed == "file:", **context
        )
        self.page, self.theme = self.context.new_page(), theme
        self.problems, self.requested_urls = [], set()
        self.page.add_init_script(
            STOP_STRAY_POINTER + f"localStorage.mode = localStorage.theme = '{theme}'"
        )
        self.page.on("pageerror", lambda error: self.problems.append(f"error: {error}"))
        self.page.on("console", self._record_message)
        self.page.on("request", lambda r: self._record_request(r.url, allowed))
        self.page.on("requestfailed", self._record_failure)

    def _record_message(self, message):
        drawn = "GPU stall due to ReadPixels" in message.text  # without a graphics card
        if message.type in ("error", "warning") and not drawn:
            self.problems.append(f"{message.type}: {message.text}")

    def _record_failure(self, request):
        if request.failure != "net::ERR_ABORTED":  # given up by a reader who went on
            self.problems.append(f"failed: {request.url}")

    def _record_request(self, url, allowed):
        self.requested_urls.add(url)
        if not url.startswith((allowed, "data:", "blob:")):
            self.problems.append(f"requested {url}")

    def open(self, url):
        self.page.goto(url)
        self.page.evaluate(FIT_ALL_BOXES)
        self.page.mouse.move(1, 1)
        return self.page


def read_storage(page, prefix):
    """Return what a page has stored in the browser under keys that begin so, as a dict."""
    storage = page.evaluate("({ ...localStorage })")
    return {key: text for key, text in storage.items() if key.startswith(prefix)}


def load_with_storage(page, stored, load):
    """Load a page that finds in its storage what `read_storage` returned from another page.

    The test carries it over, since on a busy machine Chromium gives about one page in forty (14 of
    574) a storage of its own: what it writes reaches no other page.
    """
    page.add_init_script(f"Object.assign(localStorage, {json.dumps(stored)})")
    load()
