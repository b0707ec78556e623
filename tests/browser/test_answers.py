"""Test the answer sheets in a browser: complete on paper, with code blocks that can be copied."""

from io import BytesIO

import pytest
from playwright.sync_api import expect
from pypdf import PdfReader

from answers import make_html_sheet
from helpers.robots import ELBOW
from tests.test_book import HTML


@pytest.mark.parametrize("scripts", [True, False])
def test_answers_open_for_printing_only(browser, scripts):
    context = browser.new_context(offline=True, java_script_enabled=scripts)
    page = context.new_page()
    page.goto((HTML / "answers/elbow.html").as_uri())
    page.emulate_media(media="print")
    text = "".join(sheet.extract_text() for sheet in PdfReader(BytesIO(page.pdf())).pages)
    answers = page.locator("details.answer")
    expect(answers).to_have_count(16)
    assert text.count("In numbers:") == 16
    expect(page.locator("details.answer[open]")).to_have_count(0)
    cut = "all => all.filter((one) => getComputedStyle(one).overflow !== 'visible').length"
    assert page.locator(".display").evaluate_all(cut) == 0, "a bracket that is cut off"
    context.close()


@pytest.fixture(scope="module")
def sheet(browser):
    context = browser.new_context(offline=True)
    context.grant_permissions(["clipboard-read", "clipboard-write"])
    page = context.new_page()
    page.goto((HTML / "answers/ur10e.html").as_uri())
    yield page
    context.close()


def test_copied_block_runs(sheet, capsys):
    sheet.locator("#det-j summary").click()
    sheet.locator("#det-j").get_by_role("button", name="Copy NumPy").click()
    sheet.get_by_text("NumPy copied.").wait_for()
    exec(sheet.evaluate("navigator.clipboard.readText()"), names := {})
    assert float(capsys.readouterr().out) == names["det_J"] != 0


def test_all_blocks_open_and_copy_together(sheet):
    sheet.get_by_role("button", name="Open all answers").click()
    expect(sheet.locator("details.answer:not([open])")).to_have_count(0)
    sheet.get_by_role("button", name="Copy all as SymPy").click()
    sheet.get_by_text("SymPy copied.").wait_for()
    exec(sheet.evaluate("navigator.clipboard.readText()"), names := {})
    assert names["J"].shape == (6, 6)
    assert {"A_6", "T_06", "o_6", "z_6", "det_J", "P", "G"} <= set(names)


def test_block_without_clipboard_is_selected(browser, tmp_path):
    """An older browser or a page in a frame has no clipboard."""
    page = browser.new_page(offline=True)
    page.add_init_script(
        "Object.defineProperty(navigator, 'clipboard', { value: undefined });"
        "addEventListener('copy', () => { window.copied = document.activeElement.value })"
    )
    (tmp_path / "sheet.html").write_text(make_html_sheet(ELBOW), encoding="utf-8")
    page.goto((tmp_path / "sheet.html").as_uri())
    page.locator("#a-1 summary").click()
    page.locator("#a-1").get_by_role("button", name="Copy MATLAB").click()
    page.get_by_text("MATLAB copied.").wait_for()
    assert page.evaluate("window.copied").endswith("0, 0, 0, 1;\n];")
    page.close()
