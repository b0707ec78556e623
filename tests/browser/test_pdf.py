"""What goes on paper asks for nothing that paper cannot do."""

import re

import pytest

from tests.test_book import HTML
from tools import pdf

SCREEN = re.compile(
    r"[^.\n]*\b(JavaScript|mouse|click\w*|slider\w*|[Dd]rag(?! at)\w*|hover|scroll\w*|[Uu]nfold\w*"
    r"|type over|[Cc]opy (?:all|LaTeX|SymPy|NumPy|MATLAB)|buttons? |folded under|form below|live in this page|[Pp]ress (?:Play|Draw|Back|Find)|Point at)[^.\n]*"
)


@pytest.fixture(scope="module")
def paper(browser):
    page = pdf.reader(browser)
    yield page
    page.close()


@pytest.mark.parametrize("name", pdf.names())
def test_pdf_mentions_no_mouse_or_script(paper, name):
    pdf.part(paper, name)
    text = paper.inner_text("article")
    assert len(text) > 500
    assert [found[0].strip() for found in SCREEN.finditer(text)] == []


def test_pdf_reference_leads_to_its_title(browser):
    """A title that is moved to the next page leaves the beginning of its section behind."""
    page = browser.new_page()
    page.set_content(
        "<article><p style='height: 900px'></p><section id='a'><span id='b'></span>"
        "<h2 style='margin-top: 3rem; break-after: avoid'>Title</h2>"
        "<div style='height: 300px; break-inside: avoid'></div></section>"
        "<a href='#t--a'>one</a> <a href='#t--b'>two</a></article><h1>T</h1>"
    )
    page.evaluate("document.querySelector('article').append(document.querySelector('h1'))")
    page.evaluate(f"(name) => {pdf.SCRIPT}.take(name)", "t")
    assert pdf.places(page.pdf(format="A4")) == {"t--a": 2, "t--b": 2}
    page.close()


def test_pdf_has_the_pages_of_the_book():
    assert {*pdf.names(), *pdf.ALONE} == {
        str(path.relative_to(HTML).with_suffix(""))
        for path in HTML.rglob("*.html")
        if path.stem not in {"index", "search", "genindex"}
    }
