"""Make a course from a roster: a proved sheet for each student, as a notebook to answer in.

The notebook holds nothing of the key: only what the questions print, and whose sheet it is.
"""

import secrets
from collections.abc import Sequence
from dataclasses import replace
from importlib.metadata import metadata
from itertools import count
from pathlib import Path
from typing import Any

import numpy as np

from course import sheets, store
from course.answers import NOTEBOOK_FILE, PREFIX, SHEET, to_json_value, write_last_cell
from course.arms import to_python
from course.marking import mark_sheet
from course.roster import Student
from course.store import Course
from helpers.arm import Arm, Row
from helpers.inputs import ArmError

_MAX_TRIES = 20
_INSTRUCTIONS = (
    "Answer by the names that each question gives: put each answer in place of the dots. **Write"
    ' numbers as text, with the decimals that are asked**: `"0.350, -1.204, 0.077"`, or rows on'
    " lines of their own. Lists, NumPy arrays and SymPy matrices are read too. SI units, angles in"
    " radians; a unit beside a number (`350 mm`, `20 deg`) and decimal commas are understood.\n\n"
    "Right is 1, where one unit of the last decimal asked is forgiven. Any other answer earns half"
    " of the share that is right, and half where one usual mistake explains all of it. What counts"
    " by itself stands beside each answer. Branches count one by one, a table with one mistake"
    " earns half. Numbers with fewer decimals than asked are seldom right. Write 0 for what you do"
    " not have."
)
_HAND_IN = (
    "## Hand in\n\nChoose *Restart and run all*, save the notebook, and hand it in. The last cell"
    " prints your answers: what it printed is marked, and nobody runs the notebook again. It also"
    " writes them into `answers.json`; you may hand in that file instead, or both."
)
_INSTALLATION = (
    "The first cell of code imports `helpers`, which compute with this arm. Where it says that"
    " something is missing, run this in a cell of its own, and that cell again:\n\n"
    '```\n%pip install "{source}"\n```\n\n'
    "Every question can be answered without, too: the questions stand in words, and the last cell"
    " needs nothing but Python."
)
_BOOK_FOLDER = "./companion"  # the source of the helpers if no address is known
# Only `arm` needs the helpers: a student without them can read, answer and hand in.
_SETUP = """{prefix}{sheet} = {name!r}  # whose sheet this is

try:
    import numpy as np
    import sympy as sp
    from helpers import checks, kinematics, motion, statics, symbolic
    from helpers.arm import Arm, Body, Joint, Row
except ModuleNotFoundError as missing:
    print(f"{{missing}}. The text above says how to get it; you can answer and hand in without.")
else:
    arm = {arm}"""


def make_course(
    roster: Sequence[Student], arm: Arm, folder: Path, *,
    title: str = "Homework", topics: tuple[str, ...] = (), secret: str = "",
) -> Course:  # fmt: skip
    """Draw a sheet for each student, prove it, and write the notebooks and course.json.

    A course that is in the folder grows: students keep their sheets, a notebook that was changed
    is left alone, and a corrected name is taken over.

    Raises ArmError if the folder holds a course of another title, arm, topics or secret.
    """
    topics = topics or sheets.list_suitable_topics(arm)
    course = Course(title, arm, topics, secret or secrets.token_hex(), {})
    if (folder / store.FILE).exists():
        old = store.load(folder)
        if replace(old, sheets={}) != replace(course, secret=secret or old.secret):
            raise ArmError(
                f"there is a course {old.title!r} about {old.arm.name} with the topics"
                f" {', '.join(old.topics)}; expected the same and its secret, or another folder"
            )
        course = old
    entries = {
        s.id: {**(course.sheets.get(s.id) or _draw_proved_sheet(course, s.id)), "name": s.name}
        for s in roster
    }
    grown = replace(course, sheets={**course.sheets, **entries})
    for student in entries:
        path = folder / student / NOTEBOOK_FILE
        unchanged = make_notebook(course, student) if student in course.sheets else {}
        if not path.exists() or path.read_bytes() == store.format_json(unchanged).encode():
            store.write_text(path, store.format_json(make_notebook(grown, student)))
    store.save(grown, folder)
    return grown


def _draw_proved_sheet(course: Course, student: str) -> dict[str, Any]:
    """Draw sheets until one's own key gets full marks; return its lengths and numbers.

    Raises ArmError after twenty tries.
    """
    for attempt in range(_MAX_TRIES):
        seed = store.derive_seed(course, student, attempt)
        sheet = sheets.draw_sheet(course.arm, seed, course.topics)
        marks = mark_sheet(sheet, make_right_answers(sheet))
        if all(mark.credit == 1 for mark in marks):
            return {"values": dict(sheet.arm.values), "drawn": dict(sheet.drawn)}
    wrong = next(mark for mark in marks if mark.credit != 1)
    raise ArmError(f"`{wrong.part}` cannot be marked: its own key is judged {wrong.message!r}")


def make_right_answers(sheet: sheets.Sheet) -> dict[str, Any]:
    """Make the key as a student would hand it in: four decimals, rows of a table, formulas."""
    values = {name: part.formulas or part.value for name, part in sheet.parts.items()}
    return {name: to_json_value(_as_typed(value)) for name, value in values.items()}


def _as_typed(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        return value.round(4) + 0.0
    return [*map(_write_row, value.rows, count(1))] if isinstance(value, Arm) else value


def _write_row(row: Row, number: int) -> list[str]:
    """Write the entries of a table's row with the joint's variable."""
    entries = dict(zip(("a", "alpha", "d", "theta"), map(str, row.entries), strict=True))
    if moved := {"revolute": "theta", "prismatic": "d"}.get(row.joint.kind):
        entries[moved] = f"q_{number} + {entries[moved]}"
    return list(entries.values())


def make_notebook(course: Course, student: str) -> dict[str, Any]:
    """Make a sheet's notebook (nbformat 4.5): questions, answer cells, how to hand in."""
    sheet, name = course.sheet(student), course.names[student]
    arm = to_python(sheet.arm).replace("\n", "\n    ")
    introduction = f"# {course.title}\n\n{name} ({student})\n\n{_INSTRUCTIONS}"
    sheet_name = store.name_sheet(course, student)
    setup = _SETUP.format(prefix=PREFIX, sheet=SHEET, name=sheet_name, arm=arm)
    cells = [
        _make_text_cell("title", f"{introduction}\n\n{_describe_installation()}"),
        _make_text_cell("arm", f"## The arm\n\n{sheet.arm._repr_markdown_()}"),
        _make_code_cell("setup", setup),
    ]
    for number, question in enumerate(sheet.questions, 1):
        cells.append(_make_text_cell(f"question-{number}", question.markdown))
        for part in question.parts:
            code = f"# {part.what}\n{PREFIX}{part.name} = ..."
            cells.append(_make_code_cell(f"answer-{part.name}", code))
    cells.append(_make_text_cell("hand-in", _HAND_IN))
    cells.append(_make_code_cell("write", write_last_cell()))
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    return {"cells": cells, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}


def _describe_installation() -> str:
    """Say how to get the helpers: from the address in pyproject.toml, or the book's folder."""
    urls = metadata("manipulator-homework-helpers").get_all("Project-URL") or []
    addresses = [line.partition(", ")[2] for line in urls if line.startswith("Repository, ")]
    if addresses:
        return _INSTALLATION.format(source=f"manipulator-homework-helpers @ git+{addresses[0]}")
    text = _INSTALLATION.format(source=_BOOK_FOLDER)
    return f"{text} `{_BOOK_FOLDER}` stands for the folder of the book."


def _make_text_cell(cell_id: str, source: str) -> dict[str, Any]:
    return {"cell_type": "markdown", "id": cell_id, "metadata": {}, "source": source}


def _make_code_cell(cell_id: str, source: str) -> dict[str, Any]:
    """Make a code cell that was not run."""
    empty: dict[str, Any] = {"execution_count": None, "metadata": {}, "outputs": []}
    return {"cell_type": "code", "id": cell_id.replace("_", "-"), "source": source, **empty}
