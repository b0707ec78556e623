"""A headless Chromium with no network: the PDF is printed with it, and tests look through it."""

import shutil

from playwright.sync_api import Browser, Playwright

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
NAMES = ("chromium", "chromium-browser", "google-chrome", "chrome", "msedge")


def launched(playwright: Playwright) -> Browser:
    """Chromium, Chrome or Edge; on macOS and Windows Playwright knows where Chrome is installed."""
    path = next(filter(None, map(shutil.which, NAMES)), None)
    where = {"executable_path": path} if path else {"channel": "chrome"}
    return playwright.chromium.launch(**where, args=FLAGS)
