"""No page has a serious or critical violation that axe can find, in either theme, with everything unfolded."""

from pathlib import Path

import pytest

from tests.browser.test_pages import Reader
from tests.test_book import HTML, NAMES

AXE = Path(__file__).parent / "axe" / "axe.min.js"
BAD = """() => axe.run(document, {resultTypes: ["violations"]}).then(found => found.violations
    .filter(v => ["serious", "critical"].includes(v.impact))
    .map(v => `${v.id}: ` + v.nodes.slice(0, 3).map(n => n.html.slice(0, 160)).join(" | ")))"""


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("name", [*NAMES, "search"])
def test_axe_finds_nothing_serious(browser, name, theme):
    reader = Reader(browser, theme, "wide", "file:")
    page = reader.open((HTML / f"{name}.html").as_uri())
    page.add_style_tag(content="* { animation: none !important; transition: none !important }")
    page.evaluate("document.querySelectorAll('details').forEach(d => d.open = true)")
    page.add_script_tag(path=AXE)
    found = page.evaluate(BAD)
    assert not found, "\n".join(found)
    reader.context.close()


def test_axe_would_notice(browser):
    """The other tests mean something: a button without a name is found."""
    reader = Reader(browser, "light", "wide", "file:")
    page = reader.open((HTML / "notation.html").as_uri())
    page.evaluate("document.querySelector('article').append(document.createElement('button'))")
    page.add_script_tag(path=AXE)
    assert any(found.startswith("button-name") for found in page.evaluate(BAD))
    reader.context.close()
