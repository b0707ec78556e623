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


# Column headers for ids and names, the best first: ours, Canvas, Moodle, Excel.
_ID_HEADERS = ("sis login id", "login id", "username", "id", "id number", "student id")
_NAME_HEADERS = ("name", "student", "full name", "student name")
_FIRST_NAME, _LAST_NAMES = "first name", ("last name", "surname")


def read_roster(path: str | Path) -> tuple[Student, ...]:
    """Read the students in a CSV file as platforms and spreadsheets export it.

    The file is in UTF-8 and has a column for the id and one for the name (or two), beside any
    others, with commas, semicolons or tabs between them.

    Raises ArmError with every line that has no id and name, an id that can name no folder, or an
    id that stands twice (capitals count as small letters, as some disks see them).
    """
    try:
        text = Path(path).read_bytes().decode("utf-8-sig")
        first, _, rest = text.partition("\n")
        if first.lower().startswith("sep="):  # Excel
            text, (first, _, _) = rest, rest.partition("\n")
        separator = max(",;\t", key=first.count)
        rows = list(csv.DictReader(io.StringIO(text, newline=""), delimiter=separator))
    except UnicodeDecodeError:
        raise ArmError(
            f"roster {str(path)!r} is not in UTF-8; save it as CSV UTF-8 (in Excel and LibreOffice"
            " one of the formats, or the character set, of Save As)"
        ) from None
    except csv.Error as error:
        raise ArmError(f"roster {str(path)!r} cannot be read: {error}") from None
    students, problems = dict[str, Student](), list[str]()
    for line, row in enumerate(rows, 2):
        texts = [x.strip() for x in row.values() if isinstance(x, str)]
        if not any(texts) or "Points Possible" in texts:  # a blank line; Canvas' second line
            continue
        student = _read_student(row)
        problem = _find_problem(student, row)
        if not problem and students.setdefault(student.id.casefold(), student) is not student:
            problem = f": id {student.id!r} stands above already"
        problems += [f"roster line {line}{problem}"] if problem else []
    if problems:
        raise ArmError("; ".join(problems))
    if not students:
        raise ArmError(f"roster {str(path)!r} holds no student; expected lines under id,name")
    return tuple(students.values())


def _read_student(row: Mapping[str | None, str | None]) -> Student:
    """Return the id and the name in a line; one that is missing is empty."""
    cells = {k.strip().casefold(): v.strip() for k, v in row.items() if k and isinstance(v, str)}
    student_id = next((cells[key] for key in _ID_HEADERS if key in cells), "\0")
    last = next((cells[key] for key in _LAST_NAMES if key in cells), "")
    both = f"{cells.get(_FIRST_NAME, '')} {last}".strip()
    name = next((cells[key] for key in _NAME_HEADERS if key in cells), both or "\0")
    return Student(student_id, name)


def _find_problem(student: Student, row: Mapping[str | None, str | None]) -> str:
    if "\0" in (student.id, student.name):
        columns = ", ".join(key for key in row if key) or "none"
        return f" has the columns {columns}; expected id and name"
    if not _ID.fullmatch(student.id) or _TAKEN.fullmatch(student.id.split(".")[0]):
        return (
            f": id is {student.id!r}; expected 1 to 64 letters, digits and . _ @ -, a letter or"
            " digit at either end, and no name that Windows keeps for itself"
        )
    return ""


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
