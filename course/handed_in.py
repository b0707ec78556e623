"""What lies in a student's folder: which file is the hand-in, and the answers in it.

An answers file counts before a notebook, since nothing is run for it. Names do not matter: learning
platforms rename. Nothing is raised for what a student may have done; it is told in `trouble`.
"""

import json
import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from course import sandbox
from course.answers import PREFIX, SHEET
from course.files import Found

_WHOSE = re.compile(rf"^\s*{PREFIX}{SHEET}\s*=\s*['\"]([^'\"]+)", re.M)
_LINE = re.compile(rf"^\s*{PREFIX}(\w+)(.*)$", re.M)


@dataclass(frozen=True)
class HandIn:
    """The answers that were found, by name, and what went wrong on the way."""

    answers: Mapping[str, Any]
    trouble: str = ""


def read_hand_in(files: Sequence[Found], parts: Collection[str], seconds: int = 0) -> HandIn:
    """The answers in a student's files; a notebook is run for so many seconds, not at all for 0."""
    # What could not be read at all comes first, then what is no JSON.
    files = sorted(map(_checked, sorted(files, key=_is_read)), key=_is_read)
    read = {file.name: _json(file) for file in files if file.kind in (".json", ".ipynb")}
    written = {name: named for name, data in read.items() if (named := _answers(data, parts))}
    if written:
        first, *others = written.values()
        different = any(other != first for other in others)
        return _several("answers files", written) if different else HandIn(first)
    books = {name: code for name, data in read.items() if (code := _code(data)) is not None}
    blank = {name for name, code in books.items() if _untouched(code)}
    begun = {"\n".join(code): name for name, code in books.items() if name not in blank}
    if len(begun) > 1:
        return _several("notebooks", begun.values())
    if not begun:
        return HandIn({}, _nothing(files, blank))
    (name,) = begun.values()
    if not seconds:
        return HandIn({}, f"{name}: {sandbox.NOT_RUN}")
    answers, trouble = sandbox.run(books[name], seconds)
    none = "" if answers else f"{name} answers nothing"
    return HandIn(_named(answers), trouble or none)


def whose(file: Found) -> str:
    """The id on the sheet that a file answers, "" where it does not say."""
    data = _json(file)
    if (code := _code(data)) is not None:
        said = _WHOSE.search("\n".join(code))
        return said[1] if said else ""
    return str(_named(data).get(SHEET, "")) if isinstance(data, dict) else ""


def of_another(answers: Mapping[str, Any], student: str) -> str:
    """In words that answers belong to another's sheet; "" where they do not say so."""
    other = str(answers.get(SHEET, student))
    return (
        "" if other == student else f"this answers the sheet of {other[:64]!r}, not of {student!r}"
    )


def _is_read(file: Found) -> bool:
    return not file.trouble


def _several(what: str, names: Collection[str]) -> HandIn:
    return HandIn({}, f"there are {len(names)} different {what} ({', '.join(names)}); hand in one")


def _nothing(files: Sequence[Found], blank: Collection[str]) -> str:
    """What else was seen than notebooks as they were given out."""
    seen = [str(file) for file in files if file.name not in blank]
    words = "nothing was answered" if blank else "nothing was handed in"
    if not seen:
        return words
    more = f" and {len(seen) - 5} more" if len(seen) > 5 else ""
    return f"{words} that can be marked; seen: {', '.join(seen[:5])}{more}"


def _json(file: Found) -> Any:
    try:
        return json.loads(file.content)
    except (ValueError, RecursionError):
        return None


def _checked(file: Found) -> Found:
    """The file, with why it cannot be read where it should be JSON and is not."""
    if file.trouble or file.kind not in (".json", ".ipynb"):
        return file
    try:
        json.loads(file.content)
    except json.JSONDecodeError as error:
        return replace(file, trouble=f"this is no JSON: line {error.lineno}, {error.msg}")
    except (ValueError, RecursionError) as error:
        return replace(file, trouble=f"this is no JSON: {error}"[:100])
    return file


def _answers(data: Any, parts: Collection[str]) -> dict[str, Any]:
    """The answers in data by the names of parts; empty for what is something else."""
    named = _named(data) if isinstance(data, dict) else {}
    return named if any(named.get(part) is not None for part in parts) else {}


def _named(found: Mapping[str, Any]) -> dict[str, Any]:
    return {name.removeprefix(PREFIX): answer for name, answer in found.items()}


def _code(data: Any) -> list[str] | None:
    """The sources of a notebook's cells of code; None where data are no notebook."""
    try:
        return ["".join(c["source"]) for c in data["cells"] if c["cell_type"] == "code"]
    except (KeyError, TypeError):
        return None


def _untouched(code: Sequence[str]) -> bool:
    """Whether every answer cell still holds the dots that the sheet came with."""
    lines = _LINE.findall("\n".join(code))
    return {rest.replace(" ", "") for name, rest in lines if name != SHEET} == {"=..."}
