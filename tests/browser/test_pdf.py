"""Test the pages of the PDF: their text, their links and their number."""

import re

import pytest
from playwright.sync_api import expect

from tests.test_book import HTML
from tools import pdf

SCREEN = re.compile(
    r"[^.\n]*\b(JavaScript|mouse|click\w*|slider\w*|[Dd]rag(?! at)\w*|hover|scroll\w*|[Uu]nfold\w*"
    r"|type over|[Cc]opy (?:all|LaTeX|SymPy|NumPy|MATLAB)|buttons? |folded under|form below|live in this page|[Pp]ress (?:Play|Draw|Back|Find)|Point at)[^.\n]*"
)


@pytest.fixture(scope="module")
def paper(browser):
    page = pdf.open_print_tab(browser)
    yield page
    page.close()


@pytest.mark.parametrize("name", pdf.list_pages())
def test_pdf_mentions_neither_mouse_nor_script(paper, name):
    pdf.extract_article(paper, name)
    text = paper.inner_text("article")
    assert len(text) > 500
    assert [match[0].strip() for match in SCREEN.finditer(text)] == []


def test_pdf_reference_leads_to_its_title(browser):
    """A title can move to the next page while its section starts on the page before."""
    page = browser.new_page()
    page.set_content(
        "<article><p style='height: 900px'></p><section id='a'><span id='b'></span>"
        "<h2 style='margin-top: 3rem; break-after: avoid'>Title</h2>"
        "<div style='height: 300px; break-inside: avoid'></div></section>"
        "<a href='#t--a'>one</a> <a href='#t--b'>two</a></article><h1>T</h1>"
    )
    page.evaluate("document.querySelector('article').append(document.querySelector('h1'))")
    page.evaluate(f"(name) => {pdf.SCRIPT}.extractArticle(name)", "t")
    assert pdf.target_pages(page.pdf(format="A4")) == {"t--a": 2, "t--b": 2}
    page.close()


def test_check_page_prints_question_answer_and_verdict(browser):
    page = browser.new_page(offline=True)
    page.goto((HTML / "check_your_homework.html").as_uri())
    page.locator(".arm-judge .verdict .headline").wait_for()
    page.emulate_media(media="print")
    form = page.locator(".arm-judge")
    for label in ("Question", "Arm", "Your answer"):
        expect(form.get_by_label(label, exact=True)).to_be_visible()
    expect(form.locator(".verdict")).to_contain_text("is not right")
    expect(form.locator("button").locator("visible=true")).to_have_count(0)
    answer = form.get_by_label("Your answer", exact=True)
    assert answer.evaluate("(field) => field.scrollHeight - field.clientHeight") <= 1
    page.close()


@pytest.mark.parametrize(
    "name",
    ["02_jacobian", "03_circle_tracing", "04_static_torque", "further/limits"],
)
def test_picture_takes_at_most_a_third_of_a_printed_page(paper, name):
    """A page is blank before a picture that does not fit on it."""
    paper.goto((HTML / f"{name}.html").as_uri())
    paper.wait_for_function(
        "[...document.images].every((i) => ((i.loading = 'eager'), i.complete))"
    )
    heights = paper.locator("figure, .arm-explorer").evaluate_all(
        "(parts) => parts.map((part) => part.getBoundingClientRect().height)"
    )
    assert max(heights) < pdf.VIEWPORT["height"] / 3


def test_pdf_has_the_pages_of_the_book():
    assert {*pdf.list_pages(), *pdf.LEFT_OUT} == {
        str(path.relative_to(HTML).with_suffix(""))
        for path in HTML.rglob("*.html")
        if path.stem not in {"index", "search", "genindex", "second_way"}  # an address that moved
    }
