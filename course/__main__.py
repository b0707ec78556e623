"""Make a course, print a key, sort and mark what was handed in, make an autograder."""

import argparse
import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from answers.command_line import read_arm
from course import gradescope, making, sheets, store
from course.collect import collect
from course.grading import grade
from course.roster import read_roster
from helpers.inputs import ArmError

_OPTIONS: dict[str, dict[str, Any]] = {
    "course": {"type": Path, "help": "the folder that new made"},
    "--secret": {"type": Path, "help": "a file of 16 letters or more; drawn unless given"},
    "--roster": {"required": True, "help": "CSV with the columns id and name"},
    "--arm": {"required": True, "help": "a name of the catalogue, arm.urdf, or my_arm.py:MINE"},
    "--title": {"default": "Homework", "help": "what the sheets are headed; Homework unless given"},
    "--topic": {
        "action": "append", "default": [], "choices": sheets.TOPICS, "metavar": "TOPIC",
        "help": f"one of {', '.join(sheets.TOPICS)}; may be given again; all that suit unless"
        " given",
    },
    "--id": {"required": True, "help": "a student's id in the roster"},
    "--jobs": {"type": int, "default": 0, "help": "processes; one for each processor unless given"},
    "--again": {"action": "store_true", "help": "mark everybody anew, and say what changes"},
    "--hints": {"action": "store_true", "help": "before the deadline: hints in place of marks"},
    "download": {"type": Path, "help": "a zip or folder of Canvas, Moodle, Gradescope or by hand"},
    "--out": {"type": Path, "required": True, "help": "the folder or file to write"},
}  # fmt: skip


def main(words: Sequence[str] | None = None) -> int:
    """Run one command; 0 if all went well, 2 with words on stderr if not."""
    parser = argparse.ArgumentParser(prog="python -m course", description=__doc__)
    commands = parser.add_subparsers(required=True)
    for name, (run, help_words, options) in COMMANDS.items():
        command = commands.add_parser(name, help=help_words, description=help_words)
        command.set_defaults(run=run)
        for option in options.split():
            command.add_argument(option, **_OPTIONS[option])
    given = parser.parse_args(words)
    try:
        given.run(given)
    except (ArmError, OSError, ModuleNotFoundError) as error:
        print(f"course: {error}", file=sys.stderr)
        return 2
    return 0


def _new(given: argparse.Namespace) -> None:
    arm, roster = read_arm(given.arm), read_roster(given.roster)
    secret = given.secret.read_text(encoding="utf-8").strip() if given.secret else ""
    if given.secret and len(secret) < 16:
        raise ArmError(f"the secret in {given.secret} is too short; expected 16 letters or more")
    course = making.new(
        roster, arm, given.out, title=given.title, topics=tuple(given.topic), secret=secret
    )
    print(f"{len(course.sheets)} sheets in {given.out}")


def _key(given: argparse.Namespace) -> None:
    for name, answer in making.right_work(store.load(given.course).sheet(given.id)).items():
        print(f"{name}: {json.dumps(answer)}")


def _collect(given: argparse.Namespace) -> None:
    course = store.load(given.course)
    placed, doubtful = collect(given.download, course.names, given.course)
    print(f"{len(placed)} of {len(course.sheets)} students handed in")
    for words in doubtful:
        print(words)


def _grade(given: argparse.Namespace) -> None:
    result = grade(
        given.course,
        given.out,
        given.jobs,
        again=given.again,
        before_deadline=given.hints,
        report=_show_progress,
    )
    rows = result.rows
    for change in result.changes:
        print("{id}, {part}: {before:.3g} is now {now:.3g}. {why}".format(**change))
    print(f"{len(rows)} students marked: {given.out / 'grades.csv'}")


def _show_progress(line: str) -> None:
    """Show a line in place of the last one, if a person is looking."""
    if sys.stderr.isatty():
        print(f"\r{line}", end="", file=sys.stderr, flush=True)


def _gradescope(given: argparse.Namespace) -> None:
    course = store.load(given.course)
    gradescope.pack(course, given.out)
    print(f"autograder for {len(course.sheets)} students: {given.out}")


COMMANDS = {
    "new": (
        _new, "make a sheet for each line of a roster",
        "--roster --arm --title --topic --secret --out",
    ),
    "key": (_key, "print one student's key", "course --id"),
    "collect": (_collect, "sort a download of hand-ins by student", "course download"),
    "grade": (_grade, "mark every hand-in of a course", "course --out --jobs --again --hints"),
    "gradescope": (_gradescope, "make Gradescope's autograder", "course --out"),
}  # fmt: skip

if __name__ == "__main__":
    sys.exit(main())
