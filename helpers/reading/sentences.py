"""The sentences of the checkers, one file of templates that the page's judge reads too."""

import json
from functools import cache
from pathlib import Path

_LONG = 9e6  # from here on numbers are told by a power of ten


@cache
def templates() -> dict[str, str]:
    """Every template by its key; fields stand in braces."""
    return json.loads(
        (Path(__file__).parents[2] / "judge" / "sentences.json").read_text(encoding="utf-8")
    )


def say(key: str, **fields: object) -> str:
    """A sentence with its fields put in."""
    text = templates()[key]
    for name, value in fields.items():
        text = text.replace("{" + name + "}", str(value))
    return text


def size(x: float, digits: int = 3) -> str:
    """A number to so many significant digits, as C's %g, but for whole ones of up to seven places;
    a minus sign only before what is not 0.
    """
    text = f"{x:.{digits}g}" if f"{x:.{digits}g}" != "-0" else "0"
    return f"{float(text):.0f}" if "e+0" in text and abs(x) < _LONG else text


def millimetres(metres: float, digits: int = 3) -> str:
    """A length in m as so many digits of mm, not below a thousandth of one."""
    return size(round(1e3 * float(metres), 3), digits)


def listed(words: list[str], last: str = "and") -> str:
    """``a, b and c``."""
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} {last} {words[-1]}"
