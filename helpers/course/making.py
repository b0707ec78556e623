"""A course made from a roster: a proved sheet for each student, and the key to it."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from helpers import variants
from helpers.arm import Arm
from helpers.course import sheets, store
from helpers.course.handed_in import NOTEBOOK, PAGE
from helpers.course.marking import Rules
from helpers.course.progress import counted
from helpers.course.proof import prove
from helpers.course.roster import Student
from helpers.course.store import Course
from helpers.inputs import ArmError

_TRIES = 20


def new(
    roster: Sequence[Student], secret: bytes, arm: Arm, out: Path, *,
    title: str = "Homework", topics: tuple[str, ...] | None = None,
    rules: Mapping[str, Any] | None = None,
) -> Course:  # fmt: skip
    """Draw a sheet for each student, prove it, and write notebook, page and course.json under
    `out`.

    A course that is there grows: who has a sheet keeps it, a notebook that was changed is left
    alone, a corrected name and the given `rules` (fields of `Rules`) are taken over. Raises
    ArmError where `out` holds a course of another title, arm, topics or secret.
    """
    asked = topics or variants.suiting(arm)
    before = Course(title, arm, asked, Rules(), {})
    if (out / store.FILE).exists():
        before = _same(store.load(out), before, secret)
    course = replace(before, rules=replace(before.rules, **(rules or {})))
    for student in counted(roster, "sheets", len(roster)):
        entry = course.sheets.get(student.id) or _proved(course, student, secret)
        entries = {**course.sheets, student.id: {**entry, "name": student.name}}
        course = replace(course, sheets=entries)
        _write_sheet(course, before, student.id, out / student.id)
    store.save(course, out)
    return course


def _same(old: Course, given: Course, secret: bytes) -> Course:
    """The course that is there; raises ArmError where it is not the one that is meant."""
    about = (given.title, given.arm, given.topics)
    if not old.topics or (old.title, old.arm, old.topics) != about:
        raise ArmError(
            f"there is a course {old.title!r} about {old.arm.name} with the topics"
            f" {', '.join(old.topics)}; expected the same, or another folder"
        )
    for student in old.sheets:
        old.sheet(student, secret)
    return old


def _proved(course: Course, student: Student, secret: bytes) -> dict[str, Any]:
    """The first sheet of a student's that can be marked; a pose may hide a mistake, then another is
    drawn. Raises ArmError where twenty in a row hide one.
    """
    trouble = ArmError("no sheet was drawn")
    for attempt in range(_TRIES):
        entry = store.drawn_sheet(course, student.id, student.name, secret, attempt)
        try:
            prove(replace(course, sheets={student.id: entry}).sheet(student.id, secret))
        except ArmError as error:
            trouble = error
        else:
            return entry
    raise trouble


def _write_sheet(course: Course, before: Course, student: str, folder: Path) -> None:
    """The notebook, unless it was changed since it was given out, and the page."""
    book = sheets.notebook(course.unsigned(student), course, student)
    given, page = folder / NOTEBOOK, folder / PAGE
    old = sheets.notebook(course.unsigned(student), before, student)
    if not given.exists() or given.read_bytes() == store.as_json(old).encode():
        store.write(given, store.as_json(book))
    store.write(page, sheets.sheet_page(book, f"{course.title}, {student}"))


def key(folder: Path, secret: bytes, student: str) -> str:
    """The key to a student's sheet as Markdown."""
    sheet = store.load(folder).sheet(student, secret)
    return "\n\n".join(question.key for question in sheet.questions)
