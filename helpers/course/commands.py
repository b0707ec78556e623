"""Make a course, print a key, mark what was handed in, make an autograder."""

import argparse
import hashlib
import os
import sys
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from helpers import variants
from helpers.arm import Arm
from helpers.course import autograders, gradebook, sheets, store
from helpers.course.answers import FILE as ANSWERS
from helpers.course.answers import read_hand_in
from helpers.course.arms import find_arm
from helpers.course.feedback import feedback_page
from helpers.course.marking import mark_sheet, prove
from helpers.course.roster import Student, must_name_a_folder, read_roster
from helpers.course.sandbox import Apart, Limits, best_apart
from helpers.course.secrets import read_secret
from helpers.course.store import Course, Rules
from helpers.inputs import ArmError

NOTEBOOK = "homework.ipynb"
_FOLDER = "the folder that new made"
_SECRET = "the file that the course was made with"


def new(
    roster: Sequence[Student], secret: bytes, arm: Arm, out: Path, title: str = "Homework",
    topics: tuple[str, ...] | None = None, rules: Rules | None = None,
) -> Course:  # fmt: skip
    """Draw a sheet for each student, prove it, and write notebook, page and course.json under
    `out`.

    A student who has a sheet already keeps it, and a notebook that is there is left alone, so that
    a roster can grow. Raises ArmError where `out` holds a course of another title, arm or topics.
    """
    asked = topics or tuple(t for t in variants.TOPICS if variants.suits(t, arm))
    course = Course(title, arm, asked, rules or Rules(), {})
    if (out / store.FILE).exists():
        old = store.load(out)
        if (old.title, old.arm, old.topics) != (title, arm, asked):
            raise ArmError(
                f"{out} holds the course {old.title!r} about {old.arm.name}; choose another folder"
            )
        course = replace(course, rules=old.rules, sheets=old.sheets)
    for student in _progress(roster, "sheets"):
        if student.id not in course.sheets:
            entry = _proved(course, student, secret)
            course = replace(course, sheets={**course.sheets, student.id: entry})
        _write_sheet(course, student, secret, out / student.id)
    store.save(course, out)
    return course


def _proved(course: Course, student: Student, secret: bytes) -> dict[str, Any]:
    """The first sheet of a student's that can be marked; a pose may hide a mistake, then another is
    drawn. Raises ArmError where twenty in a row hide one.
    """
    for attempt in range(20):
        entry = store.drawn_sheet(course, student.id, student.name, secret, attempt)
        try:
            prove(replace(course, sheets={student.id: entry}).sheet(student.id, secret))
        except ArmError as error:
            trouble = error
        else:
            return entry
    raise trouble


def _write_sheet(course: Course, student: Student, secret: bytes, folder: Path) -> None:
    sheet = course.sheet(student.id, secret)
    if not (folder / NOTEBOOK).exists():
        book = sheets.notebook(sheet, course, student.id, student.name)
        store.write(folder / NOTEBOOK, sheets.notebook_text(book))
    store.write(folder / sheets.FILE, sheets.numbers_text(sheet))
    store.write(
        folder / "homework.html", sheets.sheet_page(sheet, course, student.id, student.name)
    )


def key(folder: Path, secret: bytes, student: str) -> str:
    """The key to a student's sheet as Markdown."""
    sheet = store.load(folder).sheet(student, secret)
    return "\n\n".join(question.key for question in sheet.questions)


@dataclass(frozen=True)
class _Job:
    course: Course
    student: str
    name: str
    secret: bytes
    folder: Path
    out: Path
    apart: Apart
    limits: Limits
    as_root: bool


def grade(
    folder: Path, secret: bytes, out: Path, *, apart: Apart | None = None, jobs: int = 1,
    limits: Limits | None = None, as_root: bool = False,
) -> list[dict[str, Any]]:  # fmt: skip
    """Mark what every student of a course handed in; the rows of grades.csv, in the course's order.

    Writes `out/grades.csv`, and for each student `feedback.html` and `results.json`. One whose
    hand-in has not changed since the last run is not marked again. Nothing that a student did stops
    the run.
    """
    course = store.load(folder)
    how = best_apart() if apart is None else apart
    tasks = [
        _Job(
            course, s, str(e["name"]), secret, folder / s, out / s, how, limits or Limits(), as_root
        )
        for s, e in course.sheets.items()
    ]
    rows: dict[str, dict[str, Any]] = {}
    for row in _progress(_done(tasks, jobs), "students", len(tasks)):
        rows[row["id"]] = row
    ordered = [rows[student] for student in course.sheets]
    store.write(out / "grades.csv", gradebook.table(ordered))
    return ordered


def _done(tasks: Sequence[_Job], jobs: int) -> Iterator[dict[str, Any]]:
    if jobs == 1:
        yield from map(_grade_one, tasks)
        return
    with ProcessPoolExecutor(jobs) as pool:
        waiting = {pool.submit(_grade_one, task): task for task in tasks}
        for future in as_completed(waiting):
            yield future.result()


def _grade_one(task: _Job) -> dict[str, Any]:
    """One student's line; whatever goes wrong costs this student's parts, and says so."""
    print_of = _fingerprint(task)
    known = gradebook.read_results(task.out)
    if known.get("extra_data", {}).get("fingerprint") == print_of:
        return dict(known["extra_data"]["row"])
    sheet = task.course.sheet(task.student, task.secret)
    try:
        handed = read_hand_in(task.folder, task.apart, task.limits, as_root=task.as_root)
        marks = mark_sheet(sheet, handed.answers, task.course.rules)
        trouble = handed.trouble
    except Exception as error:  # a hand-in may break what reads it in ways nobody thought of
        marks = mark_sheet(sheet, {}, task.course.rules)
        trouble = f"marking stopped ({type(error).__name__}); please look at it by hand"
    row = gradebook.grade_row(task.student, task.name, marks, trouble)
    text = feedback_page(task.course, sheet, task.student, task.name, marks, trouble)
    store.write(task.out / "feedback.html", text)
    results = gradebook.gradescope(marks, trouble)
    gradebook.write_results(
        task.out, {**results, "extra_data": {"fingerprint": print_of, "row": row}}
    )
    return row


def _fingerprint(task: _Job) -> str:
    """Of everything a mark depends on: the files handed in, the stored sheet, the rules, how it is
    run.
    """
    entry, rules = task.course.sheets[task.student], task.course.rules
    digest = hashlib.sha256(f"{entry['signature']} {rules} {task.apart} {task.limits}".encode())
    for path in sorted([*task.folder.glob("*.ipynb"), task.folder / ANSWERS]):
        if path.is_file() and not path.is_symlink():
            digest.update(os.fsencode(path.name) + hashlib.sha256(path.read_bytes()).digest())
    return digest.hexdigest()


def _progress(items: Any, what: str, total: int | None = None) -> Iterator[Any]:
    """The items one by one, counted on a terminal's last line; silent where nobody watches."""
    total = len(items) if total is None else total
    for count, item in enumerate(items, 1):
        yield item
        if sys.stderr.isatty():
            done = round(30 * count / total)
            print(
                f"\r[{'#' * done}{'.' * (30 - done)}] {count} of {total} {what}",
                end="",
                file=sys.stderr,
            )
    if sys.stderr.isatty():
        print(file=sys.stderr)


# The command line


def main(words: Sequence[str] | None = None) -> int:
    """Run one command; 0 if all went well, 2 with words on stderr if not."""
    given = _parser().parse_args(words)
    try:
        given.run(given)
    except (ArmError, OSError) as error:
        print(f"course: {error}", file=sys.stderr)
        return 2
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m helpers.course", description=__doc__)
    commands = parser.add_subparsers(required=True)
    made = _command(commands, "new", _new, "make a sheet for each line of a roster")
    made.add_argument("--roster", required=True, help="CSV with the columns id and name")
    made.add_argument("--secret", required=True, help="a file of 16 bytes or more, yours alone")
    made.add_argument(
        "--arm", required=True, help="a name of the catalogue, arm.urdf, or my_arm.py:MINE"
    )
    made.add_argument(
        "--lock", type=int, action="append", default=[], metavar="JOINT",
        help="a joint held at zero; may be given again",
    )  # fmt: skip
    made.add_argument("--title", default="Homework", help="what the sheets are headed")
    made.add_argument(
        "--topic", action="append", choices=variants.TOPICS, metavar="TOPIC",
        help=f"one of {', '.join(variants.TOPICS)}; may be given again; all that suit unless given",
    )  # fmt: skip
    made.add_argument(
        "--digits", type=float, default=0.9, help="credit for right but too few digits"
    )
    made.add_argument(
        "--columns", type=float, default=1.0, help="what right columns of a wrong matrix count"
    )
    made.add_argument(
        "--cause", action="append", default=[], metavar="CAUSE=CREDIT",
        help="what a named mistake is worth, such as J.halves=0.5; may be given again",
    )  # fmt: skip
    made.add_argument("--out", type=Path, required=True, help="the course's folder")
    keyed = _command(commands, "key", _key, "print one student's key")
    keyed.add_argument("--secret", required=True, help=_SECRET)
    keyed.add_argument("--id", required=True, help="the student's id in the roster")
    keyed.add_argument(
        "--course", type=Path, default=Path("hw"), help="its folder; hw unless given"
    )
    graded = _command(commands, "grade", _grade, "mark every hand-in of a course")
    graded.add_argument("course", type=Path, help=_FOLDER)
    graded.add_argument("--secret", required=True, help=_SECRET)
    graded.add_argument("--out", type=Path, required=True, help="the folder for marks and feedback")
    graded.add_argument("--jobs", type=int, default=1, help="students at a time; else 1")
    graded.add_argument(
        "--seconds", type=int, default=120, help="for one notebook; 120 unless given"
    )
    graded.add_argument(
        "--unprotected", action="store_true",
        help="run notebooks with your rights where bubblewrap does not work",
    )  # fmt: skip
    graded.add_argument("--as-root", action="store_true", help="do that even as the superuser")
    graded.add_argument("--canvas", type=Path, help="an export of Canvas, to be filled into --out")
    graded.add_argument("--moodle", type=Path, help="a grading worksheet of Moodle, likewise")
    scope = _command(commands, "gradescope", _gradescope, "make Gradescope's autograder.zip")
    scope.add_argument("course", type=Path, help=_FOLDER)
    scope.add_argument("--secret", required=True, help=_SECRET)
    scope.add_argument("--out", type=Path, required=True, help="the zip to write")
    source = _command(commands, "nbgrader", _nbgrader, "make a source notebook for nbgrader")
    source.add_argument("course", type=Path, help=_FOLDER)
    source.add_argument("--secret", required=True, help=_SECRET)
    source.add_argument("--id", required=True, help="whose sheet all students get")
    source.add_argument("--out", type=Path, required=True, help="the notebook to write")
    looked = _command(
        commands, "look", _look, "say what the checkers find in one folder; no secret"
    )
    looked.add_argument("folder", type=Path, help="one student's folder")
    room = _command(commands, "classroom", _classroom, "make a workflow file for GitHub Classroom")
    room.add_argument("--out", type=Path, required=True, help="the file to write")
    return parser


def _command(commands: Any, name: str, run: Any, words: str) -> argparse.ArgumentParser:
    parser = commands.add_parser(name, help=words, description=words)
    parser.set_defaults(run=run)
    return parser


def _new(given: argparse.Namespace) -> None:
    rules = Rules(given.digits, given.columns, dict(map(_cause, given.cause)))
    arm = find_arm(given.arm, tuple(given.lock))
    topics = tuple(given.topic) if given.topic else None
    roster, secret = read_roster(given.roster), read_secret(given.secret)
    course = new(roster, secret, arm, given.out, given.title, topics, rules)
    print(f"{len(course.sheets)} sheets in {given.out}")


def _cause(words: str) -> tuple[str, float]:
    name, _, credit = words.rpartition("=")
    try:
        value = float(credit)
    except ValueError:
        value = -1.0
    if not (name and 0 <= value <= 1):
        raise ArmError(
            f"--cause is {words!r}; expected a cause and its credit, such as J.halves=0.5"
        )
    return name, value


def _key(given: argparse.Namespace) -> None:
    must_name_a_folder(given.id, "--id")
    print(key(given.course, read_secret(given.secret), given.id))


def _grade(given: argparse.Namespace) -> None:
    apart = best_apart()
    if apart == "nothing" and given.unprotected:
        apart = "process"
    rows = grade(
        given.course, read_secret(given.secret), given.out, apart=apart, jobs=given.jobs,
        limits=Limits(notebook=given.seconds), as_root=given.as_root,
    )  # fmt: skip
    totals = {row["id"]: row["total"] for row in rows} | {row["name"]: row["total"] for row in rows}
    course = store.load(given.course)
    if given.canvas:
        filled = gradebook.fill_canvas(given.canvas.read_text("utf-8-sig"), totals, course.title)
        store.write(given.out / "canvas.csv", filled)
    if given.moodle:
        most = float(len(rows[0]) - 4)
        filled = gradebook.fill_moodle(given.moodle.read_text("utf-8-sig"), totals, most)
        store.write(given.out / "moodle.csv", filled)
    print(f"{len(rows)} students marked: {given.out / 'grades.csv'}")


def _gradescope(given: argparse.Namespace) -> None:
    course, secret = store.load(given.course), read_secret(given.secret)
    for student in course.sheets:
        course.sheet(student, secret)  # every stored sheet is the one that was drawn
    autograders.gradescope_zip(course, given.out)
    print(f"autograder for {len(course.sheets)} students: {given.out}")


def _nbgrader(given: argparse.Namespace) -> None:
    course = store.load(given.course)
    sheet = course.sheet(given.id, read_secret(given.secret))
    book = autograders.nbgrader_notebook(course, sheet)
    store.write(given.out, sheets.notebook_text(book))
    print(f"source notebook: {given.out}")


def _look(given: argparse.Namespace) -> None:
    words, _ = autograders.look(given.folder)
    print(words)


def _classroom(given: argparse.Namespace) -> None:
    store.write(given.out, autograders.CLASSROOM)
    print(f"workflow file: {given.out}")
