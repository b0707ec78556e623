"""Print the built book into one PDF, pages in the order of its contents: `python tools/pdf.py`."""

import io
import re
import sys
from pathlib import Path

from playwright.sync_api import Browser, sync_playwright
from pypdf import PdfReader, PdfWriter

ROOT = Path(__file__).parents[1]
HTML = ROOT / "book" / "_build" / "html"
LINK = '<p class="pdf-link"><a href="book.pdf">The whole book as one PDF</a></p>'
PAPER = {"top": "18mm", "bottom": "20mm", "left": "17mm", "right": "17mm"}
SHEET = {"width": 770, "height": 1100}  # what is left of A4 between the margins, at the scale below
FOOT = (
    '<div style="font-size:8px;width:100%;text-align:center;color:#555">{} · <span'
    ' class="pageNumber"></span></div>'
)

# Links to other pages would hold this machine's paths; folded solutions are opened; wide formulas
# shrink to the paper.
PREPARE = """() => {
    document.querySelectorAll("a[href]").forEach((a) => {
        if (a.protocol === "file:" && a.pathname !== location.pathname) a.removeAttribute("href");
    });
    document.querySelectorAll("img").forEach((i) => (i.loading = "eager"));
    document.querySelectorAll("details").forEach((d) => (d.open = true));
    document.querySelectorAll(".toggle-hidden").forEach((e) => e.classList.remove("toggle-hidden"));
    document.querySelectorAll("div.math > mjx-container").forEach((m) => {
        const wide = m.querySelector("mjx-math").getBoundingClientRect().width;
        const room = m.parentElement.clientWidth / (wide + 60);
        if (room < 1) m.style.fontSize = `${Math.floor(room * parseFloat(m.style.fontSize))}%`;
    });
}"""


def names() -> list[str]:
    """The pages in the order of the table of contents."""
    contents = (ROOT / "book" / "_toc.yml").read_text(encoding="utf-8")
    return re.findall(r"(?:file|root): (\S+)", contents)


def printed(browser: Browser, name: str) -> tuple[str, bytes]:
    """A page's title and its PDF, as a reader would print it in light mode."""
    page = browser.new_page(viewport=SHEET)
    page.goto((HTML / f"{name}.html").as_uri())
    page.wait_for_function(
        "!window.MathJax || (window.MathJax.startup?.promise?.then(() => true) ?? false)"
    )
    page.emulate_media(media="print")
    page.evaluate(PREPARE)
    page.evaluate("Promise.all([...document.images].map((i) => i.decode()))")
    title = page.locator("article h1").first.inner_text().rstrip("#\n ")
    foot = FOOT.format(title)
    data = page.pdf(
        format="A4",
        scale=0.86,
        margin=PAPER,
        display_header_footer=True,
        header_template="<span></span>",
        footer_template=foot,
    )
    page.close()
    return title, data


def joined(parts: list[tuple[str, bytes]], path: Path) -> int:
    """Write the parts as one document with a bookmark for each; the number of its pages."""
    writer = PdfWriter()
    for title, data in parts:
        writer.append(PdfReader(io.BytesIO(data)), outline_item=title, import_outline=False)
    writer.compress_identical_objects()
    writer.add_metadata({"/Title": "Robot homework companion"})
    writer.write(path)
    return len(writer.pages)


def link(path: Path) -> None:
    """Link the PDF from the first page, now that there is one."""
    html = path.read_text(encoding="utf-8")
    if LINK not in html:
        before, start, article = html.partition("<article")
        article = article.replace("</h1>", f"</h1>\n{LINK}", 1)
        path.write_text(before + start + article, encoding="utf-8")


def main() -> None:
    sys.path.insert(0, str(ROOT))
    from tests.browser.conftest import launched

    with sync_playwright() as playwright:
        browser = launched(playwright)
        parts = [printed(browser, name) for name in names()]
        browser.close()
    pages = joined(parts, HTML / "book.pdf")
    link(HTML / "intro.html")
    size = (HTML / "book.pdf").stat().st_size / 1e6
    print(f"{HTML / 'book.pdf'}: {pages} pages, {size:.1f} MB")


if __name__ == "__main__":
    main()
