"""Start a headless Chromium without network access, for the PDF and for tests."""

import shutil
from contextlib import suppress

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
    "--font-render-hinting=none",  # gives characters the same width as in a visible window
]
# The headless shell comes first, because it is the fastest.
PROGRAMS = (
    "chromium-headless-shell",
    "chromium",
    "chromium-browser",
    "google-chrome",
    "chrome",
    "msedge",
)


class NoBrowser(Exception):
    """No Chromium, Chrome or Edge is installed."""


def launch_browser(playwright: Playwright, *more_flags: str) -> Browser:
    """Launch Chromium, Chrome or Edge without a window.

    If no program of `PROGRAMS` is on the PATH, Playwright looks for Chrome where macOS and Windows
    install it, and for the Chromium of `playwright install chromium`.

    Args:
        playwright: A running Playwright.
        more_flags: Command-line flags in addition to `FLAGS`.

    Raises:
        NoBrowser: No browser is installed.
    """
    flags = [*FLAGS, *more_flags]
    path = next(filter(None, map(shutil.which, PROGRAMS)), None)
    if path:
        return playwright.chromium.launch(executable_path=path, args=flags)
    for channel in ("chrome", None):
        with suppress(Error):
            return playwright.chromium.launch(channel=channel, args=flags)
    expected = ", ".join(PROGRAMS)
    raise NoBrowser(
        f"no browser is on the PATH; expected one of {expected}, or playwright install chromium"
    )
