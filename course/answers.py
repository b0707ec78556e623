"""What a student's notebook writes: every answer as it was typed, in one JSON file beside it."""

import inspect
from collections.abc import Mapping
from typing import Any

FILE = "answers.json"
NOTEBOOK = "homework.ipynb"
PREFIX = "answer_"
SHEET = "sheet"  # the answer that says whose sheet it is


def as_typed(value: Any) -> Any:
    """A value as JSON keeps it: numbers, texts and lists; anything else as Python prints it."""
    if hasattr(value, "tolist"):
        value = value.tolist()  # arrays of NumPy and matrices of SymPy alike
    if isinstance(value, dict):
        return {str(key): as_typed(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [as_typed(entry) for entry in value]
    return value if isinstance(value, (str, bool, int, float)) else str(value)


def collected(names: Mapping[str, Any]) -> dict[str, Any]:
    """The answers among a notebook's names; those without a value are left out."""
    return {
        name[len("answer_") :]: as_typed(value)
        for name, value in names.items()
        if name.startswith("answer_") and value is not None and value is not ...
    }


def last_cell() -> str:
    """A sheet's last cell, which needs nothing but Python: it writes the answers into the file."""
    functions = "\n\n\n".join(inspect.getsource(f).rstrip() for f in (as_typed, collected))
    return f"""import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any


{functions}


answers = collected(globals())
_ = Path("{FILE}").write_text(json.dumps(answers) + "\\n", encoding="utf-8")
print("{FILE} holds:", ", ".join(answers))"""
