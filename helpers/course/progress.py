"""How far a command is, on a terminal's last line."""

import sys
from collections.abc import Iterable, Iterator
from typing import Any


def counted(items: Iterable[Any], what: str, total: int) -> Iterator[Any]:
    """The items one by one, counted on a terminal; silent where nobody watches."""
    for count, item in enumerate(items, 1):
        yield item
        if sys.stderr.isatty():
            end = "\n" if count == total else ""
            print(f"\r{count} of {total} {what}", end=end, file=sys.stderr, flush=True)
