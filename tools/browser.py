"""A headless Chromium with no network: the PDF is printed with it, and tests look through it."""

import shutil

from playwright.sync_api import Browser, Error, Playwright

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
    "--font-render-hinting=none",  # letters as wide as they are in a window
]
# First the one that has no window to draw: the others' frame and tab cost more than a page.
NAMES = (
    "chromium-headless-shell",
    "chromium",
    "chromium-browser",
    "google-chrome",
    "chrome",
    "msedge",
)


def launched(playwright: Playwright, *more: str) -> Browser:
    """Chromium, Chrome or Edge, with `more` flags; on macOS and Windows Playwright knows where
    Chrome is installed. Raises NoBrowser where there is none."""
    path = next(filter(None, map(shutil.which, NAMES)), None)
    where = {"executable_path": path} if path else {"channel": "chrome"}
    try:
        return playwright.chromium.launch(**where, args=[*FLAGS, *more])
    except Error as error:
        if path:
            raise
        raise NoBrowser(f"no browser is on the PATH; expected one of {', '.join(NAMES)}") from error


class NoBrowser(Exception):
    """There is no Chromium, Chrome or Edge to look with."""
