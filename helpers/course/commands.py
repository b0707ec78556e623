"""Make a course, print a key, sort and mark what was handed in, make an autograder."""

import argparse
import sys
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from helpers import variants
from helpers.course import autograders, collect, gradebook, making, sandbox, store
from helpers.course.arms import find_arm
from helpers.course.grading import grade
from helpers.course.marking import Rules, known_causes
from helpers.course.roster import must_name_a_folder, read_roster
from helpers.course.sandbox import Limits
from helpers.course.secrets import read_secret
from helpers.inputs import ArmError, whole

_EXTRA = ("markdown_it", "mdit_py_plugins", "latex2mathml", "nbclient", "ipykernel", "yaml")

_OUT = {"type": Path, "required": True}
_OPTIONS: dict[str, dict[str, Any]] = {
    "course": {"type": Path, "help": "the folder that new made"},
    "--secret": {"required": True, "help": "a file of 16 bytes or more, yours alone"},
    "--roster": {"required": True, "help": "CSV with the columns id and name"},
    "--arm": {
        "required": True,
        "help": "a name of the catalogue, arm.urdf, or my_arm.py:MINE",
    },
    "--lock": {
        "type": int, "action": "append", "default": [], "metavar": "JOINT",
        "help": "a joint held at zero; may be given again",
    },
    "--title": {"default": "Homework", "help": "what the sheets are headed; Homework unless given"},
    "--topic": {
        "action": "append", "choices": variants.TOPICS, "metavar": "TOPIC",
        "help": f"one of {', '.join(variants.TOPICS)}; may be given again; all that suit unless"
        " given",
    },
    "--digits": {"type": float, "help": "credit for right but too few digits; at first 0.9"},
    "--columns": {"type": float, "help": "what right columns of a wrong matrix count; at first 1"},
    "--cause": {
        "action": "append", "default": [], "metavar": "CAUSE=CREDIT",
        "help": "what a named mistake is worth, such as J.halves=0.5; may be given again",
    },
    "--id": {"required": True, "help": "a student's id in the roster"},
    "--jobs": {"type": int, "default": 1, "help": "students marked at a time; 1 unless given"},
    "--seconds": {"type": int, "default": 120, "help": "for one notebook; 120 unless given"},
    "--canvas": {"type": Path, "help": "an export of Canvas, to be filled into --out"},
    "--moodle": {"type": Path, "help": "a grading worksheet of Moodle, likewise"},
    "download": {
        "type": Path, "help": "a zip or folder from Canvas, Moodle, Gradescope or by hand",
    },
    "--out": {**_OUT, "help": "the folder or file to write"},
}  # fmt: skip


def main(words: Sequence[str] | None = None) -> int:
    """Run one command; 0 if all went well, 2 with words on stderr if not."""
    given = _parser().parse_args(words)
    try:
        if missing := [name for name in _EXTRA if find_spec(name) is None]:
            raise ArmError(
                f"{', '.join(missing)} is not installed; say"
                ' pip install "manipulator-homework-helpers[course]", or pip install -e ".[course]"'
                " in the project's folder"
            )
        given.run(given)
    except (ArmError, OSError) as error:
        print(f"course: {error}", file=sys.stderr)
        return 2
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m helpers.course", description=__doc__)
    commands = parser.add_subparsers(required=True)
    for name, (run, words, options) in _COMMANDS.items():
        command = commands.add_parser(name, help=words, description=words)
        command.set_defaults(run=run)
        for option in options.split():
            command.add_argument(option, **_OPTIONS[option])
    return parser


def _new(given: argparse.Namespace) -> None:
    rules: dict[str, Any] = {
        key: getattr(given, key) for key in ("digits", "columns") if getattr(given, key) is not None
    }
    if given.cause:
        rules["causes"] = dict(map(_cause, given.cause))
    arm = find_arm(given.arm, tuple(given.lock))
    topics = tuple(given.topic) if given.topic else None
    roster, secret = read_roster(given.roster), read_secret(given.secret)
    course = making.new(
        roster, secret, arm, given.out, title=given.title, topics=topics, rules=rules
    )
    causes = "".join(f", {name} {credit:g}" for name, credit in course.rules.causes.items())
    print(f"{len(course.sheets)} sheets in {given.out}")
    print(f"credit: digits {course.rules.digits:g}, columns {course.rules.columns:g}{causes}")


def _cause(words: str) -> tuple[str, float]:
    name, _, credit = words.rpartition("=")
    if not set(name.split(" + ")) <= known_causes():
        raise ArmError(
            f"--cause is {words!r}; expected a cause that feedback names, and its credit"
        )
    try:
        return name, Rules(causes={name: float(credit)}).causes[name]
    except ValueError:
        raise ArmError(f"--cause is {words!r}; expected a credit from 0 to 1 after =") from None


def _key(given: argparse.Namespace) -> None:
    must_name_a_folder(given.id, "--id")
    print(making.key(given.course, read_secret(given.secret), given.id))


def _collect(given: argparse.Namespace) -> None:
    course = store.load(given.course)
    found = collect.sort(collect.read_download(given.download), course.names)
    collect.put(found, given.course)
    print(f"{len(found.placed)} of {len(course.sheets)} students handed in")
    for words in found.doubtful:
        print(f"not placed: {words}")


def _grade(given: argparse.Namespace) -> None:
    refusal, seconds = sandbox.refusal(), whole(given.seconds, "seconds", least=1)
    limits = None if refusal else Limits(notebook=seconds)
    for path in (given.course, Path(given.secret), given.out):
        if limits and sandbox.exposed(path):
            raise ArmError(
                f"{path} lies where notebooks can read, beside Python; move it elsewhere"
            )
    secret = read_secret(given.secret)
    rows = grade(given.course, secret, given.out, jobs=given.jobs, limits=limits)
    print(f"{len(rows)} students marked: {given.out / 'grades.csv'}")
    if any(sandbox.NOT_RUN in row["note"] for row in rows):
        print(f"notebooks were not run: {refusal}")
    course, shares = store.load(given.course), {r["id"]: r["total"] / (len(r) - 4) for r in rows}
    for export, path in ((gradebook.CANVAS, given.canvas), (gradebook.MOODLE, given.moodle)):
        if path is None:
            continue
        text = path.read_bytes().decode("utf-8")
        out = given.out / f"{export.platform.lower()}.csv"
        store.write(out, gradebook.filled(text, export, shares, course.names, course.title))
        print(f"filled: {out}")


def _gradescope(given: argparse.Namespace) -> None:
    course, secret = store.load(given.course), read_secret(given.secret)
    for student in course.sheets:
        course.sheet(student, secret)  # every stored sheet is the one that was drawn
    autograders.gradescope_zip(course, given.out)
    print(f"autograder for {len(course.sheets)} students: {given.out}")


def _nbgrader(given: argparse.Namespace) -> None:
    course = store.load(given.course)
    sheet = course.sheet(given.id, read_secret(given.secret))
    store.write(given.out, store.as_json(autograders.nbgrader_notebook(course, sheet)))
    print(f"source notebook: {given.out}")


_COMMANDS = {
    "new": (
        _new, "make a sheet for each line of a roster",
        "--roster --secret --arm --lock --title --topic --digits --columns --cause --out",
    ),
    "key": (_key, "print one student's key", "course --secret --id"),
    "collect": (_collect, "sort a download of hand-ins by student", "course download"),
    "grade": (
        _grade, "mark every hand-in of a course",
        "course --secret --out --jobs --seconds --canvas --moodle",
    ),
    "gradescope": (_gradescope, "make Gradescope's autograder", "course --secret --out"),
    "nbgrader": (_nbgrader, "make a source notebook for nbgrader", "course --secret --id --out"),
}  # fmt: skip
