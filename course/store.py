"""A course on disk: `course.json` keeps the arm, the secret, and every sheet that was drawn.

The drawn numbers are stored, not the keys: a key follows from them. So whoever reads the file has
the keys, and it stays with the instructor. Files are written beside and then renamed, so that an
interrupted command leaves the old file or the new one.
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
from course.sheets import Sheet, with_lengths
from helpers.arm import Arm
from helpers.inputs import ArmError

FILE = "course.json"


@dataclass(frozen=True)
class Course:
    """An arm, the topics asked, the secret that seeds are made from, each student's drawn sheet."""

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
        """A student's sheet as it was drawn; raises ArmError for an unknown id."""
        if student not in self.sheets:
            raise ArmError(f"student {student!r} is not in this course")
        stored = self.sheets[student]
        arm = with_lengths(self.arm, stored["values"])
        return Sheet(arm, stored["drawn"])


def name_sheet(course: Course, student: str) -> str:
    """Return the name of a sheet: the course by its arm and title, the student, the issue."""
    label = json.dumps([course.title, course.arm.name, list(course.topics)])
    issue = int(course.sheets[student].get("issue", 0))
    short = hashlib.sha256(label.encode()).hexdigest()[:6]
    return f"{short}/{student}" + (f"#{issue}" if issue else "")


def seed(course: Course, student: str, attempt: int) -> str:
    """64 hexadecimal digits that nobody guesses without the secret (HMAC-SHA-256, RFC 2104)."""
    words = json.dumps([course.title, student, attempt])
    return hmac.digest(course.secret.encode(), words.encode(), "sha256").hex()


def text(course: Course) -> str:
    """A course as JSON."""
    return as_json({**vars(course), "arm": arms.to_json(course.arm)})


def load(folder: Path) -> Course:
    """The course in a folder; raises ArmError where its file is none that `new` made."""
    path = folder / FILE
    try:
        data = json.loads(path.read_bytes())
        arm, topics = arms.from_json(data["arm"]), tuple(data["topics"])
        return Course(**{**data, "arm": arm, "topics": topics})
    except (KeyError, TypeError, UnicodeDecodeError, json.JSONDecodeError) as error:
        raise ArmError(f"{path} is no course that `new` made: {error!r}") from None


def as_json(data: Mapping[str, Any]) -> str:
    """Data as it is written to a file; raises ValueError for a number that JSON does not know."""
    return json.dumps(data, indent=1, allow_nan=False) + "\n"


def save(course: Course, folder: Path) -> None:
    """Write course.json, readable by its owner alone, and a .gitignore that keeps it to itself."""
    write(folder / ".gitignore", f"{FILE}\n")
    write(folder / FILE, text(course), mode=0o600)


def write(path: Path, text: str, mode: int = 0o666) -> None:
    """Write a text file whole or not at all; a file's name in it may be no text, and is escaped."""
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_name(f".{path.name}.{os.getpid()}")
    beside.unlink(missing_ok=True)
    beside.touch(mode)
    beside.write_bytes(text.encode(errors="backslashreplace"))
    beside.replace(path)
