"""Make a course, print an answer key, sort and mark hand-ins, make an autograder."""

import argparse
import json
import re
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from answers.command_line import read_arm
from course import gradescope, making, sending, sheets, store
from course.collect import collect_hand_ins
from course.grading import grade_hand_ins
from course.roster import read_roster
from course.sheets import Exercise
from helpers.inputs import ArmError


class _AddTopic(argparse.Action):
    """Add a topic to the last arm of the command line."""

    def __call__(self, parser: Any, namespace: Any, values: Any, _: Any = None) -> None:
        if not namespace.arm:
            parser.error(f"--topic {values!r} stands before --arm; expected it after its arm")
        namespace.arm[-1].append(values)


def _read_part_by_hand(text: str) -> tuple[str, float]:
    name, _, points = text.partition(":")
    if not re.fullmatch(r"[A-Za-z]\w*", name) or not re.fullmatch(r"\d+(\.\d+)?", points):
        raise argparse.ArgumentTypeError(f"{text!r}; expected a name and points: derivation:4")
    return name, float(points)


_OPTIONS: dict[str, dict[str, Any]] = {
    "course": {"type": Path, "help": "the folder that new made"},
    "--secret": {"type": Path, "help": "a file of 16 letters or more; drawn unless given"},
    "--roster": {"type": Path, "required": True, "help": "CSV with the columns id and name"},
    "--arm": {
        "action": "append", "required": True, "type": lambda name: [name],
        "help": "a name of the catalogue, arm.urdf, or my_arm.py:MINE; may be given again",
    },
    "--title": {"default": "Homework", "help": "what the sheets are headed; Homework unless given"},
    "--topic": {
        "action": _AddTopic, "choices": sheets.TOPICS, "metavar": "TOPIC", "dest": "arm",
        "help": f"one of {', '.join(sheets.TOPICS)}, about the last --arm; may be given again; all"
        " that suit unless given",
    },
    "--id": {"required": True, "help": "a student's id in the roster"},
    "--jobs": {"type": int, "default": 0, "help": "processes; one for each processor unless given"},
    "--again": {"action": "store_true", "help": "mark everybody anew, and say what changes"},
    "--hints": {
        "type": int, "nargs": "?", "const": 3, "default": 0, "metavar": "N",
        "help": "before the deadline: hints in place of marks, for N hand-ins of a student, or 3",
    },
    "--by-hand": {
        "action": "append", "default": [], "type": _read_part_by_hand, "metavar": "PART:POINTS",
        "help": "a part that you mark yourself, such as derivation:4; may be given again",
    },
    "--results": {
        "type": Path, "help": "the folder that grade wrote, to send feedback; sheets unless given",
    },
    "download": {"type": Path, "help": "a zip or folder of Canvas, Moodle, Gradescope or by hand"},
    "--out": {"type": Path, "required": True, "help": "the folder or file to write"},
}  # fmt: skip


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command.

    Returns 0, or 2 with a message on stderr if the command fails.
    """
    parser = argparse.ArgumentParser(prog="python -m course", description=__doc__)
    commands = parser.add_subparsers(required=True)
    for name, (run_command, description, option_names) in COMMANDS.items():
        command = commands.add_parser(name, help=description, description=description)
        command.set_defaults(run_command=run_command)
        for option in option_names.split():
            command.add_argument(option, **_OPTIONS[option])
    options = parser.parse_args(arguments)
    try:
        options.run_command(options)
    except (ArmError, OSError, ModuleNotFoundError) as error:
        print(f"course: {error}", file=sys.stderr)
        return 2
    return 0


def _make_sheets(options: argparse.Namespace) -> None:
    exercises = [Exercise(read_arm(name), tuple(topics)) for name, *topics in options.arm]
    roster, path = read_roster(options.roster), options.secret
    secret = path.read_text(encoding="utf-8").strip() if path else ""
    if path and len(secret) < 16:
        raise ArmError(f"the secret in {path} is too short; expected 16 letters or more")
    course = making.make_course(
        roster,
        exercises,
        options.out,
        title=options.title,
        secret=secret,
        by_hand=dict(options.by_hand),
        jobs=options.jobs,
        report=_show_progress,
    )
    print(f"{len(course.sheets)} sheets in {options.out}")


def _print_key(options: argparse.Namespace) -> None:
    sheet = store.load_course(options.course).sheet(options.id)
    for name, answer in making.make_right_answers(sheet).items():
        print(f"{name}: {json.dumps(answer)}")


def _reissue_sheet(options: argparse.Namespace) -> None:
    course = making.reissue_sheet(options.course, options.id)
    print(f"new sheet: {store.name_sheet(course, options.id)}")


def _drop_student(options: argparse.Namespace) -> None:
    print(f"{len(making.drop_student(options.course, options.id).sheets)} sheets are left")


def _collect_hand_ins(options: argparse.Namespace) -> None:
    course = store.load_course(options.course)
    collection = collect_hand_ins(options.download, course.names, options.course)
    count = len(collection.handed_in)
    print(f"{count} of {len(course.sheets)} students handed in something that can be read")
    for message in collection.messages:
        print(message)


def _grade_hand_ins(options: argparse.Namespace) -> None:
    result = grade_hand_ins(
        options.course,
        options.out,
        options.jobs,
        again=options.again,
        hints=options.hints,
        report=_show_progress,
    )
    for change in result.changes:
        print("{id}, {part}: {before:.3g} is now {now:.3g}. {why}".format(**change))
    print(f"{len(result.rows)} students marked: {options.out / 'grades.csv'}")
    for part in store.load_course(options.course).by_hand:
        if unmarked := sum(row[part] == "" for row in result.rows):
            print(f"{part} of {unmarked} students is not marked yet: fill in")
            print(f"{options.out / 'marks.csv'} and save it as {options.course / 'marks.csv'}")


def _pack_for_platform(options: argparse.Namespace) -> None:
    course = store.load_course(options.course)
    absent = sending.pack_for_platform(
        course, options.course, options.download, options.out, options.results
    )
    what = "feedback" if options.results else "sheets"
    print(f"{what} for {len(course.sheets) - len(absent)} of {len(course.sheets)}: {options.out}")
    if absent:
        print(f"not in the download: {', '.join(absent)}")


def _count_marks(options: argparse.Namespace) -> None:
    from course.statistics import PICTURE, write_statistics  # matplotlib is slow to import

    print(write_statistics(options.course, options.out))
    print(f"\npicture: {options.out / PICTURE}")


def _show_progress(line: str) -> None:
    """Overwrite the last line of stderr, if it is a terminal."""
    if sys.stderr.isatty():
        print(f"\r{line}", end="", file=sys.stderr, flush=True)


def _pack_autograder(options: argparse.Namespace) -> None:
    course = store.load_course(options.course)
    gradescope.pack_autograder(course, options.out, options.hints)
    print(f"autograder for {len(course.sheets)} students: {options.out}")


COMMANDS = {
    "new": (
        _make_sheets, "make a sheet for each line of a roster",
        "--roster --arm --title --topic --by-hand --secret --out --jobs",
    ),
    "key": (_print_key, "print one student's key", "course --id"),
    "reissue": (_reissue_sheet, "draw other numbers for one student", "course --id"),
    "drop": (_drop_student, "remove one student and leave all others alone", "course --id"),
    "collect": (_collect_hand_ins, "sort a download of hand-ins by student", "course download"),
    "send": (
        _pack_for_platform, "pack sheets or feedback as Canvas or Moodle take them",
        "course download --results --out",
    ),
    "grade": (
        _grade_hand_ins, "mark every hand-in of a course",
        "course --out --jobs --again --hints",
    ),
    "stats": (
        _count_marks, "count the marks by part and by mistake, and draw them", "course --out",
    ),
    "gradescope": (_pack_autograder, "make Gradescope's autograder", "course --out --hints"),
}  # fmt: skip

if __name__ == "__main__":
    sys.exit(main())
