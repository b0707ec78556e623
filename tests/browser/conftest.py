"""A Chromium with no network. Where none is found tests are skipped; in CI that is a failure."""

import os

import pytest
from playwright.sync_api import expect, sync_playwright

from tests.test_book import wait_until_built
from tools.browser import NoBrowser, launched

expect.set_options(timeout=30_000)  # as long as Playwright waits for a button


@pytest.fixture(scope="session")
def browser():
    wait_until_built()
    with sync_playwright() as playwright:
        try:
            # Smooth edges are drawn by the processor, and are half of what it draws.
            chromium = launched(playwright, "--webgl-antialiasing-mode=none")
        except NoBrowser as error:
            if os.environ.get("CI"):
                raise
            pytest.skip(str(error))
        yield chromium
        chromium.close()
