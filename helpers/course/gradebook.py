"""Marks into the files that schools use: a plain table, exports of Canvas and Moodle, Gradescope's
JSON.
"""

import csv
import io
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from helpers.course.marking import Mark
from helpers.course.roster import People
from helpers.inputs import ArmError

# A spreadsheet runs a cell that begins with one of these (OWASP, CSV injection).
_FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n", "|", "%")


def table(rows: Sequence[Mapping[str, Any]]) -> str:
    """CSV of rows with the same keys, line ends as RFC 4180 wants; no word is a formula."""
    file = io.StringIO()
    writer = csv.DictWriter(file, list(rows[0]))
    writer.writeheader()
    for row in rows:
        risky = [key for key, v in row.items() if isinstance(v, str) and v.startswith(_FORMULA)]
        writer.writerow({**row, **{key: f"'{row[key]}" for key in risky}})
    return file.getvalue()


def grade_row(student: str, name: str, marks: Sequence[Mark], trouble: str) -> dict[str, Any]:
    """A student's line: id, name, total, a column for each part, and what went wrong."""
    credits = {mark.part: round(mark.credit, 4) for mark in marks}
    total = round(sum(credits.values()), 4)
    return {"id": student, "name": name, "total": total, **credits, "note": trouble}


@dataclass(frozen=True)
class Export:
    """How a platform's table is laid out: the columns that must be there, those that hold ids, and
    the one that holds names.
    """

    platform: str
    needed: tuple[str, ...]
    ids: tuple[str, ...]
    name: str


# instructure/canvas-lms, lib/gradebook_importer.rb; moodle, mod/assign/feedback/offline.
CANVAS = Export("Canvas", ("Student", "ID"), ("SIS Login ID", "SIS User ID", "ID"), "Student")
_MOODLES = ("Identifier", "Full name", "Grade", "Maximum Grade", "Last modified (grade)")
MOODLE = Export("Moodle", _MOODLES, ("Email address", "Username", "ID number"), "Full name")
_NOBODY = re.compile(r"\s*(points possible|student, test$|test student$|$)", re.I)


def filled(
    text: str, export: Export, shares: Mapping[str, float], names: Mapping[str, str], title: str
) -> str:
    """An export with one column filled: each student's share of all parts, scaled to the points
    that the export says, with its separators and decimal signs.

    Raises ArmError, and fills nothing, where a column is missing, or where a row may be another's
    or nobody's.
    """
    mark = "\ufeff" * text.startswith("\ufeff")
    comma = ";" if text.count(";") > text.count(",") else ","
    rows = list(csv.reader(io.StringIO(text.removeprefix(mark)), delimiter=comma))
    head = rows[0] if rows else []
    if missing := [column for column in export.needed if column not in head]:
        raise ArmError(
            f"the {export.platform} export has the columns {', '.join(head)};"
            f" expected {', '.join(missing)}"
        )
    column = _column(head, export, title)
    for row in rows:
        row += [""] * (len(head) - len(row))
    for row, student in _matched(rows, export, names):
        row[column] = _points(shares[student], _most(rows, row, export, column))
    file = io.StringIO()
    csv.writer(file, delimiter=comma).writerows(rows)
    return mark + file.getvalue()


def _column(head: Sequence[str], export: Export, title: str) -> int:
    if export is MOODLE:
        return head.index("Grade")
    found = [
        i for i, words in enumerate(head) if re.fullmatch(rf"{re.escape(title)}( \(\d+\))?", words)
    ]
    if len(found) != 1:
        raise ArmError(
            f"the Canvas export has {len(found)} columns called {title!r}; expected one; it has"
            f" {', '.join(head)}"
        )
    return found[0]


def _matched(
    rows: Sequence[list[str]], export: Export, names: Mapping[str, str]
) -> Iterator[tuple[list[str], str]]:
    """Each student's row with the id; raises ArmError where one is not certain.

    Where any row bears an id of the course all must, so that no namesake gets another's mark; else
    names that are one student's only will do.
    """
    head, people = rows[0], People(names)
    at = [head.index(key) for key in export.ids if key in head]
    name = head.index(export.name)
    every = [row for row in rows[1:] if not _NOBODY.match(row[name])]
    by_id = [people.by_id(row[i] for i in at) for row in every]
    meant = by_id if any(by_id) else [people.by_name(row[name]) for row in every]
    taken = [min(students) for students in meant if len(students) == 1]
    doubtful = [
        f"{row[name]}: " + (" or ".join(sorted(students)) or "nobody in the course")
        for row, students in zip(every, meant, strict=True)
        if len(students) != 1 or taken.count(min(students)) > 1
    ]
    if doubtful or not every:
        listing = "\n".join(doubtful) or "it has no rows"
        raise ArmError(f"the {export.platform} export was not filled; not certain are:\n{listing}")
    return zip(every, taken, strict=True)


def _most(rows: Sequence[list[str]], row: list[str], export: Export, column: int) -> str:
    """What the export says is the most that a row can get."""
    if export is MOODLE:
        return row[rows[0].index("Maximum Grade")]
    told = [r[column] for r in rows if "Points Possible" in r[0]]
    return told[0] if told else ""


def _points(share: float, most: str) -> str:
    try:
        points = f"{share * float(most.replace(',', '.')):.2f}"
    except ValueError:
        raise ArmError(f"the export's maximum is {most!r}; expected a number of points") from None
    return points.replace(".", ",") if "," in most else points


def gradescope(marks: Sequence[Mark], trouble: str) -> dict[str, Any]:
    """Marks as Gradescope's results.json: one test a part, its words as output."""
    tests = [
        {
            "name": mark.part,
            "number": str(number),
            "score": round(mark.credit, 4),
            "max_score": 1.0,
            "status": "passed" if mark.credit == 1 else "failed",
            "output": mark.words,
            "output_format": "text",
            "visibility": "visible",
        }
        for number, mark in enumerate(marks, 1)
    ]
    score = round(sum(mark.credit for mark in marks), 4)
    output = trouble or "Every part is judged below."
    return {"score": score, "output": output, "output_format": "text", "tests": tests}
