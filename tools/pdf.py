"""Print the built book into one PDF: `python -m tools.pdf`.

All pages become one document, in the order of the contents, so that Chromium tags it for screen
readers as a whole, numbers its pages through, and links lead from page to page. A reference says to
which page it leads: the book is printed twice, first with room for these numbers.
"""

import re
import sys
from html import escape
from io import BytesIO
from pathlib import Path

from playwright.sync_api import Browser, Page, sync_playwright
from pypdf import PdfReader

from tools.browser import NoBrowser, launched

ROOT = Path(__file__).parents[1]
HTML = ROOT / "book" / "_build" / "html"
ALONE = {"explorer"}  # an instrument, which is nothing on paper
PAPER = {"top": "18mm", "bottom": "20mm", "left": "17mm", "right": "17mm"}
SHEET = {"width": 770, "height": 1100}  # what is left of A4 between the margins, at the scale below
FOOT = (
    '<div style="font: 8px serif; width: 100%; text-align: center; color: #555">'
    'Robot homework companion · <span class="pageNumber"></span></div>'
)
PLACE, LINK = "<!-- link to the PDF -->", '<p><a href="book.pdf">The whole book as one PDF</a></p>'

SCRIPT = (Path(__file__).parent / "pdf.js").read_text(encoding="utf-8").strip()


def names() -> list[str]:
    """The pages in the order of the table of contents."""
    contents = (ROOT / "book" / "_toc.yml").read_text(encoding="utf-8")
    found = re.findall(r"(?:file|root): (\S+)", contents)
    return [name for name in found if name not in ALONE]


def reader(browser: Browser) -> Page:
    """A page of paper's width on which no arm comes to life."""
    page = browser.new_page(viewport=SHEET)
    page.add_init_script("localStorage.mode = 'light'")
    page.emulate_media(media="print", color_scheme="light")
    page.route(re.compile(r"_static/(explorer|judge)\.js$"), lambda route: route.abort())
    return page


def part(page: Page, name: str) -> tuple[str, list[str], str]:
    """A page of the book as a part of the whole, the style sheets that it made for itself, and its
    title."""
    page.goto((HTML / f"{name}.html").as_uri())
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    return tuple(page.evaluate(f"(name) => {SCRIPT}.take(name)", name))


def contents(titles: dict[str, str]) -> str:
    """What comes after the first page; `number` in pdf.js says where."""
    _, *rest = titles
    lines = (
        f'<li><a href="#{name.replace("/", "-")}--">{escape(titles[name])}</a></li>'
        for name in rest
    )
    return f"<section><h2>Contents</h2><ul>{''.join(lines)}</ul></section>"


def whole(browser: Browser) -> str:
    """All pages as one HTML document."""
    articles, styles, titles = [], {}, {}
    page = reader(browser)
    for name in names():
        article, sheets, titles[name] = part(page, name)
        articles.append(article)
        styles |= dict.fromkeys(sheets)
    page.close()
    articles[0] = articles[0].removesuffix("</article>") + contents(titles) + "</article>"
    link = '<link rel="stylesheet" href="_static/book.css">'
    rules = "".join(f"<style>{style}</style>" for style in styles)
    return (
        '<!DOCTYPE html><html lang="en" data-theme="light"><head><meta charset="utf-8">'
        f"<title>Robot homework companion</title>{link}{rules}</head>"
        f'<body class="printed">{"".join(articles)}</body></html>'
    )


def places(data: bytes) -> dict[str, int]:
    """The page, counted from 1, on which each place that a link leads to stands."""
    reader = PdfReader(BytesIO(data))
    found = reader.named_destinations.items()
    return {name.lstrip("/"): reader.get_destination_page_number(at) + 1 for name, at in found}


def printed(page: Page) -> bytes:
    """The document with the page of each reference."""

    def once(pages: dict[str, int]) -> bytes:
        page.evaluate(f"(pages) => {SCRIPT}.number(pages)", pages)
        return page.pdf(
            format="A4",
            scale=0.86,
            margin=PAPER,
            display_header_footer=True,
            header_template="<span></span>",
            footer_template=FOOT,
            tagged=True,
            outline=True,
        )

    known = places(once({}))
    data = once(known)
    moved = sorted(name for name, number in places(data).items() if known[name] != number)
    if moved:  # a number takes the same room whatever it is
        raise RuntimeError(f"the second print moves {moved} to other pages")
    return data


def link(path: Path) -> None:
    """Link the PDF from the first page, now that there is one."""
    html = path.read_text(encoding="utf-8")
    if html.count(PLACE) + html.count(LINK) != 1:
        raise RuntimeError(f"{path.name} has no place for the PDF's link: {PLACE}")
    path.write_text(html.replace(PLACE, LINK), encoding="utf-8")


def main() -> None:
    # Where the pages are, so that what they name is found, but only in the browser.
    together, result = (HTML / "_whole.html").as_uri(), HTML / "book.pdf"
    with sync_playwright() as playwright:
        try:
            browser = launched(playwright)
        except NoBrowser as error:
            sys.exit(str(error))
        document = whole(browser)
        page = browser.new_page(viewport=SHEET)
        page.route(
            together, lambda route: route.fulfill(body="", content_type="text/html; charset=utf-8")
        )
        page.goto(together)
        page.set_content(document, timeout=0)
        page.emulate_media(media="print")
        page.evaluate("Promise.all([...document.images].map((i) => i.decode()))")
        result.write_bytes(printed(page))
        browser.close()
    link(HTML / "intro.html")
    pages = len(PdfReader(result).pages)
    print(f"{result}: {pages} pages, {result.stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
