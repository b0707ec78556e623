"""Share one Chromium without network; without it tests are skipped, and fail in CI."""

import os

import pytest
from playwright.sync_api import expect, sync_playwright

from tests.test_book import wait_until_built
from tools.browser import NoBrowser, launch_browser

expect.set_options(timeout=30_000)  # the time that Playwright also waits for a button


@pytest.fixture(scope="session")
def browser():
    wait_until_built()
    with sync_playwright() as playwright:
        try:
            # Antialiasing would double the time of drawing, which the processor does here.
            chromium = launch_browser(playwright, "--webgl-antialiasing-mode=none")
        except NoBrowser as error:
            if os.environ.get("CI"):
                raise
            pytest.skip(str(error))
        yield chromium
        chromium.close()
