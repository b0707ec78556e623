"""What a student's notebook writes: every answer as it was typed, in one JSON file beside it."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from helpers.arm import Arm
from helpers.inputs import must_be

FILE = "answers.json"
PREFIX = "answer_"


def hand_in(names: Mapping[str, Any], path: str | Path = FILE) -> None:
    """Write every answer among a notebook's names, `hand_in(globals())`, into answers.json.

    Arrays keep the digits they print with, formulas become text, an `Arm` becomes its rows. The
    file is what is marked where it is handed in, and nothing is run then.
    """
    must_be(names, Mapping, "names")
    Path(path).write_text(collected(names) + "\n", encoding="utf-8")


def collected(names: Mapping[str, Any]) -> str:
    """The answers among a notebook's names as JSON; names without a value are left out."""
    found = {
        name.removeprefix(PREFIX): as_typed(value)
        for name, value in names.items()
        if name.startswith(PREFIX) and value is not None and value is not ...
    }
    return json.dumps(found)


def as_typed(value: Any) -> Any:
    """A value as JSON keeps it: numbers, texts and lists; anything else as Python writes it."""
    if isinstance(value, str | bool | int | float):
        return value
    if isinstance(value, Arm):
        return [[str(e) for e in row.entries] for row in value.rows]
    if hasattr(value, "tolist"):
        return as_typed(value.tolist())  # arrays of NumPy and matrices of SymPy alike
    if isinstance(value, Mapping):
        return {str(key): as_typed(entry) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [as_typed(entry) for entry in value]
    return str(value)
