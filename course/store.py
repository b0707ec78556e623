"""Keep a course on disk: `course.json` holds the arm, the secret and every drawn sheet.

The file holds the drawn numbers, not the keys. Keys follow from the numbers, so whoever reads the
file has them, and it stays with the instructor. Each file is written beside its place and then
renamed, so that an interrupted command leaves the old file or the new one.
"""

import hashlib
import hmac
import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from course import arms
from course.sheets import Sheet, change_lengths
from helpers.arm import Arm
from helpers.inputs import ArmError

FILE = "course.json"


@dataclass(frozen=True)
class Course:
    """A course.

    Attributes:
        title: Heading of every sheet.
        arm: The arm, before lengths are drawn.
        topics: Topics that are asked.
        secret: Text from which all seeds are derived.
        sheets: For each student's id the name, the lengths and the drawn numbers.
        weights: What a part is worth, by its name; 1 for a part that is not listed.
    """

    title: str
    arm: Arm
    topics: tuple[str, ...]
    secret: str
    sheets: Mapping[str, Mapping[str, Any]]
    weights: Mapping[str, float] = field(default_factory=dict)

    def weight(self, part: str) -> float:
        """Return what a part is worth."""
        return float(self.weights.get(part, 1))

    @property
    def names(self) -> dict[str, str]:
        """The students' names by their ids."""
        return {student: str(entry["name"]) for student, entry in self.sheets.items()}

    def sheet(self, student: str) -> Sheet:
        """Return a student's sheet; raise ArmError for an unknown id."""
        if student not in self.sheets:
            raise ArmError(f"student {student!r} is not in this course")
        stored = self.sheets[student]
        return Sheet(change_lengths(self.arm, stored["values"]), stored["drawn"])


def name_sheet(course: Course, student: str) -> str:
    """Return the name of a sheet: the course by its arm and title, the student, the issue."""
    label = json.dumps([course.title, course.arm.name, list(course.topics)])
    issue = int(course.sheets[student].get("issue", 0))
    short = hashlib.sha256(label.encode()).hexdigest()[:6]
    return f"{short}/{student}" + (f"#{issue}" if issue else "")


def derive_seed(course: Course, student: str, attempt: int) -> str:
    """Derive 64 hexadecimal digits that need the secret (HMAC-SHA-256, RFC 2104)."""
    message = json.dumps([course.title, student, attempt])
    return hmac.digest(course.secret.encode(), message.encode(), "sha256").hex()


def load(folder: Path) -> Course:
    """Load the course in a folder; raise ArmError if `new` did not make its file."""
    path = folder / FILE
    try:
        data = json.loads(path.read_bytes())
        arm, topics = arms.from_json(data["arm"]), tuple(data["topics"])
        return Course(**{**data, "arm": arm, "topics": topics})
    except (KeyError, TypeError, UnicodeDecodeError, json.JSONDecodeError) as error:
        raise ArmError(f"{path} is no course that `new` made: {error!r}") from None


def save(course: Course, folder: Path) -> None:
    """Write course.json, readable by its owner alone, and a .gitignore that names it."""
    write_text(folder / ".gitignore", f"{FILE}\n")
    data = {**vars(course), "arm": arms.to_json(course.arm)}
    write_text(folder / FILE, format_json(data), mode=0o600)


def format_json(data: Mapping[str, Any]) -> str:
    """Format data as JSON; raise ValueError for a number that JSON does not know."""
    return json.dumps(data, indent=1, allow_nan=False) + "\n"


def write_text(path: Path, text: str, mode: int = 0o666) -> None:
    """Write a text file whole or not at all; escape what is no text, such as odd file names."""
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_name(f".{path.name}.{os.getpid()}")
    beside.unlink(missing_ok=True)
    beside.touch(mode)
    beside.write_bytes(text.encode(errors="backslashreplace"))
    beside.replace(path)
