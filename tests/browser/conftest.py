"""A Chromium with no network. Where none is found the tests are skipped; in CI that is a
failure."""

import os
import shutil

import pytest
from playwright.sync_api import Error, expect, sync_playwright

FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
]
expect.set_options(timeout=30_000)  # as long as Playwright waits for a button
NAMES = ("chromium", "chromium-browser", "google-chrome", "chrome", "msedge")


def launched(playwright):
    """A headless Chromium, Chrome or Edge; on macOS and Windows Playwright knows where Chrome is
    installed."""
    path = next(filter(None, map(shutil.which, NAMES)), None)
    where = {"executable_path": path} if path else {"channel": "chrome"}
    return playwright.chromium.launch(**where, args=FLAGS)


@pytest.fixture(scope="session")
def browser():
    with sync_playwright() as playwright:
        try:
            chromium = launched(playwright)
        except Error as error:
            if os.environ.get("CI"):
                raise
            pytest.skip(f"no Chromium found ({', '.join(NAMES)}): {str(error).splitlines()[0]}")
        yield chromium
        chromium.close()
