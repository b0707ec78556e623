"""Take the README's pictures anew from the built book: `python -m tools.screenshots`."""

from pathlib import Path

from playwright.sync_api import Browser, sync_playwright

from tools.browser import launched

ROOT = Path(__file__).parents[1]
HTML = ROOT / "book" / "_build" / "html"
DOCS = ROOT / "docs"

# What has changed is drawn in the next frame.
DRAWN = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"


def chapter(browser: Browser) -> None:
    """The Panda's table with its picture."""
    page = browser.new_page(viewport={"width": 1280, "height": 1000}, color_scheme="light")
    page.goto((HTML / "01_dh_tables.html").as_uri())
    page.evaluate("document.querySelector('#fig-panda-home').scrollIntoView()")
    page.wait_for_function("document.fonts.status === 'loaded'")
    page.screenshot(path=DOCS / "screenshot.png")
    page.close()


def explorer(browser: Browser) -> None:
    """All ways to one pose, in the last chapter's instrument."""
    page = browser.new_page(viewport={"width": 720, "height": 1000}, color_scheme="light")
    page.goto((HTML / "05_inverse_kinematics.html").as_uri())
    stub = page.locator(".cell .arm-explorer:not([data-figure])").first
    stub.evaluate("(place) => place.scrollIntoView()")
    card = stub.locator("section.explorer")
    card.locator(".labels:not([hidden])").wait_for()  # the picture is there
    card.get_by_role("button", name="Find the ways to this pose").click()
    card.get_by_text("ways to this pose.").wait_for()
    page.evaluate(DRAWN)
    card.screenshot(path=DOCS / "explorer.png")
    page.close()


def main() -> None:
    with sync_playwright() as playwright:
        browser = launched(playwright)
        chapter(browser)
        explorer(browser)
        browser.close()


if __name__ == "__main__":
    main()
