"""A Chromium with no network. Where none is found tests are skipped; in CI that is a failure."""

import os

import pytest
from playwright.sync_api import Error, expect, sync_playwright

from tests.test_book import wait_until_built
from tools.browser import NAMES, launched

expect.set_options(timeout=30_000)  # as long as Playwright waits for a button


@pytest.fixture(scope="session")
def browser():
    wait_until_built()
    with sync_playwright() as playwright:
        try:
            # Smooth edges are drawn by the processor, and are half of what it draws.
            chromium = launched(playwright, "--webgl-antialiasing-mode=none")
        except Error as error:
            if os.environ.get("CI"):
                raise
            pytest.skip(f"no Chromium found ({', '.join(NAMES)}): {str(error).splitlines()[0]}")
        yield chromium
        chromium.close()
