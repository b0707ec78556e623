"""Store a course in `course.json`, with the arms, the secret and all drawn sheets.

The file holds the drawn numbers, not the keys. Keys follow from the numbers, so whoever reads the
file has them, and it stays with the instructor. Each file is written beside its place and then
renamed, so that an interrupted command leaves the old file or the new one.
"""

import hashlib
import hmac
import json
import math
import os
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from course.sheets import Exercise, Section, Sheet, change_lengths, list_part_names, make_suffix
from helpers.arm import Arm, Body, CircleTask, Joint, Row
from helpers.inputs import ArmError, require_type

COURSE_FILE, LOCK_FILE = "course.json", ".lock"


@dataclass(frozen=True)
class Course:
    """A course.

    Attributes:
        title: Heading of every sheet.
        exercises: The arms and what is asked about each.
        secret: Text from which all seeds are derived.
        sheets: For each student's id the name, how often the sheet was issued anew, and for each
            arm the lengths and the drawn numbers.
        weights: The largest credit of a part by its name, 1 for a part that is not listed.
        by_hand: The points of each part that the instructor marks, by its name.
    """

    title: str
    exercises: tuple[Exercise, ...]
    secret: str
    sheets: Mapping[str, Mapping[str, Any]]
    weights: Mapping[str, float] = field(default_factory=dict)
    by_hand: Mapping[str, float] = field(default_factory=dict)

    @property
    def part_names(self) -> list[str]:
        """The names of all parts; parts marked by hand come last."""
        return [*list_part_names(self.exercises), *self.by_hand]

    def weight(self, part: str) -> float:
        """Return the largest credit of a part."""
        return float(self.weights.get(part, self.by_hand.get(part, 1)))

    @property
    def names(self) -> dict[str, str]:
        """The students' names by their ids."""
        return {student: str(entry["name"]) for student, entry in self.sheets.items()}

    def sheet(self, student: str) -> Sheet:
        """Return a student's sheet.

        Raises ArmError for an unknown id.
        """
        stored = zip(self.exercises, self.require_entry(student)["sections"], strict=True)
        return Sheet(
            tuple(
                Section(change_lengths(exercise.arm, x["values"]), x["drawn"], make_suffix(index))
                for index, (exercise, x) in enumerate(stored)
            )
        )

    def require_entry(self, student: str) -> Mapping[str, Any]:
        """Return the stored entry of a student.

        Raises ArmError for an unknown id.
        """
        if student not in self.sheets:
            raise ArmError(f"student {student!r} is not in this course")
        return self.sheets[student]


def name_sheet(course: Course, student: str) -> str:
    """Return the name of a sheet, made of a digest of its numbers, student and issue.

    So a notebook tells whether it holds the numbers that the course keeps. A sheet that an earlier
    edition drew keeps the digest of the course alone.
    """
    entry = course.sheets[student]
    label = [course.title, [[x.arm.name, *x.topics] for x in course.exercises]]
    label += [entry["sections"]] if entry.get("named_by") == "numbers" else []
    issue = int(entry.get("issue", 0))
    digest = hashlib.sha256(json.dumps(label).encode()).hexdigest()[:6]
    return f"{digest}/{student}" + (f"#{issue}" if issue else "")


@contextmanager
def lock_folder(folder: Path) -> Iterator[None]:
    """Lock a course, so that a single command at a time can change it.

    Raises ArmError if another one is running. The lock ends with its process, however that ends.
    """
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / LOCK_FILE).open("a+b") as file:
        try:
            if sys.platform == "win32":
                import msvcrt

                msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
            else:
                import fcntl

                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise ArmError(f"another command is changing {folder}; wait until it ends") from None
        yield


def derive_seed(course: Course, student: str, index: int, attempt: int) -> str:
    """Derive a section's seed of 64 hexadecimal digits (HMAC-SHA-256, RFC 2104)."""
    message = json.dumps([course.title, student, index, attempt])
    return hmac.digest(course.secret.encode(), message.encode(), "sha256").hex()


def load_course(folder: Path) -> Course:
    """Load the course in a folder.

    Raises ArmError if `new` did not make its file.
    """
    path = folder / COURSE_FILE
    try:
        data = json.loads(path.read_bytes())
        exercises = [
            Exercise(arm_from_json(x["arm"]), tuple(x["topics"])) for x in data["exercises"]
        ]
        course = Course(**{**data, "exercises": tuple(exercises)})
        names = course.part_names
    except (KeyError, TypeError, UnicodeDecodeError, json.JSONDecodeError) as error:
        raise ArmError(f"{path} is no course that `new` made: {error!r}") from None
    problems = [f"there is no part {name!r}" for name in course.weights if name not in names]
    problems += [
        f"{name} is {weight!r}" for name, weight in course.weights.items() if not _is_weight(weight)
    ]
    if problems:
        raise ArmError(
            f"the weights in {path} cannot be used: {'; '.join(problems)}; expected numbers, 0 or"
            f" more, for some of {', '.join(names)}"
        )
    return course


def _is_weight(value: Any) -> bool:
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return is_number and math.isfinite(value) and value >= 0


def save_course(course: Course, folder: Path) -> None:
    """Write course.json, readable by its owner alone, and a .gitignore that names it."""
    write_text(folder / ".gitignore", f"{COURSE_FILE}\n")
    exercises = [{"arm": arm_to_json(x.arm), "topics": x.topics} for x in course.exercises]
    data = {**vars(course), "exercises": exercises}
    write_text(folder / COURSE_FILE, format_json(data), mode=0o600)


def format_json(data: Mapping[str, Any]) -> str:
    """Format data as JSON.

    Raises ValueError for a number that JSON does not know.
    """
    return json.dumps(data, indent=1, allow_nan=False) + "\n"


def write_text(path: Path, text: str, mode: int = 0o666) -> None:
    """Write a text file completely or not at all.

    Bytes that are no text, such as those of odd file names, are escaped.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f".{path.name}.{os.getpid()}")
    temporary.unlink(missing_ok=True)
    try:
        temporary.touch(mode)
        temporary.write_bytes(text.encode(errors="backslashreplace"))
        temporary.replace(path)
    finally:  # remove the incomplete file if the disk is full
        temporary.unlink(missing_ok=True)


def arm_to_json(arm: Arm) -> dict[str, Any]:
    """Convert an arm to plain data, with entries as written and without unknown limits."""
    require_type(arm, Arm, "arm")
    return {
        "name": arm.name,
        "rows": [_row_to_json(row) for row in arm.rows],
        "values": dict(arm.values),
        "bodies": [dict(vars(body)) for body in arm.bodies],
        "home": list(arm.home),
        "circle": arm.circle and vars(arm.circle),
        "source": arm.source,
    }


def _row_to_json(row: Row) -> dict[str, Any]:
    unknown = (None, math.inf, -math.inf)
    return {
        "entries": dict(zip(("a", "alpha", "d", "theta"), row.entries, strict=True)),
        "joint": {name: x for name, x in vars(row.joint).items() if x not in unknown},
    }


def arm_from_json(data: Mapping[str, Any]) -> Arm:
    """Make the arm that `arm_to_json` converted.

    Raises ArmError if the data make none.
    """
    try:
        rows = [Row(**row["entries"], joint=Joint(**row["joint"])) for row in data["rows"]]
        bodies = [Body(**body) for body in data["bodies"]]
        circle = CircleTask(**data["circle"]) if data.get("circle") else None
        return Arm(**{**data, "rows": rows, "bodies": bodies, "circle": circle})
    except (KeyError, TypeError) as error:
        raise ArmError(
            f"the stored arm lacks or mistypes {error}; expected what arm_to_json makes"
        ) from None
