"""What goes on paper asks for nothing that paper cannot do."""

import re

import pytest

from tests.test_book import HTML
from tools import pdf

SCREEN = re.compile(
    r"[^.\n]*\b(JavaScript|mouse|click\w*|slider\w*|[Dd]rag(?! at)\w*|hover|scroll\w*|[Uu]nfold\w*"
    r"|type over|[Cc]opy (?:all|LaTeX|SymPy|NumPy|MATLAB)|buttons? |folded under|live in this page|[Pp]ress (?:Play|Draw|Back|Find)|Point at)[^.\n]*"
)


@pytest.fixture(scope="module")
def paper(browser):
    page = pdf.reader(browser)
    yield page
    page.close()


@pytest.mark.parametrize("name", pdf.names())
def test_no_sentence_asks_for_a_mouse_or_a_script(paper, name):
    article, _ = pdf.part(paper, name)
    paper.evaluate("(html) => (document.querySelector('article').outerHTML = html)", article)
    text = paper.inner_text("article")
    assert len(text) > 500
    assert [found[0].strip() for found in SCREEN.finditer(text)] == []


def test_the_pages_that_are_printed_are_those_of_the_book():
    assert {*pdf.names(), *pdf.ALONE} == {
        str(path.relative_to(HTML).with_suffix(""))
        for path in HTML.rglob("*.html")
        if path.stem not in {"index", "search", "genindex", "_whole"}
    }
