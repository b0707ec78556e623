"""Make a course from a roster, with a notebook for each student whose answer key was tested.

The notebook holds nothing of the key: only what the questions print, and whose sheet it is.
"""

import re
import secrets
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from importlib.metadata import metadata
from itertools import count
from pathlib import Path
from typing import Any

import numpy as np

from course import sheets, store
from course.answers import (
    ANSWER_PREFIX,
    NOTEBOOK_FILE,
    SHEET_ANSWER,
    to_json_value,
    write_last_cell,
)
from course.files import MAX_BYTES, MAX_HAND_IN_BYTES, MAX_HAND_IN_FILES, HandedFile
from course.handed_in import find_sheet_name
from course.marking import mark_sheet
from course.processes import make_pool
from course.roster import Student
from course.sheets import Exercise, Sheet
from course.store import Course
from helpers.arm import Arm, Row
from helpers.inputs import ArmError

_MAX_TRIES = 20
_MAX_SHEETS_ALONE = 4  # up to this many sheets, a single process is faster
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
    " writes them into `answers.json`; you may hand in that file instead, or both. A file may"
    f" have {MAX_BYTES // 10**6} MB, all files together {MAX_HAND_IN_BYTES // 10**6} MB, and there"
    f" may be {MAX_HAND_IN_FILES} of them; what is more is not read."
)
_BY_HAND = (
    "## {name}\n\n{points:g} points, marked by your instructor. Write into the next cell, or hand"
    " in a scan or a photograph beside the notebook."
)
_MARKUP = re.compile(r"([\\`*_\[\]<>$&#|~])")  # characters that Markdown may read as markup
_INSTALLATION = (
    "The first cell of code imports `helpers`, which compute with this arm. Where it says that"
    " something is missing, run this in a cell of its own, and that cell again:\n\n"
    '```\n%pip install "{source}"\n```\n\n'
    "Every question can be answered without, too: the questions stand in words, and the last cell"
    " needs nothing but Python."
)
_UNKNOWN_LIMIT = re.compile(r", \w+=(?:-?inf|None)")  # a limit in the text of a row
_BOOK_FOLDER = "./companion"  # source of the helpers if the book has no address
# Only `arm` needs the helpers, so a student without them can still answer and hand in.
_SETUP = """{prefix}{sheet} = {name!r}  # whose sheet this is

try:
    import numpy as np
    import sympy as sp
    from helpers import checks, kinematics, motion, statics, symbolic
    from helpers.arm import Arm, Body, Joint, Row
except ModuleNotFoundError as missing:
    print(f"{{missing}}. The text above says how to get it; you can answer and hand in without.")
else:
    {arms}"""


def make_course(
    roster: Sequence[Student], exercises: Sequence[Exercise], folder: Path, *,
    title: str = "Homework", secret: str = "", by_hand: Mapping[str, float] | None = None,
    jobs: int = 0, report: Callable[[str], None] = lambda _: None,
) -> Course:  # fmt: skip
    """Draw a sheet for each student, test its key, and write the notebooks and course.json.

    The secret is saved before any sheet, and each sheet as soon as it is drawn, so that an
    interrupted command can be typed again and draws the same numbers. A course that is in the
    folder grows: students keep their sheets, a notebook whose text was changed is left alone, and a
    corrected name is taken over.

    Args:
        roster: The students.
        exercises: The arms and topics; without topics those that suit the arm.
        folder: Where the course is written.
        title: Heading of the sheets.
        secret: Text to derive seeds from; drawn unless given.
        by_hand: Points of each part that the instructor marks, by its name.
        jobs: Processes that draw; 0 for one for each processor.
        report: Receives a line of progress after each sheet.

    Raises ArmError if the folder holds a course of another title, arm, topics, secret or parts by
    hand, a notebook with other numbers, or another command's work that is not finished.
    """
    exercises = tuple(
        replace(x, topics=x.topics or sheets.list_suitable_topics(x.arm)) for x in exercises
    )
    course = Course(title, exercises, secret or secrets.token_hex(), {}, by_hand=by_hand or {})
    if same := {*course.by_hand} & {*sheets.list_part_names(exercises)}:
        raise ArmError(f"{', '.join(same)} is a part that the sheet has; expected another name")
    with store.lock_folder(folder):
        if (folder / store.COURSE_FILE).exists():
            course = _load_same_course(course, folder, secret)
        else:
            store.save_course(course, folder)
        known = {
            s.id: {**course.sheets[s.id], "name": s.name} for s in roster if s.id in course.sheets
        }
        course = _save_sheets(course, folder, known)
        new = [student for student in roster if student.id not in course.sheets]
        entries = _draw_entries(course, [student.id for student in new], jobs)
        for number, (student, entry) in enumerate(zip(new, entries, strict=True), 1):
            course = _save_sheets(course, folder, {student.id: {"name": student.name, **entry}})
            report(f"{number} of {len(new)} sheets drawn")
    return course


def _load_same_course(course: Course, folder: Path, secret: str) -> Course:
    """Load the course in a folder, which must have the same questions as `course`."""
    old = store.load_course(folder)
    expected = (course.title, course.exercises, secret or old.secret, course.by_hand)
    if (old.title, old.exercises, old.secret, old.by_hand) != expected:
        about = "; ".join(f"{x.arm.name} with {', '.join(x.topics)}" for x in old.exercises)
        by_hand = "".join(f" and {name}:{points:g} by hand" for name, points in old.by_hand.items())
        raise ArmError(
            f"there is a course {old.title!r} about {about}{by_hand}; expected the same and its"
            " secret, or another folder"
        )
    return old


def _save_sheets(course: Course, folder: Path, entries: Mapping[str, Any]) -> Course:
    """Write the notebooks of new or renamed students, and course.json with them."""
    if not entries:
        return course
    grown = replace(course, sheets={**course.sheets, **entries})
    for student, entry in entries.items():
        path, old = folder / student / NOTEBOOK_FILE, course.sheets.get(student)
        if path.exists():
            _require_same_numbers(path, grown, student)
        unchanged = old and old != entry and store.format_json(make_notebook(course, student))
        if not path.exists() or (unchanged and path.read_bytes() == unchanged.encode()):
            store.write_text(path, store.format_json(make_notebook(grown, student)))
    store.save_course(grown, folder)
    return grown


def _read_sheet_name(path: Path) -> str:
    return find_sheet_name(HandedFile(path.name, path.read_bytes()))


def _require_same_numbers(path: Path, course: Course, student: str) -> None:
    """Raise ArmError if a notebook does not contain the numbers that the course stores."""
    found, expected = _read_sheet_name(path), store.name_sheet(course, student)
    if found != expected:
        raise ArmError(
            f"{path} holds {f'the sheet {found!r}' if found else 'no sheet'}, and the course keeps"
            f" {expected!r}, so it may have other numbers. If it was handed out, put back the"
            f" {store.COURSE_FILE} that made it; else move it away. Then type the same again"
        )


def _draw_entries(course: Course, students: list[str], jobs: int) -> Iterator[dict[str, Any]]:
    """Draw tested sheets in the order of the students, with several processes for many sheets."""
    draw = partial(draw_entry, replace(course, sheets={}))
    if len(students) <= _MAX_SHEETS_ALONE or jobs == 1:
        yield from map(draw, students)
        return
    with make_pool(jobs, __name__) as pool:
        yield from pool.map(draw, students)


def draw_entry(course: Course, student: str, issue: int = 0) -> dict[str, Any]:
    """Draw a student's sheet and test that its answer key earns full marks.

    Returns its issue, and the lengths and numbers for each arm.
    """
    indices = range(len(course.exercises))
    sections = [_draw_proved_section(course, student, index, issue) for index in indices]
    return {"issue": issue, "sections": sections, "named_by": "numbers"}


def _draw_proved_section(course: Course, student: str, index: int, issue: int) -> dict[str, Any]:
    """Draw the lengths and numbers of a section until its answer key earns full marks.

    Raises ArmError after twenty tries.
    """
    exercise = course.exercises[index]
    for attempt in range(issue * _MAX_TRIES, (issue + 1) * _MAX_TRIES):
        seed = store.derive_seed(course, student, index, attempt)
        sheet = sheets.draw_sheet(exercise.arm, seed, exercise.topics)
        marks = mark_sheet(sheet, make_right_answers(sheet))
        if all(mark.credit == 1 for mark in marks):
            (section,) = sheet.sections
            return {"values": dict(section.arm.values), "drawn": dict(section.drawn)}
    wrong = next(mark for mark in marks if mark.credit != 1)
    raise ArmError(f"`{wrong.part}` cannot be marked: its own key is judged {wrong.message!r}")


def reissue_sheet(folder: Path, student: str) -> Course:
    """Draw new numbers for a student, and keep the old notebook."""
    course = store.load_course(folder)
    old = course.require_entry(student)
    with store.lock_folder(folder):
        new = {**old, **draw_entry(course, student, old["issue"] + 1)}
        grown = replace(course, sheets={**course.sheets, student: new})
        path = folder / student / NOTEBOOK_FILE
        # An interrupted command may have written the new notebook already.
        if path.exists() and _read_sheet_name(path) != store.name_sheet(grown, student):
            _require_same_numbers(path, course, student)
            path.rename(path.with_name(f".{old['issue']} {NOTEBOOK_FILE}"))
        return _save_sheets(course, folder, {student: new})


def drop_student(folder: Path, student: str) -> Course:
    """Remove a student from the course, but keep the student's folder."""
    course = store.load_course(folder)
    course.require_entry(student)
    with store.lock_folder(folder):
        course = replace(course, sheets={s: x for s, x in course.sheets.items() if s != student})
        store.save_course(course, folder)
    return course


def make_right_answers(sheet: Sheet) -> dict[str, Any]:
    """Return the right answers in the form in which a student would hand them in."""
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
    """Make a sheet's notebook (nbformat 4.5) with questions and answer cells."""
    sheet, name = course.sheet(student), _escape_markup(course.names[student])
    introduction = f"# {course.title}\n\n{name} ({student})\n\n{_INSTRUCTIONS}"
    arms = "\n".join(f"arm{s.suffix} = {_write_arm(s.arm)}" for s in sheet.sections)
    setup = _SETUP.format(
        prefix=ANSWER_PREFIX, sheet=SHEET_ANSWER, name=store.name_sheet(course, student),
        arms=arms.replace("\n", "\n    "),
    )  # fmt: skip
    cells = [
        _make_text_cell("title", f"{introduction}\n\n{_describe_installation()}"),
        _make_code_cell("setup", setup),
    ]
    for section in sheet.sections:
        heading = f"## The arm{section.suffix.replace('_', ' ')}"
        table = section.arm._repr_markdown_()
        cells.append(_make_text_cell(f"arm{section.suffix}", f"{heading}\n\n{table}"))
        for number, question in enumerate(section.questions, 1):
            cell_id = f"question{section.suffix}-{number}"
            cells.append(_make_text_cell(cell_id, question.markdown))
            for part in question.parts:
                code = f"# {part.description}\n{ANSWER_PREFIX}{part.name} = ..."
                cells.append(_make_code_cell(f"answer-{part.name}", code))
    for part_name, points in course.by_hand.items():
        question_text = _BY_HAND.format(name=part_name, points=points)
        cells.append(_make_text_cell(part_name, question_text))
        cells.append(_make_text_cell(f"answer-{part_name}", "..."))
    cells.append(_make_text_cell("hand-in", _HAND_IN))
    cells.append(_make_code_cell("write", write_last_cell()))
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    return {"cells": cells, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}


def _escape_markup(text: str) -> str:
    """Escape a text so that Markdown shows it unchanged, on one line."""
    return _MARKUP.sub(r"\\\1", " ".join(text.split()))


def _write_arm(arm: Arm) -> str:
    """Write a Python expression that makes an arm, without its unknown limits."""
    lists = {"rows": arm.rows, "bodies": arm.bodies}
    fields = {"name": arm.name, "values": dict(arm.values), "home": [*arm.home]}
    lines = [f"{name}={value!r}," for name, value in {**fields, "source": arm.source}.items()]
    for name, items in lists.items():
        entries = [f"    {_UNKNOWN_LIMIT.sub('', repr(item))}," for item in items]
        lines += [f"{name}=[", *entries, "],"]
    return "\n    ".join(["Arm(", *lines]) + "\n)"


def _describe_installation() -> str:
    """Describe the installation of the helpers from the project's address or the book's folder."""
    urls = metadata("manipulator-homework-helpers").get_all("Project-URL") or []
    addresses = [line.partition(", ")[2] for line in urls if line.startswith("Repository, ")]
    if addresses:
        return _INSTALLATION.format(source=f"manipulator-homework-helpers @ git+{addresses[0]}")
    text = _INSTALLATION.format(source=_BOOK_FOLDER)
    return f"{text} `{_BOOK_FOLDER}` stands for the folder of the book."


def _make_text_cell(cell_id: str, source: str) -> dict[str, Any]:
    return {
        "cell_type": "markdown",
        "id": cell_id.replace("_", "-"),
        "metadata": {},
        "source": source,
    }


def _make_code_cell(cell_id: str, source: str) -> dict[str, Any]:
    """Make a code cell that was not run."""
    empty: dict[str, Any] = {"execution_count": None, "metadata": {}, "outputs": []}
    return {"cell_type": "code", "id": cell_id.replace("_", "-"), "source": source, **empty}
