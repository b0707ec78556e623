"""A course made from a roster: a proved sheet for each student, as a notebook to answer in.

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
from course.answers import NOTEBOOK_FILE as NOTEBOOK
from course.answers import PREFIX, SHEET, to_json_value, write_last_cell
from course.arms import to_python
from course.marking import mark_sheet
from course.roster import Student
from course.store import Course
from helpers.arm import Arm, Row
from helpers.inputs import ArmError

_TRIES = 20
_HOW = (
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
_LAST = (
    "## Hand in\n\nChoose *Restart and run all*, save the notebook, and hand it in. The last cell"
    " prints your answers: what it printed is marked, and nobody runs the notebook again. It also"
    " writes them into `answers.json`; you may hand in that file instead, or both."
)
_HELPERS = (
    "The first cell of code imports `helpers`, which compute with this arm. Where it says that"
    " something is missing, run this in a cell of its own, and that cell again:\n\n"
    '```\n%pip install "{what}"\n```\n\n'
    "Every question can be answered without, too: the questions stand in words, and the last cell"
    " needs nothing but Python."
)
_FOLDER = "./companion"  # where no address of the helpers is known
# Without the helpers only `arm` is missing: the questions stand in words, and answers are written.
_SETUP = """{prefix}{sheet} = {student!r}  # whose sheet this is

try:
    import numpy as np
    import sympy as sp
    from helpers import checks, kinematics, motion, statics, symbolic
    from helpers.arm import Arm, Body, Joint, Row
except ModuleNotFoundError as missing:
    print(f"{{missing}}. The text above says how to get it; you can answer and hand in without.")
else:
    arm = {arm}"""


def new(
    roster: Sequence[Student], arm: Arm, out: Path, *,
    title: str = "Homework", topics: tuple[str, ...] = (), secret: str = "",
) -> Course:  # fmt: skip
    """Draw a sheet for each student, prove it, and write the notebooks and course.json under `out`.

    A course that is there grows: who has a sheet keeps it, a notebook that was changed is left
    alone, a corrected name is taken over. Raises ArmError where `out` holds a course of another
    title, arm, topics or secret.
    """
    topics = topics or sheets.suiting(arm)
    before = Course(title, arm, topics, secret or secrets.token_hex(), {})
    if (out / store.FILE).exists():
        old = store.load(out)
        if replace(old, sheets={}) != replace(before, secret=secret or old.secret):
            raise ArmError(
                f"there is a course {old.title!r} about {old.arm.name} with the topics"
                f" {', '.join(old.topics)}; expected the same and its secret, or another folder"
            )
        before = old
    entries = {
        s.id: {**(before.sheets.get(s.id) or _proved(before, s.id)), "name": s.name} for s in roster
    }
    course = replace(before, sheets={**before.sheets, **entries})
    for student in entries:
        given = out / student / NOTEBOOK
        untouched = store.as_json(notebook(before, student)) if student in before.sheets else ""
        if not given.exists() or given.read_bytes() == untouched.encode():
            store.write(given, store.as_json(notebook(course, student)))
    store.save(course, out)
    return course


def _proved(course: Course, student: str) -> dict[str, Any]:
    """The values and drawn numbers of the first sheet whose own key gets full marks.

    Raises ArmError where twenty in a row do not.
    """
    for attempt in range(_TRIES):
        sheet = sheets.sheet(course.arm, store.seed(course, student, attempt), course.topics)
        marks = mark_sheet(sheet, right_work(sheet))
        if all(mark.credit == 1 for mark in marks):
            return {"values": dict(sheet.arm.values), "drawn": dict(sheet.drawn)}
    wrong = next(mark for mark in marks if mark.credit != 1)
    raise ArmError(f"`{wrong.part}` cannot be marked: its own key is judged {wrong.message!r}")


def right_work(sheet: sheets.Sheet) -> dict[str, Any]:
    """The key as a student would hand it in: four decimals, a table's rows, formulas."""
    values = {name: part.formulas or part.value for name, part in sheet.parts.items()}
    return {name: to_json_value(_typed(value)) for name, value in values.items()}


def _typed(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        return value.round(4) + 0.0
    return [*map(_row, value.rows, count(1))] if isinstance(value, Arm) else value


def _row(row: Row, number: int) -> list[str]:
    """A row's entries, the joint's variable among them."""
    entries = dict(zip(("a", "alpha", "d", "theta"), map(str, row.entries), strict=True))
    if moved := {"revolute": "theta", "prismatic": "d"}.get(row.joint.kind):
        entries[moved] = f"q_{number} + {entries[moved]}"
    return list(entries.values())


def notebook(course: Course, student: str) -> dict[str, Any]:
    """The sheet as a notebook, nbformat 4.5: questions, answer cells, and how to hand in."""
    sheet, name = course.sheet(student), course.names[student]
    arm = to_python(sheet.arm).replace("\n", "\n    ")
    cells = [
        _text("title", f"# {course.title}\n\n{name} ({student})\n\n{_HOW}\n\n{_helpers()}"),
        _text("arm", f"## The arm\n\n{sheet.arm._repr_markdown_()}"),
        code_cell(
            "setup",
            _SETUP.format(
                prefix=PREFIX, sheet=SHEET, student=store.name_sheet(course, student), arm=arm
            ),
        ),
    ]
    for number, question in enumerate(sheet.questions, 1):
        cells.append(_text(f"question-{number}", question.markdown))
        for part in question.parts:
            code = f"# {part.what}\n{PREFIX}{part.name} = ..."
            cells.append(code_cell(f"answer-{part.name}", code))
    cells.append(_text("hand-in", _LAST))
    cells.append(code_cell("write", write_last_cell()))
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    return {"cells": cells, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}


def _helpers() -> str:
    """How to get the helpers: from the address in pyproject.toml, or from the book's folder."""
    told = metadata("manipulator-homework-helpers").get_all("Project-URL") or []
    addresses = [line.partition(", ")[2] for line in told if line.startswith("Repository, ")]
    if addresses:
        what = f"manipulator-homework-helpers @ git+{addresses[0]}"
        return _HELPERS.format(what=what)
    return _HELPERS.format(what=_FOLDER) + f" `{_FOLDER}` stands for the folder of the book."


def _text(cell_id: str, source: str) -> dict[str, Any]:
    return {"cell_type": "markdown", "id": cell_id, "metadata": {}, "source": source}


def code_cell(cell_id: str, source: str) -> dict[str, Any]:
    """A cell of code that was not run."""
    empty: dict[str, Any] = {"execution_count": None, "metadata": {}, "outputs": []}
    return {"cell_type": "code", "id": cell_id.replace("_", "-"), "source": source, **empty}
