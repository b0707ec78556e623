"""Print the built book into a PDF by `python -m tools.pdf`.

All pages become one document in the order of the contents. Chromium then tags it for screen readers
as a whole, numbers its pages from 1 on, and keeps links between pages. Each reference names the
page it leads to, so the book is printed twice: the first print leaves room for these page numbers.
"""

import re
import sys
from html import escape
from io import BytesIO
from pathlib import Path

from playwright.sync_api import Browser, Page, sync_playwright
from pypdf import PdfReader

from tools.browser import NoBrowser, launch_browser

ROOT = Path(__file__).parents[1]
HTML = ROOT / "book" / "_build" / "html"
LEFT_OUT = {"explorer"}  # an interactive page, of no use on paper
MARGINS = {"top": "18mm", "bottom": "20mm", "left": "17mm", "right": "17mm"}
SCALE = 0.86
VIEWPORT = {"width": 770, "height": 1100}  # A4 without the margins, in pixels at SCALE
FOOTER = (
    '<div style="font: 8px serif; width: 100%; text-align: center; color: #555">'
    'Robot homework companion · <span class="pageNumber"></span></div>'
)
LINK_PLACEHOLDER = "<!-- link to the PDF -->"
LINK = '<p><a href="book.pdf">The whole book as one PDF</a></p>'

SCRIPT = (Path(__file__).parent / "pdf.js").read_text(encoding="utf-8").strip()


def list_pages() -> list[str]:
    """Return the names of the pages in the order of the table of contents."""
    toc = (ROOT / "book" / "_toc.yml").read_text(encoding="utf-8")
    names = re.findall(r"(?:file|root): (\S+)", toc)
    return [name for name in names if name not in LEFT_OUT]


def open_print_tab(browser: Browser) -> Page:
    """Open a tab as wide as the paper, in which live figures stay still pictures."""
    tab = browser.new_page(viewport=VIEWPORT)
    tab.add_init_script("localStorage.mode = 'light'")
    tab.emulate_media(media="print", color_scheme="light")
    tab.route(re.compile(r"_static/(explorer|judge)\.js$"), lambda route: route.abort())
    return tab


def extract_article(tab: Page, name: str) -> tuple[str, list[str], str]:
    """Return a page's article as HTML, the rules of its own style elements, and its title."""
    tab.goto((HTML / f"{name}.html").as_uri())
    tab.evaluate("dispatchEvent(new Event('beforeprint'))")
    return tuple(tab.evaluate(f"(name) => {SCRIPT}.extractArticle(name)", name))


def contents_html(titles: dict[str, str]) -> str:
    """Return the table of contents of all pages but the first, without page numbers.

    pdf.js adds the numbers.
    """
    _, *names = titles
    lines = (
        f'<li><a href="#{name.replace("/", "-")}--">{escape(titles[name])}</a></li>'
        for name in names
    )
    return f"<section><h2>Contents</h2><ul>{''.join(lines)}</ul></section>"


def join_pages(browser: Browser) -> str:
    """Return all pages as a single HTML document."""
    articles, styles, titles = [], {}, {}
    tab = open_print_tab(browser)
    for name in list_pages():
        article, page_styles, titles[name] = extract_article(tab, name)
        articles.append(article)
        styles |= dict.fromkeys(page_styles)
    tab.close()
    articles[0] = articles[0].removesuffix("</article>") + contents_html(titles) + "</article>"
    link = '<link rel="stylesheet" href="_static/book.css">'
    rules = "".join(f"<style>{style}</style>" for style in styles)
    return (
        '<!DOCTYPE html><html lang="en" data-theme="light"><head><meta charset="utf-8">'
        f"<title>Robot homework companion</title>{link}{rules}</head>"
        f'<body class="printed">{"".join(articles)}</body></html>'
    )


def target_pages(pdf: bytes) -> dict[str, int]:
    """Return the page, counted from 1, of each link target in a PDF."""
    reader = PdfReader(BytesIO(pdf))
    targets = reader.named_destinations.items()
    return {
        name.lstrip("/"): reader.get_destination_page_number(target) + 1 for name, target in targets
    }


def print_with_page_numbers(tab: Page) -> bytes:
    """Return a document as PDF, with the page number after each reference.

    Raises:
        RuntimeError: The page numbers moved a target to another page.
    """

    def print_once(pages: dict[str, int]) -> bytes:
        tab.evaluate(f"(pages) => {SCRIPT}.addPageNumbers(pages)", pages)
        return tab.pdf(
            format="A4",
            scale=SCALE,
            margin=MARGINS,
            display_header_footer=True,
            header_template="<span></span>",
            footer_template=FOOTER,
            tagged=True,
            outline=True,
        )

    pages = target_pages(print_once({}))
    pdf = print_once(pages)
    moved = sorted(name for name, page in target_pages(pdf).items() if pages[name] != page)
    if moved:  # impossible if all page numbers have the same width
        raise RuntimeError(f"the second print moves {moved} to other pages")
    return pdf


def link_pdf(path: Path) -> None:
    """Insert a link to the PDF into the book's first page."""
    html = path.read_text(encoding="utf-8")
    if html.count(LINK_PLACEHOLDER) + html.count(LINK) != 1:
        raise RuntimeError(f"{path.name} has no place for the PDF's link: {LINK_PLACEHOLDER}")
    path.write_text(html.replace(LINK_PLACEHOLDER, LINK), encoding="utf-8")


def main() -> None:
    # The joined document gets an address beside the pages, so that its relative links to style
    # sheets and images work. Playwright serves it there; no file is written.
    address, result = (HTML / "_whole.html").as_uri(), HTML / "book.pdf"
    with sync_playwright() as playwright:
        try:
            browser = launch_browser(playwright)
        except NoBrowser as error:
            sys.exit(str(error))
        document = join_pages(browser)
        tab = browser.new_page(viewport=VIEWPORT)
        tab.route(
            address, lambda route: route.fulfill(body="", content_type="text/html; charset=utf-8")
        )
        tab.goto(address)
        tab.set_content(document, timeout=0)
        tab.emulate_media(media="print")
        tab.evaluate("Promise.all([...document.images].map((i) => i.decode()))")
        result.write_bytes(print_with_page_numbers(tab))
        browser.close()
    link_pdf(HTML / "intro.html")
    count = len(PdfReader(result).pages)
    print(f"{result}: {count} pages, {result.stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
