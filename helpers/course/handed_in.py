"""What lies in a student's folder: which file is the hand-in, and the answers in it.

An answers file counts before a notebook, since nothing is run for it. Names do not matter: learning
platforms rename. Nothing is raised for what a student may have done; it is told in `trouble`.
"""

import json
import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from helpers.course import sandbox
from helpers.course.answers import PREFIX
from helpers.course.files import Found
from helpers.course.sandbox import Limits

NOTEBOOK = "homework.ipynb"
PAGE = "homework.html"
SHEET = "sheet"  # the answer that says whose sheet it is
_WHOSE = re.compile(rf"\b{PREFIX}{SHEET} = '([^']+)'|\"{SHEET}\": \"([^\"]+)\"")


@dataclass(frozen=True)
class HandIn:
    """The answers that were found, by name, and what went wrong on the way."""

    answers: Mapping[str, Any]
    trouble: str = ""


def read_hand_in(
    files: Sequence[Found], parts: Collection[str], limits: Limits | None = None
) -> HandIn:
    """The answers in a student's files; a notebook is run where `limits` are given."""
    written = [(file, _answers(file, parts)) for file in files if file.kind == ".json"]
    written = [(file, answers) for file, answers in written if answers]
    if written:
        if any(answers != written[0][1] for _, answers in written):
            return _several("answers files", [file for file, _ in written])
        return HandIn(written[0][1])
    books = [(file, _notebook(file)) for file in files if file.kind == ".ipynb"]
    begun = {file.content: (file, book) for file, book in books if book and not _untouched(book)}
    if len(begun) > 1:
        return _several("notebooks", [file for file, _ in begun.values()])
    if begun:
        (file, book) = begun.popitem()[1]
        if limits is None:
            return HandIn({}, f"{file.name}: {sandbox.NOT_RUN}")
        ran = sandbox.run(book, limits)
        none = "" if ran.answers else f"{file.name} answers nothing"
        return HandIn(_named(ran.answers), ran.trouble or none)
    return HandIn({}, _nothing(files, any(book for _, book in books)))


def whose(file: Found) -> str:
    """The id on the sheet that a file answers, "" where it does not say."""
    said = _WHOSE.search(file.content.decode("utf-8", "replace").replace('\\"', '"'))
    return (said[1] or said[2]) if said else ""


def _several(what: str, files: Sequence[Found]) -> HandIn:
    names = ", ".join(map(str, files))
    return HandIn({}, f"there are {len(files)} different {what} ({names}); hand in one")


def _nothing(files: Sequence[Found], untouched: bool) -> str:
    told = sorted(files, key=lambda file: not file.trouble)
    seen = [str(file) for file in told if file.trouble or file.name not in (NOTEBOOK, PAGE)]
    words = "nothing was answered" if untouched else "nothing was handed in"
    if not seen:
        return words
    more = f" and {len(seen) - 5} more" if len(seen) > 5 else ""
    return f"{words} that can be marked; seen: {', '.join(seen[:5])}{more}"


def _answers(file: Found, parts: Collection[str]) -> dict[str, Any]:
    """The answers in a JSON file by the names of parts; empty for one that is something else."""
    try:
        found = json.loads(file.content)
    except (ValueError, RecursionError):
        return {}
    named = _named(found) if isinstance(found, dict) else {}
    return named if any(named.get(part) is not None for part in parts) else {}


def _named(found: Mapping[str, Any]) -> dict[str, Any]:
    return {name.removeprefix(PREFIX): answer for name, answer in found.items()}


def _notebook(file: Found) -> dict[str, Any]:
    """A notebook as data, with the cells that Jupyter knows; empty where the file holds none."""
    try:
        book = json.loads(file.content)
        cells = [cell for cell in book["cells"] if cell["cell_type"] in ("code", "markdown", "raw")]
        for cell in cells:
            cell["source"] = "".join(cell["source"])
    except (ValueError, KeyError, TypeError, RecursionError):
        return {}
    return {"cells": cells}


def _untouched(book: Mapping[str, Any]) -> bool:
    """Whether every answer cell still holds the dots that the sheet came with."""
    lines = [
        line.replace(" ", "")
        for cell in book["cells"]
        if cell["cell_type"] == "code"
        for line in cell["source"].splitlines()
        if line.lstrip().startswith(PREFIX) and f"{PREFIX}{SHEET} =" not in line
    ]
    return bool(lines) and all(line.endswith("=...") for line in lines)
