"""What a student's notebook writes: every answer as it was typed, in one JSON file beside it."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from helpers.arm import Arm, Row
from helpers.inputs import must_be

FILE = "answers.json"
NOTEBOOK = "homework.ipynb"
PREFIX = "answer_"
SHEET = "sheet"  # the answer that says whose sheet it is


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
    if isinstance(value, Arm):
        value = [_row(number, row) for number, row in enumerate(value.rows, 1)]
    if hasattr(value, "tolist"):
        value = value.tolist()  # arrays of NumPy and matrices of SymPy alike
    if isinstance(value, Mapping):
        return {str(key): as_typed(entry) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [as_typed(entry) for entry in value]
    return value if isinstance(value, str | bool | int | float) else str(value)


def _row(number: int, row: Row) -> list[str]:
    """A row's entries, the joint's variable among them."""
    entries = dict(zip(("a", "alpha", "d", "theta"), map(str, row.entries), strict=True))
    if moved := {"revolute": "theta", "prismatic": "d"}.get(row.joint.kind):
        entries[moved] = f"q_{number} + {entries[moved]}"
    return list(entries.values())
