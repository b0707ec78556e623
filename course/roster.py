"""Read the students of a course, and find them by the names that platforms use."""

import csv
import io
import re
import unicodedata
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from helpers.inputs import ArmError

# An id becomes the name of a folder, which must be valid on every system.
_ID = re.compile(r"[A-Za-z0-9](?:[A-Za-z0-9._@-]{0,62}[A-Za-z0-9])?")
_RESERVED = re.compile(r"(?i)con|prn|aux|nul|com\d|lpt\d|course\.json")


@dataclass(frozen=True)
class Student:
    """A student's id, which is also the folder's name, and the name to display."""

    id: str
    name: str


# Column headers for ids and names, in order of preference: ours, Canvas, Moodle, Gradescope, Excel.
_ID_HEADERS = (
    "sis login id", "login id", "username", "id", "id number", "student id", "sid",
    "email address", "email",
)  # fmt: skip
_CANVAS_IDS = ("ID", "SIS User ID", "SIS Login ID")
_NAME_HEADERS = ("name", "student", "full name", "student name")
_FIRST_NAMES, _LAST_NAMES = ("first name", "firstname"), ("last name", "surname", "lastname")


def read_roster(path: Path) -> tuple[Student, ...]:
    """Read the students from a CSV file that a platform or spreadsheet exported.

    The file is in UTF-8 and has a column for the id and one for the name (or two), beside any
    others, with commas, semicolons or tabs between them. Canvas writes rows about the assignments,
    which have no ID, before those of the students; they are passed over.

    Raises ArmError with every line that has no id and name, an id that can name no folder, or an
    id of an earlier line (capitals count as small letters, as some disks treat them).
    """
    students, problems = dict[str, Student](), list[str]()
    for line, row in read_csv_rows(path):
        is_canvas = {"ID", "Section"} <= row.keys()
        if is_canvas and not students and not any(row.get(key) for key in _CANVAS_IDS):
            continue
        student = _read_student(row)
        problem = _describe_problem(student, row)
        if not problem and students.setdefault(student.id.casefold(), student) is not student:
            problem = f": id {student.id!r} stands above already"
        problems += [f"roster line {line}{problem}"] if problem else []
    if problems:
        raise ArmError("; ".join(problems))
    if not students:
        raise ArmError(f"roster {str(path)!r} holds no student; expected lines under id,name")
    return tuple(students.values())


def read_csv_rows(path: Path) -> Iterator[tuple[int, dict[str, str]]]:
    """Read a CSV file row by row, with line numbers; outer spaces and empty rows are removed.

    Raises ArmError if the file is not in UTF-8 or is no CSV.
    """
    try:
        text = path.read_bytes().decode("utf-8-sig")
        first, _, rest = text.partition("\n")
        if first.lower().startswith("sep="):  # Excel
            text, (first, _, _) = rest, rest.partition("\n")
        separator = max(",;\t", key=first.count)
        rows = list(csv.DictReader(io.StringIO(text, newline=""), delimiter=separator, strict=True))
    except UnicodeDecodeError:
        raise ArmError(
            f"{str(path)!r} is not in UTF-8; save it as CSV UTF-8 (in Excel and LibreOffice"
            " one of the formats, or the character set, of Save As)"
        ) from None
    except csv.Error as error:
        raise ArmError(
            f"{str(path)!r} cannot be read: {error}; expected a second quotation mark for each"
        ) from None
    for line, row in enumerate(rows, 2):
        cells = {key.strip(): x.strip() for key, x in row.items() if key and isinstance(x, str)}
        if any(cells.values()):
            yield line, cells


def _read_student(row: Mapping[str, str]) -> Student:
    """Return the student of a row, with "\\0" for a missing id or name."""
    cells = {header.casefold(): cell for header, cell in row.items()}
    student_id = next((cells[key] for key in _ID_HEADERS if key in cells), "\0")
    first_name, last_name = (
        next((cells[key] for key in keys if key in cells), "")
        for keys in (_FIRST_NAMES, _LAST_NAMES)
    )
    full_name = f"{first_name} {last_name}".strip()
    name = next((cells[key] for key in _NAME_HEADERS if key in cells), full_name or "\0")
    return Student(student_id, name)


def _describe_problem(student: Student, row: Mapping[str, str]) -> str:
    """Return the reason why a row gives no student, or ""."""
    if "\0" in (student.id, student.name):
        return f" has the columns {', '.join(row) or 'none'}; expected id and name"
    if not _ID.fullmatch(student.id) or _RESERVED.fullmatch(student.id.split(".")[0]):
        return (
            f": id is {student.id!r}; expected 1 to 64 letters, digits and . _ @ -, a letter or"
            " digit at either end, and no name that Windows keeps for itself"
        )
    return ""


class StudentIndex:
    """The students of a course, to be found by ids, mail addresses and names."""

    def __init__(self, names: Mapping[str, str]) -> None:
        self._ids = {student.casefold(): student for student in names}
        # Students by their names with accents, and by their names without accents.
        self._by_spelling = [defaultdict[str, set[str]](set) for _ in range(2)]
        for student, name in names.items():
            for students, spelling in zip(self._by_spelling, _list_spellings(name), strict=True):
                parts = spelling.split()
                for first in range(len(parts)):  # some systems put the last name first
                    students["".join(parts[first:] + parts[:first])].add(student)

    def is_id(self, labels: Iterable[str]) -> bool:
        """Return whether a label is an id, or a mail address with an id before the @."""
        return bool(self._find_ids(labels))

    def find_students(self, labels: Iterable[str]) -> set[str]:
        """Return the ids of the students whom some labels may mean.

        A label that is an id, or a mail address with an id before the @, counts before names.
        The parts of a name may come in any rotation.
        """
        labels = [*labels]
        if by_id := self._find_ids(labels):
            return by_id
        for place, students in enumerate(self._by_spelling):
            spellings = {_list_spellings(label)[place].replace(" ", "") for label in labels}
            if found := {s for name in spellings & students.keys() for s in students[name]}:
                return found
        return set()

    def _find_ids(self, labels: Iterable[str]) -> set[str]:
        labels = [label.strip().casefold() for label in labels]
        keys = {key for label in labels for key in (label, label.split("@")[0])}
        return {self._ids[key] for key in keys & self._ids.keys()}


def _list_spellings(name: str) -> tuple[str, str]:
    """Reduce a name to lower-case letters, digits and spaces, with accents and without."""
    exact, plain = (unicodedata.normalize(form, name).casefold() for form in ("NFKC", "NFKD"))
    with_accents, without = (
        "".join(c for c in text if c.isalnum() or c == " ") for text in (exact, plain)
    )
    return with_accents, without
