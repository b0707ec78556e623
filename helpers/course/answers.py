"""What a student hands in: values as they were typed, in one JSON file beside the notebook."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from helpers.arm import Arm
from helpers.course.sandbox import Apart, Limits, read_notebook, run
from helpers.inputs import must_be

FILE = "answers.json"
_PREFIX = "answer_"
_SIZE = 1_000_000  # bytes of an answers.json; larger ones are not read


@dataclass(frozen=True)
class HandIn:
    """The answers that were found, by name, and what went wrong on the way."""

    answers: Mapping[str, Any]
    trouble: str = ""


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
        name.removeprefix(_PREFIX): as_typed(value)
        for name, value in names.items()
        if name.startswith(_PREFIX) and value is not None and value is not ...
    }
    return json.dumps(found)


def as_typed(value: Any) -> Any:
    """A value as JSON keeps it: numbers, texts and lists; anything else as Python writes it."""
    if isinstance(value, str | bool | int | float):
        return value
    if isinstance(value, Arm):
        return [[str(e) for e in (r.a, r.alpha, r.d, r.theta)] for r in value.rows]
    if hasattr(value, "tolist"):
        return as_typed(value.tolist())  # arrays of NumPy and matrices of SymPy alike
    if isinstance(value, Mapping):
        return {str(key): as_typed(entry) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [as_typed(entry) for entry in value]
    return str(value)


def read_hand_in(
    folder: Path, apart: Apart, limits: Limits | None = None, *, as_root: bool = False
) -> HandIn:
    """What lies in a student's folder: answers.json if there is one, else the notebook, run apart.

    A notebook of any name is taken where there is one only. Nothing is raised for what a student
    may have done: a missing, renamed, broken, endless or hostile file is told in `trouble`.
    """
    written = folder / FILE
    if written.is_symlink() or written.exists():
        return _read_answers(written)
    notebooks = sorted(path for path in folder.glob("*.ipynb") if not path.is_symlink())
    if not notebooks:
        return HandIn({}, "nothing was handed in")
    chosen = next((path for path in notebooks if path.name == "homework.ipynb"), notebooks[0])
    if len(notebooks) > 1 and chosen.name != "homework.ipynb":
        names = ", ".join(path.name for path in notebooks)
        return HandIn({}, f"there are {len(notebooks)} notebooks ({names}); hand in one")
    if _untouched(chosen):
        return HandIn({}, "nothing was answered")
    ran = run(chosen, apart, limits, as_root=as_root)
    return HandIn(ran.answers or {}, ran.trouble)


def _untouched(path: Path) -> bool:
    """Whether every answer cell still holds the dots that the sheet came with; then nothing is
    run.
    """
    try:
        cells = read_notebook(path)["cells"]
    except ValueError:
        return False
    code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
    answers = [
        line for text in code for line in text.splitlines() if line.lstrip().startswith(_PREFIX)
    ]
    return bool(answers) and all(line.replace(" ", "").endswith("=...") for line in answers)


def _read_answers(path: Path) -> HandIn:
    """The answers in a file of ordinary kind and size; depth and names are checked where they are
    used.
    """
    try:
        if path.is_symlink() or not path.is_file():
            raise ValueError("is no ordinary file")
        if path.stat().st_size > _SIZE:
            raise ValueError(f"has more than {_SIZE:,} bytes")
        found = json.loads(path.read_bytes())
        if not isinstance(found, dict):
            raise ValueError("holds no names")
    except (OSError, ValueError, RecursionError) as error:
        return HandIn({}, f"{path.name} could not be read: {error}")
    return HandIn(found)
