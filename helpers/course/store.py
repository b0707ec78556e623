"""A course on disk: `course.json` keeps the arm, the rules of marking, and every sheet that was
drawn.

The drawn numbers are stored, not the keys: a key follows from them. Each sheet is signed with the
secret, so a file that lay where students could write is found out. Files are written beside and
then renamed, so that an interrupted command leaves the old file or the new one.
"""

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from helpers import variants
from helpers.arm import Arm
from helpers.course import arms
from helpers.course.marking import Rules
from helpers.course.roster import must_name_a_folder
from helpers.course.secrets import is_signed, seed, signature
from helpers.inputs import ArmError

FILE = "course.json"
_VERSION = 1


@dataclass(frozen=True)
class Course:
    """An arm, a title, the topics asked, the rules, and each student's drawn sheet and name."""

    title: str
    arm: Arm
    topics: tuple[str, ...]
    rules: Rules
    sheets: Mapping[str, Mapping[str, Any]]

    @property
    def names(self) -> dict[str, str]:
        """The students' names by their ids."""
        return {student: str(entry["name"]) for student, entry in self.sheets.items()}

    def sheet(self, student: str, secret: bytes) -> variants.Sheet:
        """A student's sheet as it was drawn.

        Raises ArmError for an id that is not in the course, and for a sheet that the secret did not
        sign.
        """
        try:
            stored = self.sheets[student]
        except KeyError:
            raise ArmError(f"student {student!r} is not in this course") from None
        content = {"values": stored["values"], "drawn": stored["drawn"]}
        if not is_signed(secret, student, content, stored["signature"]):
            raise ArmError(
                f"the stored sheet of {student!r} was changed, or the secret is another;"
                " expected the one that the course was made with"
            )
        return self.unsigned(student)

    def unsigned(self, student: str) -> variants.Sheet:
        """The same where there is no secret, as in a grader that others run: taken on trust."""
        stored = self.sheets[student]
        arm = variants.with_lengths(self.arm, stored["values"])
        return variants.Sheet(arm, stored["drawn"])


def drawn_sheet(
    course: Course, student: str, name: str, secret: bytes, attempt: int = 0
) -> dict[str, Any]:
    """The entry of `Course.sheets` for one student: values, drawn numbers, signature and name.

    Another `attempt` draws other numbers.
    """
    must_name_a_folder(student, "student id")
    drawn_from = seed(secret, student, f"{course.title} {attempt}")
    sheet = variants.sheet(course.arm, drawn_from, course.topics)
    content = {"values": dict(sheet.arm.values), "drawn": dict(sheet.drawn)}
    return {"name": name, **content, "signature": signature(secret, student, content)}


def save(course: Course, folder: Path) -> None:
    """Write course.json into a folder."""
    write(folder / FILE, text(course))


def text(course: Course) -> str:
    """A course as JSON."""
    rules = course.rules
    data = {
        "version": _VERSION,
        "title": course.title,
        "arm": arms.to_json(course.arm),
        "topics": list(course.topics),
        "rules": {"digits": rules.digits, "columns": rules.columns, "causes": dict(rules.causes)},
        "sheets": course.sheets,
    }
    return as_json(data)


def load(folder: Path) -> Course:
    """The course in a folder; raises ArmError where there is none or it cannot be read."""
    path = folder / FILE
    try:
        data = json.loads(path.read_bytes())
        if data["version"] != _VERSION:
            raise ArmError(f"{path} is of version {data['version']}; expected {_VERSION}")
        rules = Rules(**data["rules"])
        arm, topics = arms.from_json(data["arm"]), tuple(data["topics"])
        return Course(data["title"], arm, topics, rules, data["sheets"])
    except OSError as error:
        raise ArmError(
            f"{path} cannot be read ({error.strerror}); expected a course that `new` made"
        ) from None
    except (KeyError, TypeError, UnicodeDecodeError, json.JSONDecodeError) as error:
        raise ArmError(f"{path} is no course that `new` made: {error!r}") from None


def as_json(data: Mapping[str, Any]) -> str:
    """Data as it is written to a file; raises ValueError for a number that JSON does not know."""
    return json.dumps(data, indent=1, allow_nan=False) + "\n"


def write(path: Path, text: str) -> None:
    """Write a text file whole or not at all; a file's name in it may be no text, and is escaped."""
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_name(f".{path.name}.{os.getpid()}")
    beside.write_bytes(text.encode(errors="backslashreplace"))
    beside.replace(path)
