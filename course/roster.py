"""Who takes the course, the folder of each, and whom other systems mean by a name."""

import csv
import io
import re
import unicodedata
from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from helpers.inputs import ArmError

# An id becomes the name of a folder, on any system.
_ID = re.compile(r"[A-Za-z0-9](?:[A-Za-z0-9._@-]{0,62}[A-Za-z0-9])?")
_TAKEN = re.compile(r"(?i)con|prn|aux|nul|com\d|lpt\d|course\.json")


@dataclass(frozen=True)
class Student:
    """An id, which names the folder, and a name, which is only shown."""

    id: str
    name: str


def read_roster(path: str | Path) -> tuple[Student, ...]:
    """The students in a CSV file with the columns id and name, in UTF-8, beside any others; with
    commas, or with semicolons as spreadsheets write them in many countries.

    Raises ArmError, with the line, for a column that is missing, an id that can name no folder, and
    an id that stands twice (capitals count as small letters, as some disks see them).
    """
    try:
        text = Path(path).read_bytes().decode("utf-8-sig")
        head = text.partition("\n")[0]
        between = ";" if head.count(";") > head.count(",") else ","
        rows = list(csv.DictReader(io.StringIO(text, newline=""), delimiter=between))
    except UnicodeDecodeError:
        raise ArmError(
            f"roster {str(path)!r} is not in UTF-8; save it as CSV UTF-8 (in Excel and LibreOffice"
            " one of the formats, or the character set, of Save As)"
        ) from None
    except csv.Error as error:
        raise ArmError(f"roster {str(path)!r} cannot be read: {error}") from None
    students = dict[str, Student]()
    for line, row in enumerate(rows, 2):
        if None in (row.get("id"), row.get("name")):
            columns = ", ".join(k for k in row if k) or "none"
            raise ArmError(f"roster line {line} has the columns {columns}; expected id and name")
        student = Student(row["id"].strip(), row["name"].strip())
        if not _ID.fullmatch(student.id) or _TAKEN.fullmatch(student.id.split(".")[0]):
            raise ArmError(
                f"roster line {line}: id is {student.id!r}; expected 1 to 64 letters, digits and"
                " . _ @ -, a letter or digit at either end, and no name that Windows keeps for"
                " itself"
            )
        if students.setdefault(student.id.casefold(), student) is not student:
            raise ArmError(f"roster line {line}: id {student.id!r} stands above already")
    if not students:
        raise ArmError(f"roster {str(path)!r} holds no student; expected lines under id,name")
    return tuple(students.values())


class People:
    """The students of a course, found by what other systems call them."""

    def __init__(self, names: Mapping[str, str]) -> None:
        self._ids = {student.casefold(): student for student in names}
        self._names = defaultdict[str, set[str]](set)
        for student, name in names.items():
            words = _letters(name).split()
            for turn in range(len(words)):  # some put the last name first, with or without a comma
                self._names["".join(words[turn:] + words[:turn])].add(student)

    def called(self, words: Iterable[str]) -> set[str]:
        """Whose id, or mail address by its part before the @, one of the words is; if nobody's, all
        who have one of them for a name, in whatever order its parts stand.
        """
        words = [word.strip().casefold() for word in words]
        keys = {key for word in words for key in (word, word.split("@")[0])}
        names = {_letters(word).replace(" ", "") for word in words}
        by_id = {self._ids[key] for key in keys & self._ids.keys()}
        return by_id or {s for name in names & self._names.keys() for s in self._names[name]}


def _letters(name: str) -> str:
    """Letters and spaces alone, small and without accents."""
    plain = unicodedata.normalize("NFKD", name).casefold()
    return "".join(c for c in plain if c.isalnum() or c == " ")
