"""Test narrow screens: the links of the bar do not touch, and the name of an arm is readable."""

from itertools import pairwise

from tests.browser.reader import SCROLL_INTO_VIEW
from tests.test_book import HTML

LIST_LINK_ENDS = """() => [...document.querySelectorAll(".bar-links a")].map(link => {
    const words = document.createRange();
    words.selectNodeContents(link);
    const { left, right } = words.getBoundingClientRect();
    return [left, right];
})"""


def test_bar_links_do_not_overlap(browser):
    page = browser.new_page()
    page.goto((HTML / "where.html").as_uri())
    for width in (320, 360, 390):
        page.set_viewport_size({"width": width, "height": 700})
        ends = page.evaluate(LIST_LINK_ENDS)
        assert len(ends) == 3
        assert all(right + 5 < left for (_, right), (left, _) in pairwise(ends)), width
        assert ends[-1][1] < width
    page.close()


def test_arm_list_shows_a_name_on_phone(browser):
    page = browser.new_page(viewport={"width": 390, "height": 844})
    page.goto((HTML / "03_circle_tracing.html").as_uri())
    instrument = page.locator(".cell .arm-explorer:not([data-figure])").first
    instrument.evaluate(SCROLL_INTO_VIEW)
    instrument.locator("canvas").wait_for()  # the live list has replaced the still list
    arms = page.locator("section.explorer select.name").first
    arms.wait_for()
    assert arms.evaluate("list => list.getBoundingClientRect().width") > 120
    page.close()
