"""Take the README's screenshots from the built book by `python -m tools.screenshots`."""

from pathlib import Path

from playwright.sync_api import Browser, sync_playwright

from tools.browser import launch_browser

ROOT = Path(__file__).parents[1]
HTML = ROOT / "book" / "_build" / "html"
DOCS = ROOT / "docs"

# The first frame applies a change, the second has drawn it.
WAIT_TWO_FRAMES = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"


def capture_chapter(browser: Browser) -> None:
    """Capture the Panda's table with its figure in chapter 1."""
    page = browser.new_page(viewport={"width": 1280, "height": 1000}, color_scheme="light")
    page.goto((HTML / "01_dh_tables.html").as_uri())
    page.evaluate("document.querySelector('#fig-panda-home').scrollIntoView()")
    page.wait_for_function("document.fonts.status === 'loaded'")
    page.screenshot(path=DOCS / "screenshot.png")
    page.close()


def capture_explorer(browser: Browser) -> None:
    """Capture an explorer in chapter 5 that lists all joint vectors of a pose."""
    page = browser.new_page(viewport={"width": 720, "height": 1000}, color_scheme="light")
    page.goto((HTML / "05_inverse_kinematics.html").as_uri())
    # The card is taller than the window, so a fixed bar would cover part of it.
    page.add_style_tag(content=".bar { position: static !important }")
    explorer = page.locator(".cell .arm-explorer:not([data-figure])").first
    explorer.evaluate("(element) => element.scrollIntoView()")
    card = explorer.locator("section.explorer")
    card.locator(".labels:not([hidden])").wait_for()  # visible once WebGL has drawn
    card.get_by_role("button", name="Find the solutions for this pose").click()
    card.get_by_text("solutions for this pose.").wait_for()
    page.evaluate(WAIT_TWO_FRAMES)
    card.screenshot(path=DOCS / "explorer.png")
    page.close()


def main() -> None:
    with sync_playwright() as playwright:
        browser = launch_browser(playwright)
        capture_chapter(browser)
        capture_explorer(browser)
        browser.close()


if __name__ == "__main__":
    main()
