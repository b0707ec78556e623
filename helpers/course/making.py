"""A course made from a roster: a proved sheet for each student, as a notebook to answer in.

The notebook holds nothing of the key: only what the questions print, and whose sheet it is.
"""

import pprint
import secrets
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from helpers import variants
from helpers.arm import Arm
from helpers.course import store
from helpers.course.answers import NOTEBOOK, PREFIX, SHEET, as_typed
from helpers.course.arms import to_json
from helpers.course.marking import mark_sheet
from helpers.course.roster import Student
from helpers.course.store import Course
from helpers.inputs import ArmError

_TRIES = 20
_HOW = (
    "Answer by the names that each question gives. SI units, angles in radians unless you"
    " say otherwise."
    " What is forgiven stands beside each answer; fewer digits than that cost a little.\n\n"
    "Put each answer in place of the dots. A list, a NumPy array, a SymPy matrix or a text will"
    " do. The functions of `helpers.checks` say whether a result is right and what to look at if"
    " it is not."
)
_LAST = (
    "## Hand in\n\nThe last cell writes `answers.json` beside this notebook. Hand in both files."
    " Run *Restart and run all* first, so that what is written is what the notebook says."
)
_SETUP = """import numpy as np
import sympy as sp

from helpers import checks, kinematics, motion, statics, symbolic
from helpers.course.arms import from_json

{prefix}{sheet} = {student!r}  # whose sheet this is
arm = from_json(
{arm}
)"""


def new(
    roster: Sequence[Student], arm: Arm, out: Path, *,
    title: str = "Homework", topics: tuple[str, ...] = (), secret: str = "",
) -> Course:  # fmt: skip
    """Draw a sheet for each student, prove it, and write the notebooks and course.json under `out`.

    A course that is there grows: who has a sheet keeps it, a notebook that was changed is left
    alone, a corrected name is taken over. Raises ArmError where `out` holds a course of another
    title, arm, topics or secret.
    """
    topics = topics or variants.suiting(arm)
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
    store.write(out / store.FILE, store.text(course))
    return course


def _proved(course: Course, student: str) -> dict[str, Any]:
    """The values and drawn numbers of the first sheet whose own key gets full marks.

    Raises ArmError where twenty in a row do not.
    """
    for attempt in range(_TRIES):
        sheet = variants.sheet(course.arm, store.seed(course, student, attempt), course.topics)
        marks = mark_sheet(sheet, right_work(sheet))
        if all(mark.credit == 1 for mark in marks):
            return {"values": dict(sheet.arm.values), "drawn": dict(sheet.drawn)}
    wrong = next(mark for mark in marks if mark.credit != 1)
    raise ArmError(f"`{wrong.part}` cannot be marked: its own key is judged {wrong.headline!r}")


def right_work(sheet: variants.Sheet) -> dict[str, Any]:
    """The key as a student would hand it in: four decimals, a table's rows, formulas."""
    values = {name: part.value for name, part in sheet.parts.items()}
    return {n: as_typed(x.round(4) if isinstance(x, np.ndarray) else x) for n, x in values.items()}


def notebook(course: Course, student: str) -> dict[str, Any]:
    """The sheet as a notebook, nbformat 4.5: questions, answer cells, and how to hand in."""
    sheet, name = course.sheet(student), course.names[student]
    arm = pprint.pformat(to_json(sheet.arm), width=96, sort_dicts=False)
    cells = [
        _text("title", f"# {course.title}\n\n{name} ({student})\n\n{_HOW}"),
        _text("arm", f"## The arm\n\n{sheet.arm._repr_markdown_()}"),
        code_cell("setup", _SETUP.format(prefix=PREFIX, sheet=SHEET, student=student, arm=arm)),
    ]
    for number, question in enumerate(sheet.questions, 1):
        cells.append(_text(f"question-{number}", question.markdown))
        for part in question.parts:
            code = f"# {part.what}\n{PREFIX}{part.name} = ..."
            cells.append(code_cell(f"answer-{part.name}", code))
    cells.append(_text("hand-in", _LAST))
    cells.append(code_cell("write", "from helpers.course import hand_in\n\nhand_in(globals())"))
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    return {"cells": cells, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}


def _text(cell_id: str, source: str) -> dict[str, Any]:
    return {"cell_type": "markdown", "id": cell_id, "metadata": {}, "source": source}


def code_cell(cell_id: str, source: str) -> dict[str, Any]:
    """A cell of code that was not run."""
    empty: dict[str, Any] = {"execution_count": None, "metadata": {}, "outputs": []}
    return {"cell_type": "code", "id": cell_id.replace("_", "-"), "source": source, **empty}
